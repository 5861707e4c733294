// Surfaces that touch in one plane, as two desks side by side, are told apart by their outline.
#pragma once

#include "regions.hpp"

namespace scenelore::perception {

/// Cuts each plane of 0.5 to 4 m² whose outline is that of two well filled rectangles into two planes.
void part_outlines(const Cloud& cloud, Regions& regions);

}  // namespace scenelore::perception
