// Which points belong to which plane, voxel by voxel.
#pragma once

#include <cstdint>
#include <vector>

#include "regions.hpp"
#include "voxel_grid.hpp"

namespace scenelore::perception {

/// Every voxel has a few slots: one for each plane that may own points in it, and a last one for points of no plane. A
/// point has the number of its slot; whatever happens to a plane afterwards (joined, dropped, moved) is a matter of
/// slots, of which there are about two a voxel however many points there are.
struct Slots {
  std::vector<std::uint32_t> first;   ///< slot of each voxel, and the number of slots at the end
  std::vector<std::uint32_t> voxel;   ///< by slot
  std::vector<std::int32_t> region;   ///< by slot: plane it belongs to, −1 = none
  std::vector<Moments> moments;       ///< by slot, of its points
  std::vector<std::int32_t> ruler;    ///< by slot: what its points were measured with, −1 = nothing
  std::vector<PlaneEquation> rulers;
  std::vector<double> reach;          ///< by ruler, metres: no point of the slot is further from it

  [[nodiscard]] std::size_t count() const { return voxel.size(); }
};

using SlotOfPoint = std::vector<std::int32_t>;  ///< −1 = invalid, or in no voxel

/// One slot for all points of each voxel, with the regions that voxels have; for the first assignment.
[[nodiscard]] Slots slots_of_voxels(const VoxelGrid& grid, const std::vector<std::int32_t>& region_of_voxel);

/// The slots with points of each region, in order. `first`: of those from here on, the others stay empty.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> slots_of_regions(const Slots& slots, std::size_t count, std::size_t first = 0);

[[nodiscard]] std::vector<Moments> moments_of_regions(const Slots& slots, std::size_t count);

/// Fits the planes anew to what their slots hold; planes without points keep count 0.
void refit(const Slots& slots, std::vector<PlaneFit>& planes);

/// How far from the plane the nearest corner of a voxel with this centre is, half an edge given; negative where it is cut.
[[nodiscard]] double clearance(const PlaneFit& plane, const Eigen::Vector3d& center, double half);

/// The region of each point, −1 = none.
[[nodiscard]] std::vector<std::int32_t> regions_of_points(const Slots& slots, const SlotOfPoint& slot_of_point);

/// The points whose slots are of each set, in order. `set_of_slot`: −1 = of none.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> points_of_sets(const Slots& slots, const SlotOfPoint& slot_of_point,
                                                                     const std::vector<std::int32_t>& set_of_slot, std::size_t sets);

/// Tolerances of all planes.
[[nodiscard]] std::vector<double> tolerances(const std::vector<PlaneFit>& planes, const Limits& limits);

}  // namespace scenelore::perception
