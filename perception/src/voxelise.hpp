// All points of a cloud into voxels, in one pass.
#pragma once

#include <array>

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
  /// Place in its voxel of a point that one holds.
  [[nodiscard]] std::array<std::int32_t, 3> within_voxel(float x, float y, float z) const {
    const auto low = [this](float c) { return static_cast<std::int32_t>(static_cast<std::int64_t>(fixed(c)) & (kFixedSteps - 1)); };
    return {low(x), low(y), low(z)};
  }
  [[nodiscard]] static bool inside(double fixed) {
    constexpr double low = 8.0 * kFixedSteps, high = static_cast<double>(kPlaceLimit) * kFixedSteps;
    return fixed >= low && fixed < high;
  }
};

/// Points sorted by voxel, those of one in their own order, with their places in it: what a pass voxel by voxel reads.
struct PointsByVoxel {
  std::vector<std::uint32_t> first;                ///< of each voxel, and the number of points at the end; empty = not sorted
  std::vector<std::uint32_t> point;
  std::vector<std::array<std::uint16_t, 3>> at;    ///< in the steps of FixedScale
};

/// What the points of a cloud, or of a part of it, leave in the voxels of a grid.
struct VoxelPoints {
  std::vector<FixedMoments> fixed;       ///< of each voxel
  std::vector<std::uint32_t> of_point;   ///< voxel; kNoVoxel for invalid points and those a million voxels away
  PointsByVoxel sorted;                  ///< of a sample, whose points all have voxels
};

struct VoxelisedCloud : VoxelPoints {
  VoxelGrid grid;
};

/// Identical for any number of threads and, apart from `of_point`'s order, for any order of the points.
[[nodiscard]] VoxelisedCloud voxelise(const Cloud& cloud, double voxel, int threads);

}  // namespace scenelore::perception
