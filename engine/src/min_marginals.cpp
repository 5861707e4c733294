// Cost of the best assignment that contains a literal, for all literals. Any assignment that is met bounds the values
// of its literals from above, the shifted costs at the root bound them from below; only where the two differ is there a
// search.
#include <algorithm>
#include <limits>

#include "implementation.hpp"

namespace scenelore::engine {
namespace {

struct Values {
  std::vector<std::vector<Cost>> value;
  Cost best = kTop;
  bool exact = true;
};

}  // namespace

MinMarginals Solver::Implementation::min_marginals() {
  Budget budget(options.limits);
  MinMarginals result;
  for (const Variable& variable : problem.variables())
    result.value.emplace_back(variable.labels.size(), std::numeric_limits<double>::infinity());
  if (!feasible()) return result;

  std::vector<Values> all;
  Cost total = parts.constant;
  for (Component& component : parts.components) {
    const Network& network = component.network;
    Values values;
    const SearchResult best = solve(component, {}, budget);
    if (best.complete && best.assignment.empty()) return result;
    values.best = best.complete ? best.cost : best.lower_bound;
    values.exact = best.complete;
    for (int v = 0; v < network.variables(); ++v) {
      auto& row = values.value.emplace_back(static_cast<std::size_t>(network.labels(v)), kTop);
      for (const int label : network.live(v)) {
        const Cost least = std::max(values.best, network.bound() + network.unary(v, label));
        Cost& value = row[static_cast<std::size_t>(label)];
        for (const auto& [cost, labels] : component.pool)
          if (labels[static_cast<std::size_t>(v)] == label) value = std::min(value, cost);
        if (value <= least) continue;
        const SearchResult with = solve(component, {{v, label, true}}, budget);
        if (!with.complete) values.exact = false;
        value = !with.complete ? std::max(least, with.lower_bound) : with.assignment.empty() ? kTop : with.cost;
      }
    }
    total += values.best;
    result.exact = result.exact && values.exact;
    all.push_back(std::move(values));
  }
  for (std::size_t c = 0; c < all.size(); ++c)
    for (std::size_t v = 0; v < all[c].value.size(); ++v)
      for (std::size_t l = 0; l < all[c].value[v].size(); ++l) {
        const Cost value = all[c].value[v][l];
        if (!is_forbidden(value))
          result.value[static_cast<std::size_t>(parts.components[c].variables[v])][l] =
              scale.real(total - all[c].best + value);
      }
  return result;
}

}  // namespace scenelore::engine
