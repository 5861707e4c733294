// Cost of the best assignment that contains a literal, for all literals. Any assignment that is met bounds the values
// of its literals from above, the shifted costs at the root bound them from below; only where the two differ is there a
// search. Literals of worlds near the optimum come first, in the small problem that holds these.
#include <algorithm>
#include <cmath>
#include <limits>

#include "implementation.hpp"

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void Solver::Implementation::literal_costs(Component& component, Cost limit, Budget& budget, LiteralCosts& values) {
  const Network& network = component.network;
  const Cost others = optimum() - component.best_cost;
  for (int v = 0; v < network.variables(); ++v) {
    const int variable = component.variables[index(v)];
    for (int label = 0; label < network.labels(v); ++label) {
      const auto l = index(component.labels[index(v)][index(label)]);
      if (values.known[index(variable)][l] != 0) continue;
      const auto tell = [&](Cost cost) {
        values.value[index(variable)][l] = is_forbidden(cost) ? kTop : others + cost;
        values.known[index(variable)][l] = 1;
      };
      if (!network.is_live(v, label)) {
        if (is_forbidden(limit)) tell(kTop);
        continue;
      }
      const Cost least = std::max(component.best_cost, network.bound() + network.unary(v, label));
      Cost seen = kTop;
      for (const auto& [cost, labels] : component.pool)
        if (labels[index(v)] == label) seen = std::min(seen, cost);
      if (seen <= least) {
        tell(seen);
        continue;
      }
      const Cost of_part = is_forbidden(limit) ? limit : limit - others;
      if (least >= of_part) continue;
      const SearchResult with = solve(component, {{v, label, true}}, budget, of_part);
      if (with.complete && !with.assignment.empty())
        tell(with.cost);
      else if (with.complete && is_forbidden(limit))
        tell(kTop);
      else if (!with.complete)
        values.exact = false;
    }
  }
}

MinMarginals Solver::Implementation::min_marginals() {
  Budget budget(options.limits);
  MinMarginals result;
  LiteralCosts values;
  for (const Variable& variable : problem.variables()) {
    result.value.emplace_back(variable.labels.size(), std::numeric_limits<double>::infinity());
    values.value.emplace_back(variable.labels.size(), Cost{0});
    values.known.emplace_back(variable.labels.size(), char{0});
  }
  const Solution solved = solve({}, budget);
  if (solved.outcome == Outcome::infeasible) return result;
  Cost floor = scale.whole(solved.lower_bound);
  if (solved.outcome == Outcome::proved) {
    for (const double nats : {5.0, 20.0, std::numeric_limits<double>::infinity()}) {
      const Cost limit = std::isinf(nats) ? kTop / 2 : optimum() + scale.whole(nats);
      if (!reach(limit, budget)) {
        values.exact = false;
        break;
      }
      for (std::size_t v = 0; v < solved.assignment.size(); ++v) {  // those of settled variables are in no component
        values.value[v][index(solved.assignment[v])] = optimum();
        values.known[v][index(solved.assignment[v])] = 1;
      }
      for (Component& component : parts.components) literal_costs(component, limit, budget, values);
      if (!values.exact) break;
      floor = limit;
    }
  } else {
    values.exact = false;
  }
  result.exact = values.exact;
  for (std::size_t v = 0; v < values.value.size(); ++v)
    for (std::size_t l = 0; l < values.value[v].size(); ++l)
      result.value[v][l] = scale.real(values.known[v][l] != 0 ? values.value[v][l] : floor);
  return result;
}

}  // namespace scenelore::engine
