#include "find_regions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "absorb.hpp"
#include "assign.hpp"
#include "clutter.hpp"
#include "grow.hpp"
#include "limits.hpp"
#include "merge.hpp"
#include "part_outlines.hpp"
#include "promises.hpp"
#include "scale.hpp"
#include "thin_objects.hpp"

namespace scenelore::perception {
namespace {

constexpr int kLevels = 3;              // voxels of 1, 2 and 4 times the finest size
constexpr int kRounds = 3;              // of merging and assigning; later ones change next to nothing
constexpr double kFewestToGrow = 12;    // points of a region while it is still growing

/// Regions of one level become regions of points: those of the voxel that lie near enough to its plane.
void take_points(const Cloud& cloud, const VoxelGrid& grid, const Growth& growth, const Limits& limits, Regions& regions) {
  const auto first = static_cast<std::int32_t>(regions.planes.size());
  for (std::size_t v = 0; v < grid.count(); ++v) {
    const std::int32_t r = growth.region_of_voxel[v];
    if (r < 0) continue;
    const PlaneFit& plane = growth.regions[static_cast<std::size_t>(r)];
    const double reach = tolerance(plane, limits);
    for (const std::uint32_t i : grid.cells.items(v)) {
      if (std::abs(plane.distance(cloud.offset(i).cast<double>())) <= reach) regions.of_point[i] = first + r;
    }
  }
  regions.planes.insert(regions.planes.end(), growth.regions.begin(), growth.regions.end());
}

/// The planes that hold points, most points first.
std::vector<PlaneFit> by_size(const std::vector<PlaneFit>& planes) {
  std::vector<PlaneFit> result;
  std::copy_if(planes.begin(), planes.end(), std::back_inserter(result), [](const PlaneFit& p) { return p.count > 0; });
  std::stable_sort(result.begin(), result.end(), [](const PlaneFit& a, const PlaneFit& b) { return a.count > b.count; });
  return result;
}

}  // namespace

FoundRegions find_regions(const Cloud& cloud, const SegmentationParameters& parameters, int threads,
                          const std::optional<Eigen::Vector3d>& up, const std::optional<double>& floor_z) {
  check(parameters);
  FoundRegions found;
  const Scale scale = estimate_scale(cloud, threads);
  found.voxel = scale.voxel;
  found.spacing = scale.spacing;
  Regions& regions = found.regions;
  regions.of_point.assign(cloud.size(), -1);
  double size = scale.voxel;
  CellIndex cells;                     // the finest voxels, of all points
  std::vector<LocalSurface> finest;    // their surroundings
  for (int level = 0; level < kLevels; ++level, size *= 2) {
    VoxelGrid grid = make_voxel_grid(cloud, size, regions.of_point, threads);
    std::vector<LocalSurface> surfaces = local_surfaces(grid, threads);
    const NoiseMap noise = estimate_noise(grid, surfaces, threads);
    if (level == 0) {
      found.noise = noise.typical;
      found.limits = derive_limits(parameters, scale, noise);
    }
    const Growth growth = grow_regions(grid, surfaces, noise, kFewestToGrow);
    take_points(cloud, grid, growth, found.limits, regions);
    if (level == 0) {
      cells = std::move(grid.cells);
      finest = std::move(surfaces);
    }
    refit(cloud, regions);
    // What growing left along the edges must not become regions of its own on the next level.
    assign_points(cloud, cells, found.limits, true, threads, regions);
  }
  for (int round = 0; round < kRounds; ++round) {
    refit(cloud, regions);
    merge_regions(cloud, cells, 2, found.limits.max_plane_distance / 3, regions);
    absorb_fragments(cloud, cells, found.limits, regions);
    assign_points(cloud, cells, found.limits, false, threads, regions);
  }
  refit(cloud, regions);
  bridge_shadows(cloud, cells, 6, found.limits.max_plane_distance / 3, kLargePlane, regions);
  drop_clutter(cloud, cells, finest, scale.voxel, regions);
  assign_points(cloud, cells, found.limits, true, threads, regions);  // what clutter held may belong to what is left
  refit(cloud, regions);
  found.upright = estimate_upright(cloud, by_size(regions.planes), up, floor_z);
  const std::size_t supports = regions.planes.size();
  split_thin_objects(cloud, found.upright, found.limits, regions);
  join_level_pieces(cloud, cells, 3, found.upright.rotation.inverse() * Eigen::Vector3d::UnitZ(), supports, regions);
  part_outlines(cloud, regions);
  keep_promises(cloud, found.limits, threads, regions);
  return found;
}

}  // namespace scenelore::perception
