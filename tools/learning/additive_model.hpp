// Logistic regression on a sum of curves, one a trait (generalised additive model, Hastie & Tibshirani 1986).
#pragma once

#include <cstddef>
#include <vector>

namespace scenelore::learning {

/// Piecewise linear, constant beyond its ends.
struct AdditiveCurve {
  std::vector<double> at;    ///< knots, rising
  std::vector<double> odds;  ///< log-odds at the knots, of mean zero over the examples
};
struct AdditiveModel {
  double offset = 0;
  std::vector<AdditiveCurve> curves;
  [[nodiscard]] double odds(const std::vector<double>& traits) const;
};

/// Maximum likelihood with a penalty on the bends of the curves (P-splines of degree 1, Eilers & Marx 1996), by iteratively
/// reweighted least squares. Knots lie at equal shares of the examples, so that no curve tells of what was never seen. Throws
/// std::invalid_argument when an example has another number of traits than the first, or one class is missing.
[[nodiscard]] AdditiveModel fit_additive(const std::vector<std::vector<double>>& traits, const std::vector<bool>& outcomes, std::size_t knots, double penalty);

}  // namespace scenelore::learning
