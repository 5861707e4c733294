// Fragments that a larger neighbouring plane explains.
#pragma once

#include "adjacency.hpp"

namespace scenelore::perception {

/// A region goes to the larger neighbour that has at least 70 % of its points within its tolerance (that neighbour which
/// has most of them), unless the two are turned against each other by more than the region's scatter allows. Layers of one noisy wall and steps of rounded distances come together here; what is a thing of its
/// own in front of a plane is found afterwards, by the statistics of the residuals (thin_objects.hpp).
void absorb_fragments(const VoxelGrid& grid, const Pyramid& pyramid, const Limits& limits, Slots& slots, std::vector<PlaneFit>& planes);

}  // namespace scenelore::perception
