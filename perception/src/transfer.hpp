// What was found by looking at single points becomes a matter of planes and voxels again.
#pragma once

#include <functional>

#include "sample.hpp"
#include "slots.hpp"

namespace scenelore::perception {

/// `judge` gives the points of the sample to other planes than `slots` do, or to new ones at the end, or to none. In the
/// voxels where it changed something, the points are then given to the plane nearest to them, as far as the plane's
/// points reach: to one of those that hold points there and, with `old_ones_too`, to those that held points before.
void transfer(const PointSample& sample, const VoxelGrid& grid, const Limits& limits, const std::function<void(Regions&)>& judge,
              bool old_ones_too, int threads, SlotOfPoint& slot_of_point, Slots& slots, std::vector<PlaneFit>& planes);

/// The slots of the whole cloud from those of its sample: every point goes to the nearest of the planes that hold sampled
/// points in its voxel, as far as these reach. `slot_of_point` is that of the sample before and of the cloud afterwards; of the
/// sample only its numbers are left, to make room.
void spread_from_sample(const Cloud& cloud, const VoxelisedCloud& voxels, PointSample& sample, const Limits& limits, int threads,
                        SlotOfPoint& slot_of_point, Slots& slots, std::vector<PlaneFit>& planes);

}  // namespace scenelore::perception
