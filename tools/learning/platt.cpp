#include "learning/platt.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace scenelore::learning {

kb::ProbabilityScale fit_scale(std::span<const evaluation::Claim> claims, double strength) {
  const Eigen::Vector2d start(1, 0);
  Eigen::Vector2d at = start;
  for (int step = 0; step < 50; ++step) {
    // A claim at an even chance has a curvature of 1/4.
    Eigen::Matrix2d curvature = strength / 4 * Eigen::Matrix2d::Identity();
    Eigen::Vector2d gradient = -curvature * (at - start);
    for (const evaluation::Claim& claim : claims) {
      if (claim.probability <= 0 || claim.probability >= 1) continue;
      const Eigen::Vector2d x(std::log(claim.probability / (1 - claim.probability)), 1);
      const double p = 1 / (1 + std::exp(-at.dot(x)));
      gradient += (claim.right - p) * x;
      curvature += p * (1 - p) * x * x.transpose();
    }
    const Eigen::Vector2d move = curvature.ldlt().solve(gradient);
    at += std::min(1.0, 2 / std::max(move.norm(), 1e-12)) * move;
    at.x() = std::clamp(at.x(), 0.1, 9.0), at.y() = std::clamp(at.y(), -9.0, 9.0);
    if (move.norm() < 1e-9) break;
  }
  return {at.x(), at.y()};
}

}  // namespace scenelore::learning
