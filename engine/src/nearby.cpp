// Only the part of a problem that can matter for a question is built. With an upper bound on the answer, a label whose
// own cost, on top of the cheapest label of every other variable, reaches it is in no world of interest. Descent from the
// cheapest labels finds an upper bound before anything is built; as a rule it is the optimum, and what is left to do is
// the proof.
#include <algorithm>
#include <cmath>

#include "early_bound.hpp"
#include "implementation.hpp"
#include "scenelore/engine/checker.hpp"

namespace scenelore::engine {
namespace {

constexpr std::size_t kMostMet = 64;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool agrees(const std::vector<int>& assignment, const Assumptions& assumptions) {
  const auto holds = [&](const Literal& literal) { return assignment[index(literal.variable)] == literal.label; };
  return std::all_of(assumptions.fixed.begin(), assumptions.fixed.end(), holds) &&
         std::none_of(assumptions.forbidden.begin(), assumptions.forbidden.end(), holds);
}

}  // namespace

void Solver::Implementation::meet(const std::vector<int>& assignment, double cost) {
  for (const auto& known : met)
    if (known.second == assignment) return;
  if (met.size() == kMostMet) met.erase(std::max_element(met.begin(), met.end()));
  met.emplace_back(cost, assignment);
}

Cost Solver::Implementation::upper_limit(const Assumptions& assumptions, Budget& budget) {
  if (options.bound == Bound::paper) return kTop / 2;
  const auto cheapest = [&] {
    double least = assumptions.below;
    bool any = false;
    for (const auto& [cost, assignment] : met) {
      if (!(cost < least) || !agrees(assignment, assumptions)) continue;
      least = cost;
      any = true;
    }
    return any ? scale.whole(least) + scale.slack() : kTop / 2;
  };
  // A limit that is given serves many questions; one parts and reduction for them all.
  if (!best_world.empty() && std::isfinite(assumptions.below)) return kTop / 2;
  const Cost limit = cheapest();
  if (!is_forbidden(limit)) return limit;
  if (!local_search) local_search.emplace(outline());
  std::vector<int> assignment = local_search->begin(assumptions, best_world);
  local_search->descend(assignment, budget);
  const Check checked = check(problem, assignment, outline().relevant(assignment));
  if (checked.valid && agrees(assignment, assumptions)) meet(assignment, checked.cost);
  return cheapest();
}

std::vector<std::vector<char>> Solver::Implementation::labels_below(Cost limit) const {
  if (is_forbidden(limit)) return {};
  const auto cheapest = std::min_element(met.begin(), met.end());
  EarlyBound bound(outline(), !best_world.empty() || cheapest == met.end() ? best_world : cheapest->second);
  constexpr int kMostRounds = 4;
  bool changed = true;
  for (int round = 0; changed && round < kMostRounds; ++round) {
    bound.raise();
    changed = bound.strike(limit, best_world) || round == 0;
  }
  return bound.labels();
}

Cost Solver::Implementation::optimum() const {
  Cost sum = parts.constant;
  for (const Component& component : parts.components) sum += component.best_cost;
  return sum;
}

bool Solver::Implementation::reach(Cost limit, Budget& budget) {
  if (options.bound == Bound::paper) limit = kTop / 2;
  if (limit <= cutoff) return true;
  if (!best_world.empty() && !is_forbidden(limit)) {  // at least twice as far as was asked before, so that there are few steps
    if (asked > 0) limit = std::max(limit, 2 * asked - optimum());
  }
  Decomposition next = decompose(outline(), options.bound, {.labels = labels_below(limit), .settle = !is_forbidden(limit)},
                                 limit, &budget, best_world);
  if (!next.built) return false;
  if (!best_world.empty() && !is_forbidden(limit)) asked = limit;
  parts = std::move(next);
  cutoff = parts.cut ? -1 : is_forbidden(limit) ? kTop : limit;  // what was cut short is made anew next time
  for (Component& component : parts.components) seed(component);
  return true;
}

std::optional<std::vector<int>> Solver::Implementation::polished(const Component& component,
                                                                 const std::vector<Decision>& decisions, Cost limit,
                                                                 std::uint64_t sweeps, Budget& budget) {
  if (!local_search) local_search.emplace(outline());
  std::vector<int>& world = polished_world;
  if (world.empty()) {
    world = local_search->begin({});
    local_search->descend(world, budget);
  }
  std::vector<char> allowed(index(outline().literals()), 0);
  const auto literal = [&](std::size_t place, int label) {
    return index(outline().literal({component.variables[place], component.labels[place][index(label)]}));
  };
  for (std::size_t i = 0; i < component.variables.size(); ++i) {
    for (const int label : component.network.live(static_cast<int>(i))) allowed[literal(i, label)] = 1;
    for (const Decision& d : decisions) {
      if (index(d.variable) != i) continue;
      for (int label = 0; label < component.network.labels(d.variable); ++label)
        if ((label == d.label) != d.equal) allowed[literal(i, label)] = 0;
    }
    int& own = world[index(component.variables[i])];
    for (int label = 0; allowed[index(outline().literal({component.variables[i], own}))] == 0; ++label) {
      if (label == component.network.labels(static_cast<int>(i))) return std::nullopt;
      if (allowed[literal(i, label)] != 0) own = component.labels[i][index(label)];
    }
  }
  const auto cheaper = [&]() -> std::optional<std::vector<int>> {
    std::vector<int> labels = part_of(parts, component, world);
    if (component.network.evaluate(labels) >= limit) return std::nullopt;
    return labels;
  };
  if (auto labels = cheaper()) return labels;  // descent breaks something elsewhere alone
  local_search->allow(std::move(allowed));
  local_search->anneal(world, sweeps, budget);
  return cheaper();
}

/// What is known when time runs out before there is anything to search.
Solution Solver::Implementation::unbuilt(const Assumptions& assumptions, const Budget& budget) const {
  Cost least = 0;
  for (const Variable& variable : problem.variables())
    least = std::min(least + scale.whole(*std::min_element(variable.costs.begin(), variable.costs.end())), kTop);
  const std::pair<double, std::vector<int>>* best = nullptr;
  for (const auto& known : met)
    if (known.first < assumptions.below && agrees(known.second, assumptions) && (best == nullptr || known < *best)) best = &known;
  return finish(best == nullptr ? std::vector<int>() : best->second, false, least, budget);
}

/// What is known of the whole problem, in terms of one component.
void Solver::Implementation::seed(Component& component) const {
  if (!component.feasible) return;
  for (const auto& known : met) {
    const bool is_in = std::all_of(component.variables.begin(), component.variables.end(), [&](int v) {
      return parts.label_in[index(v)][index(known.second[index(v)])] >= 0;
    });
    if (!is_in) continue;
    const std::vector<int> labels = part_of(parts, component, known.second);
    remember(component, labels, component.network.evaluate(labels));
  }
  if (best_world.empty()) return;
  component.best = part_of(parts, component, best_world);
  component.best_cost = component.network.evaluate(component.best);
}

}  // namespace scenelore::engine
