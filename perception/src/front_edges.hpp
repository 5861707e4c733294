// Where a face is seen at a slant, its front edge is seen more squarely than the face, and gives it points that lie on the side of the thing.
#pragma once

#include "slots.hpp"

namespace scenelore::perception {

/// Frees, of planes of up to 2.5 m² that are seen at 45 degrees or more, those points near the front that are more likely of what lies behind or
/// before the face (face_and_sides.hpp): the front edge of a shelf or a desk, the feet of the books on it. A plane that would then hold
/// too little of its voxels (kOwnShare) stays as it is, and so do clouds without a sensor's position. `noise`: metres along the ray.
/// `slot_of_point` is that of the whole cloud; moments of slots and planes are made anew. The same with any number of threads.
void free_front_edges(const Cloud& cloud, double noise, int threads, SlotOfPoint& slot_of_point, Slots& slots, std::vector<PlaneFit>& planes);

}  // namespace scenelore::perception
