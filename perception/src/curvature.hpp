// Backs of chairs, bins, people: locally flat, but no planes.
#pragma once

#include <cstdint>
#include <span>

#include "voxel_grid.hpp"

namespace scenelore::perception {

/// Means of small pieces of a surface, as heights over its plane.
struct HeightSample {
  double u = 0, v = 0;    ///< along the plane's axes, from its centroid
  double height = 0;      ///< mean over the plane
  double weight = 0;      ///< number of points
};

/// Fits h = c + a·(u, v) + ½ (u, v) H (u, v)ᵀ and compares it with the plane. Curved means: the bend is significant (the
/// bent surface explains a good part of the deviation, beyond what n points with this noise would show by chance) and its
/// normal turns by more than 12 degrees between centre and edge. Fewer than 8 samples are never curved.
[[nodiscard]] bool is_curved(std::span<const HeightSample> samples, const PlaneFit& plane);

[[nodiscard]] bool is_curved(const VoxelGrid& grid, std::span<const std::uint32_t> voxels, const PlaneFit& plane);

}  // namespace scenelore::perception
