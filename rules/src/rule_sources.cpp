#include "rule_sources.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "lua_files.hpp"

namespace scenelore::rules {

bool is_test_name(std::string_view name) { return name.ends_with("_test.lua"); }

bool is_built_in(const RuleSource& source) {
  const auto files = lua_files();
  return std::any_of(files.begin(), files.end(), [&](const EmbeddedFile& file) { return file.name == source.shown; });
}

std::vector<RuleSource> built_in_sources() {
  std::vector<RuleSource> out;
  for (const EmbeddedFile& file : lua_files()) {
    if (file.name.starts_with("rules/lua/") || is_test_name(file.name)) continue;
    out.push_back({std::string(file.name), std::string(file.text)});
  }
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.shown < b.shown; });
  return out;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw Error(path.string() + ": cannot be read");
  return text;
}

std::vector<RuleSource> sources_below(const std::filesystem::path& directory, bool with_tests) {
  std::error_code error;
  if (!std::filesystem::is_directory(directory, error)) {
    throw Error(directory.string() + ": is not a folder; rules are the *.lua files of a folder");
  }
  std::vector<std::filesystem::path> paths;
  for (std::filesystem::recursive_directory_iterator entry(directory, error), end; entry != end; entry.increment(error)) {
    if (error) break;
    if (entry->path().filename().string().starts_with('.')) {  // what editors keep beside the rules
      if (entry->is_directory(error)) entry.disable_recursion_pending();
      continue;
    }
    if (entry->is_regular_file(error) && entry->path().extension() == ".lua") paths.push_back(entry->path());
  }
  if (error) throw Error(directory.string() + ": cannot be read: " + error.message());
  std::sort(paths.begin(), paths.end());
  std::vector<RuleSource> out;
  for (const std::filesystem::path& path : paths) {
    if (with_tests || !is_test_name(path.filename().string())) out.push_back({path.string(), read_text(path)});
  }
  return out;
}

}  // namespace scenelore::rules
