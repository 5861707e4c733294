// From a problem on which something goes wrong to a small one on which it still does.
#pragma once

#include <functional>

#include "scenelore/engine/problem.hpp"

namespace scenelore::engine::testing {

/// Takes away constraints, variables, labels, supports and literals, and makes costs and weights plain (0, 1, whole),
/// one at a time, as long as `fails` says true of what is left. `fails(problem)` must be true at the start.
Problem shrink(const Problem& problem, const std::function<bool(const Problem&)>& fails);

}  // namespace scenelore::engine::testing
