// How densely the cloud is sampled, and the voxels that follow.
#pragma once

#include "voxelise.hpp"

namespace scenelore::perception {

struct Scale {
  double voxel = 0;    ///< metres; at least 5 cm, more where the cloud is so sparse (or not in metres) that voxels stay empty
  double spacing = 0;  ///< metres, median distance of a point to its nearest neighbour, copies of the point left out
};

/// The cloud in voxels of a size that suits it.
struct ScaledCloud : VoxelisedCloud {
  Scale scale;
};
[[nodiscard]] ScaledCloud voxelise_to_scale(const Cloud& cloud, int threads);

}  // namespace scenelore::perception
