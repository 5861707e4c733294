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

/// Joins level planes of one height (within 7 mm) with a gap of at most `reach` cells: pieces of a table whose plane fits
/// had been tilted by what stands on it. Regions from number `count` on are
/// thin things, of which only large ones take part.
void join_level_pieces(const Cloud& cloud, const CellIndex& cells, int reach, const Eigen::Vector3d& up, std::size_t count, Regions& regions);

}  // namespace scenelore::perception
