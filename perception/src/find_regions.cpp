#include "find_regions.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "assign.hpp"
#include "grow.hpp"
#include "limits.hpp"
#include "merge.hpp"
#include "scale.hpp"

namespace scenelore::perception {
namespace {

constexpr int kLevels = 3;              // voxels of 1, 2 and 4 times the finest size
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

}  // namespace

FoundRegions find_regions(const Cloud& cloud, const SegmentationParameters& parameters, int threads) {
  check(parameters);
  FoundRegions found;
  const Scale scale = estimate_scale(cloud, threads);
  found.voxel = scale.voxel;
  found.spacing = scale.spacing;
  Regions& regions = found.regions;
  regions.of_point.assign(cloud.size(), -1);
  double size = scale.voxel;
  for (int level = 0; level < kLevels; ++level, size *= 2) {
    VoxelGrid grid = make_voxel_grid(cloud, size, regions.of_point, threads);
    const std::vector<LocalSurface> surfaces = local_surfaces(grid, threads);
    const NoiseMap noise = estimate_noise(grid, surfaces, threads);
    if (level == 0) {
      found.noise = noise.typical;
      found.limits = derive_limits(parameters, scale, noise);
    }
    const Growth growth = grow_regions(grid, surfaces, noise, kFewestToGrow);
    take_points(cloud, grid, growth, found.limits, regions);
    if (level == 0) found.cells = std::move(grid.cells);
    refit(cloud, regions);
    // What growing left along the edges must not become regions of its own on the next level.
    assign_points(cloud, found.cells, found.limits, true, threads, regions);
  }
  for (int round = 0; round < 2; ++round) {
    refit(cloud, regions);
    merge_regions(cloud, found.cells, 2, found.noise, regions);
    assign_points(cloud, found.cells, found.limits, false, threads, regions);
  }
  refit(cloud, regions);
  return found;
}

}  // namespace scenelore::perception
