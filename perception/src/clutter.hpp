// What is locally flat but no plane: folds, curved backs, legs, leaves.
#pragma once

#include <vector>

#include "slots.hpp"

namespace scenelore::perception {

/// Frees the slots of regions that are bent, or that go on smoothly into a neighbour of another slope (a facet of a curved surface: flat
/// things in rooms meet at edges of more than 50 degrees). What else is no face is judged at the end (face_model.hpp).
void drop_clutter(const VoxelGrid& grid, Slots& slots, std::vector<PlaneFit>& planes);

}  // namespace scenelore::perception
