// What it costs to change one label of a world and leave all others as they are.
#pragma once

#include <span>
#include <vector>

#include "scenelore/engine/problem.hpp"

namespace scenelore::rules {

/// [variable][label]: cost of the world with that one label changed, less the world's own; infinite where a hard
/// constraint breaks. The world's own labels have 0. `assignment` must be valid, and no variable both
/// condition (or requiring literal) and counted (or support) in one constraint, as compile never makes it.
[[nodiscard]] std::vector<std::vector<double>> flip_costs(const engine::Problem& problem,
                                                          const std::vector<int>& assignment);

/// What some of the constraints alone add to that.
[[nodiscard]] std::vector<std::vector<double>> flip_costs(const engine::Problem& problem, const std::vector<int>& assignment,
                                                          std::span<const int> constraints);

}  // namespace scenelore::rules
