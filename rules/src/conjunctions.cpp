#include "conjunctions.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "flip_costs.hpp"
#include "scenelore/engine/checker.hpp"

namespace scenelore::rules {

namespace {

using engine::Literal;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Changes of one label with which a conjunction begins or ceases to hold.
std::set<Literal> telling_changes(const LabellingProblem& compiled, const std::vector<int>& assignment) {
  std::set<Literal> out;
  for (const std::vector<Literal>& members : compiled.conjunctions) {
    std::vector<Literal> missing;
    for (const Literal& m : members) {
      if (assignment[at(m.variable)] != m.label) missing.push_back(m);
    }
    if (missing.size() == 1) out.insert(missing[0]);
    if (!missing.empty()) continue;
    for (const Literal& m : members) {
      const int labels = static_cast<int>(compiled.problem.variables()[at(m.variable)].labels.size());
      for (int l = 0; l < labels; ++l) {
        if (l != m.label) out.insert({m.variable, l});
      }
    }
  }
  return out;
}

}  // namespace

void settle(const LabellingProblem& compiled, std::vector<int>& assignment) {
  assignment.resize(compiled.plane_of_variable.size());
  for (const std::vector<Literal>& members : compiled.conjunctions) {
    const bool all = std::all_of(members.begin(), members.end(), [&](Literal m) { return assignment[at(m.variable)] == m.label; });
    assignment.push_back(all ? kYes : kNo);
  }
}

std::vector<std::vector<double>> label_flip_costs(const LabellingProblem& compiled, const std::vector<int>& assignment) {
  std::vector<std::vector<double>> flips = flip_costs(compiled.problem, assignment);
  flips.resize(compiled.plane_of_variable.size());
  if (compiled.conjunctions.empty()) return flips;
  const double now = engine::check(compiled.problem, assignment).cost;
  for (const Literal& change : telling_changes(compiled, assignment)) {
    std::vector<int> other = assignment;
    other[at(change.variable)] = change.label;
    settle(compiled, other);
    const engine::Check checked = engine::check(compiled.problem, other);
    flips[at(change.variable)][at(change.label)] = checked.valid ? checked.cost - now : std::numeric_limits<double>::infinity();
  }
  return flips;
}

}  // namespace scenelore::rules
