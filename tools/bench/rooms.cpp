#include "bench/rooms.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <map>
#include <thread>

#include "scenelore/perception/perceive.hpp"

namespace scenelore::experiment {

namespace {

Room perceive_room(const simulator::SimulationOptions& options) {
  Room room;
  room.scan = simulator::simulate(options);
  const perception::Cloud cloud = perception::to_cloud(room.scan.points, "simulated room");
  const perception::Perception seen = perception::perceive(cloud, {.threads = 1});
  room.record = {.name = "room", .rotation = seen.upright.rotation, .floor_z = seen.upright.floor_z};
  room.planes = stored(seen.planes);
  room.truth = plane_truth(room.scan, seen.plane_of_point, seen.planes.size());
  room.scan.points.bytes = {};  // the points are not needed any more, and a hundred rooms of them fill the memory
  return room;
}

}  // namespace

std::vector<Room> perceive_rooms(const std::vector<simulator::SimulationOptions>& rooms, int threads) {
  std::vector<Room> out(rooms.size());
  std::atomic<std::size_t> next{0};
  std::vector<std::jthread> workers;
  for (int t = 0; t < threads; ++t) {
    workers.emplace_back([&] {
      for (std::size_t i = next++; i < rooms.size(); i = next++) out[i] = perceive_room(rooms[i]);
    });
  }
  workers.clear();
  return out;
}

Labelling label_planes(const kb::Knowledge& knowledge, rules::RuleSet& rules, const kb::Scan& record,
                       const std::vector<kb::StoredPlane>& planes) {
  rules::Scene scene = rules::make_scene(record, planes, kb::built_in_features(record, planes));
  rules.compute_features(scene, scene.features);
  const auto evidence = kb::preclassify(knowledge, scene.features);
  const rules::Facts facts = rules.relate(scene, rules::used_relations(knowledge, rules));
  const kb::Inference inference = rules::label(knowledge, scene, evidence, facts, {}, {.alternatives = 0});

  std::map<kb::PlaneId, std::string> label;
  for (const kb::Label& entry : inference.labels) label[entry.plane] = entry.object_class;
  Labelling out{.before = {}, .after = {}, .run = inference.run};
  for (const kb::StoredPlane& plane : planes) out.after.push_back(label[plane.id]);
  for (const auto& row : evidence) {
    out.before.push_back(knowledge.classes[static_cast<std::size_t>(std::max_element(row.begin(), row.end()) - row.begin())].name);
  }
  return out;
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
