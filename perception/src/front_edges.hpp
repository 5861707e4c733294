// Where a face is seen at a slant, its front edge is seen more squarely than the face, and gives it points that lie on the side of the thing.
#pragma once

#include "slots.hpp"

namespace scenelore::perception {

/// Frees the points of planes of up to 2.5 m² that are seen at 45 degrees or more and that are more likely of what lies below or above the face:
/// the front edge of a shelf or a desk, the feet of the books on it. `noise`: metres along the ray. `slot_of_point` is that of the whole cloud.
/// Clouds without a sensor's position stay as they are.
void free_front_edges(const Cloud& cloud, double noise, int threads, std::vector<std::uint32_t>& slot_of_point, Slots& slots, std::vector<PlaneFit>& planes);

}  // namespace scenelore::perception
