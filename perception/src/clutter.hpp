// What is locally flat but no plane: folds, curved backs, legs, leaves.
#pragma once

#include <vector>

#include "regions.hpp"
#include "surface_voxels.hpp"

namespace scenelore::perception {

/// Frees the points of regions that are narrower than three of their own thicknesses; whose surroundings do not look like
/// a plane with this normal; that are bent; or that go on smoothly into a neighbour of another slope (a facet of a curved
/// surface: flat things in rooms meet at edges of more than 50 degrees).
void drop_clutter(const Cloud& cloud, const CellIndex& cells, const std::vector<LocalSurface>& surfaces, double voxel, Regions& regions);

}  // namespace scenelore::perception
