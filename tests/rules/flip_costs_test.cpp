// Costs of single changes against the engine's checker, which recomputes each changed world whole.
#include "flip_costs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "scenelore/engine/checker.hpp"

namespace scenelore::rules {
namespace {

using engine::Literal;

engine::Problem random_problem(std::mt19937& random) {
  engine::Problem problem;
  for (int v = 0; v < 4; ++v) {
    const auto cost = [&] { return 0.1 * static_cast<double>(random() % 9); };
    problem.add_variable("v", {"a", "b", "c"}, {cost(), cost(), cost()});
  }
  const auto literal = [&](int variable) { return Literal{variable, static_cast<int>(random() % 3)}; };
  const auto weight = [&] { return random() % 4 == 0 ? engine::kHard : 0.5 + static_cast<double>(random() % 4); };
  for (int i = 0; i < 6; ++i) {
    const int a = static_cast<int>(random() % 4), b = (a + 1 + static_cast<int>(random() % 3)) % 4;
    const double w = weight();
    switch (random() % 4) {
      case 0: problem.add("conflict", w, i, engine::Conflict{literal(a), literal(b)}); break;
      case 1: {
        engine::Requirement body{.literal = literal(a), .supports = {}};
        for (int k = 0; k < 3; ++k) {
          const Literal support = literal((a + 1 + static_cast<int>(random() % 3)) % 4);
          body.supports.push_back({support, std::isinf(w) ? 0 : w * 0.1 * static_cast<double>(random() % 10)});
        }
        problem.add("requirement", w, i, body);
        break;
      }
      case 2: {
        engine::Cardinality body{.literals = {{1, 1}, {2, 1}, {2, 2}, {3, 0}}};
        if (random() % 2 == 0) body.condition = Literal{0, 0};
        (random() % 2 == 0 ? body.low : body.high) = 1 + static_cast<int>(random() % 2);
        problem.add("cardinality", w, i, body);
        break;
      }
      default: {
        std::vector<double> costs;
        for (int k = 0; k < 9; ++k) costs.push_back(random() % 3 == 0 ? 0.5 : 0);
        problem.add("pair", w, i, engine::PairTable{a, b, problem.add_table(3, 3, costs)});
      }
    }
  }
  return problem;
}

TEST(FlipCosts, AreWhatTheCheckerSays) {
  std::mt19937 random(12);
  int valid = 0;
  for (int round = 0; round < 300; ++round) {
    const engine::Problem problem = random_problem(random);
    std::vector<int> world;
    for (int v = 0; v < 4; ++v) world.push_back(static_cast<int>(random() % 3));
    const engine::Check now = engine::check(problem, world);
    if (!now.valid) continue;
    ++valid;
    const auto flips = flip_costs(problem, world);
    for (std::size_t v = 0; v < 4; ++v) {
      for (int l = 0; l < 3; ++l) {
        std::vector<int> changed = world;
        changed[v] = l;
        const engine::Check then = engine::check(problem, changed);
        const double found = flips[v][static_cast<std::size_t>(l)];
        ASSERT_EQ(std::isfinite(found), then.valid) << round << " " << v << " " << l;
        if (then.valid) {
          ASSERT_NEAR(found, then.cost - now.cost, 1e-9) << round << " " << v << " " << l;
        }
      }
    }
  }
  EXPECT_GT(valid, 50);
}

}  // namespace
}  // namespace scenelore::rules
