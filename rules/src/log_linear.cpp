#include "log_linear.hpp"

#include <algorithm>
#include <cmath>

namespace scenelore::rules {

namespace {

constexpr int kSteps = 300;
constexpr double kDone = 1e-6;  // gain in mean log-likelihood

struct Slope {
  double log_likelihood = 0;
  std::vector<double> gradient, curvature;
};

Slope slope_at(std::span<const Example> examples, const std::vector<double>& parameters) {
  Slope slope;
  const std::size_t size = parameters.size();
  slope.gradient.assign(size, 0.0);
  slope.curvature.assign(size, 0.0);
  std::vector<double> mean(size), square(size);
  for (const Example& example : examples) {
    std::vector<double> share;
    for (const std::vector<double>& x : example.of_class) {
      double score = 0;
      for (std::size_t i = 0; i < size; ++i) score += parameters[i] * x[i];
      share.push_back(score);
    }
    const double top = *std::max_element(share.begin(), share.end());
    double sum = 0;
    for (double& s : share) sum += s = std::exp(s - top);
    std::fill(mean.begin(), mean.end(), 0.0);
    std::fill(square.begin(), square.end(), 0.0);
    for (std::size_t c = 0; c < share.size(); ++c) {
      share[c] /= sum;
      if (share[c] < 1e-12) continue;
      for (std::size_t i = 0; i < size; ++i) {
        const double x = example.of_class[c][i];
        mean[i] += share[c] * x;
        square[i] += share[c] * x * x;
      }
    }
    const std::vector<double>& right = example.of_class[static_cast<std::size_t>(example.truth)];
    for (std::size_t i = 0; i < size; ++i) {
      slope.gradient[i] += right[i] - mean[i];
      slope.curvature[i] += square[i] - mean[i] * mean[i];
    }
    slope.log_likelihood += std::log(std::max(share[static_cast<std::size_t>(example.truth)], 1e-300));
  }
  return slope;
}

double penalty(const LogLinearFit& fit, const std::vector<double>& parameters) {
  double sum = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) sum += (parameters[i] - fit.start[i]) * (parameters[i] - fit.start[i]);
  return fit.strength / 2 * sum;
}

}  // namespace

double fit_log_linear(std::span<const Example> examples, const LogLinearFit& fit, std::vector<double>& parameters) {
  if (examples.empty()) return 0;
  const auto count = static_cast<double>(examples.size());
  Slope slope = slope_at(examples, parameters);
  double value = slope.log_likelihood - penalty(fit, parameters), step = 0.5;
  for (int k = 0; k < kSteps && step > 1e-4; ++k) {
    std::vector<double> next = parameters;
    for (std::size_t i = 0; i < next.size(); ++i) {
      const double gradient = slope.gradient[i] - fit.strength * (parameters[i] - fit.start[i]);
      next[i] += step * gradient / (slope.curvature[i] + fit.strength + 1e-6);
      const bool bounded = i < fit.free || i >= fit.free + fit.frees;
      if (bounded) next[i] = std::clamp(next[i], fit.low[i], fit.high[i]);
    }
    Slope there = slope_at(examples, next);
    const double reached = there.log_likelihood - penalty(fit, next);
    if (reached < value) {
      step /= 2;  // features that say the same thing overshoot together
      continue;
    }
    const bool done = reached - value < kDone * count;
    parameters = std::move(next);
    slope = std::move(there);
    value = reached;
    step = std::min(1.0, step * 1.2);
    if (done) break;
  }
  return slope.log_likelihood / count;
}

}  // namespace scenelore::rules
