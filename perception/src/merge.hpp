// Joins neighbouring regions that one plane explains as well as two.
#pragma once

#include "regions.hpp"

#include "voxel_grid.hpp"

namespace scenelore::perception {

/// `cells` are the voxels of all points; regions are neighbours when they meet in cells `reach` times as large, or in adjacent ones.
void merge_regions(const Cloud& cloud, const CellIndex& cells, int reach, double noise, Regions& regions);

}  // namespace scenelore::perception
