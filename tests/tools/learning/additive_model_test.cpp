#include "learning/additive_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace scenelore::learning {
namespace {

double odds_of(double probability) { return std::log(probability / (1 - probability)); }

TEST(AdditiveModel, FindsTheLogOddsOfTwoGaussians) {
  // Of two Gaussians a deviation of 1 and two means apart, Bayes' rule gives log odds of 2x; the second trait is noise.
  std::mt19937 random(1);
  const auto normal = [&] {  // Box–Muller: the same numbers with every library
    const double a = (static_cast<double>(random()) + 1) / 4294967297.0, b = static_cast<double>(random()) / 4294967296.0;
    return std::sqrt(-2 * std::log(a)) * std::cos(6.283185307179586 * b);
  };
  std::vector<std::vector<double>> traits;
  std::vector<bool> outcomes;
  for (int i = 0; i < 20'000; ++i) {
    const bool yes = i % 2 == 0;
    traits.push_back({(yes ? 1.0 : -1.0) + normal(), normal()});
    outcomes.push_back(yes);
  }
  const AdditiveModel model = fit_additive(traits, outcomes, 9, 1);
  for (const double x : {-1.5, -0.5, 0.0, 0.5, 1.5}) EXPECT_NEAR(model.odds({x, 0}), 2 * x, 0.25) << x;
  EXPECT_NEAR(model.odds({0.5, 1.5}), model.odds({0.5, -1.5}), 0.2);
}

TEST(AdditiveModel, FindsACurveThatIsNoLine) {
  // Yes nine times in ten within |x| < 1, once in ten outside.
  std::vector<std::vector<double>> traits;
  std::vector<bool> outcomes;
  for (int i = 0; i < 6000; ++i) {
    const double x = -3 + 6.0 * i / 5999;
    traits.push_back({x});
    outcomes.push_back((i % 10 == 0) != (std::abs(x) < 1));
  }
  const AdditiveModel model = fit_additive(traits, outcomes, 15, 0.1);
  EXPECT_NEAR(model.odds({0.0}), odds_of(0.9), 0.4);
  EXPECT_NEAR(model.odds({-2.5}), odds_of(0.1), 0.4);
  EXPECT_NEAR(model.odds({2.5}), odds_of(0.1), 0.4);
  EXPECT_NEAR(model.odds({1e9}), model.odds({3.0}), 1e-12) << "constant beyond what was seen";
}

TEST(AdditiveModel, GivesAValueThatMostShareOneKnot) {
  std::vector<std::vector<double>> traits;
  std::vector<bool> outcomes;
  for (int i = 0; i < 1000; ++i) {
    traits.push_back({i % 4 != 0 ? 0.0 : 1 + i / 1000.0});
    outcomes.push_back(i % 4 == 0 ? i % 3 != 0 : i % 3 == 0);
  }
  const AdditiveModel model = fit_additive(traits, outcomes, 5, 0.1);
  EXPECT_EQ(model.curves.front().at.front(), 0.0);
  EXPECT_GT(model.curves.front().at[1], 1.0);
  EXPECT_LT(model.odds({0.0}), 0);
  EXPECT_GT(model.odds({1.5}), 0);
}

TEST(AdditiveModel, RefusesWhatTeachesNothing) {
  EXPECT_THROW(static_cast<void>(fit_additive({}, {}, 5, 1)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(fit_additive({{1}, {2}}, {true, true}, 5, 1)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(fit_additive({{1}, {2, 3}}, {true, false}, 5, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace scenelore::learning
