// Probabilities of literals under P(world) ∝ exp(−cost).
#include <algorithm>
#include <cmath>

#include "implementation.hpp"

namespace scenelore::engine {

Marginals Solver::Implementation::marginals(int most_worlds) {
  Budget budget(options.limits);
  Marginals result;
  for (const Variable& variable : problem.variables()) result.probability.emplace_back(variable.labels.size(), 0.0);
  if (!feasible()) return result;
  for (Component& component : parts.components) {
    const Worlds found = k_best(component, most_worlds, budget);
    if (found.worlds.empty()) continue;
    double sum = 0;
    for (const World& world : found.worlds) sum += std::exp(scale.real(found.worlds[0].cost) - scale.real(world.cost));
    const bool all = found.exact && found.worlds.size() < static_cast<std::size_t>(most_worlds);
    result.exact = result.exact && all;
    for (const World& world : found.worlds) {
      const double p = std::exp(scale.real(found.worlds[0].cost) - scale.real(world.cost)) / sum;
      for (std::size_t v = 0; v < world.labels.size(); ++v)
        result.probability[static_cast<std::size_t>(component.variables[v])]
                          [static_cast<std::size_t>(world.labels[v])] += p;
    }
  }
  return result;
}

}  // namespace scenelore::engine
