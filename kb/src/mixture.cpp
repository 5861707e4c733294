#include "mixture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace scenelore::kb {

namespace {

double log_sum(const std::vector<double>& logs) {
  const double highest = *std::max_element(logs.begin(), logs.end());
  double sum = 0;
  for (const double value : logs) sum += std::exp(value - highest);
  return highest + std::log(sum);
}

}  // namespace

KindTerm::KindTerm(const Feature& feature, const KindFeature& row, double outlier_share)
    : mean_(row.mean), sigma_(row.sigma), half_precision_(0.5 / (row.sigma * row.sigma)), turn_(feature.scale == Scale::circular ? range_on_scale(feature) : 0) {
  const double peak = 1 / (row.sigma * std::sqrt(2 * std::numbers::pi));
  inlier_ = (1 - outlier_share) * peak;
  outlier_ = outlier_share / 2 * peak / kTail;
  uniform_ = outlier_share / 2 / range_on_scale(feature);
  log_inlier_ = std::log(inlier_);
}

// Each Gaussian, the wide one of odd values too, seen through normal errors.
double KindTerm::log_blurred(double distance, double error) const {
  const double near = std::hypot(sigma_, error), far = std::hypot(kTail * sigma_, error);
  const auto exponent = [distance](double sigma) { return distance * distance / (2 * sigma * sigma); };
  if (uniform_ <= 0) return log_inlier_ + std::log(sigma_ / near) - exponent(near);
  return std::log(inlier_ * sigma_ / near * std::exp(-exponent(near)) + outlier_ * kTail * sigma_ / far * std::exp(-exponent(far)) + uniform_);
}

Mixture::Mixture(std::span<const ClassKind> kinds, std::span<const Feature* const> features, double outlier_share) {
  double shares = 0;
  for (const ClassKind& row : kinds) {
    shares += row.share;
    Kind kind{.number = row.number, .log_share = std::log(row.share), .term_of_feature = std::vector<int>(features.size(), -1), .terms = {}};
    for (const KindFeature& of : row.features) {
      const auto found = std::find_if(features.begin(), features.end(), [&](const Feature* f) { return f->name == of.feature; });
      if (found == features.end()) continue;  // its weight is 0, or the scan has no such feature
      kind.term_of_feature[static_cast<std::size_t>(found - features.begin())] = static_cast<int>(kind.terms.size());
      kind.terms.emplace_back(**found, of, outlier_share);
    }
    kinds_.push_back(std::move(kind));
  }
  log_own_share_ = shares < 1 ? std::log(1 - shares) : -std::numeric_limits<double>::infinity();
}

const KindTerm* Mixture::term(int kind, std::size_t feature) const {
  if (kind < 0) return nullptr;
  const Kind& of = kinds_[static_cast<std::size_t>(kind)];
  return of.term_of_feature[feature] < 0 ? nullptr : &of.terms[static_cast<std::size_t>(of.term_of_feature[feature])];
}

double Mixture::log_share(int kind) const { return kind < 0 ? log_own_share_ : kinds_[static_cast<std::size_t>(kind)].log_share; }

double Mixture::log_density(const MixtureInput& input, int kind) const {
  const KindTerm* const term = this->term(kind, input.feature);
  return term == nullptr ? input.own : term->log_density(input.scaled, input.error);
}

double Mixture::log_product(std::span<const MixtureInput> inputs, int kind) const {
  double log = log_share(kind);
  if (kind < 0) {
    for (const MixtureInput& input : inputs) log += input.weight * input.own;
    return log;
  }
  const Kind& of = kinds_[static_cast<std::size_t>(kind)];
  for (const MixtureInput& input : inputs) {
    const int term = of.term_of_feature[input.feature];
    log += input.weight * (term < 0 ? input.own : of.terms[static_cast<std::size_t>(term)].log_density(input.scaled, input.error));
  }
  return log;
}

double Mixture::log_density(std::span<const MixtureInput> inputs) const {
  std::vector<double> logs{log_product(inputs, -1)};
  for (int kind = 0; kind < static_cast<int>(kinds_.size()); ++kind) logs.push_back(log_product(inputs, kind));
  return log_sum(logs);
}

Responsibilities Mixture::responsibilities(std::span<const MixtureInput> inputs) const {
  Responsibilities out{log_product(inputs, -1)};
  for (int kind = 0; kind < static_cast<int>(kinds_.size()); ++kind) out.push_back(log_product(inputs, kind));
  const double all = log_sum(out);
  for (double& share : out) share = std::exp(share - all);
  return out;
}

}  // namespace scenelore::kb
