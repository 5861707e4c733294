// Thousands of small problems of every kind against the enumeration of all assignments.
#include <gtest/gtest.h>

#include <cmath>

#include "random_problem.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {
namespace {

using testing::all_worlds;
using testing::random_problem;
using testing::Shape;

class Random : public ::testing::TestWithParam<std::pair<const char*, Shape>> {
 protected:
  static constexpr std::uint64_t kProblems = 1500;
  Problem problem(std::uint64_t seed) const { return random_problem(seed * 7919 + 13, GetParam().second); }
  double tolerance() const { return 1e-6 * GetParam().second.largest; }
};

TEST_P(Random, OptimumEqualsEnumeration) {
  for (std::uint64_t seed = 0; seed < kProblems; ++seed) {
    SCOPED_TRACE(seed);
    const Problem p = problem(seed);
    const auto worlds = all_worlds(p, tolerance());
    for (const Bound bound : {Bound::soft_consistency, Bound::paper}) {
      const Solution solution = Solver(p, {.bound = bound}).solve();
      if (worlds.empty()) {
        ASSERT_EQ(solution.outcome, Outcome::infeasible);
        ASSERT_TRUE(solution.assignment.empty());
        continue;
      }
      ASSERT_EQ(solution.outcome, Outcome::proved);
      ASSERT_NEAR(solution.cost, worlds[0].first, tolerance());
      ASSERT_EQ(solution.lower_bound, solution.cost);
      const Check checked = check(p, solution.assignment);
      ASSERT_TRUE(checked.valid);
      ASSERT_EQ(checked.cost, solution.cost);
      ASSERT_EQ(checked.violations.size(), solution.violations.size());
    }
  }
}

TEST_P(Random, KBestEqualEnumerationInOrder) {
  for (std::uint64_t seed = 0; seed < kProblems; ++seed) {
    SCOPED_TRACE(seed);
    const Problem p = problem(seed);
    const auto worlds = all_worlds(p, tolerance());
    const int k = 1 + static_cast<int>(seed % 12);
    const auto best = Solver(p).k_best(k);
    ASSERT_EQ(best.size(), std::min(worlds.size(), static_cast<std::size_t>(k)));
    for (std::size_t i = 0; i < best.size(); ++i) {
      ASSERT_EQ(best[i].assignment, worlds[i].second) << "place " << i;
      ASSERT_NEAR(best[i].cost, worlds[i].first, tolerance());
    }
  }
}

TEST_P(Random, MinMarginalsAndAssumptionsEqualEnumeration) {
  for (std::uint64_t seed = 0; seed < kProblems; ++seed) {
    SCOPED_TRACE(seed);
    const Problem p = problem(seed);
    const auto worlds = all_worlds(p, tolerance());
    Solver solver(p);
    solver.solve();
    const MinMarginals least = solver.min_marginals();
    ASSERT_TRUE(least.exact);
    for (int v = 0; v < static_cast<int>(p.variables().size()); ++v)
      for (int l = 0; l < static_cast<int>(p.variables()[static_cast<std::size_t>(v)].labels.size()); ++l) {
        double with = kHard, without = kHard;
        for (const auto& [cost, labels] : worlds)
          (labels[static_cast<std::size_t>(v)] == l ? with : without) =
              std::min(cost, labels[static_cast<std::size_t>(v)] == l ? with : without);
        const double value = least.value[static_cast<std::size_t>(v)][static_cast<std::size_t>(l)];
        if (std::isinf(with))
          ASSERT_TRUE(std::isinf(value));
        else
          ASSERT_NEAR(value, with, tolerance());
        const Solution other = solver.solve({.fixed = {}, .forbidden = {{v, l}}});
        if (std::isinf(without))
          ASSERT_EQ(other.outcome, Outcome::infeasible);
        else
          ASSERT_NEAR(other.cost, without, tolerance());
      }
  }
}

TEST_P(Random, WhatIsBelowALimitEqualsEnumeration) {
  // The limits rise and fall, so that reductions are made, used again and made anew.
  for (std::uint64_t seed = 0; seed < kProblems / 3; ++seed) {
    SCOPED_TRACE(seed);
    const Problem p = problem(seed);
    const auto worlds = all_worlds(p, tolerance());
    if (worlds.empty()) continue;
    Solver solver(p);
    solver.solve();
    for (const double share : {0.0, 0.3, 0.1, 2.0, 0.7}) {
      const double below = worlds[0].first + share * GetParam().second.largest + 10 * tolerance();
      for (int v = 0; v < static_cast<int>(p.variables().size()); ++v)
        for (int l = 0; l < static_cast<int>(p.variables()[static_cast<std::size_t>(v)].labels.size()); ++l)
          for (const bool fixed : {true, false}) {
            Assumptions assumptions{.fixed = {}, .forbidden = {}, .below = below};
            (fixed ? assumptions.fixed : assumptions.forbidden).push_back({v, l});
            const Solution cut = solver.solve(assumptions);
            double expected = kHard;
            for (const auto& [cost, labels] : worlds)
              if ((labels[static_cast<std::size_t>(v)] == l) == fixed) expected = std::min(expected, cost);
            if (std::abs(expected - below) < 2 * tolerance()) continue;  // rounding decides
            if (expected < below) {
              ASSERT_EQ(cut.outcome, Outcome::proved);
              ASSERT_NEAR(cut.cost, expected, tolerance());
            } else {
              ASSERT_TRUE(cut.assignment.empty());
              ASSERT_NE(cut.outcome, Outcome::proved);
              ASSERT_GE(cut.lower_bound, below - tolerance());
            }
          }
    }
  }
}

TEST_P(Random, MarginalsEqualEnumeration) {
  if (GetParam().second.largest > 1000) return;  // one world has all the probability
  for (std::uint64_t seed = 0; seed < kProblems; ++seed) {
    SCOPED_TRACE(seed);
    const Problem p = problem(seed);
    const auto worlds = all_worlds(p);
    if (worlds.empty()) continue;
    const Marginals marginals = Solver(p).marginals();
    ASSERT_TRUE(marginals.exact);
    std::vector<std::vector<double>> expected;
    for (const Variable& v : p.variables()) expected.emplace_back(v.labels.size(), 0.0);
    double sum = 0;
    for (const auto& [cost, labels] : worlds) sum += std::exp(worlds[0].first - cost);
    for (const auto& [cost, labels] : worlds)
      for (std::size_t v = 0; v < labels.size(); ++v)
        expected[v][static_cast<std::size_t>(labels[v])] += std::exp(worlds[0].first - cost) / sum;
    for (std::size_t v = 0; v < expected.size(); ++v)
      for (std::size_t l = 0; l < expected[v].size(); ++l)
        ASSERT_NEAR(marginals.probability[v][l], expected[v][l], 1e-6);
  }
}

TEST_P(Random, ConflictIsUnsatisfiableAndMinimal) {
  for (std::uint64_t seed = 0; seed < kProblems; ++seed) {
    SCOPED_TRACE(seed);
    const Problem p = problem(seed);
    const std::vector<int> core = Solver(p).conflict().constraints;
    const auto keep = [&](int without) {
      Problem part;
      for (const Variable& v : p.variables()) part.add_variable(v.name, v.labels, v.costs);
      for (int t = 0; t < p.tables(); ++t) part.add_table(p.table_size(t).first, p.table_size(t).second, p.table(t));
      for (const int c : core) {
        const Constraint& constraint = p.constraints()[static_cast<std::size_t>(c)];
        if (c != without) part.add(constraint.name, constraint.weight, constraint.reference, constraint.body);
      }
      return all_worlds(part).empty();
    };
    if (core.empty()) continue;
    ASSERT_TRUE(all_worlds(p).empty());
    ASSERT_TRUE(keep(-1));
    for (const int c : core) ASSERT_FALSE(keep(c)) << "constraint " << c << " is not needed";
  }
}

TEST_P(Random, AnswersAreTheSameEachTime) {
  for (std::uint64_t seed = 0; seed < kProblems / 10; ++seed) {
    const Problem p = problem(seed);
    const Solution a = Solver(p).solve(), b = Solver(p).solve();
    ASSERT_EQ(a.assignment, b.assignment);
    ASSERT_EQ(a.nodes, b.nodes);
    ASSERT_EQ(a.backtracks, b.backtracks);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Random,
    ::testing::Values(std::pair{"mixed", Shape{}},
                      std::pair{"soft", Shape{.most_constraints = 14, .hard = 0, .forbidden = 0}},
                      std::pair{"hard", Shape{.most_constraints = 16, .hard = 0.9, .forbidden = 0.2}},
                      std::pair{"dense", Shape{.most_variables = 5, .most_constraints = 25, .hard = 0.15}},
                      std::pair{"huge", Shape{.largest = 1e9}}, std::pair{"tiny", Shape{.largest = 0x1p-10}}),
    [](const auto& shape) { return shape.param.first; });

}  // namespace
}  // namespace scenelore::engine
