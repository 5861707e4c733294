// Region growing over voxels from the flattest places, each voxel tested against the region's plane from moments alone.
#pragma once

#include <cstdint>
#include <vector>

#include "surface_voxels.hpp"

namespace scenelore::perception {

struct Growth {
  std::vector<std::int32_t> region_of_voxel;  ///< −1 = none
  std::vector<PlaneFit> regions;
  std::vector<double> noise;                  ///< metres, of each region's own points about its plane
};

[[nodiscard]] Growth grow_regions(const VoxelGrid& grid, const std::vector<LocalSurface>& surfaces, const NoiseMap& noise,
                                  double fewest_points);

}  // namespace scenelore::perception
