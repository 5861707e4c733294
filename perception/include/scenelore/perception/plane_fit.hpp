// A plane as segmentation knows it: equation, place and spread. Φ is computed from it and its points by describe().
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace scenelore::perception {

/// The plane normal · p = offset.
struct PlaneEquation {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;

  [[nodiscard]] double distance(const Eigen::Vector3d& p) const { return normal.dot(p) - offset; }
};

/// A least-squares plane with the spread of its points along its own axes.
struct PlaneFit : PlaneEquation {
  double count = 0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();  ///< m², eigenvalues, rising; [0] = mean squared distance
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();   ///< eigenvectors as columns, in the order of `variances`

  [[nodiscard]] double rmse() const { return variances[0] > 0 ? std::sqrt(variances[0]) : 0.0; }
  /// m², of the rectangle that spreads as the points do when it is evenly filled.
  [[nodiscard]] double spread_area() const { return 12 * std::sqrt(std::max(0.0, variances[1] * variances[2])); }
};

}  // namespace scenelore::perception
