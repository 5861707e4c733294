// Makes the promises of a segmentation true: connectedness, distance, mean squared error, number of points.
#pragma once

#include "regions.hpp"

namespace scenelore::perception {

/// Splits, trims and drops regions until every one keeps all limits, and numbers them by falling point count, ties by
/// position. A region in `fixed_normal` terms needs nothing special: its plane is fitted to its points like any other.
void keep_promises(const Cloud& cloud, const Limits& limits, int threads, Regions& regions);

}  // namespace scenelore::perception
