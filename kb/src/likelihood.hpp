// p(x|C): what one feature's value is worth under one class.
#pragma once

#include <limits>
#include <vector>

#include "scenelore/kb/knowledge.hpp"

namespace scenelore::kb {

/// ln p0 below which no histogram falls, relative to the uniform density: a value outside all bins, or in an empty one,
/// counts as a millionth of uniform, not as impossible. Doubt is expressed by the setting `outlier_share`; this only
/// keeps the logarithm finite where that is 0.
inline constexpr double kLogDensityFloor = -13.815510557964274;  // ln 1e-6

/// How much wider odd values scatter than usual ones: k of (1).
inline constexpr double kTail = 4;

/// A value on the scale of its feature: ln x for log (values below `low`, zero and negative ones too, count as `low`,
/// since a logarithm has no smaller sensible value), x itself else.
[[nodiscard]] double on_scale(const Feature& feature, double value);

/// Length of the feature's range on its scale; the uniform density is 1 / range.
[[nodiscard]] double range_on_scale(const Feature& feature);

/// The density of one feature given one class: a histogram where there are class_density rows, else a Gaussian where
/// there is a class_feature row, else uniform over the feature's range (also for values outside it).
/// Densities are per unit of the scale, so that all classes are compared in the same unit.
class Likelihood {
 public:
  /// `outlier_share` ε mixes in what odd values follow: p = (1 − ε) p0 + ε (u + N(μ, (kσ)²)) / 2 with k = 4, u the uniform
  /// density and μ, σ the class's Gaussian; without a Gaussian, on circles, u alone.   (1)
  /// After Tukey 1960, A survey of sampling from contaminated distributions (his k is 3): other rooms and other sensors
  /// than those learned from stray near the usual values more often than far from them.
  /// `bins` by low. `with_errors`: whether log_density may be asked about values with a standard error.
  Likelihood(const Feature& feature, const ClassFeature* gaussian, const std::vector<const ClassDensity*>& bins, double outlier_share,
             bool with_errors = true);

  [[nodiscard]] double log_density(double value) const { return log_density(value, on_scale(*feature_, value)); }
  /// The same for callers that ask many classes about one value: `scaled` = on_scale(feature, value). `error` ≥ 0: standard
  /// error of the value on the scale, which every part of the density is convolved with (a histogram is folded back at the ends of the
  /// feature's range, since a tilt of −3° is one of 3°; a density on a circle takes no errors).
  [[nodiscard]] double log_density(double value, double scaled, double error = 0) const;
  /// NaN where no Gaussian decides.
  [[nodiscard]] double mean() const { return mean_; }
  [[nodiscard]] double sigma() const { return sigma_; }

 private:
  struct Bin {
    double low, high, log_density;  ///< bounds in the feature's unit
  };
  struct Box {
    double low, high, density;  ///< bounds on the scale
  };
  /// ln N(μ + distance; μ, σ), the constant part of the logarithm computed once.
  struct LogNormal {
    double sigma = std::numeric_limits<double>::quiet_NaN(), log_scale = sigma;
    LogNormal() = default;
    explicit LogNormal(double s);
    [[nodiscard]] double operator()(double distance) const;
  };

  [[nodiscard]] double log_own(double value, double scaled, double error) const;
  [[nodiscard]] double log_outlier(double scaled, double error) const;
  [[nodiscard]] double log_blurred(double scaled, double error) const;
  [[nodiscard]] double log_gaussian(double scaled) const;
  [[nodiscard]] double log_histogram(double value) const;

  const Feature* feature_;
  double mean_ = std::numeric_limits<double>::quiet_NaN(), sigma_ = mean_;
  LogNormal normal_, tail_;  // of sigma NaN: none
  std::vector<Bin> bins_;    // by low
  std::vector<Box> boxes_;   // the same, for values with errors
  double tail_mean_ = mean_;
  double range_;             // on the scale
  double log_uniform_, outlier_share_, log_inlier_share_, log_outlier_share_;
  double low_on_scale_, least_;  // of the feature's range; of a blurred density
};

/// ln(eᵃ + eᵇ) without overflow.
[[nodiscard]] double log_add(double a, double b);

}  // namespace scenelore::kb
