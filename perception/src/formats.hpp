// The point formats behind read_points and write_points: one reader and one writer each. A reader throws Error; it is
// given the name by which to call the file.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mapped_file.hpp"
#include "scenelore/perception/output_file.hpp"
#include "scenelore/perception/point_table.hpp"

namespace scenelore::perception {

[[nodiscard]] bool looks_like_ply(std::string_view text);
/// With `rows_at`, rows that stand in the file as the table would hold them are not copied: the table's `bytes` stay empty
/// and the place of the first one in the file is told.
[[nodiscard]] PointTable read_ply(const MappedFile& file, const std::string& file_name, std::optional<std::size_t>* rows_at = nullptr);
void write_ply(OutputFile& out, const PointTable& table);

[[nodiscard]] bool looks_like_pcd(std::string_view text);
[[nodiscard]] PointTable read_pcd(const MappedFile& file, const std::string& file_name, std::optional<std::size_t>* rows_at = nullptr);
void write_pcd(OutputFile& out, const PointTable& table);

/// A first line (past comments) of three numbers at least, of column names with x, y and z, or of a number of points.
[[nodiscard]] bool looks_like_text(std::string_view text);
[[nodiscard]] PointTable read_text(const MappedFile& file, const std::string& file_name);
void write_csv(OutputFile& out, const PointTable& table);

/// A sentence about binary data that are text in truth, to end an error message with; else nothing.
[[nodiscard]] std::string text_hint(std::string_view body);

/// Shortest text that reads back as the same number.
[[nodiscard]] std::string shortest(double value);

/// With blanks for line ends: a comment is one line.
[[nodiscard]] std::string one_line(std::string text);

/// Whether the columns follow one another without gaps, in order, to the end of the row.
[[nodiscard]] bool is_packed(const PointTable& table);

}  // namespace scenelore::perception
