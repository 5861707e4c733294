// Problems whose answers are known from elsewhere.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "plane_problem.hpp"
#include "scenelore/engine/checker.hpp"
#include "scenelore/engine/error.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {
namespace {

std::vector<std::string> numbered(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.push_back(std::to_string(i));
  return names;
}

Problem queens(int n) {
  Problem problem;
  for (int row = 0; row < n; ++row)
    problem.add_variable("row" + std::to_string(row), numbered(n),
                         std::vector<double>(static_cast<std::size_t>(n), 0.0));
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b)
      for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y)
          if (x == y || std::abs(x - y) == b - a) problem.add("attack", kHard, 0, Conflict{{a, x}, {b, y}});
  return problem;
}

TEST(Queens, HaveTheKnownNumberOfSolutions) {
  for (const auto& [n, count] : {std::pair{1, 1}, {2, 0}, {3, 0}, {4, 2}, {5, 10}, {6, 4}, {7, 40}, {8, 92}})
    EXPECT_EQ(Solver(queens(n)).k_best(1000).size(), static_cast<std::size_t>(count)) << n;
}

TEST(Queens, TwentyAreSolved) {
  const Problem problem = queens(20);
  const Solution solution = Solver(problem).solve();
  ASSERT_EQ(solution.outcome, Outcome::proved);
  EXPECT_TRUE(check(problem, solution.assignment).valid);
}

TEST(MapColouring, TheWheelNeedsFourColours) {
  // A hub and an odd rim: three colours do not suffice; the core is the whole wheel.
  for (const int colours : {3, 4}) {
    Problem problem;
    for (int v = 0; v < 6; ++v)
      problem.add_variable("region" + std::to_string(v), numbered(colours),
                           std::vector<double>(static_cast<std::size_t>(colours), 0.0));
    std::vector<double> entries;
    for (int i = 0; i < colours * colours; ++i) entries.push_back(i % (colours + 1) == 0 ? 1 : 0);
    const int differ = problem.add_table(colours, colours, entries);
    for (int v = 0; v < 5; ++v) {
      problem.add("hub", kHard, v, PairTable{5, v, differ});
      problem.add("rim", kHard, v, PairTable{v, (v + 1) % 5, differ});
    }
    Solver solver(problem);
    EXPECT_EQ(solver.solve().outcome, colours == 3 ? Outcome::infeasible : Outcome::proved);
    EXPECT_EQ(solver.conflict().constraints.size(), colours == 3 ? 10u : 0u);
  }
}

TEST(Sudoku, WithOneSolutionIsSolved) {
  // Gordon Royle's collection of minimal sudokus has 17 givens; this one has a unique solution.
  const std::string givens = "000000010400000000020000000000050407008000300001090000300400200050100000000806000";
  const std::string solved = "693784512487512936125963874932651487568247391741398625319475268856129743274836159";
  Problem problem;
  for (int cell = 0; cell < 81; ++cell) {
    std::vector<double> costs(9, 0.0);
    const char given = givens[static_cast<std::size_t>(cell)];
    for (int d = 0; d < 9; ++d)
      if (given != '0' && d != given - '1') costs[static_cast<std::size_t>(d)] = kHard;
    problem.add_variable("cell" + std::to_string(cell), numbered(9), costs);
  }
  for (int digit = 0; digit < 9; ++digit)
    for (int unit = 0; unit < 9; ++unit) {
      Cardinality row, column, box;
      for (int i = 0; i < 9; ++i) {
        row.literals.push_back({unit * 9 + i, digit});
        column.literals.push_back({i * 9 + unit, digit});
        box.literals.push_back({(unit / 3 * 3 + i / 3) * 9 + unit % 3 * 3 + i % 3, digit});
      }
      for (Cardinality* group : {&row, &column, &box}) {
        group->low = group->high = 1;
        problem.add("once", kHard, unit, *group);
      }
    }
  const auto best = Solver(problem).k_best(2);
  ASSERT_EQ(best.size(), 1u);
  for (int cell = 0; cell < 81; ++cell)
    EXPECT_EQ(best[0].assignment[static_cast<std::size_t>(cell)], solved[static_cast<std::size_t>(cell)] - '1');
}

TEST(Solver, AnEmptyProblemHasAnEmptyAnswer) {
  const Problem problem;
  const Solution solution = Solver(problem).solve();
  EXPECT_EQ(solution.outcome, Outcome::proved);
  EXPECT_EQ(solution.cost, 0);
}

TEST(Solver, LimitsLeaveAnIncumbentAndABound) {
  const Problem problem = testing::plane_problem(3, {.planes = 40, .noise = 1.5, .truth = 0});
  const double optimum_at_least = Solver(problem).solve().lower_bound;
  for (const std::uint64_t nodes : {0u, 1u, 30u, 60u, 120u}) {
    const Solution solution = Solver(problem, {.limits = {.nodes = nodes}}).solve();
    EXPECT_LE(solution.lower_bound, optimum_at_least + 1e-6);
    EXPECT_LE(solution.nodes, nodes + 1);
    if (solution.outcome == Outcome::feasible) {
      EXPECT_GE(solution.cost, optimum_at_least - 1e-6);
      EXPECT_TRUE(check(problem, solution.assignment).valid);
    }
  }
  const std::atomic<bool> interrupt{true};
  const Solution stopped = Solver(problem, {.limits = {.interrupt = &interrupt}}).solve();
  // What was found before the search began is not lost.
  ASSERT_EQ(stopped.outcome, Outcome::feasible);
  EXPECT_EQ(stopped.nodes, 0u);
  EXPECT_TRUE(check(problem, stopped.assignment).valid);
  EXPECT_LE(stopped.lower_bound, optimum_at_least + 1e-6);
}

TEST(Solver, HasAnAnswerAlsoWhenTimeEndsBeforeTheSearchCanBegin) {
  const Problem problem = testing::plane_problem(4, {.planes = 300, .truth = 4});
  Solver solver(problem, {.limits = {.seconds = 0}});
  const Solution solution = solver.solve();
  ASSERT_EQ(solution.outcome, Outcome::feasible);
  EXPECT_TRUE(check(problem, solution.assignment).valid);
  EXPECT_LE(solution.lower_bound, solution.cost);
  EXPECT_GT(solution.lower_bound, 0);
  EXPECT_FALSE(solver.min_marginals().exact);
  EXPECT_FALSE(solver.marginals().exact);
  EXPECT_LE(solver.k_best(2).size(), 1u);
  EXPECT_EQ(solver.solve().cost, solution.cost);
}

TEST(Solver, HonoursItsTimeWhileTheRootIsMade) {
  const Problem problem = testing::plane_problem(5, {.planes = 400, .truth = 0});
  for (const double seconds : {0.0, 0.05, 0.2}) {
    const Solution solution = Solver(problem, {.limits = {.seconds = seconds}}).solve();
    EXPECT_TRUE(solution.outcome == Outcome::feasible || solution.outcome == Outcome::stopped);
    EXPECT_LT(solution.seconds, seconds + 2) << "2 s for a machine that is busy";
  }
}

TEST(Solver, BelowCutsOffWhatIsOfNoInterest) {
  const Problem problem = testing::plane_problem(1, {.planes = 30});
  Solver solver(problem);
  const Solution best = solver.solve();
  for (int v = 0; v < 30; ++v) {
    const Literal mine{v, best.assignment[static_cast<std::size_t>(v)]};
    const Solution other = solver.solve({.fixed = {}, .forbidden = {mine}});
    const Solution cut = solver.solve({.fixed = {}, .forbidden = {mine}, .below = best.cost + 4});
    if (other.cost < best.cost + 4) {
      EXPECT_EQ(cut.outcome, Outcome::proved);
      EXPECT_NEAR(cut.cost, other.cost, 1e-6);
    } else {
      EXPECT_EQ(cut.outcome, Outcome::stopped);
      EXPECT_GE(cut.lower_bound, best.cost + 4 - 1e-6);
    }
  }
}

TEST(Marginals, OfALargeRoomComeFromTheBestWorldsAndSayHowMuchTheyCover) {
  const Problem problem = testing::plane_problem(1, {.planes = 30, .noise = 0.5, .truth = 8});
  const Marginals marginals = Solver(problem).marginals(100);
  EXPECT_FALSE(marginals.exact);
  EXPECT_GT(marginals.covered, 0.5);
  EXPECT_LE(marginals.covered, 1);
  for (const auto& row : marginals.probability) {
    double sum = 0;
    for (const double p : row) sum += p;
    EXPECT_NEAR(sum, 1, 1e-9);
  }
}

struct Recorder : Observer {
  int expansions = 0, improvements = 0;
  double last_cost = kHard, last_bound = 0;
  void expanded(int, Literal, double) override { ++expansions; }
  void improved(double cost) override {
    EXPECT_LT(cost, last_cost);
    last_cost = cost;
    ++improvements;
  }
  void bounded(double bound) override {
    EXPECT_GE(bound, last_bound);
    last_bound = bound;
  }
};

TEST(Observer, HearsEachImprovementAndRisingBounds) {
  const Problem problem = testing::plane_problem(2, {.planes = 30, .noise = 1.5, .truth = 1});
  Recorder recorder;
  const Solution solution = Solver(problem, {.observer = &recorder}).solve();
  EXPECT_EQ(static_cast<std::uint64_t>(recorder.expansions), solution.nodes);
  EXPECT_GE(recorder.improvements, 1);
  EXPECT_NEAR(recorder.last_cost, solution.cost, 1e-6);
  EXPECT_LE(recorder.last_bound, solution.cost + 1e-6);
}

TEST(Problem, RefusesWhatMakesNoSense) {
  Problem problem;
  EXPECT_THROW(problem.add_variable("v", {}, {}), Error);
  EXPECT_THROW(problem.add_variable("v", {"a"}, {-1}), Error);
  EXPECT_THROW(problem.add_variable("v", {"a"}, {std::nan("")}), Error);
  problem.add_variable("v", {"a", "b"}, {0, 1});
  problem.add_variable("w", {"a"}, {0});
  EXPECT_THROW(problem.add("c", 0, 0, Conflict{{0, 0}, {0, 1}}), Error);
  EXPECT_THROW(problem.add("c", kHard, 0, Conflict{{0, 0}, {2, 0}}), Error);
  EXPECT_THROW(problem.add("c", 1, 0, Requirement{{0, 2}, {}}), Error);
  EXPECT_THROW(problem.add("c", 1, 0, Requirement{{0, 0}, {{{0, 1}, 2}}}), Error);
  EXPECT_THROW(problem.add("c", 1, 0, PairTable{0, 0, problem.add_table(2, 2, {0, 0, 0, 0})}), Error);
  EXPECT_THROW(problem.add("c", 1, 0, PairTable{0, 1, 0}), Error);  // 2 × 2 for 2 × 1 labels
  try {
    problem.add("screen needs table", kHard, 0, Conflict{{0, 0}, {1, 7}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("screen needs table"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("'w'"), std::string::npos);
  }
  EXPECT_THROW(static_cast<void>(Solver(problem).solve({.fixed = {{5, 0}}, .forbidden = {}})), Error);
}

}  // namespace
}  // namespace scenelore::engine
