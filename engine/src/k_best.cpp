// The k cheapest assignments: those of each component, then combined.
#include <algorithm>
#include <cmath>
#include <limits>

#include "implementation.hpp"

namespace scenelore::engine {

/// (i, j) has at least (i + 1)(j + 1) − 1 pairs before it, in cost and
/// among equal costs in lexicographic order too, so that few pairs need be looked at.
std::vector<World> combine(const std::vector<World>& a, const std::vector<World>& b, std::size_t k,
                           const std::vector<int>& variables_of_b) {
  std::vector<World> all;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size() && (i + 1) * (j + 1) <= k; ++j) {
      World world{a[i].cost + b[j].cost, a[i].labels};
      for (std::size_t v = 0; v < variables_of_b.size(); ++v)
        world.labels[static_cast<std::size_t>(variables_of_b[v])] = b[j].labels[v];
      all.push_back(std::move(world));
    }
  std::sort(all.begin(), all.end());
  if (all.size() > k) all.resize(k);
  return all;
}

/// First the k least costs, by a search whose limit is the k-th best so far. Among assignments that cost as much as the
/// dearest of them that search keeps those it happened to meet; a second one finds them all or, when they are very
/// many, the first ones by going in lexicographic order.
Worlds Solver::Implementation::k_best(Component& component, int k, Budget& budget, Cost limit) {
  constexpr std::size_t kMostEqual = 256;
  if (component.feasible && component.whole) {
    if (component.best.empty()) solve(component, {}, budget);
    if (Reduction* reduced = reduction(component, limit)) return k_best_reduced(component, *reduced, k, budget, limit);
  }
  Worlds found;
  const auto most = static_cast<std::size_t>(k);
  const Search::Report events = report(component);
  Search search(component.network, budget, events);
  if (!component.best.empty()) search.prefer(component.best);
  std::vector<World>& worlds = found.worlds;
  // The k-th best is near the best, as a rule, and a low limit from the start makes for a short search.
  for (const double reach : {0.5, 2.0, std::numeric_limits<double>::infinity()}) {
    const bool last = component.best.empty() || std::isinf(reach);
    const Cost near = last ? limit : std::min(limit, component.best_cost + scale.whole(reach));
    worlds.clear();
    found.exact = search.enumerate({}, near, [&](const std::vector<int>& labels, Cost cost) {
      World world{cost, labels};
      worlds.insert(std::upper_bound(worlds.begin(), worlds.end(), world), std::move(world));
      if (worlds.size() > most) worlds.pop_back();
      return worlds.size() < most ? near : worlds.back().cost;
    });
    if (!found.exact || worlds.size() == most || near == limit) break;
  }
  for (const World& world : worlds) remember(component, world.labels, world.cost);
  if (!found.exact || worlds.size() < most) return found;

  const Cost dearest = worlds.back().cost;
  std::vector<World> cheaper;
  for (World& world : worlds)
    if (world.cost < dearest) cheaper.push_back(world);
  std::vector<World> equal;
  bool too_many = false;
  const auto all_equal = [&](const std::vector<int>& labels, Cost cost) {
    if (cost == dearest) equal.push_back({cost, labels});
    too_many = equal.size() > kMostEqual;
    return too_many ? Cost{0} : dearest + 1;
  };
  found.exact = search.enumerate({}, dearest + 1, all_equal);
  if (too_many) {
    equal.clear();
    Search again(component.network, budget, events);
    again.search_in_order();
    found.exact = again.enumerate({}, dearest + 1, [&](const std::vector<int>& labels, Cost cost) {
      if (cost == dearest) equal.push_back({cost, labels});
      return cheaper.size() + equal.size() < most ? dearest + 1 : Cost{0};
    });
  }
  if (!found.exact) return found;
  cheaper.insert(cheaper.end(), equal.begin(), equal.end());
  std::sort(cheaper.begin(), cheaper.end());
  if (cheaper.size() > most) cheaper.resize(most);
  worlds = std::move(cheaper);
  return found;
}

/// The k cheapest are near the best, as a rule: first those within a small reach of it.
Worlds Solver::Implementation::k_best_worlds(int k, Budget& budget) {
  Worlds all;
  if (k < 1 || solve({}, budget).outcome == Outcome::infeasible) return all;
  for (const double nats : {2.0, 10.0, std::numeric_limits<double>::infinity()}) {
    if (best_world.empty() && std::isfinite(nats)) continue;
    const Cost limit = std::isinf(nats) ? kTop / 2 : optimum() + scale.whole(nats);
    if (!reach(limit, budget)) {
      all.exact = false;
      break;
    }
    all = {.worlds = {{parts.constant, parts.settled}}, .exact = true};
    for (Component& component : parts.components) {
      const Worlds part = k_best(component, k, budget, is_forbidden(limit) ? limit : component.best_cost + scale.whole(nats));
      all.exact = all.exact && part.exact;
      std::vector<World> of_problem;
      for (const World& world : part.worlds) {
        of_problem.push_back({world.cost, {}});
        for (std::size_t v = 0; v < world.labels.size(); ++v)
          of_problem.back().labels.push_back(component.labels[v][static_cast<std::size_t>(world.labels[v])]);
      }
      all.worlds = combine(all.worlds, of_problem, static_cast<std::size_t>(k), component.variables);
    }
    if (!is_forbidden(limit)) std::erase_if(all.worlds, [&](const World& world) { return world.cost >= limit; });
    if (all.worlds.size() == static_cast<std::size_t>(k) || !all.exact) break;
  }
  return all;
}

std::vector<Solution> Solver::Implementation::k_best(int k) {
  Budget budget(options.limits);
  const Worlds all = k_best_worlds(k, budget);
  std::vector<Solution> solutions;
  for (const World& world : all.worlds) solutions.push_back(finish(world.labels, all.exact, parts.constant, budget));
  return solutions;
}

}  // namespace scenelore::engine
