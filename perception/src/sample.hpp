// A part of the points that stands for all of them where there are more than any question needs.
#pragma once

#include "voxelise.hpp"

namespace scenelore::perception {

/// The points keep the order of the cloud, and lie in the voxels of the whole one. Chosen by a hash of their coordinates, so that the choice depends neither on
/// the order of the points nor on threads.
struct PointSample {
  Cloud cloud;
  std::vector<std::uint32_t> points;  ///< of the whole cloud
  PointsByVoxel by_voxel;
};

/// About `most` points of each voxel that has more, all of the others.
[[nodiscard]] PointSample take_sample(const Cloud& cloud, const VoxelisedCloud& voxels, std::int64_t most, int threads);

}  // namespace scenelore::perception
