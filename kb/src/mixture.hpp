// p(Φ|C) of a class that has kinds (class_kind rows): a mixture, inside of which features are independent.
//
//   p(Φ|C) = (1 − Σ s_k) Π_i p(x_i|C)^F_i + Σ_k s_k Π_i p(x_i|k)^F_i                                              (5)
//
// s_k share of kind k, F_i weight of feature i, p(x_i|C) by the class's own rows, which also stand in where a kind has no row.
// The latent class model of Lazarsfeld & Henry 1968 with Gaussians; without kinds it is the product of knowledge.md.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "likelihood.hpp"

namespace scenelore::kb {

/// What (1) of likelihood.hpp makes of a Gaussian: p = (1 − ε) N(x; μ, σ) + ε (u + N(x; μ, 4σ)) / 2, cheap to ask. On circles x is the
/// image nearest to μ.
class KindTerm {
 public:
  KindTerm(const Feature& feature, const KindFeature& row, double outlier_share);

  /// `error`: standard error of the value, which both σ are widened by.
  [[nodiscard]] double log_density(double scaled, double error) const {
    const double distance = turn_ > 0 ? std::remainder(scaled - mean_, turn_) : scaled - mean_;
    if (error > 0) return log_blurred(distance, error);
    const double exponent = distance * distance * half_precision_;
    if (uniform_ <= 0) return log_inlier_ - exponent;
    static_assert(kTail == 4);  // the two exponents are as 16 to one, so one exponential gives both
    const double wide = std::exp(-exponent / 16), squared = wide * wide, fourth = squared * squared, eighth = fourth * fourth;
    return std::log(inlier_ * eighth * eighth + outlier_ * wide + uniform_);
  }
  [[nodiscard]] double mean() const { return mean_; }
  [[nodiscard]] double sigma() const { return sigma_; }

 private:
  [[nodiscard]] double log_blurred(double distance, double error) const;

  double mean_, sigma_, half_precision_;  // 1 / 2σ²
  double inlier_, outlier_, uniform_;     // factors of the two exponentials, and the constant
  double log_inlier_;
  double turn_;                        // 0 where the scale is no circle
};

/// A value as a class's mixture is asked about it.
struct MixtureInput {
  std::size_t feature = 0;    ///< index as in the constructor's list
  double scaled = 0;          ///< on the feature's scale
  double error = 0;           ///< standard error
  double weight = 1;          ///< F_i
  double own = 0;             ///< ln p(x_i|C) by the class's own rows
};

/// Shares of a plane among the kinds of a class: first what its own rows account for, then kinds in their order; they sum to one.
using Responsibilities = std::vector<double>;

class Mixture {
 public:
  Mixture() = default;
  /// `kinds`: of one class, in the order of their numbers. `features`: what MixtureInput::feature counts through.
  Mixture(std::span<const ClassKind> kinds, std::span<const Feature* const> features, double outlier_share);

  [[nodiscard]] bool empty() const { return kinds_.empty(); }
  /// (5) in logarithms.
  [[nodiscard]] double log_density(std::span<const MixtureInput> inputs) const;
  [[nodiscard]] Responsibilities responsibilities(std::span<const MixtureInput> inputs) const;
  /// What one value is worth to a kind (from 0), or to the class's own rows (−1).
  [[nodiscard]] double log_density(const MixtureInput& input, int kind) const;
  /// nullptr where the class's own rows decide.
  [[nodiscard]] const KindTerm* term(int kind, std::size_t feature) const;
  /// ln of the share of a kind, or of the class's own rows (−1); −∞ for none.
  [[nodiscard]] double log_share(int kind) const;
  /// The number that the kind's row has.
  [[nodiscard]] int number(int kind) const { return kinds_[static_cast<std::size_t>(kind)].number; }

 private:
  struct Kind {
    int number = 0;
    double log_share = 0;
    std::vector<int> term_of_feature;  // index into terms; −1 = none
    std::vector<KindTerm> terms;
  };

  [[nodiscard]] double log_product(std::span<const MixtureInput> inputs, int kind) const;

  std::vector<Kind> kinds_;
  double log_own_share_ = 0;
};

}  // namespace scenelore::kb
