// Real scans with labels: which labelled instances carry the right class. Usage: real_scans FOLDER…
// A folder holds scans `*.ply` with columns label and instance; `labels.txt` beside or above it names the label ids.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "bench/rooms.hpp"

namespace {

using namespace scenelore;
namespace fs = std::filesystem;

/// Classes of ours that are right for a label of the data.
const std::map<std::string, std::vector<std::string>> kRightClasses{
    {"wall", {"wall"}},         {"floor", {"floor"}},       {"ceiling", {"ceiling"}},
    {"table", {"table"}},       {"desk", {"table"}},        {"chair", {"chair_seat", "chair_back"}},
    {"monitor", {"flat_screen"}}, {"tv", {"flat_screen"}},  {"keyboard", {"keyboard"}},
    {"door", {"door"}},         {"window", {"window"}},     {"whiteboard", {"whiteboard"}},
    {"bookshelf", {"shelf"}},   {"cabinet", {"cabinet"}},   {"partition", {"wall", "cabinet"}}};

struct Instance {
  int label = 0;
  std::size_t points = 0;
  std::map<std::string, std::size_t> classes;  ///< points by the class of the plane they are on; "" = no plane
};

std::map<int, std::string> label_names(fs::path folder) {
  std::map<int, std::string> names;
  for (; !folder.empty() && folder != folder.root_path(); folder = folder.parent_path()) {
    std::ifstream file(folder / "labels.txt");
    int id = 0;
    std::string name;
    while (file >> id >> name) names[id] = name;
    if (!names.empty()) return names;
  }
  return names;
}

std::map<int, Instance> instances(const perception::PointTable& points, const std::vector<std::int32_t>& plane_of_point,
                                  const std::vector<std::string>& labels) {
  std::map<int, Instance> out;
  const perception::Column* label = points.find("label");
  const perception::Column* instance = points.find("instance");
  if (!label || !instance) return out;
  for (std::size_t i = 0; i < points.rows; ++i) {
    const int id = static_cast<int>(points.value(*instance, i));
    if (id <= 0) continue;
    Instance& entry = out[id];
    entry.label = static_cast<int>(points.value(*label, i));
    ++entry.points;
    ++entry.classes[plane_of_point[i] < 0 ? "" : labels[static_cast<std::size_t>(plane_of_point[i])]];
  }
  return out;
}

void report(const fs::path& path, const kb::Knowledge& knowledge, rules::RuleSet& rules, int& right, int& wanted) {
  const auto start = std::chrono::steady_clock::now();
  const perception::PointTable points = perception::read_points(path);
  const perception::Perception seen = perception::perceive(perception::to_cloud(points, path.string()));
  const kb::Scan record{.name = "scan", .rotation = seen.upright.rotation, .floor_z = seen.upright.floor_z};
  const experiment::Labelling labelling = experiment::label_planes(knowledge, rules, record, experiment::stored(seen.planes));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  std::map<std::string, int> count;
  for (const std::string& name : labelling.after.classes) ++count[name];
  fmt::print("\n{}: {} points, {} planes, {} in {:.2f} s\n  {}\n ", path.stem().string(), points.rows, seen.planes.size(),
             labelling.run.outcome, seconds, seen.upright.explanation);
  for (const auto& [name, planes] : count) fmt::print(" {} {}", planes, name);
  fmt::print("\n");

  const auto names = label_names(path.parent_path());
  for (const auto& [id, instance] : instances(points, seen.plane_of_point, labelling.after.classes)) {
    const auto name = names.find(instance.label);
    if (name == names.end() || !kRightClasses.contains(name->second) || instance.points < 100) continue;
    const auto& accepted = kRightClasses.at(name->second);
    std::size_t good = 0;
    std::string all;
    for (const auto& [object_class, n] : instance.classes) {
      if (std::find(accepted.begin(), accepted.end(), object_class) != accepted.end()) good += n;
      if (n * 20 > instance.points) all += fmt::format(" {}:{}%", object_class.empty() ? "-" : object_class, 100 * n / instance.points);
    }
    const bool ok = 2 * good >= instance.points;
    ++wanted;
    right += ok;
    fmt::print("  {} {:<11} {:>6} points:{}\n", ok ? "ok  " : "MISS", name->second, instance.points, all);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto missing = std::find_if_not(argv + 1, argv + argc, [](const char* folder) { return fs::is_directory(folder); });
  if (argc < 2 || missing != argv + argc) {
    if (argc > 1) fmt::print(stderr, "{}: there is no such folder\n", *missing);
    fmt::print(stderr, "usage: real_scans FOLDER…    folders of labelled .ply files\n");
    return 2;
  }
  rules::RuleSet rules = rules::RuleSet::load();
  const kb::Knowledge knowledge = experiment::knowledge_pack("office");
  std::vector<fs::path> scans;
  for (int i = 1; i < argc; ++i) {
    for (const auto& entry : fs::recursive_directory_iterator(argv[i])) {
      if (entry.path().extension() == ".ply") scans.push_back(entry.path());
    }
  }
  std::sort(scans.begin(), scans.end());
  int right = 0, wanted = 0;
  for (const fs::path& scan : scans) report(scan, knowledge, rules, right, wanted);
  fmt::print("\n{} of {} labelled instances have the right class on at least half of their points\n", right, wanted);
  return 0;
}
