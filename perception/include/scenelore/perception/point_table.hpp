// A point file as it is: every property of every point, in file order. Reading one loses nothing, so that a labelled
// copy can be written later with all the input's properties.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scenelore::perception {

enum class ScalarType : std::uint8_t { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };
[[nodiscard]] std::size_t size_of(ScalarType type);

struct Column {
  std::string name;
  ScalarType type = ScalarType::f32;
  std::size_t offset = 0;  ///< bytes from the start of a row
};

/// Rows of packed little-endian records.
struct PointTable {
  std::vector<Column> columns;
  std::size_t stride = 0;  ///< bytes a row
  std::size_t rows = 0;
  std::vector<std::byte> bytes;                ///< stride * rows
  std::vector<std::string> comments;           ///< header comments, without the keyword
  std::optional<Eigen::Vector3d> viewpoint;    ///< sensor position in the file's frame, where the file tells

  [[nodiscard]] const Column* find(std::string_view name) const;
  /// The value in double precision; exact for all types but 64-bit integers.
  [[nodiscard]] double value(const Column& column, std::size_t row) const;
  /// Appends a column (or replaces the one of that name) from one value a row.
  void set_column(const std::string& name, std::span<const std::int32_t> values);
  void set_column(const std::string& name, std::span<const float> values);
  void set_column(const std::string& name, std::span<const std::uint8_t> values);
};

/// Reads .ply (ascii, binary little and big endian), .pcd (ascii, binary, binary_compressed) and .xyz/.txt/.csv/.asc text.
/// The format is told from the content where it can be, else from the name. Strict: throws Error naming the file, the
/// line or byte, and the field for anything that is not exactly what the header promises.
[[nodiscard]] PointTable read_points(const std::filesystem::path& path);

/// Formats from the name: .ply (binary little endian), .pcd (binary), .csv. Writes to a temporary file and renames it, so that
/// an existing file is replaced whole or not at all. Throws Error when the disk is full.
void write_points(const std::filesystem::path& path, const PointTable& table);

}  // namespace scenelore::perception
