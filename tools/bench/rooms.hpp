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
[[nodiscard]] std::vector<Room> perceive_rooms(const std::vector<simulator::SimulationOptions>& rooms, int threads = 2);

}  // namespace scenelore::experiment
