// What a Solver keeps between calls.
#pragma once

#include "component.hpp"
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

  Solution solve(const Assumptions& assumptions);
  std::vector<Solution> k_best(int k);
  MinMarginals min_marginals();
  Marginals marginals(int most_worlds);

  // --- one component ---
  /// Least cost under the decisions; uses and fills the pool.
  /// `limit`: dearer ones are of no interest.
  SearchResult solve(Component& component, const std::vector<Decision>& decisions, Budget& budget,
                     Cost limit = kTop / 2);
  Cost least_cost(const Component& component) const;
  SearchResult split(Component& component, Search& search, const std::vector<Decision>& decisions, Cost limit) const;
  Worlds k_best(Component& component, int k, Budget& budget, Cost limit = kTop / 2);

  // --- near the optimum of one component ---
  /// The reduction that holds all worlds cheaper than `limit`; nothing when the optimum is not known, or no limit is
  /// set.
  Reduction* reduction(Component& component, Cost limit) const;
  SearchResult solve_reduced(Component& component, Reduction& reduced, const std::vector<Decision>& decisions,
                             Budget& budget, Cost limit);
  /// Those of the k cheapest that are below the cutoff.
  Worlds k_best_reduced(Component& component, Reduction& reduced, int k, Budget& budget);
  Search::Report report(const Component& component) const;
  void remember(Component& component, const std::vector<int>& labels, Cost cost) const;
  bool feasible() const;

  // --- the whole ---
  Worlds k_best_worlds(int k, Budget& budget);
  /// Fills cost, violations, outcome and so on from an assignment and what the search said about it.
  Solution finish(std::vector<int> assignment, bool complete, Cost lower_bound, const Budget& budget) const;

  const Problem& problem;
  SolverOptions options;
  Scale scale;
  Decomposition parts;
};

}  // namespace scenelore::engine
