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

/// A known value of a plane, as the mixtures are asked about it.
struct MixtureInput {
  std::size_t feature = 0;    ///< index as in the constructor's list
  double value = 0;
  double scaled = 0;          ///< on the feature's scale
  double error = 0;           ///< standard error
  double weight = 1;          ///< F_i
};

/// A class as a mixture.
struct MixtureClass {
  std::span<const ClassKind> kinds{};     ///< in the order of their numbers; may be none
  std::vector<const Likelihood*> own{};   ///< by its own rows, one a feature
  std::vector<double> factors{};          ///< of the kinds' shares, ≥ 0; empty = 1 each; the share of the class's own rows is not touched by them
};

/// The mixtures of all classes side by side, so that one pass over a feature serves them all. Safe for concurrent use.
class Mixtures {
 public:
  Mixtures() = default;
  /// `features`: what MixtureInput::feature counts through. The classes' likelihoods must live as long.
  Mixtures(std::span<const MixtureClass> classes, std::span<const Feature* const> features, double outlier_share);

  /// Whether any class has kinds.
  [[nodiscard]] bool any_kinds() const { return numbers_.size() + 1 > starts_.size(); }
  [[nodiscard]] bool has_kinds(std::size_t object_class) const { return starts_[object_class + 1] - starts_[object_class] > 1; }
  /// (5) in logarithms, one a class. Inputs of one weight take less time next to each other.
  [[nodiscard]] std::vector<double> log_densities(std::span<const MixtureInput> inputs) const;

  /// A plane divided among the kinds of a class.
  struct Division {
    int likeliest = 0;                    ///< number of the kind with the greatest share; 0 = the class's own rows
    std::vector<double> means, sigmas;    ///< of that kind, one an input; NaN where it has no row
    std::vector<double> log_likelihoods;  ///< ln p(x_i|k), one an input, mean over the kinds by their shares of the plane
    double usual = 0;                     ///< Σ r_k (ln s_k − ln r_k), r_k the shares: how usual these kinds are
  };
  /// ln p(Φ|C) = Σ_i F_i log_likelihoods[i] + usual.
  [[nodiscard]] Division divide(std::size_t object_class, std::span<const MixtureInput> inputs) const;

 private:
  using Row = Eigen::Array<double, 1, Eigen::Dynamic>;
  using Table = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  // a row a feature, a column a kind

  /// Neighbouring columns.
  struct Columns {
    Eigen::Index first, count;
  };
  /// A column that has no Gaussian for a feature, so that the class's own rows tell.
  struct Untold {
    Eigen::Index column;
    const Likelihood* own;
  };

  /// The kinds of a class, the last of these columns its own rows.
  [[nodiscard]] Columns of_class(std::size_t object_class) const;
  /// Of the value from each mean, squared; on circles from its nearest image.
  void put_squares(const MixtureInput& input, Columns columns, Row& out) const;
  /// p(x_i|k); needs odd values, so that none is 0.
  void put_densities(const MixtureInput& input, Columns columns, Row& out) const;
  /// ln p(x_i|k).
  void put_log_densities(const MixtureInput& input, Columns columns, Row& out) const;
  /// Calls visit(column, ln p) for those of the columns, counted from the first of them, that the class's own rows tell.
  template <typename Visit>
  void for_each_untold(const MixtureInput& input, Columns columns, Visit visit) const;
  /// Logarithms of the summands of (5) for all classes.
  [[nodiscard]] Row log_summands(std::span<const MixtureInput> inputs) const;

  std::vector<Eigen::Index> starts_;         // of each class's columns, then the end
  std::vector<int> numbers_;                 // of the kinds; 0 = a class's own rows
  Row log_shares_;
  Table means_, sigmas_;                     // NaN and 1 where there is no row
  Table variances_, exponents_, peaks_;      // of the narrow Gaussians; of Gaussians of four times the width: −1 / 2(4σ)²; of the narrow ones: 1 / σ√2π
  std::vector<std::vector<Untold>> untold_;  // a feature; by column
  std::vector<double> uniforms_, turns_;     // a feature; ε u / 2; 0 where the scale is no circle
  double outlier_share_ = 0;
};

}  // namespace scenelore::kb
