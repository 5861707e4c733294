// What a Solver keeps between calls.
#pragma once

#include "component.hpp"
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
  Worlds k_best(Component& component, int k, Budget& budget);
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
