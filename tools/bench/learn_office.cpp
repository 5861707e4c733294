// Learns the default priors and densities from simulated rooms and prints them as SQL (schemas/knowledge/office_learned.sql).
// Usage: learn_office [SETS]
// The rooms are the paper-like sets of seeds 1 to SETS; tests and reported figures use seeds from 5001 on.
#include <fmt/core.h>

#include <cstdlib>

#include "bench/rooms.hpp"
#include "scenelore/kb/learn.hpp"

namespace {

using namespace scenelore;

/// A plane that shows less than this share of its object's visible points is a scrap, which teaches nothing about sizes.
constexpr double kWholeEnough = 0.3;

/// Adds a room's planes with their features, built-in and Lua ones, and their true classes ("" for scraps).
void add_room(const experiment::Room& room, rules::RuleSet& rules, kb::LabelledPlanes& planes) {
  rules::Scene scene = rules::make_scene(room.record, room.planes, kb::built_in_features(room.record, room.planes));
  rules.compute_features(scene, scene.features);
  planes.features.names = scene.features.names;
  for (std::size_t i = 0; i < room.planes.size(); ++i) {
    const experiment::PlaneTruth& truth = room.truth[i];
    const bool scrap = truth.object_class != "unknown" && truth.coverage < kWholeEnough;
    planes.features.values.push_back(scene.features.values[i]);
    planes.classes.push_back(scrap ? "" : truth.object_class);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int sets = argc > 1 ? std::atoi(argv[1]) : 10;
  rules::RuleSet rules = rules::RuleSet::load();
  const kb::Knowledge knowledge = experiment::knowledge_pack("office");
  kb::LabelledPlanes planes;
  for (int seed = 1; seed <= sets; ++seed) {
    for (const experiment::Room& room : experiment::perceive_rooms(simulator::paper_rooms(static_cast<std::uint64_t>(seed)))) {
      add_room(room, rules, planes);
    }
    fmt::print(stderr, "set {} of {}: {} planes so far\n", seed, sets, planes.classes.size());
  }
  const kb::LearnedRows rows = kb::learn(knowledge, planes);
  for (const std::string& note : rows.notes) fmt::print(stderr, "{}\n", note);
  fmt::print("-- Learned by `make knowledge` from {} planes of {} simulated paper-like rooms, seeds 1 to {}, range noise 1 cm.\n"
             "-- Priors, Gaussians and densities of classes with enough examples replace the hand-set rows of office.sql.\n{}",
             planes.classes.size(), 6 * sets, sets, kb::to_sql(rows));
  return 0;
}
