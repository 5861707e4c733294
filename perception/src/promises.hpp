// Makes the promises of a segmentation true: connectedness, distance, mean squared error, number of points.
#pragma once

#include "sample.hpp"
#include "slots.hpp"

namespace scenelore::perception {

/// Of the points of its voxels that a plane must hold, not to be what is left over between the points of another.
inline constexpr double kOwnShare = 0.25;

/// What the promises leave of the regions: planes numbered by falling point count, ties by position.
struct Settled {
  Regions regions;
  std::vector<std::vector<std::uint32_t>> sampled;  ///< by plane: points of the cloud that are in the sample
};

/// Makes the connected parts of each region regions of their own, and where their planes differ from those that the points
/// were given to, gives the points to them anew. `bridged` says of each region, and then of each part, whether it goes on across shadows:
/// its points may be `max_point_distance` apart, however small it is, and need not fill its rectangle.
void separate_parts(const PointSample& sample, const VoxelGrid& grid, const Limits& limits, int threads,
                    SlotOfPoint& slot_of_point, Slots& slots, std::vector<PlaneFit>& planes, std::vector<bool>& bridged);

/// Splits, trims and drops regions until every one keeps all limits. Mostly the moments and rulers of the slots prove it;
/// the points are looked at only where they do not. What is too narrow, too thick or too loosely filled to be a surface
/// (edges, legs, frames) is dropped. `bridged`: by region, as separate_parts leaves it. `slot_of_point` is used up.
[[nodiscard]] Settled keep_promises(const Cloud& cloud, const VoxelisedCloud& voxels, const PointSample& sample, const Slots& slots,
                                    const std::vector<bool>& bridged, const Limits& limits, int threads, SlotOfPoint slot_of_point);

}  // namespace scenelore::perception
