#include "curvature.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

namespace scenelore::perception {
namespace {

constexpr double kTurn = 0.21;          // radians, 12 degrees between centre and edge
constexpr double kSignificance = 16.0;  // gain in units of the noise's own variance: chance reaches 3 on average

}  // namespace

// Half width and half length of a uniform rectangle with these variances.
BentSurface::BentSurface(const PlaneFit& plane)
    : half_width_(std::sqrt(3 * std::max(0.0, plane.variances[1]))), half_length_(std::sqrt(3 * std::max(0.0, plane.variances[2]))) {}

void BentSurface::add(const HeightSample& s) {
  const double u = s.u / half_width_, v = s.v / half_length_;
  const Eigen::Matrix<double, 6, 1> row = (Eigen::Matrix<double, 6, 1>() << 1, u, v, u * u, u * v, v * v).finished();
  normal_ += s.weight * row * row.transpose();
  right_ += s.weight * s.height * row;
  ++count_;
}

std::optional<BentSurface::Bend> BentSurface::bend() const {
  if (count_ < 8 || !(half_width_ > 0)) return {};
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(normal_);
  if (solver.info() != Eigen::Success || solver.rcond() < 1e-9) return {};
  const Eigen::Matrix<double, 6, 1> c = solver.solve(right_);
  const Eigen::Matrix3d flat = normal_.topLeftCorner<3, 3>();
  const Eigen::Vector3d flat_right = right_.head<3>();
  Eigen::Matrix2d hessian;
  hessian << 2 * c[3] / (half_width_ * half_width_), c[4] / (half_width_ * half_length_), c[4] / (half_width_ * half_length_), 2 * c[5] / (half_length_ * half_length_);
  const Eigen::Vector2d across = hessian * Eigen::Vector2d(half_width_, 0), along = hessian * Eigen::Vector2d(0, half_length_);
  return Bend{c.dot(right_) - flat.ldlt().solve(flat_right).dot(flat_right), std::max(across.norm(), along.norm())};
}

bool is_curved(std::span<const HeightSample> samples, const PlaneFit& plane) {
  BentSurface surface(plane);
  for (const HeightSample& s : samples) surface.add(s);
  const std::optional<BentSurface::Bend> bend = surface.bend();
  if (!bend) return false;
  const double left = plane.variances[0] * plane.count - bend->gain;  // squares about the bent surface
  const double noise = std::max(left, 0.0) / std::max(plane.count - 6, 1.0);
  return bend->gain >= kSignificance * noise && bend->gain >= 0.15 * plane.variances[0] * plane.count && bend->turn > kTurn;
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
