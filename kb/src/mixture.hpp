// p(Φ|C) of a class that has kinds (class_kind rows): a mixture, inside of which features are independent.
//
//   p(Φ|C) = (1 − Σ s_k) Π_i p(x_i|C)^F_i + Σ_k s_k Π_i p(x_i|k)^F_i                                              (5)
//
// s_k share of kind k, F_i weight of feature i, p(x_i|C) by the class's own rows, which also stand in where a kind has no row, and
// p(x|k) = (1 − ε) N(x; μ, σ) + ε (u + N(x; μ, 4σ)) / 2, which is (1) of likelihood.hpp; on circles x is the image nearest to μ.
// The latent class model of Lazarsfeld & Henry 1968 with Gaussians; without kinds it is the product of docs/knowledge.md.
#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

#include "likelihood.hpp"

namespace scenelore::kb {

/// A known value of a plane, as a class's mixture is asked about it.
struct MixtureInput {
  std::size_t feature = 0;    ///< index as in the constructor's list
  double scaled = 0;          ///< on the feature's scale
  double error = 0;           ///< standard error
  double weight = 1;          ///< F_i
  double own = 0;             ///< ln p(x_i|C) by the class's own rows
};

/// Not safe for concurrent use: see blur_of.
class Mixture {
 public:
  Mixture() = default;
  /// `kinds`: of one class, in the order of their numbers. `features`: what MixtureInput::feature counts through. `factors`: of the
  /// kinds' shares, ≥ 0; empty = 1 each. The share of the class's own rows is not touched by them.
  Mixture(std::span<const ClassKind> kinds, std::span<const Feature* const> features, double outlier_share, std::span<const double> factors = {});

  [[nodiscard]] bool empty() const { return numbers_.empty(); }
  /// (5) in logarithms.
  [[nodiscard]] double log_density(std::span<const MixtureInput> inputs) const;

  /// A plane divided among the kinds.
  struct Division {
    int likeliest = 0;                    ///< number of the kind with the greatest share; 0 = the class's own rows
    std::vector<double> means, sigmas;    ///< of that kind, one an input; NaN where it has no row
    std::vector<double> log_likelihoods;  ///< ln p(x_i|k), one an input, mean over the kinds by their shares of the plane
    double usual = 0;                     ///< Σ r_k (ln s_k − ln r_k), r_k the shares: how usual these kinds are
  };
  /// ln p(Φ|C) = Σ_i F_i log_likelihoods[i] + usual.
  [[nodiscard]] Division divide(std::span<const MixtureInput> inputs) const;

 private:
  using Row = Eigen::Array<double, 1, Eigen::Dynamic>;
  using Table = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  // a row a feature or an input, a column a kind

  /// ln p(x_i|k); the last column is the class's own rows.
  [[nodiscard]] Table log_terms(std::span<const MixtureInput> inputs) const;
  /// Logarithms of the summands of (5), in the order of the columns.
  [[nodiscard]] Row log_summands(std::span<const MixtureInput> inputs, const Table& terms) const;
  /// Of the value from each kind's mean; on circles from its nearest image.
  [[nodiscard]] Row distances(const MixtureInput& input) const;
  /// p(x_i|k); nonsense where a kind has no row.
  [[nodiscard]] Row densities(const MixtureInput& input) const;

  /// What a feature's Gaussians look like through errors of one size, by kind.
  struct Blur {
    double error = -1;
    Row near, far;              ///< 2 w², w the width of usual and of odd values
    Row near_peaks, far_peaks;  ///< factors of the two exponentials
    Row log_peaks;              ///< logarithm of the former, where there are no odd values
  };
  /// Of the planes of a scan most have the same error, so the last one is kept.
  const Blur& blur_of(Eigen::Index feature, double error) const;

  std::vector<int> numbers_;
  Row log_shares_;                                                    // then that of the class's own rows
  Table means_, half_precisions_, inliers_, outliers_, log_inliers_;  // 1 / 2σ², factors of the two exponentials
  Eigen::Array<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> has_row_;
  std::vector<double> uniforms_, turns_;                              // a feature; ε u / 2; 0 where the scale is no circle
  std::vector<bool> all_rows_;                                        // a feature: whether every kind has one for it
  bool bounded_ = false;                                              // odd values keep every density above 0
  mutable std::vector<Blur> blurs_;                                   // a feature
};

}  // namespace scenelore::kb
