// Rows of densities and logarithms, against the same formulas one number at a time with the C library in long double.
#include "row_math.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace scenelore::kb {
namespace {

constexpr OddValues kOdd{0.97, 0.015, 0.004};
constexpr std::size_t kSizes[] = {1, 2, 3, 7, 8, 9, 16, 31, 400};  // whole registers of any width, and what is left over

long double normal(long double square, long double variance) {
  return std::exp(-square / (2 * variance)) / std::sqrt(2 * std::numbers::pi_v<long double> * variance);
}

long double density(double square, double variance, double error) {
  const long double blur = static_cast<long double>(error) * error;
  return kOdd.usual * normal(square, variance + blur) + kOdd.odd * normal(square, 16.0L * variance + blur) + kOdd.uniform;
}

/// From 1e-6 to 1e6, evenly in the logarithm.
std::vector<double> any_magnitude(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<double> out(n);
  for (double& x : out) x = std::exp(std::uniform_real_distribution<double>(-13.8, 13.8)(random));
  return out;
}

TEST(RowMath, GivesDensitiesOfValuesWithAndWithoutErrors) {
  for (const std::size_t n : kSizes) {
    const std::vector<double> squares = any_magnitude(n, 1), variances = any_magnitude(n, 2);
    std::vector<double> exponents, peaks, out(n);
    for (const double variance : variances) {
      exponents.push_back(-1 / (32 * variance));
      peaks.push_back(1 / std::sqrt(2 * std::numbers::pi * variance));
    }
    for (const double error : {1e-3, 0.2, 50.0}) {
      blurred_densities(squares, variances, error, kOdd, out);
      for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(out[k] / static_cast<double>(density(squares[k], variances[k], error)), 1, 1e-13);
    }
    sharp_densities(squares, exponents, peaks, kOdd, out);
    for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(out[k] / static_cast<double>(density(squares[k], variances[k], 0)), 1, 1e-13);
  }
}

TEST(RowMath, GivesSquaredDistancesAlsoRoundACircle) {
  constexpr double kTurn = 360, kNone = std::numeric_limits<double>::quiet_NaN();
  std::mt19937_64 random(7);
  for (const double range : {kTurn, 3 * kTurn}) {  // the latter: values that have not been brought onto the circle
    std::vector<double> means{0, 90, 180, 270, kTurn, kNone};
    for (int i = 0; i < 100; ++i) means.push_back(std::uniform_real_distribution<double>(0, range)(random));
    std::vector<double> straight(means.size()), round(means.size());
    for (const double value : {0.0, 180.0, 359.9, std::uniform_real_distribution<double>(0, range)(random)}) {
      squared_distances(value, means, 0, straight);
      squared_distances(value, means, kTurn, round);
      for (std::size_t k = 0; k < means.size(); ++k) {
        const double distance = value - means[k], nearest = std::remainder(distance, kTurn);
        EXPECT_TRUE(std::isnan(means[k]) ? std::isnan(straight[k]) : straight[k] == distance * distance);
        EXPECT_TRUE(std::isnan(means[k]) ? std::isnan(round[k]) : round[k] == nearest * nearest) << value << " and " << means[k];
      }
    }
  }
}

TEST(RowMath, TakesLogarithmsOfEveryNormalNumber) {
  std::vector<double> x{1, std::numeric_limits<double>::min(), std::numeric_limits<double>::max(), std::numbers::e, 2, 0.5, std::sqrt(0.5), std::sqrt(2.0),
                        std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0), std::nextafter(std::sqrt(0.5), 0.0), 1e-300, 1e300};
  for (const double more : any_magnitude(2000, 3)) x.push_back(more);
  std::vector<double> out(x.size(), 0.0);
  add_logarithms(x, 1, out);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(out[k], std::log(x[k]), 4e-16 * std::abs(std::log(x[k]))) << x[k];
  add_logarithms(x, -0.5, out);
  for (std::size_t k = 0; k < x.size(); ++k) EXPECT_NEAR(out[k], 0.5 * std::log(x[k]), 4e-16 * std::abs(std::log(x[k]))) << x[k];
}

TEST(RowMath, SumsExponentialsHoweverSmallOrGreat) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(log_sum(std::vector{-3.0}), -3.0);
  EXPECT_DOUBLE_EQ(log_sum(std::vector{-2000.0, -2000.0}), -2000 + std::numbers::ln2);
  EXPECT_DOUBLE_EQ(log_sum(std::vector{5.0, -kInfinity, -900.0}), 5.0);
  EXPECT_DOUBLE_EQ(log_sum(std::vector{1e6, 1e6 - 1, 1e6 - 2}), 1e6 + std::log(1 + std::exp(-1.0) + std::exp(-2.0)));
}

TEST(RowMath, GivesEachNumberTheSameBitsWhereverItStands) {
  const std::vector<double> squares = any_magnitude(37, 4), variances = any_magnitude(37, 5);
  std::vector<double> all(37), one(1), logs(37, 0.0);
  blurred_densities(squares, variances, 0.1, kOdd, all);
  add_logarithms(all, 0.4, logs);
  for (std::size_t k = 0; k < all.size(); ++k) {
    blurred_densities(std::span(squares).subspan(k, 1), std::span(variances).subspan(k, 1), 0.1, kOdd, one);
    EXPECT_EQ(one[0], all[k]);
    std::vector<double> log(1, 0.0);
    add_logarithms(one, 0.4, log);
    EXPECT_EQ(log[0], logs[k]);
  }
}

TEST(RowMath, LetsNoNumberThatIsNoneGoUnseen) {
  const std::vector<double> squares{1, std::numeric_limits<double>::quiet_NaN(), 1}, variances{1, 1, std::numeric_limits<double>::quiet_NaN()};
  std::vector<double> out(3);
  blurred_densities(squares, variances, 0.1, kOdd, out);
  EXPECT_THAT(out, testing::ElementsAre(testing::Gt(0.0), testing::IsNan(), testing::IsNan()));
}

}  // namespace
}  // namespace scenelore::kb
