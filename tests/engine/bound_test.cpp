// What the lower bound is worth: how far from the optimum it is before the first branch, and how many branches that saves.
#include <gtest/gtest.h>

#include "plane_problem.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {
namespace {

using testing::Random;

/// Which pairs of labels clash at which price; nothing else costs anything.
Problem max_csp(std::uint64_t seed, double price, double first_price) {
  Random random(seed);
  Problem problem;
  const std::vector<std::string> labels{"a", "b", "c", "d"};
  for (int v = 0; v < 16; ++v) problem.add_variable("v" + std::to_string(v), labels, {0, 0, 0, 0});
  for (int a = 0; a < 16; ++a)
    for (int b = a + 1; b < 16; ++b) {
      if (!random.chance(0.5)) continue;
      std::vector<double> costs;
      for (int i = 0; i < 16; ++i) costs.push_back(random.chance(0.4) ? 1 : 0);
      const bool first = problem.constraints().empty();
      problem.add("clash", first ? first_price : price, -1, PairTable{a, b, problem.add_table(4, 4, costs)});
    }
  return problem;
}

TEST(Bound, BeforeTheFirstBranchIsNearTheOptimumOfDensePlanes) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = testing::plane_problem(seed, {.planes = 40, .truth = 0});
    const double optimum = Solver(problem).solve().cost;
    const double root = Solver(problem, {.limits = {.nodes = 0}}).solve().lower_bound;
    const double paper = Solver(problem, {.bound = Bound::paper, .limits = {.nodes = 0}}).solve().lower_bound;
    EXPECT_LE(root, optimum + 1e-6);
    EXPECT_LE(paper, root);
    EXPECT_LT(optimum - root, 0.4 * (optimum - paper)) << "root " << root << ", optimum " << optimum;
  }
}

TEST(Bound, IsRoundedUpWhenAllCostsAreWhole) {
  std::uint64_t whole = 0, other = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = max_csp(seed, 1, 1);
    const Solution a = Solver(problem).solve();
    const Solution b = Solver(max_csp(seed, 1, 1 + 0x1p-30)).solve();
    ASSERT_EQ(a.outcome, Outcome::proved);
    ASSERT_NEAR(a.cost, b.cost, 1e-8);
    const Solution thirds = Solver(max_csp(seed, 1.0 / 3, 1.0 / 3)).solve();  // multiples of what is no multiple of 2^-40
    ASSERT_NEAR(3 * thirds.cost, a.cost, 1e-8);
    ASSERT_EQ(thirds.nodes, a.nodes);
    whole += a.nodes;
    other += b.nodes;
  }
  EXPECT_LT(whole * 3, other * 2);
}

TEST(Bound, OfPlanesWithATruthIsTheOptimumBeforeTheFirstBranch) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    for (const bool graded : {false, true}) {
      const Problem problem = testing::plane_problem(seed, {.planes = 80, .truth = 3.5, .graded = graded});
      const Solution root = Solver(problem, {.limits = {.nodes = 0}}).solve();
      EXPECT_EQ(root.outcome, Outcome::proved) << root.cost << " over " << root.lower_bound;
    }
  }
}

TEST(Incumbent, OfPlanesWithoutATruthIsFoundWhereDescentAndDivingEndInClashes) {
  const Problem problem = testing::plane_problem(3, {.planes = 150, .truth = 0});
  const Solution early = Solver(problem, {.limits = {.nodes = 1}}).solve();
  ASSERT_EQ(early.outcome, Outcome::feasible);
  const Solution later = Solver(problem, {.limits = {.nodes = 20}}).solve();
  EXPECT_LE(later.cost, early.cost);
  EXPECT_LE(later.lower_bound, later.cost);
  EXPECT_EQ(later.assignment, Solver(problem, {.limits = {.nodes = 20}}).solve().assignment);
}

/// A chain of variables in which each pair of neighbours clashes here and there, and some must be supported farther on.
Problem chain(std::uint64_t seed) {
  Random random(seed);
  Problem problem;
  for (int v = 0; v < 40; ++v) {
    std::vector<double> costs;
    for (int l = 0; l < 4; ++l) costs.push_back(random.real());
    problem.add_variable("v" + std::to_string(v), {"a", "b", "c", "d"}, costs);
  }
  for (int v = 1; v < 40; ++v) {
    std::vector<double> costs;
    for (int i = 0; i < 16; ++i) costs.push_back(2 * random.real());
    problem.add("next", 1, -1, PairTable{v - 1, v, problem.add_table(4, 4, costs)});
    if (v % 8 == 0) problem.add("needs", 1.5, -1, Requirement{{v, 0}, {{{v - 2, 1}, 0}, {{v - 3, 2}, 0.3}}});
    if (v % 10 == 0) problem.add("few", 0.7, -1, Cardinality{{}, {{v, 1}, {v - 1, 1}, {v - 2, 1}}, 1, 1});
  }
  return problem;
}

TEST(Elimination, FinishesWhatHangsTogetherLooselyWithoutBranches) {
  std::uint64_t with = 0, without = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = chain(seed);
    const Solution a = Solver(problem).solve();
    const Solution b = Solver(problem, {.elimination = false}).solve();
    ASSERT_EQ(a.outcome, Outcome::proved);
    ASSERT_EQ(b.outcome, Outcome::proved);
    EXPECT_NEAR(a.cost, b.cost, 1e-9);
    with += a.nodes;
    without += b.nodes;
  }
  EXPECT_EQ(with, 0u);
  EXPECT_GT(without, 0u);
}

}  // namespace
}  // namespace scenelore::engine
