// What relations cost: a call into Lua beyond its geometry, and whole buildings of equal rooms with every built-in relation.
// Usage: rules_bench. Prints CPU time of one thread, which asks them all.
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "bench/rooms.hpp"
#include "scenelore/rules/made_plane.hpp"
#include "scenelore/rules/rule_set.hpp"

namespace {

using namespace scenelore;
namespace fs = std::filesystem;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Three lines of judgement, no geometry: what remains is the way from C++ into Lua and back.
constexpr const char* kThreeLines =
    "return relation { api = 1, name = 'three_lines', summary = 'a is a little higher than b', full = 0.02, none = 0.1,\n"
    "  degree = function(a, b, r)\n"
    "    local step = a.height - b.height\n"
    "    if step < 0 then return 0 end\n"
    "    return falloff(step, r.full, r.none)\n"
    "  end }";

/// `rooms` copies of a room on a square grid; planes are moved, nothing else.
rules::Scene grid(const std::vector<perception::Plane>& room, int rooms, double spacing) {
  rules::Scene out;
  const int side = static_cast<int>(std::ceil(std::sqrt(rooms)));
  for (int r = 0; r < rooms; ++r) {
    const Eigen::Vector3d shift(spacing * (r % side), spacing * (r / side), 0);
    for (perception::Plane plane : room) {
      plane.centroid += shift;
      for (Eigen::Vector3d& corner : plane.hull.outer) corner += shift;
      for (perception::Ring& hole : plane.hull.holes) {
        for (Eigen::Vector3d& corner : hole) corner += shift;
      }
      out.planes.push_back(std::move(plane));
      out.ids.push_back(static_cast<kb::PlaneId>(out.ids.size() + 1));
    }
  }
  return out;
}

/// Twenty rectangles: floor, ceiling, walls, four desks with screen and keyboard, a chair.
std::vector<perception::Plane> made_up_room() {
  std::mt19937 random(4);
  const auto uniform = [&](double low, double high) { return low + (high - low) * static_cast<double>(random() % 1000) / 1000; };
  std::vector<rules::MadePlane> made{{.center = {0, 0, 0}, .length = 5.8, .width = 4.8}, {.center = {0, 0, 2.6}, .length = 5.8, .width = 4.8}};
  for (const double s : {-1.0, 1.0}) {
    made.push_back({.center = {0, 2.4 * s, 1.3}, .normal = {0, -s, 0}, .length = 5.8, .width = 2.6});
    made.push_back({.center = {2.9 * s, 0, 1.3}, .normal = {-s, 0, 0}, .length = 4.8, .width = 2.6});
  }
  for (int i = 0; i < 4; ++i) {
    const double x = uniform(-2, 2), y = uniform(-1.5, 1.5);
    made.push_back({.center = {x, y, 0.74}, .length = 1.6, .width = 0.8});
    made.push_back({.center = {x, y + 0.2, 1.05}, .normal = {0, -1, 0.05}, .length = 0.5, .width = 0.35});
    made.push_back({.center = {x, y - 0.1, 0.76}, .length = 0.45, .width = 0.15});
  }
  made.push_back({.center = {1, 1, 0.45}, .length = 0.4, .width = 0.4});
  made.push_back({.center = {1, 1.2, 0.8}, .normal = {0, 1, 0}, .length = 0.4, .width = 0.4});
  return rules::make_scene(made).planes;
}

std::vector<std::string> names_of(const rules::RuleSet& rules) {
  std::vector<std::string> names;
  for (const rules::RelationInfo& relation : rules.relations()) names.push_back(relation.name);
  return names;
}

void time_call() {
  const fs::path folder = fs::temp_directory_path() / ("scenelore_rules_" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "three_lines.lua") << kThreeLines;
  rules::RuleSet rules = rules::RuleSet::load({folder});
  fs::remove_all(folder);
  const rules::Scene scene = grid(made_up_room(), 25, 6);
  std::vector<double> per_call;
  for (int run = 0; run < 5; ++run) {
    const double start = cpu_seconds();
    const rules::Facts facts = rules.relate(scene, {"three_lines"});
    per_call.push_back(1e6 * (cpu_seconds() - start) / static_cast<double>(facts.counts.at(0).asked));
  }
  std::sort(per_call.begin(), per_call.end());
  fmt::print("a relation of three lines: {:.2f} us a call (median of 5 runs of {} calls)\n\n", per_call[2],
             scene.planes.size() * (scene.planes.size() - 1));
}

void time_building(const char* what, const std::vector<perception::Plane>& room, double spacing) {
  fmt::print("{}\n{:>8} {:>12} {:>10} {:>8}\n", what, "planes", "pairs asked", "a plane", "CPU s");
  for (const int planes : {250, 500, 1000, 2000}) {
    const rules::Scene scene = grid(room, std::max(1, planes / static_cast<int>(room.size())), spacing);
    rules::RuleSet rules = rules::RuleSet::load();
    const std::vector<std::string> names = names_of(rules);
    const double start = cpu_seconds();
    std::int64_t asked = 0;
    for (const rules::RelationCount& count : rules.relate(scene, names, {}, 1).counts) asked += count.asked;
    const double seconds = cpu_seconds() - start;
    fmt::print("{:>8} {:>12} {:>10.1f} {:>8.2f}\n", scene.planes.size(), asked, static_cast<double>(asked) / static_cast<double>(scene.planes.size()), seconds);
  }
  fmt::print("\n");
}

}  // namespace

int main() {
  time_call();
  time_building("every built-in relation, equal made-up rooms of 20 rectangles", made_up_room(), 6);
  const experiment::Room room = experiment::perceive_rooms({{.seed = 7}}, 1).front();
  const rules::Scene measured = rules::make_scene(room.record, room.planes, kb::built_in_features(room.record, room.planes));
  time_building("every built-in relation, copies of simulated room 7 with the outlines that segmentation found", measured.planes, 9);
  return 0;
}
