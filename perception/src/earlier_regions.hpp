// Regions as they were before they were given up. One that takes in what stands beside it gets thicker, so reaches further and takes in more: a screen
// and the lamp before it, a keyboard and the mug. What it was at first may be the face that it is no more.
#pragma once

#include <cstdint>
#include <span>

#include "regions.hpp"

namespace scenelore::perception {

/// Makes regions of `earlier` (one number a point, −1 = none) new ones, at the end, of their points that are free now: those most of whose points
/// are, `fewest` at least.
void bring_back(const Cloud& cloud, std::span<const std::int32_t> earlier, int fewest, Regions& regions);

}  // namespace scenelore::perception
