#include "bench/rooms.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <thread>

#include "evaluation/stored_scan.hpp"
#include "scenelore/perception/perceive.hpp"

namespace scenelore::experiment {

namespace {

/// Directions off z by 0 to `most` radians; the golden ratio spreads seeds evenly.
Eigen::Vector3d tilted_up(std::uint64_t seed, double most) {
  const auto spread = [seed](double factor) { return std::fmod(static_cast<double>(seed) * factor, 1.0); };
  const double angle = most * spread(0.6180339887), around = 2 * std::numbers::pi * spread(0.7548776662);
  return {std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around), std::cos(angle)};
}

evaluation::SceneTruth truth_of(const simulator::SimulatedScan& scan) {
  evaluation::SceneTruth truth;
  std::map<int, std::int32_t> index;
  for (const simulator::TruthObject& object : scan.objects) {
    index[object.instance] = static_cast<std::int32_t>(truth.objects.size());
    truth.objects.push_back({.instance = object.instance, .classes = {object.object_class}, .planar = object.planar, .points = object.points});
  }
  const perception::Column* instance = scan.points.find("instance");
  truth.object_of_point.reserve(scan.points.rows);
  for (std::size_t i = 0; i < scan.points.rows; ++i) {
    const auto found = index.find(static_cast<int>(scan.points.value(*instance, i)));
    truth.object_of_point.push_back(found == index.end() ? evaluation::kNothing : found->second);
  }
  return truth;
}

Room perceive_room(const simulator::SimulationOptions& options, double up_error_deg) {
  Room room;
  room.scan = simulator::simulate(options);
  const perception::Cloud cloud = perception::to_cloud(room.scan.points, "simulated room");
  perception::PerceptionOptions how{.threads = 1};
  if (up_error_deg > 0) how.up = tilted_up(options.seed, up_error_deg * std::numbers::pi / 180);
  const perception::Perception seen = perception::perceive(cloud, how);
  room.record = {.name = "room", .rotation = seen.upright.rotation, .floor_z = seen.upright.floor_z};
  room.planes = stored(seen.planes);
  room.objects = truth_of(room.scan);
  room.plane_of_point = seen.plane_of_point;
  room.truth = evaluation::plane_truth(room.objects, room.plane_of_point, seen.planes.size(), "unknown");
  room.scan.points.bytes = {};  // the points are not needed any more, and a hundred rooms of them fill the memory
  return room;
}

}  // namespace

std::vector<Room> perceive_rooms(const std::vector<simulator::SimulationOptions>& rooms, int threads, double up_error_deg) {
  std::vector<Room> out(rooms.size());
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> workers;
  for (int t = 0; t < threads; ++t) {
    workers.emplace_back([&] {
      for (std::size_t i = next++; i < rooms.size(); i = next++) out[i] = perceive_room(rooms[i], up_error_deg);
    });
  }
  workers.clear();
  return out;
}

Situation assess(Room room, const std::vector<std::string>& relations, rules::RuleSet& rules) {
  Situation out{.room = std::move(room), .scene = {}, .facts = {}};
  out.scene = rules::make_scene(out.room.record, out.room.planes, kb::built_in_features(out.room.record, out.room.planes));
  rules.compute_features(out.scene, out.scene.features);
  const auto start = std::chrono::steady_clock::now();
  out.facts = rules.relate(out.scene, relations);
  out.relate_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return out;
}

Labelling label(const kb::Knowledge& knowledge, const Situation& situation) {
  const auto start = std::chrono::steady_clock::now();
  const auto evidence = kb::preclassify(knowledge, situation.scene.features);
  const kb::Inference inference =
      rules::label(knowledge, situation.scene, evidence, situation.facts, {}, {.alternatives = 0, .reasons = false});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return {.before = evaluation::answer_before(knowledge, evidence),
          .after = evaluation::answer_after(situation.scene.ids, inference.labels),
          .run = inference.run,
          .seconds = seconds};
}

std::vector<std::string> best_classes(const kb::Knowledge& knowledge, const Situation& situation) {
  const auto evidence = kb::preclassify(knowledge, situation.scene.features);
  const rules::LabellingProblem compiled = rules::compile(knowledge, situation.scene, evidence, situation.facts, {});
  const engine::Solution best = engine::Solver(compiled.problem, {.limits = {.seconds = 5}}).solve();
  std::vector<std::string> out;
  for (const int variable : compiled.variable_of_plane) {
    const auto v = static_cast<std::size_t>(variable);
    const auto label = static_cast<std::size_t>(best.assignment.at(v));
    out.push_back(knowledge.classes[static_cast<std::size_t>(compiled.class_of_label[v][label])].name);
  }
  return out;
}

Labelling label_planes(const kb::Knowledge& knowledge, rules::RuleSet& rules, const kb::Scan& record,
                       const std::vector<kb::StoredPlane>& planes) {
  return label(knowledge, assess({.scan = {}, .record = record, .planes = planes, .objects = {}, .plane_of_point = {}, .truth = {}},
                                 rules::used_relations(knowledge, rules), rules));
}

kb::Knowledge knowledge_pack(const std::string& name) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("scenelore_" + name + "_" + std::to_string(getpid()) + ".gpkg");
  const kb::Knowledge knowledge = kb::KnowledgeBase::create(file, name).knowledge();
  std::filesystem::remove(file);
  return knowledge;
}

std::vector<kb::StoredPlane> stored(const std::vector<perception::Plane>& planes) {
  std::vector<kb::StoredPlane> out;
  for (const perception::Plane& plane : planes) out.push_back({static_cast<kb::PlaneId>(out.size() + 1), plane});
  return out;
}

}  // namespace scenelore::experiment
