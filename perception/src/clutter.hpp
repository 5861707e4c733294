// What is locally flat but no plane: folds, curved backs, legs, leaves.
#pragma once

#include <vector>

#include "slots.hpp"
#include "surface_voxels.hpp"

namespace scenelore::perception {

/// Frees the slots of regions that are narrower than three of their own thicknesses; whose surroundings do not look like
/// a plane with this normal; that are bent; or that go on smoothly into a neighbour of another slope (a facet of a curved
/// surface: flat things in rooms meet at edges of more than 50 degrees).
void drop_clutter(const VoxelGrid& grid, const std::vector<LocalSurface>& surfaces, Slots& slots, std::vector<PlaneFit>& planes);

}  // namespace scenelore::perception
