#include "bytes.hpp"
#include "formats.hpp"

namespace scenelore::perception {
namespace {

char type_letter(ScalarType type) {
  switch (type) {
    case ScalarType::f32:
    case ScalarType::f64:
      return 'F';
    case ScalarType::i8:
    case ScalarType::i16:
    case ScalarType::i32:
    case ScalarType::i64:
      return 'I';
    default:
      return 'U';
  }
}

std::string header(const PointTable& table) {
  std::string text = "# .PCD v0.7 - Point Cloud Data file format\n";
  for (const std::string& comment : table.comments) text += "# " + one_line(comment) + "\n";
  std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
  for (const Column& column : table.columns) {
    fields += " " + column.name;
    sizes += " " + std::to_string(size_of(column.type));
    types += std::string(" ") + type_letter(column.type);
    counts += " 1";
  }
  const Eigen::Vector3d v = table.viewpoint.value_or(Eigen::Vector3d::Zero());
  const std::string rows = std::to_string(table.rows);
  return text + "VERSION 0.7\n" + fields + "\n" + sizes + "\n" + types + "\n" + counts + "\nWIDTH " + rows +
         "\nHEIGHT 1\nVIEWPOINT " + shortest(v.x()) + " " + shortest(v.y()) + " " + shortest(v.z()) +
         " 1 0 0 0\nPOINTS " + rows + "\nDATA binary\n";
}

}  // namespace

void write_pcd(OutputFile& out, const PointTable& table) {
  out.write(header(table));
  if (is_packed(table)) return out.write(table.bytes);
  for (std::size_t row = 0; row < table.rows; ++row) {
    for (const Column& column : table.columns) {
      out.write(std::span(table.bytes.data() + row * table.stride + column.offset, size_of(column.type)));
    }
  }
}

}  // namespace scenelore::perception
