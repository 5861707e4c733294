#include "evaluation/class_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <span>
#include <sstream>

#include <scenelore/embedded_file.hpp>
#include "evaluation/error.hpp"
#include "scenelore/kb/suggest.hpp"

namespace scenelore::evaluation {

std::span<const EmbeddedFile> class_map_files();

namespace {

namespace fs = std::filesystem;

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw Error(fmt::format("{}: cannot be read", file.string()));
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

ClassMap parse_class_map(const std::string& text, const std::string& source, const std::vector<std::string>& classes) {
  ClassMap map;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line = line.substr(0, line.find('#'));
    if (words(line).empty()) continue;
    const std::size_t equals = line.find('=');
    const std::vector<std::string> label = words(line.substr(0, equals));
    std::vector<std::string> right = equals == std::string::npos ? std::vector<std::string>{} : words(line.substr(equals + 1));
    const std::string where = fmt::format("{}:{}: ", source, number);
    if (label.size() != 1 || right.empty()) {
      throw Error(where + "a line must be `label = class class…`, or `label = -` for one that is not judged");
    }
    if (right.size() == 1 && right[0] == "-") right.clear();
    for (const std::string& name : right) {
      if (std::find(classes.begin(), classes.end(), name) != classes.end()) continue;
      throw Error(where + fmt::format("class '{}' does not exist in the knowledge base{}", name, kb::did_you_mean(name, classes)));
    }
    if (!map.emplace(label[0], std::move(right)).second) throw Error(where + fmt::format("label '{}' comes twice", label[0]));
  }
  return map;
}

ClassMap read_class_map(const std::string& name, const std::vector<std::string>& classes) {
  if (fs::exists(name)) return parse_class_map(text_of(name), name, classes);
  std::string known;
  for (const EmbeddedFile& file : class_map_files()) {
    const std::string stem = fs::path(file.name).stem().string();
    if (stem == name) return parse_class_map(std::string(file.text), name, classes);
    known += (known.empty() ? "" : ", ") + stem;
  }
  throw Error(fmt::format("there is no class map '{}': give a file, or one that comes with the program ({})", name, known));
}

std::map<int, std::string> read_label_names(const fs::path& file) {
  std::map<int, std::string> names;
  std::istringstream lines(text_of(file));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (words(line).empty()) continue;
    std::istringstream fields(line);
    int id = 0;
    std::string name, more;
    if (!(fields >> id >> name) || fields >> more || !names.emplace(id, name).second) {
      throw Error(fmt::format("{}:{}: a line must be `id name`, each id once", file.string(), number));
    }
  }
  return names;
}

fs::path find_label_names(const fs::path& file) {
  fs::path folder = fs::absolute(file).parent_path();
  for (;; folder = folder.parent_path()) {
    if (fs::exists(folder / "labels.txt")) return folder / "labels.txt";
    if (folder == folder.root_path()) return {};
  }
}

}  // namespace scenelore::evaluation
