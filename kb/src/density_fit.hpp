// Fitting one feature of one class.
#pragma once

#include <optional>
#include <vector>

#include "scenelore/kb/knowledge.hpp"
#include "scenelore/kb/learn.hpp"

namespace scenelore::kb {

struct Gaussian {
  double mean = 0, sigma = 1;
};

/// Robust: values beyond the quantiles that options.outliers leaves out are pulled to them (winsorised). `sorted` is on
/// the feature's scale, ascending, not empty. Sigma is at least a 200th of the feature's range.
[[nodiscard]] Gaussian fit_gaussian(const std::vector<double>& sorted, double range, const LearnOptions& options);

/// A bin on the feature's scale; the densities integrate to one over all bins.
struct Bin {
  double low = 0, high = 0, density = 0;
};

/// What the rows say now; neither = they say nothing.
struct Present {
  std::optional<Gaussian> gaussian;
  std::vector<Bin> bins;  ///< instead of the Gaussian, when there are any
};

/// The Gaussian after n examples that `fitted` describes, when `present` stands for `strength` examples more.
[[nodiscard]] Gaussian joined(const Gaussian& fitted, double n, const Present& present, double strength);

/// Histogram over [low, high] (the feature's range on its scale).
[[nodiscard]] std::vector<Bin> fit_histogram(const std::vector<double>& sorted, const Gaussian& gaussian, const Present& present, double low,
                                             double high, const LearnOptions& options);

}  // namespace scenelore::kb
