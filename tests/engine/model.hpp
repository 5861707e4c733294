// Every answer of the engine about one small problem, beside the enumeration of all its assignments.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "random_problem.hpp"

namespace scenelore::engine::testing {

/// Empty when all answers are right, else a sentence about the first one that is not. `largest` is the scale of the costs.
std::string what_is_wrong(const Problem& problem, double largest);

/// The shapes of random problems that are tried in turn.
const std::vector<std::pair<std::string, Shape>>& shapes();

/// Looks at the random problem of a number. Empty when all is well, else what is wrong with it, and the smallest problem
/// that was found on which something is wrong, as a .cfn file.
std::string report(std::uint64_t number);

}  // namespace scenelore::engine::testing
