#include <algorithm>
#include <cctype>

#include "formats.hpp"
#include "lines.hpp"
#include "rows_to_cloud.hpp"
#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void check_columns(const std::string& name, const PointTable& table) {
  if (table.columns.empty()) throw Error(name + ": a point file needs at least one column");
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string& column = table.columns[i].name;
    if (column.empty() || column.find_first_of(" \t\r\n\v\f,") != std::string::npos) {
      throw Error(name + ": '" + printable(column) +
                  "' cannot name a column in a point file (blank, comma or nothing)");
    }
    if (table.find(column) != &table.columns[i])
      throw Error(name + ": two columns are named '" + printable(column) + "'");
  }
}

/// Formats that are often tried and that we can at least name.
const char* foreign_format(std::string_view text) {
  if (text.starts_with("LASF")) return "a LAS or LAZ";
  if (text.starts_with("ASTM-E57")) return "an E57";
  if (text.starts_with("PK\x03\x04")) return "a zip";
  if (text.starts_with("\x1f\x8b")) return "a gzip";
  return nullptr;
}

bool is_text_name(const std::string& extension) {
  const auto known = {".xyz", ".txt", ".csv", ".asc", ".pts", ".xyzrgb", ".xyzi", ".tsv"};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

}  // namespace

namespace {

PointTable read_table(const MappedFile& file, const std::filesystem::path& path, std::optional<std::size_t>* rows_at) {
  const std::string name = path.string(), extension = lower_extension(path);
  const std::string_view text = file.text();
  if (text.empty()) throw Error(name + " is empty");
  if (looks_like_ply(text)) return read_ply(file, name, rows_at);
  if (looks_like_pcd(text)) return read_pcd(file, name, rows_at);
  if (const char* const format = foreign_format(text)) {
    throw Error(name + " is " + format +
                " file; PLY, PCD and text point files can be read: convert it, for instance with CloudCompare");
  }
  if (extension == ".ply") return read_ply(file, name, rows_at);
  if (extension == ".pcd") return read_pcd(file, name, rows_at);
  const bool binary = text.substr(0, 4096).find('\0') != std::string_view::npos;
  if (!binary && (is_text_name(extension) || looks_like_text(text))) return read_text(file, name);
  throw Error(name + " is not a PLY, PCD or text point file");
}

}  // namespace

PointTable read_points(const std::filesystem::path& path) { return read_table(MappedFile(path), path, nullptr); }

Cloud read_cloud(const std::filesystem::path& path, int threads) {
  const MappedFile file(path);
  std::optional<std::size_t> rows_at;
  const PointTable table = read_table(file, path, &rows_at);
  const std::string name = path.string();
  if (!rows_at) return to_cloud({.table = table, .bytes = table.bytes.data(), .file = nullptr}, name, threads);
  return to_cloud({.table = table, .bytes = file.bytes().data() + *rows_at, .file = &file}, name, threads);
}

void write_points(const std::filesystem::path& path, const PointTable& table) {
  const std::string extension = lower_extension(path), name = path.string();
  check_columns(name, table);
  const auto writer = extension == ".ply"   ? &write_ply
                      : extension == ".pcd" ? &write_pcd
                      : extension == ".csv" ? &write_csv
                                            : nullptr;
  if (writer == nullptr) throw Error(name + ": the name must end in .ply, .pcd or .csv to tell the format");
  OutputFile out(path);
  writer(out, table);
  out.commit();
}

}  // namespace scenelore::perception
