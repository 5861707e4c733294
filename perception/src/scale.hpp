// How densely the cloud is sampled, and the voxel size that follows.
#pragma once

#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception {

struct Scale {
  double voxel = 0;    ///< metres; at least 5 cm, more where the cloud is so sparse (or not in metres) that voxels stay empty
  double spacing = 0;  ///< metres, median distance of a point to its nearest neighbour, copies of the point left out
};

[[nodiscard]] Scale estimate_scale(const Cloud& cloud, int threads);

}  // namespace scenelore::perception
