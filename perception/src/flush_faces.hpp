// Boards, pictures, doors and windows that stand out from their wall by less than its points scatter.
#pragma once

#include <span>

#include "regions.hpp"

namespace scenelore::perception {

/// Gives the parts of a plane of 0.5 m² and more that lie a few millimetres before or behind the rest of it planes of
/// their own, where the means of many points leave no doubt of the step (StepFaceFinder). What of another plane lies in
/// such a part goes along when that is nearly all of it. `weight`: how many points of the scan each point of the cloud
/// stands for; `up` is a unit vector.
void part_flush_faces(const Cloud& cloud, std::span<const float> weight, const Eigen::Vector3d& up, Regions& regions);

}  // namespace scenelore::perception
