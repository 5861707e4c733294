#include "curvature.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <vector>

namespace scenelore::perception {
namespace {

constexpr double kTurn = 0.21;          // radians, 12 degrees between centre and edge
constexpr double kSignificance = 16.0;  // gain in units of the noise's own variance: chance reaches 3 on average

}  // namespace

bool is_curved(std::span<const HeightSample> samples, const PlaneFit& plane) {
  if (samples.size() < 8 || plane.variances[1] <= 0) return false;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  // Half width and half length of a uniform rectangle with these variances.
  const double eu = std::sqrt(3 * plane.variances[1]), ev = std::sqrt(3 * plane.variances[2]);
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6 right = Vector6::Zero();
  double squares = 0;
  for (const HeightSample& s : samples) {
    const double u = s.u / eu, v = s.v / ev;
    const Vector6 row = (Vector6() << 1, u, v, u * u, u * v, v * v).finished();
    normal += s.weight * row * row.transpose();
    right += s.weight * s.height * row;
    squares += s.weight * s.height * s.height;
  }
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(normal);
  if (solver.info() != Eigen::Success || solver.rcond() < 1e-9) return false;
  const Vector6 c = solver.solve(right);
  const Eigen::Matrix3d flat = normal.topLeftCorner<3, 3>();
  const Eigen::Vector3d flat_right = right.head<3>();
  const double gain = c.dot(right) - flat.ldlt().solve(flat_right).dot(flat_right);
  const double left = plane.variances[0] * plane.count - gain;  // squares about the bent surface
  const double noise = std::max(left, 0.0) / std::max(plane.count - 6, 1.0);
  if (gain < kSignificance * noise || gain < 0.15 * plane.variances[0] * plane.count) return false;
  Eigen::Matrix2d hessian;
  hessian << 2 * c[3] / (eu * eu), c[4] / (eu * ev), c[4] / (eu * ev), 2 * c[5] / (ev * ev);
  const Eigen::Vector2d turn_u = hessian * Eigen::Vector2d(eu, 0), turn_v = hessian * Eigen::Vector2d(0, ev);
  return std::max(turn_u.norm(), turn_v.norm()) > kTurn;
}

bool is_curved(const VoxelGrid& grid, std::span<const std::uint32_t> voxels, const PlaneFit& plane) {
  std::vector<HeightSample> samples;
  samples.reserve(voxels.size());
  for (const std::uint32_t v : voxels) {
    const Moments& m = grid.moments[v];
    const Eigen::Vector3d d = plane.axes.transpose() * (m.mean() - plane.centroid);
    samples.push_back({d[1], d[2], d[0], m.n});
  }
  return is_curved(samples, plane);
}

}  // namespace scenelore::perception
