#include "mixture.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <unordered_map>

#include "row_math.hpp"

namespace scenelore::kb {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
const double kPeak = 1 / std::sqrt(2 * std::numbers::pi);  // of the normal distribution

template <typename Row>
std::span<const double> numbers(const Row& row) {
  return {row.data(), static_cast<std::size_t>(row.size())};
}

std::span<double> numbers(Eigen::Array<double, 1, Eigen::Dynamic>& row) { return {row.data(), static_cast<std::size_t>(row.size())}; }

}  // namespace

Mixtures::Mixtures(std::span<const MixtureClass> classes, std::span<const Feature* const> features, double outlier_share)
    : untold_(features.size()), outlier_share_(outlier_share) {
  std::unordered_map<std::string_view, Eigen::Index> rows;
  for (const Feature* feature : features) {
    rows.emplace(feature->name, static_cast<Eigen::Index>(rows.size()));
    turns_.push_back(feature->scale == Scale::circular ? range_on_scale(*feature) : 0);
    uniforms_.push_back(outlier_share / 2 / range_on_scale(*feature));
  }
  starts_.push_back(0);
  for (const MixtureClass& of : classes) starts_.push_back(starts_.back() + static_cast<Eigen::Index>(of.kinds.size()) + 1);
  means_ = Table::Constant(static_cast<Eigen::Index>(features.size()), starts_.back(), kNone);
  sigmas_ = Table::Ones(means_.rows(), means_.cols());
  log_shares_.resize(starts_.back());
  const auto add = [&](Eigen::Index f, double mean, double sigma) {
    means_(f, static_cast<Eigen::Index>(numbers_.size())) = mean;
    sigmas_(f, static_cast<Eigen::Index>(numbers_.size())) = sigma;
  };
  const auto end_column = [&](const MixtureClass& of, int number, double log_share) {
    const auto column = static_cast<Eigen::Index>(numbers_.size());
    for (Eigen::Index f = 0; f < means_.rows(); ++f) {
      const auto feature = static_cast<std::size_t>(f);
      if (std::isnan(means_(f, column))) untold_[feature].push_back({column, of.own[feature]});
    }
    log_shares_[column] = log_share;
    numbers_.push_back(number);
  };
  for (const MixtureClass& of : classes) {
    double shares = 0;
    for (std::size_t k = 0; k < of.kinds.size(); ++k) {
      const ClassKind& kind = of.kinds[k];
      for (const KindFeature& row : kind.features) {
        const auto found = rows.find(row.feature);
        if (found != rows.end()) add(found->second, row.mean, row.sigma);
      }
      end_column(of, kind.number, std::log(kind.share * (of.factors.empty() ? 1 : of.factors[k])));
      shares += kind.share;
    }
    for (std::size_t f = 0; f < features.size(); ++f) {  // on circles a class's own rows know all images, and odd values are uniform
      if (turns_[f] <= 0) add(static_cast<Eigen::Index>(f), of.own[f]->mean(), of.own[f]->sigma());
    }
    end_column(of, 0, shares < 1 ? std::log(1 - shares) : -std::numeric_limits<double>::infinity());
  }
  variances_ = sigmas_.square();
  exponents_ = -0.5 / (kTail * sigmas_).square();
  peaks_ = kPeak / sigmas_;
}

Mixtures::Columns Mixtures::of_class(std::size_t object_class) const {
  return {starts_[object_class], starts_[object_class + 1] - starts_[object_class]};
}

void Mixtures::put_squares(const MixtureInput& input, Columns columns, Row& out) const {
  out.resize(columns.count);
  const auto means = means_.row(static_cast<Eigen::Index>(input.feature)).segment(columns.first, columns.count);
  squared_distances(input.scaled, numbers(means), turns_[input.feature], numbers(out));
}

// Each Gaussian, the wide one of odd values too, seen through normal errors.
void Mixtures::put_densities(const MixtureInput& input, Columns columns, Row& out) const {
  const auto row = [&](const Table& table) { return numbers(table.row(static_cast<Eigen::Index>(input.feature)).segment(columns.first, columns.count)); };
  const OddValues odd{1 - outlier_share_, outlier_share_ / 2, uniforms_[input.feature]};
  put_squares(input, columns, out);
  if (input.error > 0) {
    blurred_densities(numbers(out), row(variances_), input.error, odd, numbers(out));
  } else {
    sharp_densities(numbers(out), row(exponents_), row(peaks_), odd, numbers(out));
  }
  for_each_untold(input, columns, [&](Eigen::Index column, double log_density) { out[column] = std::exp(log_density); });
}

void Mixtures::put_log_densities(const MixtureInput& input, Columns columns, Row& out) const {
  const auto sigmas = sigmas_.row(static_cast<Eigen::Index>(input.feature)).segment(columns.first, columns.count);
  if (outlier_share_ > 0) {
    put_densities(input, columns, out);
    out = out.log();
  } else {
    const auto variances = sigmas.square() + input.error * input.error;
    put_squares(input, columns, out);
    out = std::log(kPeak) - 0.5 * (variances.log() + out / variances);
  }
  for_each_untold(input, columns, [&](Eigen::Index column, double log_density) { out[column] = log_density; });
}

template <typename Visit>
void Mixtures::for_each_untold(const MixtureInput& input, Columns columns, Visit visit) const {
  const Likelihood* asked = nullptr;
  double log_density = 0;
  for (const auto& [column, own] : untold_[input.feature]) {
    if (column < columns.first || column >= columns.first + columns.count) continue;
    if (own != asked) log_density = own->log_density(input.value, input.scaled, input.error);
    asked = own;
    visit(column - columns.first, log_density);
  }
}

// Densities of one weight are multiplied before the logarithm, Σ_i F ln p_i = F ln Π_i p_i, which saves most logarithms. Odd values keep each
// factor above ε u / 2, so that a product of so many stays far from underflow.
Mixtures::Row Mixtures::log_summands(std::span<const MixtureInput> inputs) const {
  constexpr std::size_t kFactors = 12;
  const Columns all{0, means_.cols()};
  Row logs = log_shares_, densities(all.count), product(all.count);
  if (outlier_share_ <= 0) {
    for (const MixtureInput& input : inputs) {
      put_log_densities(input, all, densities);
      logs += input.weight * densities;
    }
    return logs;
  }
  for (std::size_t i = 0; i < inputs.size();) {
    const double weight = inputs[i].weight;
    product.setOnes();
    for (std::size_t factors = 0; factors < kFactors && i < inputs.size() && inputs[i].weight == weight; ++factors, ++i) {
      put_densities(inputs[i], all, densities);
      multiply(numbers(densities), numbers(product));
    }
    add_logarithms(numbers(product), weight, numbers(logs));
  }
  return logs;
}

std::vector<double> Mixtures::log_densities(std::span<const MixtureInput> inputs) const {
  const Row logs = log_summands(inputs);
  std::vector<double> out;
  for (std::size_t c = 0; c + 1 < starts_.size(); ++c) out.push_back(log_sum(numbers(logs.segment(of_class(c).first, of_class(c).count))));
  return out;
}

Mixtures::Division Mixtures::divide(std::size_t object_class, std::span<const MixtureInput> inputs) const {
  const Columns columns = of_class(object_class);
  const auto log_shares = log_shares_.segment(columns.first, columns.count);
  Table terms(static_cast<Eigen::Index>(inputs.size()), columns.count);  // ln p(x_i|k)
  Row logs = log_shares, term(columns.count);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    put_log_densities(inputs[i], columns, term);
    terms.row(static_cast<Eigen::Index>(i)) = term;
    logs += inputs[i].weight * term;
  }
  const double all = log_sum(numbers(logs));
  const Row shares = (logs - all).exp();
  Division out;
  Eigen::Index likeliest = 0;
  shares.maxCoeff(&likeliest);
  out.likeliest = numbers_[static_cast<std::size_t>(columns.first + likeliest)];
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto f = static_cast<Eigen::Index>(inputs[i].feature);
    const double mean = out.likeliest == 0 ? kNone : means_(f, columns.first + likeliest);
    out.means.push_back(mean);
    out.sigmas.push_back(std::isnan(mean) ? kNone : sigmas_(f, columns.first + likeliest));
    out.log_likelihoods.push_back((terms.row(static_cast<Eigen::Index>(i)) * shares).sum());
  }
  for (Eigen::Index k = 0; k < columns.count; ++k) {
    if (shares[k] > 0) out.usual += shares[k] * (log_shares[k] - (logs[k] - all));
  }
  return out;
}

}  // namespace scenelore::kb
