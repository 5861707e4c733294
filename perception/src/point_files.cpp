#include <algorithm>
#include <cctype>

#include "formats.hpp"
#include "lines.hpp"
#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void check_columns(const std::string& name, const PointTable& table) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string& column = table.columns[i].name;
    if (column.empty() || column.find_first_of(" \t\r\n\v\f,") != std::string::npos) {
      throw Error(name + ": '" + printable(column) + "' cannot name a column in a point file (blank, comma or nothing)");
    }
    if (table.find(column) != &table.columns[i]) throw Error(name + ": two columns are named '" + printable(column) + "'");
  }
}

}  // namespace

PointTable read_points(const std::filesystem::path& path) {
  const MappedFile file(path);
  const std::string name = path.string();
  if (file.bytes().empty()) throw Error(name + " is empty");
  if (looks_like_ply(file.text()) || lower_extension(path) == ".ply") return read_ply(file, name);
  throw Error(name + " is not a PLY, PCD or text point file");
}

void write_points(const std::filesystem::path& path, const PointTable& table) {
  const std::string extension = lower_extension(path), name = path.string();
  check_columns(name, table);
  const auto writer = extension == ".ply" ? &write_ply : nullptr;
  if (writer == nullptr) throw Error(name + ": the name must end in .ply, .pcd or .csv to tell the format");
  OutputFile out(path);
  writer(out, table);
  out.commit();
}

}  // namespace scenelore::perception
