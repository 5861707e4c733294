// Variables that stand for "these planes are all of these classes": they follow from the labels of the planes.
#pragma once

#include <vector>

#include "scenelore/rules/labelling.hpp"

namespace scenelore::rules {

/// Labels of a conjunction's variable.
inline constexpr int kNo = 0, kYes = 1;

/// Gives the conjunctions' variables the labels that follow from those of the planes; `assignment` may end with the planes.
void settle(const LabellingProblem& compiled, std::vector<int>& assignment);

/// [variable][label], by planes' variables: cost of the world with that one plane's label changed, and the conjunctions as they
/// follow from it, less the world's own; infinite where a hard constraint breaks. Otherwise as flip_costs.
[[nodiscard]] std::vector<std::vector<double>> label_flip_costs(const LabellingProblem& compiled, const std::vector<int>& assignment);

}  // namespace scenelore::rules
