#include "transfer.hpp"

#include <algorithm>
#include <cmath>

#include "assign.hpp"
#include "scenelore/perception/memory.hpp"

namespace scenelore::perception {
namespace {

using VoxelRegion = std::pair<std::uint32_t, std::int32_t>;

/// Rows of distinct regions by voxel.
Candidates rows_of(std::vector<VoxelRegion> pairs, std::size_t voxels) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Candidates rows;
  rows.first.assign(voxels + 1, 0);
  for (const auto& [v, r] : pairs) {
    ++rows.first[v + 1];
    rows.regions.push_back(r);
  }
  for (std::size_t v = 0; v < voxels; ++v) rows.first[v + 1] += rows.first[v];
  return rows;
}

}  // namespace

void transfer(const PointSample& sample, const VoxelGrid& grid, const Limits& limits, const std::function<void(Regions&)>& judge,
              bool old_ones_too, int threads, SlotOfPoint& slot_of_point, Slots& slots, std::vector<PlaneFit>& planes) {
  Regions regions;
  regions.planes = planes;
  regions.of_point = regions_of_points(slots, slot_of_point);
  judge(regions);
  const std::size_t points = slot_of_point.size();

  AssignRule rule;
  rule.larger_first = false;
  std::vector<bool> anew(grid.count(), false);
  std::vector<bool> changed(regions.planes.size(), false);
  std::fill(changed.begin() + static_cast<std::ptrdiff_t>(planes.size()), changed.end(), true);
  for (std::size_t k = 0; k < points; ++k) {
    const std::int32_t before = slots.region[slot_of_point[k]];
    if (before == regions.of_point[k]) continue;
    anew[slots.voxel[slot_of_point[k]]] = true;
    if (before >= 0) changed[before] = true;
    if (regions.of_point[k] >= 0) changed[regions.of_point[k]] = true;
  }
  // What did not change keeps the plane of all its points.
  for (std::size_t r = 0; r < planes.size(); ++r) {
    if (!changed[r]) regions.planes[r] = planes[r];
  }
  planes = std::move(regions.planes);
  rule.reach = reaches(sample.cloud, regions.of_point, planes, limits, threads);
  rule.unit.assign(planes.size(), 1.0);
  std::vector<VoxelRegion> pairs;
  std::vector<std::int32_t> last(grid.count(), -1);
  for (std::size_t k = 0; k < points; ++k) {
    const std::int32_t r = regions.of_point[k];
    if (r < 0) continue;
    const std::uint32_t v = slots.voxel[slot_of_point[k]];
    if (!anew[v] || last[v] == r) continue;
    last[v] = r;
    pairs.emplace_back(v, r);
  }
  for (std::size_t s = 0; old_ones_too && s < slots.count(); ++s) {
    if (anew[slots.voxel[s]] && slots.region[s] >= 0 && slots.moments[s].n > 0) pairs.emplace_back(slots.voxel[s], slots.region[s]);
  }
  assign_anew(sample.by_voxel, grid, anew, rows_of(std::move(pairs), grid.count()), planes, rule, threads, slot_of_point, slots);
  refit(slots, planes);
}

namespace {

/// The planes as all points would have them: a slot of the sample stands for as many points as its voxel has for each
/// sampled one.
std::vector<PlaneFit> planes_of_all(const VoxelisedCloud& voxels, const PointSample& sample, const Slots& slots, std::size_t count) {
  std::vector<Moments> moments(count);
  for (std::size_t s = 0; s < slots.count(); ++s) {
    if (slots.region[s] < 0 || slots.moments[s].n <= 0) continue;
    const std::uint32_t v = slots.voxel[s];
    Moments all = slots.moments[s];
    all *= static_cast<double>(voxels.fixed[v].n) / static_cast<double>(sample.by_voxel.count(v));
    moments[slots.region[s]] += all;
  }
  std::vector<PlaneFit> planes(count);
  for (std::size_t r = 0; r < count; ++r) planes[r] = fit_plane(moments[r]);
  return planes;
}

}  // namespace

void spread_from_sample(const Cloud& cloud, const VoxelisedCloud& voxels, PointSample& sample, const Limits& limits, int threads,
                        SlotOfPoint& slot_of_point, Slots& slots, std::vector<PlaneFit>& planes) {
  if (sample.points.size() == cloud.size()) return;
  planes = planes_of_all(voxels, sample, slots, planes.size());
  AssignRule rule;
  rule.larger_first = false;
  const std::vector<std::int32_t> region_of_point = regions_of_points(slots, slot_of_point);
  rule.reach = reaches(sample.cloud, region_of_point, planes, limits, threads);
  rule.unit = scatters(sample.cloud, region_of_point, planes, threads);
  const Candidates candidates = candidates_within(slots, rule.unit);
  slots = {}, sample.cloud = {}, sample.by_voxel = {};
  release(slot_of_point);
  slots = assign_points(cloud, voxels, candidates, planes, rule, threads, slot_of_point);
  refit(slots, planes);
}

}  // namespace scenelore::perception
