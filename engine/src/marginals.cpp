// Probabilities of literals under P(world) ∝ exp(−cost): exactly by elimination, or from the k best worlds.
#include <algorithm>
#include <cmath>

#include "elimination.hpp"
#include "implementation.hpp"

namespace scenelore::engine {
namespace {

constexpr std::size_t kMostTuples = std::size_t{1} << 18;  // of one table: 2 MB

/// No less than the whole probability mass, in units of that of the best world. Functions cost >= 0, so leaving them
/// out can only add mass, and what is left is a product over variables; with the costs as given and as shifted at the
/// root, whichever is less.
double most_mass(const Network& network, const Scale& scale, Cost best) {
  double shifted = scale.real(best) - scale.real(network.bound());
  double original = scale.real(best);
  for (int v = 0; v < network.variables(); ++v) {
    double shifted_sum = 0, original_sum = 0;
    for (const int label : network.live(v)) {
      shifted_sum += std::exp(-scale.real(network.unary(v, label)));
      original_sum += std::exp(-scale.real(network.original(v, label)));
    }
    shifted += std::log(shifted_sum);
    original += std::log(original_sum);
  }
  return std::exp(std::min({shifted, original, 700.0}));
}

}  // namespace

Marginals Solver::Implementation::marginals(int most_worlds) {
  Budget budget(options.limits);
  Marginals result;
  for (const Variable& variable : problem.variables()) result.probability.emplace_back(variable.labels.size(), 0.0);
  const Solution solved = solve({}, budget);
  if (solved.outcome == Outcome::infeasible) return result;
  if (!reach(kTop / 2, budget)) {  // no time: the best world that is known
    for (std::size_t v = 0; v < solved.assignment.size(); ++v)
      result.probability[v][static_cast<std::size_t>(solved.assignment[v])] = 1;
    result.exact = false;
    result.covered = 0;
    return result;
  }
  for (Component& component : parts.components) {
    const auto row = [&](std::size_t v) -> std::vector<double>& {
      return result.probability[static_cast<std::size_t>(component.variables[v])];
    };
    if (const auto exact = eliminate(component.network, scale, kMostTuples)) {
      for (std::size_t v = 0; v < exact->size(); ++v) row(v) = (*exact)[v];
      continue;
    }
    const Worlds found = k_best(component, std::max(most_worlds, 1), budget);
    if (found.worlds.empty()) continue;
    const Cost best = found.worlds[0].cost;
    double sum = 0;
    for (const World& world : found.worlds) sum += std::exp(scale.real(best) - scale.real(world.cost));
    for (const World& world : found.worlds) {
      const double p = std::exp(scale.real(best) - scale.real(world.cost)) / sum;
      for (std::size_t v = 0; v < world.labels.size(); ++v) row(v)[static_cast<std::size_t>(world.labels[v])] += p;
    }
    if (found.exact && found.worlds.size() < static_cast<std::size_t>(most_worlds)) continue;  // these are all
    result.exact = false;
    result.covered *= std::min(1.0, sum / most_mass(component.network, scale, best));
  }
  return result;
}

}  // namespace scenelore::engine
