// Questions about worlds near the optimum of a component, answered in its reduction.
#include <algorithm>

#include "implementation.hpp"
#include "reduction.hpp"

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void Solver::Implementation::translate(const Component& component, const std::vector<int>& labels,
                                       std::vector<int>& assignment) {
  for (std::size_t i = 0; i < labels.size(); ++i)
    assignment[index(component.variables[i])] = component.labels[i][index(labels[i])];
}

Reduction* Solver::Implementation::reduction(Component& component, Cost limit) const {
  if (options.bound != Bound::soft_consistency || !component.whole || component.best.empty() ||
      limit <= component.best_cost || is_forbidden(limit))
    return nullptr;
  auto& kept = component.reduction;
  if (kept == nullptr || kept->cutoff < limit) {
    const Cost reach = kept == nullptr ? 0 : 2 * (kept->cutoff - component.best_cost);
    const Cost wanted = std::max(limit, component.best_cost + reach);
    // A little more, so that the same reach, rounded another way, does not need another one.
    kept = std::make_unique<Reduction>(reduce(component, wanted + (wanted - component.best_cost) / 1024 + 1));
  }
  return kept.get();
}

SearchResult Solver::Implementation::solve_reduced(Component& component, Reduction& reduced,
                                                   const std::vector<Decision>& decisions, Budget& budget, Cost limit) {
  const SearchResult none{limit, limit, {}, true};
  std::vector<std::vector<Decision>> of_part(reduced.parts.size());
  for (const Decision& d : decisions) {
    const int part = reduced.part_of[index(d.variable)];
    if (part < 0) {
      if ((reduced.settled[index(d.variable)] == d.label) != d.equal) return none;
      continue;
    }
    const int label = reduced.label_in[index(d.variable)][index(d.label)];
    if (label >= 0)
      of_part[index(part)].push_back({reduced.index_in[index(d.variable)], label, d.equal});
    else if (d.equal)
      return none;
  }
  SearchResult result{component.best_cost, component.best_cost, component.best, true};
  for (std::size_t p = 0; p < reduced.parts.size(); ++p) {
    if (of_part[p].empty()) continue;
    Component& part = reduced.parts[p];
    const Cost others = result.lower_bound - part.best_cost;
    const SearchResult of = solve(part, of_part[p], budget, std::max<Cost>(0, limit - others));
    if (of.complete && of.assignment.empty()) return none;
    result.complete = result.complete && of.complete;
    result.lower_bound += of.lower_bound - part.best_cost;
    result.cost += of.cost - part.best_cost;
    if (of.assignment.empty())
      result.assignment.clear();
    else if (!result.assignment.empty())
      translate(part, of.assignment, result.assignment);
  }
  if (result.assignment.empty()) result.cost = limit;
  return result;
}

Worlds Solver::Implementation::k_best_reduced(Component& component, Reduction& reduced, int k, Budget& budget,
                                              Cost limit) {
  Worlds all;
  all.worlds.push_back({component.best_cost, component.best});
  for (Component& part : reduced.parts) {
    const Worlds of_part = k_best(part, k, budget, limit - (component.best_cost - part.best_cost));
    all.exact = all.exact && of_part.exact;
    std::vector<World> next;
    for (const World& world : of_part.worlds) {
      next.push_back({world.cost - part.best_cost, std::vector<int>(world.labels.size())});
      for (std::size_t i = 0; i < world.labels.size(); ++i)
        next.back().labels[i] = part.labels[i][index(world.labels[i])];
    }
    all.worlds = combine(all.worlds, next, index(k), part.variables);
  }
  std::erase_if(all.worlds, [&](const World& world) { return world.cost >= limit; });
  return all;
}

}  // namespace scenelore::engine
