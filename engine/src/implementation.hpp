// What a Solver keeps between calls.
#pragma once

#include <optional>

#include "component.hpp"
#include "local_search.hpp"
#include "outline.hpp"
#include "reduction.hpp"
#include "scale.hpp"
#include "scenelore/engine/solver.hpp"
#include "search.hpp"

namespace scenelore::engine {

/// A cost with its assignment to the variables of one component (or of the problem).
struct World {
  Cost cost;
  std::vector<int> labels;
  auto operator<=>(const World&) const = default;  // cheapest first, then in lexicographic order
};

struct Worlds {
  std::vector<World> worlds;  ///< sorted
  bool exact = true;
};

/// The k cheapest sums of one of a and one of b, whose labels take their places among those of a. Both are sorted.
std::vector<World> combine(const std::vector<World>& a, const std::vector<World>& b, std::size_t k,
                           const std::vector<int>& variables_of_b);

struct Solver::Implementation {
  Implementation(const Problem& of, SolverOptions with);

  Solution solve(const Assumptions& assumptions, Budget& budget);
  std::vector<Solution> k_best(int k);
  MinMarginals min_marginals();
  Marginals marginals(int most_worlds);

  struct LiteralCosts {  ///< least cost of a world with each literal
    std::vector<std::vector<Cost>> value;
    std::vector<std::vector<char>> known;
    bool exact = true;
  };
  /// Makes those of one component's literals known whose cost is below the limit.
  void literal_costs(Component& component, Cost limit, Budget& budget, LiteralCosts& costs);

  /// Forgets everything when the problem has changed since.
  void refresh();
  std::vector<int> conflict(bool& minimal) const;

  // --- which part of the problem is looked at ---
  /// Makes `parts` hold all worlds cheaper than `limit`.
  /// False: time ran out before anything was built; everything is as before.
  bool reach(Cost limit, Budget& budget);
  Solution unbuilt(const Assumptions& assumptions, const Budget& budget) const;
  /// The limit below which at least one world that agrees with the assumptions is found without search; kTop = none.
  Cost upper_limit(const Assumptions& assumptions, Budget& budget);
  const Outline& outline() const;
  /// Cost of the best world, once it is proved.
  Cost optimum() const;
  /// Labels that can occur in a world cheaper than `limit`, and those of the best world; empty = all.
  std::vector<std::vector<char>> labels_below(Cost limit) const;
  void seed(Component& component) const;
  /// Notes a world that was met.
  void meet(const std::vector<int>& assignment, double cost);


  // --- one component ---
  /// Least cost under the decisions; uses and fills the pool. `limit`: dearer ones are of no interest.
  SearchResult solve(Component& component, const std::vector<Decision>& decisions, Budget& budget,
                     Cost limit = kTop / 2);
  Cost least_cost(const Component& component) const;
  /// An assignment of the component that agrees with the decisions and is cheaper than the limit, by local search.
  std::optional<std::vector<int>> polished(const Component& component, const std::vector<Decision>& decisions, Cost limit,
                                           std::uint64_t sweeps, Budget& budget);
  SearchResult split(Component& component, Search& search, const std::vector<Decision>& decisions, Cost limit) const;
  /// Those of the k cheapest that are below the limit.
  Worlds k_best(Component& component, int k, Budget& budget, Cost limit = kTop / 2);

  // --- near the optimum of one component ---
  /// The reduction that holds all worlds cheaper than `limit`; nothing when the optimum is not known, or no limit is
  /// set.
  Reduction* reduction(Component& component, Cost limit) const;
  SearchResult solve_reduced(Component& component, Reduction& reduced, const std::vector<Decision>& decisions,
                             Budget& budget, Cost limit);
  /// Those of the k cheapest that are below the limit, which is no more than the reduction's.
  Worlds k_best_reduced(Component& component, Reduction& reduced, int k, Budget& budget, Cost limit);
  Search::Report report(const Component& component) const;
  /// Labels of the problem in `assignment` for those of a component.
  static void translate(const Component& component, const std::vector<int>& labels, std::vector<int>& assignment);
  void remember(Component& component, const std::vector<int>& labels, Cost cost) const;
  bool feasible() const;

  // --- the whole ---
  Worlds k_best_worlds(int k, Budget& budget);
  /// Fills cost, violations, outcome and so on from an assignment and what the search said about it.
  Solution finish(std::vector<int> assignment, bool complete, Cost lower_bound, const Budget& budget) const;

  const Problem& problem;
  SolverOptions options;
  Scale scale;  ///< of the problem as it was when last looked at
  Cost cutoff = -1;       ///< parts hold all worlds cheaper than this; at first there are none
  Cost asked = 0;         ///< what was asked for last, once the optimum was known
  Decomposition parts{};  ///< made when first needed, with no more labels than that asks for
  std::vector<std::pair<double, std::vector<int>>> met{};  ///< worlds of the whole problem, for upper bounds
  std::vector<int> polished_world{};  ///< where looking for better ones goes on
  std::vector<int> best_world{};                                 ///< an optimal one, once it is proved
  std::optional<LocalSearch> local_search{};
  mutable std::optional<Outline> outlined{};
  std::uint64_t revision = 0;  ///< of the problem that all this is about
};

}  // namespace scenelore::engine
