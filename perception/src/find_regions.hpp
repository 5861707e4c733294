// The steps of segmentation, shared by segment() and perceive().
#pragma once

#include "promises.hpp"
#include "scenelore/perception/perceive.hpp"

namespace scenelore::perception {

struct FoundRegions : Settled {
  Limits limits;
  Upright upright;
  double voxel = 0, spacing = 0, noise = 0;  ///< metres
  std::vector<Moments> voxels;               ///< of all points, in the cloud's offsets
};

/// Everything up to the promises, which hold for the result. Throws Error for a parameter out of range.
[[nodiscard]] FoundRegions find_regions(const Cloud& cloud, const PerceptionOptions& options);

}  // namespace scenelore::perception
