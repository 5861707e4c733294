#include "mixture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace scenelore::kb {

namespace {

template <typename Row>
double log_sum(const Row& logs) {
  const double highest = logs.maxCoeff();
  return highest + std::log((logs - highest).exp().sum());
}

double sigma_of(double half_precision) { return std::sqrt(0.5 / half_precision); }

}  // namespace

Mixture::Mixture(std::span<const ClassKind> kinds, std::span<const Feature* const> features, double outlier_share) {
  const auto rows = static_cast<Eigen::Index>(features.size()), columns = static_cast<Eigen::Index>(kinds.size());
  if (columns == 0) return;
  means_ = half_precisions_ = inliers_ = outliers_ = Table::Zero(rows, columns);
  has_row_ = Eigen::ArrayXXi::Zero(rows, columns);
  log_shares_.resize(columns + 1);
  double shares = 0;
  for (Eigen::Index f = 0; f < rows; ++f) {
    const Feature& feature = *features[static_cast<std::size_t>(f)];
    turns_.push_back(feature.scale == Scale::circular ? range_on_scale(feature) : 0);
    uniforms_.push_back(outlier_share / 2 / range_on_scale(feature));
    for (Eigen::Index k = 0; k < columns; ++k) {
      const std::vector<KindFeature>& of = kinds[static_cast<std::size_t>(k)].features;
      const auto row = std::find_if(of.begin(), of.end(), [&](const KindFeature& r) { return r.feature == feature.name; });
      if (row == of.end()) continue;
      const double peak = 1 / (row->sigma * std::sqrt(2 * std::numbers::pi));
      means_(f, k) = row->mean;
      half_precisions_(f, k) = 0.5 / (row->sigma * row->sigma);
      inliers_(f, k) = (1 - outlier_share) * peak;
      outliers_(f, k) = outlier_share / 2 * peak / kTail;
      has_row_(f, k) = 1;
    }
  }
  all_rows_ = has_row_.all();
  blurs_.resize(features.size());
  log_inliers_ = inliers_.log();
  for (Eigen::Index k = 0; k < columns; ++k) {
    numbers_.push_back(kinds[static_cast<std::size_t>(k)].number);
    log_shares_[k] = std::log(kinds[static_cast<std::size_t>(k)].share);
    shares += kinds[static_cast<std::size_t>(k)].share;
  }
  log_shares_[columns] = shares < 1 ? std::log(1 - shares) : -std::numeric_limits<double>::infinity();
}

// Each Gaussian, the wide one of odd values too, seen through normal errors.
const Mixture::Blur& Mixture::blur_of(Eigen::Index f, double error) const {
  Blur& blur = blurs_[static_cast<std::size_t>(f)];
  if (blur.error == error) return blur;
  const Eigen::Index columns = means_.cols();
  for (Row* row : {&blur.near, &blur.far, &blur.near_peaks, &blur.far_peaks, &blur.log_peaks}) row->resize(columns);
  for (Eigen::Index k = 0; k < columns; ++k) {
    const double sigma = sigma_of(half_precisions_(f, k)), near = std::hypot(sigma, error), far = std::hypot(kTail * sigma, error);
    blur.near[k] = 2 * near * near;
    blur.far[k] = 2 * far * far;
    blur.near_peaks[k] = inliers_(f, k) * sigma / near;
    blur.far_peaks[k] = outliers_(f, k) * kTail * sigma / far;
    blur.log_peaks[k] = log_inliers_(f, k) + std::log(sigma / near);
  }
  blur.error = error;
  return blur;
}

double Mixture::blurred(Eigen::Index f, Eigen::Index k, const MixtureInput& input) const {
  const Blur& blur = blur_of(f, input.error);
  const double turn = turns_[input.feature], uniform = uniforms_[input.feature];
  const double distance = turn > 0 ? std::remainder(input.scaled - means_(f, k), turn) : input.scaled - means_(f, k);
  const double near = distance * distance / blur.near[k];
  if (uniform <= 0) return blur.log_peaks[k] - near;
  return std::log(blur.near_peaks[k] * std::exp(-near) + blur.far_peaks[k] * std::exp(-(distance * distance / blur.far[k])) + uniform);
}

Mixture::Table Mixture::log_terms(std::span<const MixtureInput> inputs) const {
  static_assert(kTail == 4);  // so the two exponents are as 16 to one, and one exponential gives both
  const Eigen::Index columns = means_.cols();
  Table out(static_cast<Eigen::Index>(inputs.size()), columns + 1);
  Row exponents, wide;
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    const MixtureInput& input = inputs[static_cast<std::size_t>(i)];
    const auto f = static_cast<Eigen::Index>(input.feature);
    out(i, columns) = input.own;
    const double uniform = uniforms_[input.feature];
    if (input.error > 0 || turns_[input.feature] > 0) {
      for (Eigen::Index k = 0; k < columns; ++k) out(i, k) = has_row_(f, k) != 0 ? blurred(f, k, input) : input.own;
      continue;
    }
    exponents = (input.scaled - means_.row(f)).square() * half_precisions_.row(f);
    if (uniform <= 0) {
      out.row(i).head(columns) = log_inliers_.row(f) - exponents;
    } else {
      wide = (exponents * (-1.0 / 16)).exp();
      out.row(i).head(columns) = (inliers_.row(f) * wide.square().square().square().square() + outliers_.row(f) * wide + uniform).log();
    }
    for (Eigen::Index k = 0; !all_rows_ && k < columns; ++k) {
      if (has_row_(f, k) == 0) out(i, k) = input.own;
    }
  }
  return out;
}

Mixture::Row Mixture::log_summands(std::span<const MixtureInput> inputs, const Table& terms) const {
  Row logs = log_shares_;
  for (Eigen::Index i = 0; i < terms.rows(); ++i) logs += inputs[static_cast<std::size_t>(i)].weight * terms.row(i);
  return logs;
}

double Mixture::log_density(std::span<const MixtureInput> inputs) const { return log_sum(log_summands(inputs, log_terms(inputs))); }

Mixture::Division Mixture::divide(std::span<const MixtureInput> inputs) const {
  const Table terms = log_terms(inputs);
  const Row logs = log_summands(inputs, terms);
  const double all = log_sum(logs);
  const Row shares = (logs - all).exp();
  Division out;
  Eigen::Index likeliest = 0;
  shares.maxCoeff(&likeliest);
  const bool own = likeliest == means_.cols();
  out.likeliest = own ? 0 : numbers_[static_cast<std::size_t>(likeliest)];
  for (Eigen::Index i = 0; i < terms.rows(); ++i) {
    const auto f = static_cast<Eigen::Index>(inputs[static_cast<std::size_t>(i)].feature);
    const bool told = !own && has_row_(f, likeliest) != 0;
    out.means.push_back(told ? means_(f, likeliest) : std::numeric_limits<double>::quiet_NaN());
    out.sigmas.push_back(told ? sigma_of(half_precisions_(f, likeliest)) : std::numeric_limits<double>::quiet_NaN());
    out.log_likelihoods.push_back((terms.row(i) * shares).sum());
  }
  for (Eigen::Index k = 0; k < shares.size(); ++k) {
    if (shares[k] > 0) out.usual += shares[k] * (log_shares_[k] - (logs[k] - all));
  }
  return out;
}

}  // namespace scenelore::kb
