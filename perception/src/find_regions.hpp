// The steps of segmentation, shared by segment() and perceive().
#pragma once

#include "cell_index.hpp"
#include "regions.hpp"
#include "scenelore/perception/parameters.hpp"

namespace scenelore::perception {

struct FoundRegions {
  Regions regions;   ///< not yet within the promises
  Limits limits;
  CellIndex cells;   ///< the finest voxels, of all points
  double voxel = 0, spacing = 0, noise = 0;  ///< metres
};

/// Throws Error for a parameter out of range.
[[nodiscard]] FoundRegions find_regions(const Cloud& cloud, const SegmentationParameters& parameters, int threads);


}  // namespace scenelore::perception
