// The best assignment of what is left of a network by dynamic programming, without any branch: variables are eliminated one
// by one, the one that needs the smallest table first, which is a tree decomposition of the graph (Dechter, "Bucket
// elimination", Artificial Intelligence 1999).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cost.hpp"
#include "residual.hpp"

namespace scenelore::engine {

struct TreeSolution {
  Cost cost = 0;            ///< with the residual's constant; forbidden: there is no assignment
  std::vector<int> labels;  ///< of each variable of the residual, a place among its labels
};

/// Nothing when the tables would have more than `most` entries together.
std::optional<TreeSolution> solve_by_elimination(const Residual& residual, std::size_t most);

}  // namespace scenelore::engine
