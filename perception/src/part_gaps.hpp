// Pieces in one plane with nothing between them: the sensor saw through the gap.
#pragma once

#include "regions.hpp"

namespace scenelore::perception {

/// Parts planes of up to 12 m² into those of their pieces where rays crossed the gaps between them. A gap that no ray crossed
/// is a shadow or too sparsely seen, and parts nothing. Clouds without a sensor's position stay as they are.
void part_at_gaps(const Cloud& cloud, const Limits& limits, Regions& regions, int threads = 1);

}  // namespace scenelore::perception
