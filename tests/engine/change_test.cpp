// A problem that changes under its solver, in another order, or too tight: against fresh solvers and enumeration.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>

#include "plane_problem.hpp"
#include "random_problem.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {
namespace {

using testing::all_worlds;
using testing::Random;
using testing::random_problem;

constexpr std::uint64_t kProblems = 400;

void expect_same(Solver& solver, const Problem& problem) {
  Solver fresh(problem);
  const Solution a = solver.solve(), b = fresh.solve();
  ASSERT_EQ(a.outcome, b.outcome);
  ASSERT_EQ(a.assignment, b.assignment);
  ASSERT_EQ(a.cost, b.cost);
  ASSERT_EQ(a.nodes, b.nodes);
  ASSERT_EQ(solver.min_marginals().value, fresh.min_marginals().value);
  ASSERT_EQ(solver.conflict().constraints, fresh.conflict().constraints);
  const auto worlds = solver.k_best(5), others = fresh.k_best(5);
  ASSERT_EQ(worlds.size(), others.size());
  for (std::size_t i = 0; i < worlds.size(); ++i) ASSERT_EQ(worlds[i].assignment, others[i].assignment);
}

TEST(Changes, OfCostsAndConstraintsGiveTheAnswersOfAFreshSolver) {
  for (std::uint64_t seed = 0; seed < kProblems; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Problem problem = random_problem(seed + 9000, {});
    const Problem other = random_problem(seed + 9000, {.largest = 3});
    Solver solver(problem);
    for (int step = 0; step < 4; ++step) {
      const int v = random.below(static_cast<int>(problem.variables().size()));
      const int l = random.below(static_cast<int>(problem.variables()[static_cast<std::size_t>(v)].labels.size()));
      const int constraints = static_cast<int>(problem.constraints().size());
      switch (random.below(3)) {
        case 0:
          problem.set_cost({v, l}, random.chance(0.2) ? kHard : 8 * random.real());
          break;
        case 1:
          if (constraints > 0) problem.drop(random.below(constraints));
          break;
        default:
          problem.add("new", random.chance(0.3) ? kHard : 1 + random.real(), -1, Conflict{{v, l}, {0, 0}});
      }
      expect_same(solver, problem);
      if (HasFatalFailure()) return;
      const auto worlds = all_worlds(problem);
      const Solution best = solver.solve();
      ASSERT_EQ(worlds.empty(), best.assignment.empty());
      if (!worlds.empty()) {
        ASSERT_NEAR(best.cost, worlds[0].first, 1e-6);
      }
      // A literal is fixed and let go again.
      const Solution fixed = solver.solve({.fixed = {{v, l}}, .forbidden = {}});
      double least = kHard;
      for (const auto& [cost, labels] : worlds)
        if (labels[static_cast<std::size_t>(v)] == l) least = std::min(least, cost);
      ASSERT_EQ(std::isinf(least), fixed.assignment.empty());
      if (!std::isinf(least)) {
        ASSERT_NEAR(fixed.cost, least, 1e-6);
      }
    }
  }
}

TEST(Order, InWhichConstraintsAreAddedChangesNoAnswer) {
  for (std::uint64_t seed = 0; seed < kProblems; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = random_problem(seed + 400, {.most_constraints = 14});
    std::vector<std::size_t> order(problem.constraints().size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Random random(seed);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    Problem shuffled;
    for (const Variable& v : problem.variables()) shuffled.add_variable(v.name, v.labels, v.costs);
    for (int t = 0; t < problem.tables(); ++t)
      shuffled.add_table(problem.table_size(t).first, problem.table_size(t).second, problem.table(t));
    for (const std::size_t c : order) {
      const Constraint& constraint = problem.constraints()[c];
      shuffled.add(constraint.name, constraint.weight, constraint.reference, constraint.body);
    }
    const Solution a = Solver(problem).solve(), b = Solver(shuffled).solve();
    ASSERT_EQ(a.assignment, b.assignment);
    ASSERT_EQ(a.nodes, b.nodes);
    if (!a.assignment.empty()) {
      ASSERT_NEAR(a.cost, b.cost, 1e-9);
    }
  }
}

TEST(Relaxation, BreaksFewestHardConstraintsAndIsCheapestAmongThese) {
  int infeasible = 0;
  for (std::uint64_t seed = 0; seed < 2 * kProblems; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = random_problem(seed + 60, {.most_constraints = 14, .hard = 0.8, .forbidden = 0.02});
    const Relaxation relaxation = cheapest_relaxation(problem);
    // All assignments without forbidden labels, by how many units of hard constraints they break, then by cost.
    std::pair<double, double> best{kHard, kHard};
    const auto& variables = problem.variables();
    std::vector<int> labels(variables.size(), 0);
    for (;;) {
      double broken = 0, cost = 0;
      for (std::size_t v = 0; v < labels.size(); ++v) cost += variables[v].costs[static_cast<std::size_t>(labels[v])];
      for (const Violation& violation : check(problem, labels).violations) {
        if (!std::isinf(violation.amount)) {
          cost += violation.amount;
          continue;
        }
        const Constraint& constraint = problem.constraints()[static_cast<std::size_t>(violation.constraint)];
        double units = 1;
        if (const auto* c = std::get_if<Cardinality>(&constraint.body)) {
          Problem one;  // the same with weight 1 says how many are too many
          for (const Variable& v : variables) one.add_variable(v.name, v.labels, std::vector<double>(v.labels.size(), 0.0));
          one.add("one", 1, -1, *c);
          units = check(one, labels).cost;
        }
        broken += units;
      }
      if (std::isfinite(cost)) best = std::min(best, {broken, cost});
      std::size_t v = 0;
      while (v < labels.size() && ++labels[v] == static_cast<int>(variables[v].labels.size())) labels[v++] = 0;
      if (v == labels.size()) break;
    }
    ASSERT_EQ(std::isinf(best.first), relaxation.solution.assignment.empty());
    if (std::isinf(best.first)) continue;
    ASSERT_NEAR(relaxation.solution.cost, best.second, 1e-5);
    ASSERT_EQ(relaxation.constraints.empty(), best.first == 0);
    infeasible += best.first > 0 ? 1 : 0;
  }
  EXPECT_GT(infeasible, 20);
}

TEST(Conflict, UnderALimitIsStillAConflictOrSaysNothing) {
  int cut = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Problem problem = random_problem(seed + 60, {.most_constraints = 16, .hard = 0.9, .forbidden = 0.2});
    for (const std::uint64_t nodes : {0u, 1u, 3u}) {
      const Conflicting found = Solver(problem, {.limits = {.nodes = nodes}}).conflict();
      cut += found.minimal ? 0 : 1;
      if (found.constraints.empty()) continue;
      Problem part;
      for (const Variable& v : problem.variables()) part.add_variable(v.name, v.labels, v.costs);
      for (int t = 0; t < problem.tables(); ++t)
        part.add_table(problem.table_size(t).first, problem.table_size(t).second, problem.table(t));
      for (const int c : found.constraints) {
        const Constraint& constraint = problem.constraints()[static_cast<std::size_t>(c)];
        part.add(constraint.name, constraint.weight, -1, constraint.body);
      }
      ASSERT_TRUE(all_worlds(part).empty());
    }
  }
  EXPECT_GT(cut, 0);
}

/// Tells another thread that there is an answer.
class FirstAnswer : public Observer {
 public:
  std::atomic<bool> found{false};
  void improved(double) override { found = true; }
};

TEST(Interrupt, FromAnotherThreadEndsASearchSoonAndKeepsTheIncumbent) {
  const Problem problem = testing::plane_problem(2, {.planes = 150, .noise = 1, .truth = 0});
  std::atomic<bool> interrupt{false}, ended{false};
  FirstAnswer first;
  Solution solution;
  std::thread search([&] {
    solution = Solver(problem, {.limits = {.seconds = 60, .interrupt = &interrupt}, .observer = &first}).solve();
    ended = true;
  });
  // However slow the machine is, there is something to keep when the interruption comes.
  while (!first.found && !ended) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  interrupt = true;
  const auto start = std::chrono::steady_clock::now();
  search.join();
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 5);
  if (solution.outcome == Outcome::proved) GTEST_SKIP() << "this machine solves it at once";
  ASSERT_EQ(solution.outcome, Outcome::feasible);
  EXPECT_TRUE(check(problem, solution.assignment).valid);
  EXPECT_LT(solution.lower_bound, solution.cost);
}

}  // namespace
}  // namespace scenelore::engine
