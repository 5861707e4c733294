// All points of a cloud into voxels, in one pass.
#pragma once

#include <array>

#include "fixed_moments.hpp"
#include "scenelore/perception/cloud.hpp"
#include "voxel_grid.hpp"

namespace scenelore::perception {

struct FixedPlace {
  VoxelPlace voxel;
  std::array<std::int32_t, 3> within{};  ///< in steps
};

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
  /// False for points that no voxel holds.
  [[nodiscard]] bool locate(float x, float y, float z, FixedPlace& place) const {
    const double fx = fixed(x), fy = fixed(y), fz = fixed(z);
    if (!(inside(fx) && inside(fy) && inside(fz))) return false;
    const auto ix = static_cast<std::int64_t>(fx), iy = static_cast<std::int64_t>(fy), iz = static_cast<std::int64_t>(fz);
    const auto high = [](std::int64_t i) { return static_cast<std::uint32_t>(i >> kFixedBits); };
    const auto low = [](std::int64_t i) { return static_cast<std::int32_t>(i & (kFixedSteps - 1)); };
    place = {{high(ix), high(iy), high(iz)}, {low(ix), low(iy), low(iz)}};
    return true;
  }
};

/// Points sorted by voxel, those of one in their own order, with their places in it: what a pass voxel by voxel reads.
struct PointsByVoxel {
  std::vector<std::uint32_t> first;                ///< of each voxel, and the number of points at the end
  std::vector<std::uint32_t> point;
  std::vector<std::array<std::uint16_t, 3>> at;    ///< in the steps of FixedScale

  [[nodiscard]] std::uint32_t count(std::size_t voxel) const { return first[voxel + 1] - first[voxel]; }
};

struct VoxelisedCloud {
  VoxelGrid grid;
  std::vector<FixedMoments> fixed;  ///< of each voxel
};

/// Which voxel holds each point is asked in the few passes over all points alone, and found again in each: it takes no longer than to read it,
/// and a number a point is a third of a cloud.
class PointLocator {
 public:
  explicit PointLocator(const VoxelGrid& grid) : scale_(grid.size), finder_(grid.table) {}

  /// kNoVoxel for invalid points, those a million voxels away and those where the grid has none. `place` is set unless the point is invalid.
  [[nodiscard]] std::uint32_t locate(float x, float y, float z, FixedPlace& place) { return scale_.locate(x, y, z, place) ? finder_.find(place.voxel) : kNoVoxel; }
  [[nodiscard]] std::uint32_t locate(const Cloud& cloud, std::size_t i) {
    FixedPlace place;
    return locate(cloud.x[i], cloud.y[i], cloud.z[i], place);
  }

 private:
  FixedScale scale_;
  VoxelFinder finder_;
};

/// Identical for any number of threads and any order of the points.
[[nodiscard]] VoxelisedCloud voxelise(const Cloud& cloud, double voxel, int threads);

/// The moments of VoxelGrid from the sums in whole numbers.
[[nodiscard]] std::vector<Moments> moments_of_voxels(const VoxelGrid& grid, const std::vector<FixedMoments>& fixed, int threads);

}  // namespace scenelore::perception
