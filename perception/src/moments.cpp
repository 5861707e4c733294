#include "moments.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace scenelore::perception {

Eigen::Matrix3d Moments::covariance() const {
  const Eigen::Vector3d m = mean();
  Eigen::Matrix3d c;
  c(0, 0) = xx / n - m.x() * m.x();
  c(1, 1) = yy / n - m.y() * m.y();
  c(2, 2) = zz / n - m.z() * m.z();
  c(0, 1) = c(1, 0) = xy / n - m.x() * m.y();
  c(0, 2) = c(2, 0) = xz / n - m.x() * m.z();
  c(1, 2) = c(2, 1) = yz / n - m.y() * m.z();
  return c;
}

double Moments::mean_squared_distance(const PlaneEquation& plane) const {
  // Var + mean², both about the points' own mean: no difference of large numbers is left.
  const Eigen::Vector3d& a = plane.normal;
  const double variance = a.dot(covariance() * a);
  const double mean = mean_distance(plane);
  return std::max(0.0, variance) + mean * mean;
}

namespace {

template <typename Solve>
PlaneFit fit(const Moments& moments, Solve solve) {
  PlaneFit result;
  if (moments.n <= 0) return result;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solve(solver, moments.covariance());
  result.count = moments.n;
  result.centroid = moments.mean();
  result.variances = solver.eigenvalues().cwiseMax(0.0);
  result.axes = solver.eigenvectors();
  result.normal = result.axes.col(0);
  result.offset = result.normal.dot(result.centroid);
  return result;
}

}  // namespace

PlaneFit fit_plane(const Moments& moments) {
  return fit(moments, [](auto& solver, const Eigen::Matrix3d& c) { solver.compute(c); });
}

PlaneFit fit_plane_fast(const Moments& moments) {
  return fit(moments, [](auto& solver, const Eigen::Matrix3d& c) { solver.computeDirect(c); });
}

}  // namespace scenelore::perception
