// What dominance strikes out, against the enumeration of all assignments.
#include "dominance.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_problem.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {
namespace {

Cost plus(Cost a, Cost b) { return std::min(a + b, kTop); }

Cost evaluate(const Residual& of, const std::vector<int>& labels) {
  const auto label = [&](int v) { return labels[static_cast<std::size_t>(v)]; };
  Cost sum = 0;
  for (std::size_t v = 0; v < labels.size(); ++v) sum = plus(sum, of.variables[v].costs[static_cast<std::size_t>(labels[v])]);
  for (const auto& pair : of.pairs) {
    const auto columns = of.variables[static_cast<std::size_t>(pair.y)].labels.size();
    sum = plus(sum, pair.costs[static_cast<std::size_t>(label(pair.x)) * columns + static_cast<std::size_t>(label(pair.y))]);
  }
  for (const auto& need : of.needs) {
    if (label(need.x) != need.label) continue;
    Cost least = need.weight;
    for (const auto& support : need.supports)
      if (label(support.variable) == support.label) least = std::min(least, support.cost);
    sum = plus(sum, least);
  }
  for (const auto& count : of.counts) {
    if (count.x >= 0 && label(count.x) != count.label) continue;
    int held = 0;
    for (const auto& [v, counts] : count.members) held += counts[static_cast<std::size_t>(label(v))];
    sum = plus(sum, held < count.low ? (is_forbidden(count.weight) ? kTop : count.weight * (count.low - held))
                    : held > count.high ? (is_forbidden(count.weight) ? kTop : count.weight * (held - count.high))
                                        : 0);
  }
  return sum;
}

/// Two to five variables with two to four labels (and one with a single label now and then) and every kind of function.
Residual random_residual(testing::Random& random) {
  Residual result;
  const auto cost = [&] { return random.chance(0.1) ? kTop : Cost{random.below(random.chance(0.3) ? 20 : 6)}; };
  const int count = 2 + random.below(4);
  for (int v = 0; v < count; ++v) {
    Residual::OpenVariable variable{100 + v, {}, {}};
    for (int l = random.chance(0.1) ? 0 : -1 - random.below(3); l <= 0; ++l) {
      variable.labels.push_back(10 + static_cast<int>(variable.labels.size()));
      variable.costs.push_back(cost());
    }
    result.variables.push_back(std::move(variable));
  }
  const auto labels = [&](int v) { return static_cast<int>(result.variables[static_cast<std::size_t>(v)].labels.size()); };
  for (int x = 0; x < count; ++x)
    for (int y = x + 1; y < count; ++y) {
      if (!random.chance(0.4)) continue;
      Residual::Pair pair{x, y, {}};
      for (int i = 0; i < labels(x) * labels(y); ++i) pair.costs.push_back(random.chance(0.6) ? 0 : cost());
      result.pairs.push_back(std::move(pair));
    }
  for (int n = random.below(3); n > 0; --n) {
    const int x = random.below(count);
    Residual::Need need{x, random.below(labels(x)), random.chance(0.3) ? kTop : 5 + random.below(5), {}};
    for (int v = 0; v < count; ++v)
      for (int l = 0; l < labels(v); ++l)
        if (v != x && random.chance(0.3)) need.supports.push_back({v, l, random.below(5)});
    if (!need.supports.empty()) result.needs.push_back(std::move(need));
  }
  for (int n = random.below(3); n > 0; --n) {
    const int x = random.below(count + 1) - 1;
    const int low = random.below(3);
    Residual::Count of{x, x < 0 ? -1 : random.below(labels(x)), low, low + random.below(2), random.chance(0.3) ? kTop : 1 + random.below(6), {}};
    for (int v = 0; v < count; ++v) {
      std::vector<char> counts;
      for (int l = 0; l < labels(v); ++l) counts.push_back(random.chance(0.4) ? 1 : 0);
      if (random.chance(0.6)) of.members.emplace_back(v, std::move(counts));
    }
    result.counts.push_back(std::move(of));
  }
  return result;
}

/// Calls visit(labels) for each assignment.
void for_each_assignment(const Residual& of, const auto& visit) {
  std::vector<int> labels(of.variables.size(), 0);
  for (std::size_t v = 0; v < labels.size();) {
    if (v == 0) visit(labels);
    if (++labels[v] < static_cast<int>(of.variables[v].labels.size()))
      v = 0;
    else
      labels[v++] = 0;
  }
}

TEST(Dominance, StrikesNoLabelOfAnyOptimum) {
  testing::Random random(42);
  int struck = 0, by_needs_and_counts = 0;
  for (int round = 0; round < 20'000; ++round) {
    SCOPED_TRACE(round);
    const Residual residual = random_residual(random);
    const auto dominated = dominated_labels(residual, 1'000'000);
    ASSERT_TRUE(std::is_sorted(dominated.begin(), dominated.end()));
    struck += static_cast<int>(dominated.size());
    if (residual.pairs.empty()) by_needs_and_counts += static_cast<int>(dominated.size());
    Cost least = kTop;
    for_each_assignment(residual, [&](const std::vector<int>& labels) { least = std::min(least, evaluate(residual, labels)); });
    if (least == kTop) continue;
    for_each_assignment(residual, [&](const std::vector<int>& labels) {
      if (evaluate(residual, labels) != least) return;
      for (std::size_t v = 0; v < labels.size(); ++v) {
        const auto& variable = residual.variables[v];
        const std::pair literal{variable.variable, variable.labels[static_cast<std::size_t>(labels[v])]};
        EXPECT_FALSE(std::binary_search(dominated.begin(), dominated.end(), literal)) << "variable " << v << " label " << labels[v];
      }
    });
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(struck, 10'000);
  EXPECT_GT(by_needs_and_counts, 1'000);
}

TEST(Dominance, KeepsLabelsThatAreEquallyGood) {
  Residual residual;
  residual.variables = {{0, {0, 1, 2}, {3, 3, 4}}};
  EXPECT_EQ(dominated_labels(residual, 1000), (std::vector<std::pair<int, int>>{{0, 2}}));
}

TEST(Dominance, LeavesWhatThereIsNoTimeFor) {
  Residual residual;
  residual.variables = {{0, {0, 1}, {0, 9}}, {1, {0, 1}, {0, 9}}};
  residual.pairs = {{0, 1, {0, 0, 0, 1}}};
  EXPECT_EQ(dominated_labels(residual, 1000).size(), 2u);
  EXPECT_TRUE(dominated_labels(residual, 0).empty());
}

/// A grid of Potts variables, whose search is long enough for the root to be looked at once more.
Problem grid(std::uint64_t seed) {
  testing::Random random(seed);
  Problem problem;
  constexpr int kSide = 14;
  for (int v = 0; v < kSide * kSide; ++v) {
    std::vector<double> costs;
    for (int l = 0; l < 4; ++l) costs.push_back(2 * random.real());
    problem.add_variable("v" + std::to_string(v), {"a", "b", "c", "d"}, costs);
  }
  const auto join = [&](int a, int b) {
    const double price = random.real();
    std::vector<double> costs;
    for (int i = 0; i < 16; ++i) costs.push_back(i % 5 == 0 ? 0 : price);
    problem.add("alike", 1, -1, PairTable{a, b, problem.add_table(4, 4, costs)});
  };
  for (int v = 0; v < kSide * kSide; ++v) {
    if (v % kSide + 1 < kSide) join(v, v + 1);
    if (v + kSide < kSide * kSide) join(v, v + kSide);
  }
  return problem;
}

TEST(Dominance, ChangesTheSearchAndNotTheOptimum) {
  std::uint64_t with = 0, without = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = grid(seed);
    const Solution a = Solver(problem, {.elimination = false}).solve();
    const Solution b = Solver(problem, {.elimination = false, .dominance = false}).solve();
    ASSERT_EQ(a.outcome, Outcome::proved);
    ASSERT_EQ(b.outcome, Outcome::proved);
    EXPECT_NEAR(a.cost, b.cost, 1e-9);
    with += a.nodes;
    without += b.nodes;
  }
  EXPECT_NE(with, without);
}

}  // namespace
}  // namespace scenelore::engine
