#include "scenelore/perception/segment.hpp"

#include "find_regions.hpp"
#include "limits.hpp"

namespace scenelore::perception {

Segmentation segment(const Cloud& cloud, const SegmentationParameters& parameters, int threads) {
  FoundRegions found = find_regions(cloud, {.parameters = parameters, .up = {}, .floor_z = {}, .threads = threads, .on_stage = {}});
  Segmentation result;
  result.parameters = to_parameters(found.limits);
  result.voxel = found.voxel;
  result.spacing = found.spacing;
  result.noise = found.noise;
  result.plane_of_point = std::move(found.regions.of_point);
  result.planes = std::move(found.regions.planes);
  return result;
}

}  // namespace scenelore::perception
