// Joins neighbouring regions that one plane explains as well as two.
#pragma once

#include "regions.hpp"

#include "voxel_grid.hpp"

namespace scenelore::perception {

/// `cells` are the voxels of all points; regions are neighbours when they meet in cells `reach` times as large, or in adjacent ones.
void merge_regions(const Cloud& cloud, const CellIndex& cells, int reach, double noise, Regions& regions);

/// Joins pieces of one wall, floor or ceiling across the shadows of what stands before it: planes in one line with one of
/// at least `smallest` m², with a gap of at most `reach` cells. Tables side by side stay apart.
void bridge_shadows(const Cloud& cloud, const CellIndex& cells, int reach, double noise, double smallest, Regions& regions);

}  // namespace scenelore::perception
