// The header of a PLY file: elements in file order, each with its properties.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenelore/perception/point_table.hpp"

namespace scenelore::perception {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::f32;       ///< of the value, or of each entry of a list
  std::optional<ScalarType> list_count{};  ///< type of the number of entries, for a list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  [[nodiscard]] bool has_list() const;
  [[nodiscard]] std::size_t row_size() const;  ///< bytes of a binary row; requires: no list
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> comments;         ///< obj_info lines keep their keyword
  std::optional<Eigen::Vector3d> viewpoint;  ///< of a line "comment viewpoint x y z"
  std::size_t body = 0;                      ///< byte at which the first element begins
  std::size_t lines = 0;                     ///< lines of the header
};

/// Throws Error, with line number, for anything that is no PLY header.
[[nodiscard]] PlyHeader parse_ply_header(std::string_view text, const std::string& file_name);

/// The type's name in PLY files; nothing for 64-bit integers, which PLY does not have.
[[nodiscard]] std::optional<std::string_view> ply_type_name(ScalarType type);

}  // namespace scenelore::perception
