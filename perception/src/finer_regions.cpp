#include "finer_regions.hpp"

#include <cmath>

#include "grow.hpp"
#include "scenelore/perception/memory.hpp"
#include "voxelise.hpp"

namespace scenelore::perception {

void grow_finer(const Cloud& cloud, double voxel, double fewest, const Limits& limits, int threads, Regions& regions) {
  Cloud left;
  left.origin = cloud.origin;
  std::vector<std::uint32_t> point;  // of the cloud
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (regions.of_point[i] >= 0) continue;
    point.push_back(static_cast<std::uint32_t>(i));
    left.x.push_back(cloud.x[i]), left.y.push_back(cloud.y[i]), left.z.push_back(cloud.z[i]);
  }
  if (point.empty()) return;
  VoxelisedCloud voxels = voxelise(left, voxel, threads);
  release(voxels.fixed);  // growing asks for moments
  const std::vector<LocalSurface> surfaces = local_surfaces(voxels.grid, threads);
  const Growth growth = grow_regions(voxels.grid, surfaces, estimate_noise(voxels.grid, surfaces, threads), fewest);
  const auto first = static_cast<std::int32_t>(regions.planes.size());
  PointLocator locator(voxels.grid);
  for (std::size_t k = 0; k < point.size(); ++k) {
    const std::uint32_t v = locator.locate(left, k);
    const std::int32_t r = v == kNoVoxel ? -1 : growth.region_of_voxel[v];
    if (r < 0) continue;
    const PlaneFit& plane = growth.regions[static_cast<std::size_t>(r)];
    if (std::abs(plane.distance(left.offset(k).cast<double>())) <= tolerance(plane, limits)) regions.of_point[point[k]] = first + r;
  }
  regions.planes.insert(regions.planes.end(), growth.regions.begin(), growth.regions.end());
  refit(cloud, regions);
}

}  // namespace scenelore::perception
