// What was found in a sample of the points becomes true of all of them.
#pragma once

#include <functional>

#include "sample.hpp"
#include "slots.hpp"

namespace scenelore::perception {

/// `judge` gives the points of the sample to other planes than `slots` do, or to new ones at the end, or to none. In the
/// voxels where it changed something, all points are then given to the plane nearest to them, as far as the plane's
/// points in the sample reach: to one of those that hold points of the sample there and, with `old_ones_too`, to those
/// that held points before.
void transfer_from_sample(const Cloud& cloud, const VoxelisedCloud& voxels, const PointSample& sample, const Limits& limits,
                          const std::function<void(Regions&)>& judge, bool old_ones_too, int threads,
                          std::vector<std::uint32_t>& slot_of_point, Slots& slots, std::vector<PlaneFit>& planes);

}  // namespace scenelore::perception
