// Simulated rooms, perceived and stored: what learning and evaluation work on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/evaluation.hpp"
#include "pipeline/pipeline.hpp"
#include "simulator/simulate.hpp"

namespace scenelore::experiment {

struct Room {
  simulator::SimulatedScan scan;
  kb::Scan record;
  std::vector<kb::StoredPlane> planes;  ///< with ids 1, 2, …
  evaluation::SceneTruth objects;       ///< one each of scan.objects, in their order
  std::vector<std::int32_t> plane_of_point;
  std::vector<evaluation::PlaneTruth> truth;  ///< one a plane
};

/// Simulates and segments one room after another on `threads` threads; the result does not depend on them.
/// `up_error_deg` > 0: instead of estimating up, perception is told a direction that is off by 0 to that much, differently in
/// each room. Real cameras bend planes and tilt what they see in ways that the simulator does not.
[[nodiscard]] std::vector<Room> perceive_rooms(const std::vector<simulator::SimulationOptions>& rooms, int threads = 2,
                                               double up_error_deg = 0);

/// One class a plane.
struct Labelling {
  evaluation::Answer before;  ///< of the highest evidence alone
  evaluation::Answer after;   ///< of the best world model
  kb::Run run;
  double seconds = 0;  ///< from features to labels, without relations
};

/// A room with everything that labels need but knowledge that may change: features, and facts of relations.
struct Situation {
  Room room;
  rules::Scene scene;
  rules::Facts facts;
  double relate_seconds = 0;
};
[[nodiscard]] Situation assess(Room room, const std::vector<std::string>& relations, rules::RuleSet& rules);
[[nodiscard]] Labelling label(const kb::Knowledge& knowledge, const Situation& situation);
/// Classes of the best world alone, without margins and probabilities, which take most of the time.
[[nodiscard]] std::vector<std::string> best_classes(const kb::Knowledge& knowledge, const Situation& situation);

/// Labels planes without a file in between.
[[nodiscard]] Labelling label_planes(const kb::Knowledge& knowledge, rules::RuleSet& rules, const kb::Scan& record,
                                     const std::vector<kb::StoredPlane>& planes);

/// The knowledge of a pack ("office", "paper").
[[nodiscard]] kb::Knowledge knowledge_pack(const std::string& name);

/// Planes as the knowledge base would hand them out, with ids 1, 2, …
[[nodiscard]] std::vector<kb::StoredPlane> stored(const std::vector<perception::Plane>& planes);

}  // namespace scenelore::experiment
