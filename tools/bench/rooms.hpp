// Simulated rooms, perceived and stored: what learning and evaluation work on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/truth.hpp"
#include "pipeline/pipeline.hpp"
#include "simulator/simulate.hpp"

namespace scenelore::experiment {

struct Room {
  simulator::SimulatedScan scan;
  kb::Scan record;
  std::vector<kb::StoredPlane> planes;  ///< with ids 1, 2, …
  std::vector<PlaneTruth> truth;        ///< one a plane
};

/// Simulates and segments one room after another on `threads` threads; the result does not depend on them.
/// `up_error_deg` > 0: instead of estimating up, perception is told a direction that is off by 0 to that much, differently in
/// each room. Real cameras bend planes and tilt what they see in ways that the simulator does not.
[[nodiscard]] std::vector<Room> perceive_rooms(const std::vector<simulator::SimulationOptions>& rooms, int threads = 2,
                                               double up_error_deg = 0);

/// Class names, one a plane.
struct Labelling {
  std::vector<std::string> before;  ///< of the highest evidence alone
  std::vector<std::string> after;   ///< of the best world model
  kb::Run run;
};

/// Labels planes without a file in between.
[[nodiscard]] Labelling label_planes(const kb::Knowledge& knowledge, rules::RuleSet& rules, const kb::Scan& record,
                                     const std::vector<kb::StoredPlane>& planes);

/// The knowledge of a pack ("office", "paper").
[[nodiscard]] kb::Knowledge knowledge_pack(const std::string& name);

/// Planes as the knowledge base would hand them out, with ids 1, 2, …
[[nodiscard]] std::vector<kb::StoredPlane> stored(const std::vector<perception::Plane>& planes);

}  // namespace scenelore::experiment
