// The point formats behind read_points and write_points: one reader and one writer each.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "mapped_file.hpp"
#include "output_file.hpp"
#include "scenelore/perception/point_table.hpp"

namespace scenelore::perception {

[[nodiscard]] bool looks_like_ply(std::string_view text);
[[nodiscard]] PointTable read_ply(const MappedFile& file, const std::string& file_name);
void write_ply(OutputFile& out, const PointTable& table);

}  // namespace scenelore::perception
