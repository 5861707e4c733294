// Surfaces that touch in one plane, as two desks side by side, are told apart by their outline.
#pragma once

#include "regions.hpp"

namespace scenelore::perception {

/// Cuts planes of 0.5 to 4 m² into those of rectangles by outlines that two well filled rectangles explain. Where the sensor's position is known,
/// level planes alone, of up to 12 m², by what it saw past them before. `up` is a unit vector.
/// Returns by region whether it is a part of what was cut.
std::vector<bool> part_outlines(const Cloud& cloud, const Eigen::Vector3d& up, Regions& regions);

}  // namespace scenelore::perception
