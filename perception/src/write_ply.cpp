#include <algorithm>
#include <cmath>

#include "bytes.hpp"
#include "formats.hpp"
#include "ply_header.hpp"
#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

/// PLY knows no 64-bit integers: they become doubles.
ScalarType stored_type(ScalarType type) { return ply_type_name(type) ? type : ScalarType::f64; }

std::string header(const PointTable& table) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  if (table.viewpoint) {
    const Eigen::Vector3d& v = *table.viewpoint;
    text += "comment viewpoint " + shortest(v.x()) + " " + shortest(v.y()) + " " + shortest(v.z()) + "\n";
  }
  for (const std::string& comment : table.comments) {
    text += (comment.starts_with("obj_info") ? "" : "comment ") + one_line(comment) + "\n";
  }
  text += "element vertex " + std::to_string(table.rows) + "\n";
  for (const Column& column : table.columns) {
    text += "property " + std::string(*ply_type_name(stored_type(column.type))) + " " + column.name + "\n";
  }
  return text + "end_header\n";
}

bool stored_as_is(const PointTable& table) {
  return is_packed(table) && std::all_of(table.columns.begin(), table.columns.end(),
                                         [](const Column& c) { return stored_type(c.type) == c.type; });
}

void write_row(OutputFile& out, const PointTable& table, std::size_t row) {
  const std::byte* const start = table.bytes.data() + row * table.stride;
  for (const Column& column : table.columns) {
    if (stored_type(column.type) == column.type) {
      out.write(std::span(start + column.offset, size_of(column.type)));
      continue;
    }
    const double value = table.value(column, row);
    if (std::abs(value) > 9007199254740992.0) {  // 2^53
      throw Error(out.name() + ": column '" + column.name + "', point " + std::to_string(row) +
                  ": PLY has no 64-bit integers and a double does not hold this one; write a .pcd file instead");
    }
    out.write(std::as_bytes(std::span(&value, 1)));
  }
}

}  // namespace

void write_ply(OutputFile& out, const PointTable& table) {
  out.write(header(table));
  if (stored_as_is(table)) return out.write(table.bytes);
  for (std::size_t row = 0; row < table.rows; ++row) write_row(out, table, row);
}

}  // namespace scenelore::perception
