// Conditional likelihood of a log-linear model: the convex fit inside the learning of weights.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace scenelore::rules {

/// Classes compete with score θ·of_class[c]; the truth should win.
struct Example {
  std::vector<std::vector<double>> of_class;
  int truth = 0;
};

struct LogLinearFit {
  std::vector<double> start;      ///< what parameters hold on to
  double strength = 0;            ///< of the Gaussian prior about `start`, in examples
  std::vector<double> low, high;  ///< bounds
  std::size_t free = 0, frees = 0;  ///< parameters [free, free + frees) have no bounds
};

/// Maximises Σ ln softmax(θ·x)[truth] − strength/2 Σ (θ − start)² over θ from the given `parameters`, by projected gradient
/// steps scaled by the curvature of each parameter. Returns the mean log-likelihood at the end; 0 without examples.
double fit_log_linear(std::span<const Example> examples, const LogLinearFit& fit, std::vector<double>& parameters);

}  // namespace scenelore::rules
