#include "learning/boosted_trees.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace scenelore::learning {
namespace {

double odds_of(double probability) { return std::log(probability / (1 - probability)); }

struct Examples {
  std::vector<std::vector<double>> traits;
  std::vector<bool> outcomes;
};

TEST(BoostedTrees, FindTheLogOddsOfTwoGaussians) {
  // Of two Gaussians a deviation of 1 and two means apart, Bayes' rule gives log odds of 2x; the second trait is noise.
  std::mt19937 random(1);
  const auto normal = [&] {  // Box–Muller: the same numbers with every library
    const double a = (static_cast<double>(random()) + 1) / 4294967297.0, b = static_cast<double>(random()) / 4294967296.0;
    return std::sqrt(-2 * std::log(a)) * std::cos(6.283185307179586 * b);
  };
  Examples examples;
  for (int i = 0; i < 20'000; ++i) {
    const bool yes = i % 2 == 0;
    examples.traits.push_back({(yes ? 1.0 : -1.0) + normal(), normal()});
    examples.outcomes.push_back(yes);
  }
  const BoostedTrees model = fit_boosted_trees(examples.traits, examples.outcomes, {.trees = 100, .depth = 2});
  for (const double x : {-1.5, -0.5, 0.0, 0.5, 1.5}) EXPECT_NEAR(model.odds({x, 0}), 2 * x, 0.45) << x;
  EXPECT_NEAR(model.odds({0.5, 1.5}), model.odds({0.5, -1.5}), 0.5);
}

TEST(BoostedTrees, FindWhatNoSumOfCurvesTells) {
  // Yes nine times in ten where just one of two traits is above zero.
  Examples examples;
  for (int i = 0; i < 6000; ++i) {
    const double x = -1 + 2.0 * (i % 77) / 76, y = -1 + 2.0 * (i % 101) / 100;
    examples.traits.push_back({x, y});
    examples.outcomes.push_back((i % 10 == 0) != ((x > 0) != (y > 0)));
  }
  const BoostedTrees model = fit_boosted_trees(examples.traits, examples.outcomes, {.trees = 400, .depth = 2, .rate = 0.2});
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) EXPECT_NEAR(model.odds({x, y}), odds_of((x > 0) != (y > 0) ? 0.9 : 0.1), 0.4) << x << ' ' << y;
  }
  EXPECT_EQ(model.odds({1e9, 1e9}), model.odds({1, 1})) << "constant beyond what was seen";
}

TEST(BoostedTrees, TellTheUnknownFromTheLowest) {
  Examples examples;
  for (int i = 0; i < 3000; ++i) {
    const bool known = i % 3 != 0;
    examples.traits.push_back({known ? static_cast<double>(i % 10) : std::numeric_limits<double>::quiet_NaN()});
    examples.outcomes.push_back(known ? i % 10 >= 5 : i % 4 != 0);
  }
  const BoostedTrees model = fit_boosted_trees(examples.traits, examples.outcomes, {.trees = 80, .depth = 3});
  EXPECT_NEAR(model.odds({std::numeric_limits<double>::quiet_NaN()}), odds_of(0.75), 0.3);
  EXPECT_LT(model.odds({0.0}), -2);
  EXPECT_GT(model.odds({9.0}), 2);
}

TEST(BoostedTrees, RefuseWhatTeachesNothing) {
  EXPECT_THROW(static_cast<void>(fit_boosted_trees({}, {})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(fit_boosted_trees({{1}, {2}}, {true, true})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(fit_boosted_trees({{1}, {2, 3}}, {true, false})), std::invalid_argument);
  const BoostedTrees model = fit_boosted_trees({{1}, {1}, {1}}, {true, false, true});
  EXPECT_TRUE(model.trees.empty()) << "nothing to ask";
  EXPECT_NEAR(model.odds({1}), odds_of(2.0 / 3), 1e-9);
}

}  // namespace
}  // namespace scenelore::learning
