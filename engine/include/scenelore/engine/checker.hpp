// A second, simple opinion: recomputes cost and constraints of an assignment straight from the problem.
#pragma once

#include <vector>

#include "scenelore/engine/problem.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {

struct Check {
  bool valid = false;                 ///< every variable has a label of its own and all hard constraints hold
  double cost = 0;                    ///< unary costs + soft constraints; infinite when not valid
  std::vector<Violation> violations;  ///< soft ones that pay, and (amount infinite) hard ones that are broken
};

/// Shares no code with the search. `assignment` has one label a variable, else valid = false.
[[nodiscard]] Check check(const Problem& problem, const std::vector<int>& assignment);

/// The same, looking only at these constraints, in this order; the others are known to hold at no cost.
[[nodiscard]] Check check(const Problem& problem, const std::vector<int>& assignment, const std::vector<int>& constraints);

}  // namespace scenelore::engine
