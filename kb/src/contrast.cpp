// Conditional maximum likelihood of kinds. Notation as in mixture.hpp; y_n the class of plane n, r_nk the share that kind k has of
// p(Φ_n|C_k), C_k its class, v_n what is at stake.
//
//   L = Σ_n v_n ln P(y_n|Φ_n) − λ/2 Σ_k [ (Δ ln s_k π_C)² + Σ_i ((Δμ_ki / σ_ki)² + (Δ ln σ_ki)²) ]                     (1)
//   ∂L/∂ ln(s_k π_C) = Σ_n v_n ([y_n = C_k] − P(C_k|Φ_n)) r_nk − …                                                      (2)
//
// and, of a mean or a deviation, the same sum weighed by F_i ∂ ln p(x_i|k): (1) is the maximum mutual information estimate of Bahl et
// al. 1986 with a Gaussian prior about the present kinds, and is climbed by Adam (Kingma & Ba 2015), each step with some of the planes.
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <thread>
#include <utility>

#include "kind_fit.hpp"
#include "likelihood.hpp"
#include "scenelore/kb/error.hpp"
#include "scenelore/kb/learn.hpp"

namespace scenelore::kb {

namespace {

using Row = Eigen::Array<double, 1, Eigen::Dynamic>;
using Table = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct Example {
  int truth = 0;
  double stake = 1;
  std::vector<double> x, error;  ///< by feature, on its scale; NaN = not known
  Row own;                       ///< Σ F_i ln p(x_i|C) by the rows of each class itself
};

/// Means, logarithms of deviations and of s_k π_C; a row a feature, a column a kind.
struct Parameters {
  Table means, log_sigmas;
  Row log_shares;

  static Parameters zero(Eigen::Index features, Eigen::Index kinds) {
    return {Table::Zero(features, kinds), Table::Zero(features, kinds), Row::Zero(kinds)};
  }
};

/// ∂ ln p(x|k) by mean and by ln σ, in units of 1 / σ for the mean; one of a plane and feature.
struct Slope {
  Row mean, log_sigma;
};

/// Steps of a pass over the planes; each takes every 64th, so that it sees planes of all scans.
constexpr std::size_t kSteps = 64;

class Contrast {
 public:
  Contrast(Knowledge knowledge, const LabelledPlanes& planes, const ContrastOptions& options);

  void climb();
  void give_back(LearnedRows& rows) const;

 private:
  void take_kinds();
  void take_examples(const LabelledPlanes& planes);
  void find_shares();
  void add_gradient(const Example& example, Parameters& gradient) const;
  [[nodiscard]] Parameters gradient(std::size_t step) const;
  /// ln of what of each class its own rows judge.
  [[nodiscard]] Row log_own_shares(const Row& log_shares) const;

  Knowledge knowledge_;
  ContrastOptions options_;
  double outlier_share_;
  std::vector<const Feature*> features_;
  std::vector<double> weights_, uniforms_, least_log_sigma_;  // by feature
  std::vector<std::string> classes_;
  std::vector<Eigen::Index> first_kind_;  // of each class, and the number of kinds at the end
  std::vector<double> log_priors_, kind_shares_;  // by class: present prior, how much of the class its kinds are
  Parameters present_, now_;
  std::vector<Row> shares_;  // by class: of its kinds, adding up to 1
  std::vector<Example> examples_;
};

Contrast::Contrast(Knowledge knowledge, const LabelledPlanes& planes, const ContrastOptions& options)
    : knowledge_(std::move(knowledge)), options_(options), outlier_share_(std::strtod(knowledge_.setting("outlier_share", "0").c_str(), nullptr)) {
  for (const Feature& feature : knowledge_.features) {
    const bool told = std::find(planes.features.names.begin(), planes.features.names.end(), feature.name) != planes.features.names.end();
    if (!told || feature.weight <= 0 || feature.scale == Scale::circular) continue;
    features_.push_back(&feature);
    weights_.push_back(feature.weight);
    uniforms_.push_back(outlier_share_ / 2 / range_on_scale(feature));
    least_log_sigma_.push_back(std::log(least_sigma(feature)));
  }
  take_kinds();
  take_examples(planes);
}

void Contrast::take_kinds() {
  double priors = 0;
  for (const ObjectClass& c : knowledge_.classes) priors += c.prior;
  std::vector<std::pair<const ClassKind*, double>> kinds;  // with the prior of its class
  for (const ObjectClass& c : knowledge_.classes) {
    classes_.push_back(c.name);
    log_priors_.push_back(std::log(c.prior / priors));
    kind_shares_.push_back(0);
    first_kind_.push_back(static_cast<Eigen::Index>(kinds.size()));
    for (const ClassKind& kind : knowledge_.kinds) {
      if (kind.object_class != c.name) continue;
      kinds.emplace_back(&kind, c.prior / priors);
      kind_shares_.back() += kind.share;
    }
  }
  first_kind_.push_back(static_cast<Eigen::Index>(kinds.size()));
  const auto rows = static_cast<Eigen::Index>(features_.size()), columns = static_cast<Eigen::Index>(kinds.size());
  present_ = Parameters::zero(rows, columns);
  for (Eigen::Index k = 0; k < columns; ++k) {
    const auto& [kind, prior] = kinds[static_cast<std::size_t>(k)];
    present_.log_shares[k] = std::log(kind->share * prior);
    for (Eigen::Index f = 0; f < rows; ++f) {
      const auto of = std::find_if(kind->features.begin(), kind->features.end(),
                                   [&](const KindFeature& row) { return row.feature == features_[static_cast<std::size_t>(f)]->name; });
      if (of == kind->features.end()) throw Error("kind " + std::to_string(kind->number) + " of class '" + kind->object_class + "' has no row for " + features_[static_cast<std::size_t>(f)]->name);
      present_.means(f, k) = of->mean;
      present_.log_sigmas(f, k) = std::log(of->sigma);
    }
  }
  now_ = present_;
}

void Contrast::take_examples(const LabelledPlanes& planes) {
  Knowledge own = knowledge_;
  own.kinds.clear();
  for (std::size_t p = 0; p < planes.classes.size(); ++p) {
    const int truth = knowledge_.class_index(planes.classes[p]);
    if (truth < 0) continue;
    Example& example = examples_.emplace_back();
    example.truth = truth;
    if (!planes.stakes.empty()) example.stake = planes.stakes[p];
    FeatureTable alone{planes.features.names, {planes.features.values[p]}, {}};
    for (const auto& [name, errors] : planes.features.errors) alone.errors[name] = {errors[p]};
    for (const Feature* feature : features_) {
      const auto column = static_cast<std::size_t>(std::find(alone.names.begin(), alone.names.end(), feature->name) - alone.names.begin());
      const double value = alone.values[0][column];
      example.x.push_back(std::isnan(value) ? value : on_scale(*feature, value));
      const auto error = alone.errors.find(feature->name);
      example.error.push_back(error == alone.errors.end() ? 0 : error->second[0]);
    }
    std::vector<std::pair<std::size_t, std::size_t>> entries;
    for (std::size_t c = 0; c < classes_.size(); ++c) entries.emplace_back(0, c);
    example.own = Row::Zero(static_cast<Eigen::Index>(classes_.size()));
    const auto told = contributions(own, alone, entries);
    for (std::size_t c = 0; c < told.size(); ++c) {
      for (const Contribution& term : told[c]) example.own[static_cast<Eigen::Index>(c)] += term.weight * term.log_likelihood;
    }
  }
}

Row Contrast::log_own_shares(const Row& log_shares) const {
  Row out(static_cast<Eigen::Index>(classes_.size()));
  for (std::size_t c = 0; c < classes_.size(); ++c) {
    const Eigen::Index first = first_kind_[c], count = first_kind_[c + 1] - first;
    const double left = 1 - kind_shares_[c];
    const double rest = left > 1e-9 ? std::log(left) : -std::numeric_limits<double>::infinity();
    out[static_cast<Eigen::Index>(c)] =
        count == 0 ? log_priors_[c] : rest - std::log(kind_shares_[c]) + std::log(log_shares.segment(first, count).exp().sum());
  }
  return out;
}

void Contrast::find_shares() {
  shares_.clear();
  for (std::size_t c = 0; c < classes_.size(); ++c) {
    const Row of = now_.log_shares.segment(first_kind_[c], first_kind_[c + 1] - first_kind_[c]).exp();
    shares_.push_back(of / of.sum());
  }
}

void Contrast::add_gradient(const Example& example, Parameters& gradient) const {
  const Eigen::Index kinds = now_.log_shares.size();
  const double peak = 1 / std::sqrt(2 * std::numbers::pi);
  Row logs = now_.log_shares;
  std::vector<Slope> slopes(features_.size());
  for (std::size_t f = 0; f < features_.size(); ++f) {
    if (std::isnan(example.x[f])) continue;
    const auto row = static_cast<Eigen::Index>(f);
    const Row distance = example.x[f] - now_.means.row(row), sigma = now_.log_sigmas.row(row).exp();
    const Row variance = sigma.square(), near = variance + example.error[f] * example.error[f],
              far = kTail * kTail * variance + example.error[f] * example.error[f];
    const Row of_near = (1 - outlier_share_) * peak * near.rsqrt() * (-0.5 * distance.square() / near).exp();
    const Row of_far = outlier_share_ / 2 * peak * far.rsqrt() * (-0.5 * distance.square() / far).exp();
    const Row density = of_near + of_far + uniforms_[f] + std::numeric_limits<double>::min();
    logs += weights_[f] * density.log();
    slopes[f].mean = (of_near / near + of_far / far) / density * distance * sigma;
    slopes[f].log_sigma = (of_near * (distance.square() / near - 1) * variance / near +
                           of_far * (distance.square() / far - 1) * kTail * kTail * variance / far) / density;
  }
  const Row own = log_own_shares(now_.log_shares) + example.own;
  Row of_class(own.size());
  for (Eigen::Index c = 0; c < own.size(); ++c) {
    const Eigen::Index first = first_kind_[static_cast<std::size_t>(c)], count = first_kind_[static_cast<std::size_t>(c) + 1] - first;
    const double highest = count > 0 ? std::max(own[c], logs.segment(first, count).maxCoeff()) : own[c];
    of_class[c] = highest + std::log(std::exp(own[c] - highest) + (logs.segment(first, count) - highest).exp().sum());
  }
  const Row posterior = (of_class - of_class.maxCoeff()).exp();
  const double all = posterior.sum();
  Row pull(kinds);  // [y = C_k] − P(C_k|Φ), times r_k
  for (Eigen::Index c = 0; c < own.size(); ++c) {
    const Eigen::Index first = first_kind_[static_cast<std::size_t>(c)], count = first_kind_[static_cast<std::size_t>(c) + 1] - first;
    const double of_all = example.stake * ((c == example.truth ? 1 : 0) - posterior[c] / all);
    pull.segment(first, count) = of_all * (logs.segment(first, count) - of_class[c]).exp();
    // What the class's own rows judge grows with all of its kinds.
    if (count > 0) gradient.log_shares.segment(first, count) += of_all * std::exp(own[c] - of_class[c]) * shares_[static_cast<std::size_t>(c)];
  }
  gradient.log_shares += pull;
  for (std::size_t f = 0; f < features_.size(); ++f) {
    if (std::isnan(example.x[f])) continue;
    gradient.means.row(static_cast<Eigen::Index>(f)) += weights_[f] * pull * slopes[f].mean;
    gradient.log_sigmas.row(static_cast<Eigen::Index>(f)) += weights_[f] * pull * slopes[f].log_sigma;
  }
}

/// Of a part of (1) that has every 64th plane, means in units of their deviations. Always in the same pieces, whatever the machine, so that
/// sums come out the same.
Parameters Contrast::gradient(std::size_t step) const {
  constexpr std::size_t kPieces = 2;
  std::vector<Parameters> parts(kPieces, Parameters::zero(now_.means.rows(), now_.means.cols()));
  {
    std::vector<std::jthread> workers;
    for (std::size_t piece = 0; piece < kPieces; ++piece) {
      workers.emplace_back([&, piece] {
        for (std::size_t i = step + piece * kSteps; i < examples_.size(); i += kPieces * kSteps) add_gradient(examples_[i], parts[piece]);
      });
    }
  }
  Parameters sum = std::move(parts.front());
  for (std::size_t piece = 1; piece < kPieces; ++piece) {
    sum.means += parts[piece].means, sum.log_sigmas += parts[piece].log_sigmas, sum.log_shares += parts[piece].log_shares;
  }
  const double strength = options_.strength / kSteps;
  sum.means -= strength * (now_.means - present_.means) / present_.log_sigmas.exp();
  sum.log_sigmas -= strength * (now_.log_sigmas - present_.log_sigmas);
  sum.log_shares -= strength * (now_.log_shares - present_.log_shares);
  return sum;
}

/// Adam, for parameters of one shape.
template <typename Values>
class Climber {
 public:
  Climber(const Values& like, double rate) : first_(Values::Zero(like.rows(), like.cols())), second_(first_), rate_(rate) {}

  Values step(const Values& gradient) {
    constexpr double kFirst = 0.9, kSecond = 0.99, kLeast = 1e-8;
    ++steps_;
    first_ = kFirst * first_ + (1 - kFirst) * gradient;
    second_ = kSecond * second_ + (1 - kSecond) * gradient.square();
    const double a = 1 - std::pow(kFirst, steps_), b = 1 - std::pow(kSecond, steps_);
    return rate_ * (first_ / a) / ((second_ / b).sqrt() + kLeast);
  }

 private:
  Values first_, second_;
  double rate_;
  int steps_ = 0;
};

void Contrast::climb() {
  constexpr double kRate = 0.05;
  Climber<Table> means(now_.means, kRate), log_sigmas(now_.means, kRate);
  Climber<Row> log_shares(now_.log_shares, kRate);
  const int steps = options_.passes * static_cast<int>(kSteps);
  for (int i = 0; i < steps; ++i) {
    find_shares();
    const Parameters slope = gradient(static_cast<std::size_t>(i) % kSteps);
    const double length = 1 - static_cast<double>(i) / steps;
    now_.means += length * means.step(slope.means) * present_.log_sigmas.exp();
    now_.log_sigmas += length * log_sigmas.step(slope.log_sigmas);
    now_.log_shares += length * log_shares.step(slope.log_shares);
    for (std::size_t f = 0; f < features_.size(); ++f) {
      auto row = now_.log_sigmas.row(static_cast<Eigen::Index>(f));
      row = row.max(least_log_sigma_[f]);
    }
  }
}

void Contrast::give_back(LearnedRows& rows) const {
  double priors = 0;
  std::vector<double> prior_of(classes_.size());
  for (std::size_t c = 0; c < classes_.size(); ++c) {
    const Eigen::Index first = first_kind_[c], count = first_kind_[c + 1] - first;
    prior_of[c] = count == 0 ? std::exp(log_priors_[c]) : now_.log_shares.segment(first, count).exp().sum() / kind_shares_[c];
    priors += prior_of[c];
  }
  for (LearnedClass& learned : rows.classes) {
    const auto c = static_cast<std::size_t>(std::find(classes_.begin(), classes_.end(), learned.object_class) - classes_.begin());
    learned.prior = prior_of[c] / priors;
    for (std::size_t k = 0; k < learned.kinds.size(); ++k) {
      const Eigen::Index column = first_kind_[c] + static_cast<Eigen::Index>(k);
      ClassKind& kind = learned.kinds[k];
      kind.share = std::exp(now_.log_shares[column]) / prior_of[c];
      for (std::size_t f = 0; f < features_.size(); ++f) {
        for (KindFeature& of : kind.features) {
          if (of.feature != features_[f]->name) continue;
          of.mean = now_.means(static_cast<Eigen::Index>(f), column);
          of.sigma = std::exp(now_.log_sigmas(static_cast<Eigen::Index>(f), column));
        }
      }
    }
  }
}

}  // namespace

void contrast(const Knowledge& knowledge, const LabelledPlanes& planes, LearnedRows& rows, const ContrastOptions& options) {
  if (!planes.stakes.empty() && planes.stakes.size() != planes.classes.size())
    throw Error("what is at stake is known of " + std::to_string(planes.stakes.size()) + " planes of " + std::to_string(planes.classes.size()));
  Contrast contrast(with_rows(knowledge, rows), planes, options);
  contrast.climb();
  contrast.give_back(rows);
}

}  // namespace scenelore::kb
