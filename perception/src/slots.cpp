#include "slots.hpp"

#include <algorithm>
#include <cmath>

namespace scenelore::perception {

Slots slots_of_voxels(const VoxelGrid& grid, const std::vector<std::int32_t>& region_of_voxel) {
  Slots slots;
  slots.first.resize(grid.count() + 1);
  slots.voxel.resize(grid.count());
  for (std::size_t v = 0; v < grid.count(); ++v) slots.first[v] = slots.voxel[v] = static_cast<std::uint32_t>(v);
  slots.first.back() = static_cast<std::uint32_t>(grid.count());
  slots.region = region_of_voxel;
  slots.ruler.assign(grid.count(), -1);
  slots.moments = grid.moments;
  return slots;
}

std::vector<std::vector<std::uint32_t>> slots_of_regions(const Slots& slots, std::size_t count, std::size_t first) {
  std::vector<std::vector<std::uint32_t>> members(count);
  for (std::size_t s = 0; s < slots.count(); ++s) {
    const std::int32_t r = slots.region[s];
    if (r >= static_cast<std::int32_t>(first) && slots.moments[s].n > 0) members[r].push_back(static_cast<std::uint32_t>(s));
  }
  return members;
}

std::vector<Moments> moments_of_regions(const Slots& slots, std::size_t count) {
  std::vector<Moments> moments(count);
  for (std::size_t s = 0; s < slots.count(); ++s) {
    if (slots.region[s] >= 0) moments[static_cast<std::size_t>(slots.region[s])] += slots.moments[s];
  }
  return moments;
}

void refit(const Slots& slots, std::vector<PlaneFit>& planes) {
  const std::vector<Moments> moments = moments_of_regions(slots, planes.size());
  for (std::size_t r = 0; r < planes.size(); ++r) planes[r] = fit_plane(moments[r]);
}

/// The planes are fitted anew to what they were given; as long as that moves them by less than what is left free here,
/// no point is too far from them.
constexpr double kFree = 0.97;

std::vector<std::int32_t> regions_of_points(const Slots& slots, const SlotOfPoint& slot_of_point) {
  std::vector<std::int32_t> regions;
  regions.reserve(slot_of_point.size());
  for (const std::int32_t s : slot_of_point) regions.push_back(s < 0 ? -1 : slots.region[s]);
  return regions;
}

std::vector<std::vector<std::uint32_t>> points_of_sets(const Slots& slots, const SlotOfPoint& slot_of_point, const std::vector<std::int32_t>& set_of_slot,
                                                       std::size_t sets) {
  std::vector<double> sizes(sets, 0);
  for (std::size_t s = 0; s < slots.count(); ++s) {
    if (set_of_slot[s] >= 0) sizes[set_of_slot[s]] += slots.moments[s].n;
  }
  std::vector<std::vector<std::uint32_t>> points(sets);
  for (std::size_t k = 0; k < sets; ++k) points[k].reserve(static_cast<std::size_t>(sizes[k]));
  for (std::size_t i = 0; i < slot_of_point.size(); ++i) {
    const std::int32_t set = slot_of_point[i] < 0 ? -1 : set_of_slot[slot_of_point[i]];
    if (set >= 0) points[set].push_back(static_cast<std::uint32_t>(i));
  }
  return points;
}

std::vector<double> tolerances(const std::vector<PlaneFit>& planes, const Limits& limits) {
  std::vector<double> result(planes.size());
  for (std::size_t r = 0; r < planes.size(); ++r) result[r] = std::min(tolerance(planes[r], limits), kFree * limits.max_plane_distance);
  return result;
}

double clearance(const PlaneFit& plane, const Eigen::Vector3d& center, double half) {
  return std::abs(plane.distance(center)) - half * plane.normal.cwiseAbs().sum();
}

}  // namespace scenelore::perception
