#include "likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenelore::kb {

double log_add(double a, double b) {
  const double high = std::max(a, b), low = std::min(a, b);
  if (low - high < -40 && std::abs(high) > 0.1) return high;  // e^-40 is less than half of the last digit: the same bits, sooner
  return std::isinf(high) ? high : high + std::log1p(std::exp(low - high));
}

double on_scale(const Feature& feature, double value) {
  return feature.scale == Scale::log ? std::log(std::max(value, feature.low)) : value;
}

double range_on_scale(const Feature& feature) {
  return feature.scale == Scale::log ? std::log(feature.high / feature.low) : feature.high - feature.low;
}

Likelihood::LogNormal::LogNormal(double s) : sigma(s), log_scale(std::log(s * std::sqrt(2 * std::numbers::pi))) {}

double Likelihood::LogNormal::operator()(double distance) const {
  const double z = distance / sigma;
  return -0.5 * z * z - log_scale;
}

Likelihood::Likelihood(const Feature& feature, const ClassFeature* gaussian, const std::vector<const ClassDensity*>& bins, double outlier_share,
                       bool with_errors)
    : feature_(&feature), range_(range_on_scale(feature)), log_uniform_(-std::log(range_)), outlier_share_(outlier_share),
      log_inlier_share_(std::log1p(-outlier_share)), log_outlier_share_(std::log(outlier_share)),
      low_on_scale_(on_scale(feature, feature.low)), least_(std::exp(log_uniform_ + kLogDensityFloor)) {
  const double least = log_uniform_ + kLogDensityFloor;
  bins_.reserve(bins.size());
  for (const ClassDensity* bin : bins) {
    const double log_density = bin->density > 0 ? std::max(std::log(bin->density), least) : least;
    bins_.push_back({bin->low, bin->high, log_density});
    if (with_errors) boxes_.push_back({on_scale(feature, bin->low), on_scale(feature, bin->high), std::exp(log_density)});
  }
  if (gaussian != nullptr && feature.scale != Scale::circular) {
    tail_mean_ = gaussian->mean;
    tail_ = LogNormal(kTail * gaussian->sigma);
  }
  if (gaussian != nullptr && bins_.empty()) {
    mean_ = gaussian->mean;
    sigma_ = gaussian->sigma;
    normal_ = LogNormal(sigma_);
  }
}

// Equation (1) in logarithms.
double Likelihood::log_density(double value, double scaled, double error) const {
  if (feature_->scale == Scale::circular) error = 0;
  const double own = log_own(value, scaled, error);
  if (outlier_share_ <= 0) return own;
  return log_add(log_inlier_share_ + own, log_outlier_share_ + log_outlier(scaled, error));
}

double Likelihood::log_outlier(double scaled, double error) const {
  if (std::isnan(tail_.sigma)) return log_uniform_;
  const double far = scaled - tail_mean_;
  return log_add(log_uniform_, error > 0 ? LogNormal(std::hypot(tail_.sigma, error))(far) : tail_(far)) - std::numbers::ln2;
}

double Likelihood::log_own(double value, double scaled, double error) const {
  if (!bins_.empty()) return error > 0 ? log_blurred(scaled, error) : log_histogram(value);
  if (std::isnan(sigma_)) return log_uniform_;
  return error > 0 ? LogNormal(std::hypot(sigma_, error))(scaled - mean_) : log_gaussian(scaled);
}

// Each bin is a box, and a box seen through normal errors a difference of two normal distribution functions.
double Likelihood::log_blurred(double scaled, double error) const {
  const double low = low_on_scale_, high = low + range_;
  double sum = 0;
  for (const double image : {scaled, 2 * low - scaled, 2 * high - scaled}) {
    const auto below = [&](double bound) { return 0.5 * std::erfc((image - bound) / (error * std::numbers::sqrt2)); };
    if (image != scaled && std::min(std::abs(image - low), std::abs(image - high)) > 8 * error) continue;
    double edge = std::numeric_limits<double>::quiet_NaN(), share = 0;  // of the box before
    for (const Box& box : boxes_) {
      const double from = box.low == edge ? share : below(box.low);
      edge = box.high;
      share = below(edge);
      sum += box.density * (share - from);
    }
  }
  return std::log(std::max(sum, least_));
}

// On a circle of circumference T the normal density is wrapped: p(x) = Σ_k N(x + kT; μ, σ).   (2)
// From σ = T on, its deviation from uniform is below exp(−2π²), so uniform it is.
double Likelihood::log_gaussian(double scaled) const {
  const double distance = scaled - mean_;
  if (feature_->scale != Scale::circular) return normal_(distance);
  const double turn = range_on_scale(*feature_);
  if (sigma_ >= turn) return log_uniform_;
  const double nearest = std::remainder(distance, turn);  // in [−T/2, T/2]
  double sum = normal_(nearest);
  for (int k = 1; k <= 6; ++k) {  // 6σ < 6T: terms beyond are below double precision
    sum = log_add(sum, normal_(nearest + k * turn));
    sum = log_add(sum, normal_(nearest - k * turn));
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
                                      [](double x, const Bin& bin) { return x < bin.low; });
  if (after == bins_.begin()) return least;
  const Bin& bin = *std::prev(after);
  const bool inside = value < bin.high || (after == bins_.end() && value == bin.high);
  return inside ? bin.log_density : least;
}

}  // namespace scenelore::kb
