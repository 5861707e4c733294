// Backs of chairs, bins, people: locally flat, but no planes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "voxel_grid.hpp"

namespace scenelore::perception {

/// Means of small pieces of a surface, as heights over its plane.
struct HeightSample {
  double u = 0, v = 0;    ///< along the plane's axes, from its centroid
  double height = 0;      ///< mean over the plane
  double weight = 0;      ///< number of points
};

/// Least squares of heights over a plane by h = c + a·(u, v) + ½ (u, v) H (u, v)ᵀ.
class BentSurface {
 public:
  explicit BentSurface(const PlaneFit& plane);
  void add(const HeightSample& sample);

  struct Bend {
    double gain = 0;  ///< m² times points, of the squares of heights: what it explains and no flat surface does
    double turn = 0;  ///< radians, of its normal between centre and edge of the plane
  };
  /// Nothing for fewer than 8 samples, and for those that tell no bend, as in a line.
  [[nodiscard]] std::optional<Bend> bend() const;

 private:
  double half_width_, half_length_;  ///< metres
  std::size_t count_ = 0;
  Eigen::Matrix<double, 6, 6> normal_ = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right_ = Eigen::Matrix<double, 6, 1>::Zero();
};

/// Fits a bent surface and compares it with the plane. Curved means: the bend is significant (the
/// bent surface explains a good part of the deviation, beyond what n points with this noise would show by chance) and its
/// normal turns by more than 12 degrees between centre and edge. Fewer than 8 samples are never curved.
[[nodiscard]] bool is_curved(std::span<const HeightSample> samples, const PlaneFit& plane);

[[nodiscard]] bool is_curved(const VoxelGrid& grid, std::span<const std::uint32_t> voxels, const PlaneFit& plane);

}  // namespace scenelore::perception
