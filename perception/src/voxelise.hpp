// All points of a cloud into voxels, in one pass.
#pragma once

#include "fixed_moments.hpp"
#include "scenelore/perception/cloud.hpp"
#include "voxel_grid.hpp"

namespace scenelore::perception {

/// A coordinate in steps of a voxel's edge / 2^14, counted from below the lowest place; its upper bits are the voxel, the
/// lower ones the position in it. Every pass over the points computes it in the same way, so that all agree.
struct FixedScale {
  double steps_per_metre = 0;

  explicit FixedScale(double voxel) : steps_per_metre(kFixedSteps / voxel) {}
  static constexpr double kOrigin = static_cast<double>(kPlaceOrigin) * kFixedSteps;
  /// May be anything, NaN too, for coordinates that no voxel holds.
  [[nodiscard]] double fixed(float coordinate) const { return static_cast<double>(coordinate) * steps_per_metre + kOrigin; }
  [[nodiscard]] static bool inside(double fixed) {
    constexpr double low = 8.0 * kFixedSteps, high = static_cast<double>(kPlaceLimit) * kFixedSteps;
    return fixed >= low && fixed < high;
  }
};

struct VoxelisedCloud {
  VoxelGrid grid;
  std::vector<FixedMoments> fixed;       ///< of each voxel
  std::vector<std::uint32_t> of_point;   ///< voxel; kNoVoxel for invalid points and those a million voxels away
};

/// Identical for any number of threads and, apart from `of_point`'s order, for any order of the points.
[[nodiscard]] VoxelisedCloud voxelise(const Cloud& cloud, double voxel, int threads);

}  // namespace scenelore::perception
