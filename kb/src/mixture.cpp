#include "mixture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace scenelore::kb {

namespace {

template <typename Row>
double log_sum(const Row& logs) {
  const double highest = logs.maxCoeff();
  return highest + std::log((logs - highest).exp().sum());
}

double sigma_of(double half_precision) { return std::sqrt(0.5 / half_precision); }

}  // namespace

Mixture::Mixture(std::span<const ClassKind> kinds, std::span<const Feature* const> features, double outlier_share, std::span<const double> factors) {
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
  bounded_ = outlier_share > 0;
  for (Eigen::Index f = 0; f < rows; ++f) all_rows_.push_back(has_row_.row(f).all());
  blurs_.resize(features.size());
  log_inliers_ = inliers_.log();
  for (Eigen::Index k = 0; k < columns; ++k) {
    numbers_.push_back(kinds[static_cast<std::size_t>(k)].number);
    log_shares_[k] = std::log(kinds[static_cast<std::size_t>(k)].share * (factors.empty() ? 1 : factors[static_cast<std::size_t>(k)]));
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

Mixture::Row Mixture::distances(const MixtureInput& input) const {
  const auto f = static_cast<Eigen::Index>(input.feature);
  const double turn = turns_[input.feature];
  Row out = input.scaled - means_.row(f);
  if (turn > 0) out = out.unaryExpr([turn](double distance) { return std::remainder(distance, turn); });
  return out;
}

// With odd values, so that no density is 0.
Mixture::Row Mixture::densities(const MixtureInput& input) const {
  const auto f = static_cast<Eigen::Index>(input.feature);
  const double uniform = uniforms_[input.feature];
  const Row squares = distances(input).square();
  if (input.error > 0) {
    const Blur& blur = blur_of(f, input.error);
    return blur.near_peaks * (-squares / blur.near).exp() + blur.far_peaks * (-squares / blur.far).exp() + uniform;
  }
  static_assert(kTail == 4);  // so the two exponents are as 16 to one, and one exponential gives both
  const Row wide = (squares * half_precisions_.row(f) * (-1.0 / 16)).exp();
  return inliers_.row(f) * wide.square().square().square().square() + outliers_.row(f) * wide + uniform;
}

Mixture::Table Mixture::log_terms(std::span<const MixtureInput> inputs) const {
  const Eigen::Index columns = means_.cols();
  Table out(static_cast<Eigen::Index>(inputs.size()), columns + 1);
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    const MixtureInput& input = inputs[static_cast<std::size_t>(i)];
    const auto f = static_cast<Eigen::Index>(input.feature);
    out(i, columns) = input.own;
    if (uniforms_[input.feature] > 0) {
      out.row(i).head(columns) = densities(input).log();
    } else if (input.error > 0) {
      const Blur& blur = blur_of(f, input.error);
      out.row(i).head(columns) = blur.log_peaks - distances(input).square() / blur.near;
    } else {
      out.row(i).head(columns) = log_inliers_.row(f) - distances(input).square() * half_precisions_.row(f);
    }
    for (Eigen::Index k = 0; !all_rows_[input.feature] && k < columns; ++k) {
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

// Densities of one weight are multiplied before the logarithm, Σ_i F ln p_i = F ln Π_i p_i, which saves most logarithms. Odd values keep each
// factor above ε u / 2, so that a product of so many stays far from underflow.
double Mixture::log_density(std::span<const MixtureInput> inputs) const {
  constexpr std::size_t kFactors = 12;
  if (!bounded_) return log_sum(log_summands(inputs, log_terms(inputs)));
  const Eigen::Index columns = means_.cols();
  std::vector<std::size_t> order(inputs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return inputs[a].weight < inputs[b].weight; });
  Row logs = log_shares_, product(columns);
  for (std::size_t i = 0; i < order.size();) {
    const double weight = inputs[order[i]].weight;
    product.setOnes();
    for (std::size_t factors = 0; factors < kFactors && i < order.size() && inputs[order[i]].weight == weight; ++factors, ++i) {
      const MixtureInput& input = inputs[order[i]];
      const auto f = static_cast<Eigen::Index>(input.feature);
      if (all_rows_[input.feature]) {
        product *= densities(input);
      } else {
        product *= (has_row_.row(f) != 0).select(densities(input), 1.0);
        logs.head(columns) += (has_row_.row(f) != 0).select(Row::Zero(columns), weight * input.own);
      }
      logs[columns] += weight * input.own;
    }
    logs.head(columns) += weight * product.log();
  }
  return log_sum(logs);
}

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
