// Pre-classification: P(C|Φ) of each plane from the Gaussians and densities of the knowledge base.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scenelore/kb/knowledge.hpp"

namespace scenelore::kb {

/// Feature values of planes; NaN = not known, which says nothing about any class.
struct FeatureTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;  ///< [plane][feature]
  /// By feature, one a plane: standard error of its value on the feature's scale. Features that are missing have none.
  std::map<std::string, std::vector<double>> errors;
};

/// No class gets less than this, so that −ln P stays finite (27.6 nats): evidence alone rules nothing out.
inline constexpr double kLeastProbability = 1e-12;

/// Stands for the feature's name in the term that says how usual the kinds are that the plane looks like; no feature of Lua is called so.
inline constexpr const char* kKindTerm = "(kind)";

/// What one feature says about one plane and class.
struct Contribution {
  std::string feature;
  double value = 0;             ///< of kKindTerm: number of the likeliest kind; 0 = none, the class's own rows
  double mean = 0, sigma = 0;   ///< of the class, or of the likeliest of its kinds; NaN where a density or uniform stands instead
  double log_likelihood = 0;    ///< ln p(x|C), per unit of the feature's scale; where the class has kinds, the mean over them
  double weight = 0;            ///< F_i
  double error = 0;             ///< standard error of the value
};

/// [plane][class], each row sums to one. Setting `combination`:
/// `product` (default): ln P(C|Φ) = ln π_C + Σ F_i ln p(x_i|C) − ln Z (log-linear pooling);
/// where C has kinds (class_kind rows), the logarithm of Σ_k s_k Π p(x_i|k)^F_i in place of the sum (mixture.hpp, (5));
/// `mean`: P(C|Φ) = Σ P(C|x_i) F_i / Σ F_i (Goldhoorn & Hartanto 2014, equation 1), P(C|x_i) by Bayes' theorem.
/// Densities are per unit of the feature's scale: a histogram (class_density), else a Gaussian (class_feature), else
/// what stands for the fallback class, and for that uniform over the feature's range: a feature that a class has no row for
/// speaks neither for it nor against it, compared with the fallback class. Setting `outlier_share` ε (0 without a row) mixes in what
/// odd values follow, half uniform and half the class's Gaussian at four times its width (likelihood.hpp, (1)). Outside all its bins a histogram counts as 1e-6 u. With
/// `product` a value that has a standard error is judged by the class's density as it looks through errors of that size:
/// p(x|C) = ∫ p(t|C) N(x; t, error²) dt. Features of weight 0, features that the table lacks and NaN values are left out. Without any known feature P(C|Φ) is the prior.
/// The result does not depend on `threads`.
[[nodiscard]] std::vector<std::vector<double>> preclassify(const Knowledge& knowledge, const FeatureTable& features, int threads = 2);

/// The terms behind one entry of preclassify, in the order of the knowledge's features; those left out are left out. Where any class
/// has kinds, a term kKindTerm comes last (0 for classes without). The sum of weight · log_likelihood is ln P(Φ|C) of `product`.
[[nodiscard]] std::vector<Contribution> contributions(const Knowledge& knowledge, const FeatureTable& features,
                                                      std::size_t plane, std::size_t object_class);
/// The same for many entries (plane, class), the model being built only once.
[[nodiscard]] std::vector<std::vector<Contribution>> contributions(
    const Knowledge& knowledge, const FeatureTable& features,
    const std::vector<std::pair<std::size_t, std::size_t>>& entries);

}  // namespace scenelore::kb
