// Surfaces that touch in one plane, as two desks side by side, are told apart by their outline.
#pragma once

#include "regions.hpp"

namespace scenelore::perception {

/// Cuts planes of 0.5 to 4 m² into those of rectangles: level planes by what the sensor saw past them, where its position is
/// known, and all others by outlines that two well filled rectangles explain. `up` is a unit vector.
void part_outlines(const Cloud& cloud, const Eigen::Vector3d& up, Regions& regions);

}  // namespace scenelore::perception
