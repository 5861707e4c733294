// Gives points to planes.
#pragma once

#include "candidates.hpp"
#include "voxelise.hpp"

namespace scenelore::perception {

/// What an assignment weighs.
struct AssignRule {
  std::vector<double> reach;         ///< by region, metres: the furthest point it takes
  std::vector<double> unit;          ///< by region, metres: distances are compared in these units
  bool larger_first = true;          ///< of two almost parallel planes the larger one keeps what it explains
};

/// Gives every point of a cloud with these voxels to the nearest of its voxel's candidates, one pass over the points.
[[nodiscard]] Slots assign_points(const Cloud& cloud, const VoxelisedCloud& voxels, const Candidates& candidates, const std::vector<PlaneFit>& planes,
                                  const AssignRule& rule, int threads, SlotOfPoint& slot_of_point);

/// The same of points that are sorted by voxel.
[[nodiscard]] Slots assign_points(const PointsByVoxel& points, const VoxelGrid& grid, const Candidates& candidates, const std::vector<PlaneFit>& planes,
                                  const AssignRule& rule, int threads, SlotOfPoint& slot_of_point);

/// The same of the points in some of the voxels: `anew` says of each whether it is one. The rest keep their slots.
void assign_anew(const PointsByVoxel& points, const VoxelGrid& grid, const std::vector<bool>& anew, const Candidates& candidates,
                 const std::vector<PlaneFit>& planes, const AssignRule& rule, int threads, SlotOfPoint& slot_of_point, Slots& slots);

}  // namespace scenelore::perception
