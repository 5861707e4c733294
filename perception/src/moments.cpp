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

FlatFit fit_flat(const Moments& moments) {
  FlatFit fit;
  if (moments.n <= 0) return fit;
  const Eigen::Matrix3d c = moments.covariance();
  const double trace = c.trace();
  if (!(trace > 0)) return fit;
  // λ³ − t λ² + q λ − d; all roots are real and not negative, so Newton's method climbs to the smallest one.
  const double yz = c(1, 1) * c(2, 2) - c(1, 2) * c(1, 2), xz = c(0, 0) * c(2, 2) - c(0, 2) * c(0, 2), xy = c(0, 0) * c(1, 1) - c(0, 1) * c(0, 1);
  const double q = yz + xz + xy;
  const double d = c(0, 0) * yz - c(0, 1) * (c(0, 1) * c(2, 2) - c(1, 2) * c(0, 2)) + c(0, 2) * (c(0, 1) * c(1, 2) - c(1, 1) * c(0, 2));
  double root = 0;
  for (int step = 0; step < 40; ++step) {
    const double value = ((root - trace) * root + q) * root - d, slope = (3 * root - 2 * trace) * root + q;
    if (!(value < 0) || !(slope > 0)) break;
    const double next = root - value / slope;
    if (!(next > root * (1 + 1e-12))) break;
    root = next;
  }
  fit.across = std::min(root, trace / 3);
  const double rest = trace - fit.across;  // of the other two, whose product is q − root · rest
  fit.along = std::max(fit.across, (rest - std::sqrt(std::max(0.0, rest * rest - 4 * (q - fit.across * rest)))) / 2);
  // The normal is at right angles to all rows of C − λ; the two that span the most give it best.
  Eigen::Matrix3d rows = c;
  rows.diagonal().array() -= fit.across;
  const Eigen::Vector3d a = rows.row(0), b = rows.row(1), e = rows.row(2);
  const Eigen::Vector3d crosses[] = {a.cross(b), a.cross(e), b.cross(e)};
  const Eigen::Vector3d* best = &crosses[0];
  for (const Eigen::Vector3d& cross : crosses) {
    if (cross.squaredNorm() > best->squaredNorm()) best = &cross;
  }
  if (best->squaredNorm() > 1e-24 * trace * trace * trace * trace) {
    fit.normal = best->normalized();
  } else {
    fit.normal = fit_plane_fast(moments).normal;
  }
  return fit;
}

PlaneFit fit_plane(const Moments& moments) {
  return fit(moments, [](auto& solver, const Eigen::Matrix3d& c) { solver.compute(c); });
}

PlaneFit fit_plane_fast(const Moments& moments) {
  return fit(moments, [](auto& solver, const Eigen::Matrix3d& c) { solver.computeDirect(c); });
}

}  // namespace scenelore::perception
