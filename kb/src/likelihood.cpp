#include "likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenelore::kb {

namespace {

constexpr double kTail = 4;  // how much wider odd values scatter than usual ones

double log_normal(double distance, double sigma) {
  const double z = distance / sigma;
  return -0.5 * z * z - std::log(sigma * std::sqrt(2 * std::numbers::pi));
}

}  // namespace

double log_add(double a, double b) {
  const double high = std::max(a, b), low = std::min(a, b);
  return std::isinf(high) ? high : high + std::log1p(std::exp(low - high));
}

double on_scale(const Feature& feature, double value) {
  return feature.scale == Scale::log ? std::log(std::max(value, feature.low)) : value;
}

double range_on_scale(const Feature& feature) {
  return feature.scale == Scale::log ? std::log(feature.high / feature.low) : feature.high - feature.low;
}

Likelihood::Likelihood(const Feature& feature, const ClassFeature* gaussian, std::vector<ClassDensity> bins, double outlier_share)
    : feature_(&feature), bins_(std::move(bins)), log_uniform_(-std::log(range_on_scale(feature))), outlier_share_(outlier_share) {
  if (gaussian != nullptr && feature.scale != Scale::circular) {
    tail_mean_ = gaussian->mean;
    tail_sigma_ = kTail * gaussian->sigma;
  }
  if (gaussian != nullptr && bins_.empty()) {
    mean_ = gaussian->mean;
    sigma_ = gaussian->sigma;
  }
}

// Equation (1) in logarithms.
double Likelihood::log_density(double value) const {
  const double own = log_own(value);
  if (outlier_share_ <= 0) return own;
  return log_add(std::log1p(-outlier_share_) + own, std::log(outlier_share_) + log_outlier(value));
}

double Likelihood::log_outlier(double value) const {
  if (std::isnan(tail_sigma_)) return log_uniform_;
  return log_add(log_uniform_, log_normal(on_scale(*feature_, value) - tail_mean_, tail_sigma_)) - std::numbers::ln2;
}

double Likelihood::log_own(double value) const {
  if (!bins_.empty()) return log_histogram(value);
  return std::isnan(sigma_) ? log_uniform_ : log_gaussian(value);
}

// On a circle of circumference T the normal density is wrapped: p(x) = Σ_k N(x + kT; μ, σ).   (2)
// From σ = T on, its deviation from uniform is below exp(−2π²), so uniform it is.
double Likelihood::log_gaussian(double value) const {
  const double distance = on_scale(*feature_, value) - mean_;
  if (feature_->scale != Scale::circular) return log_normal(distance, sigma_);
  const double turn = range_on_scale(*feature_);
  if (sigma_ >= turn) return log_uniform_;
  const double nearest = std::remainder(distance, turn);  // in [−T/2, T/2]
  double sum = log_normal(nearest, sigma_);
  for (int k = 1; k <= 6; ++k) {  // 6σ < 6T: terms beyond are below double precision
    sum = log_add(sum, log_normal(nearest + k * turn, sigma_));
    sum = log_add(sum, log_normal(nearest - k * turn, sigma_));
  }
  return sum;
}

// A bin holds its lower bound; the highest bin also holds its upper one.
double Likelihood::log_histogram(double value) const {
  if (feature_->scale == Scale::circular) {
    const double turn = range_on_scale(*feature_);
    value -= turn * std::floor((value - feature_->low) / turn);
  }
  const double least = log_uniform_ + kLogDensityFloor;
  const auto after = std::upper_bound(bins_.begin(), bins_.end(), value,
                                      [](double x, const ClassDensity& bin) { return x < bin.low; });
  if (after == bins_.begin()) return least;
  const ClassDensity& bin = *std::prev(after);
  const bool inside = value < bin.high || (after == bins_.end() && value == bin.high);
  return inside && bin.density > 0 ? std::max(std::log(bin.density), least) : least;
}

}  // namespace scenelore::kb
