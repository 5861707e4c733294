// Region growing from voxel moments: which points of a cloud lie on which plane, in linear time.
//
//   const Segmentation s = segment(cloud);
//   s.plane_of_point[i];   // number of the plane that holds point i, −1 = none
#pragma once

#include <cstdint>
#include <vector>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/parameters.hpp"
#include "scenelore/perception/plane_fit.hpp"

namespace scenelore::perception {

/// What holds for every result, for the parameters in it: the points of a plane are connected by steps of at most
/// max_point_distance; each lies within max_plane_distance of the plane fitted to them all; the mean of the squared
/// distances is at most max_mse; there are at least min_points of them.
struct Segmentation {
  SegmentationParameters parameters;         ///< all five set, as used
  double voxel = 0;                          ///< metres, edge of the finest cells used
  double spacing = 0;                        ///< metres, typical distance between neighbouring points
  double noise = 0;                          ///< metres, typical deviation of a point from its surface
  std::vector<std::int32_t> plane_of_point;  ///< one a point of the cloud, −1 = none
  std::vector<PlaneFit> planes;              ///< by falling point count, ties by position; in the cloud's offsets (origin left out)
};

/// Throws Error for a parameter out of range. The result does not depend on `threads`, and on the order of the points
/// only through rounding.
[[nodiscard]] Segmentation segment(const Cloud& cloud, const SegmentationParameters& parameters = {}, int threads = 2);

}  // namespace scenelore::perception
