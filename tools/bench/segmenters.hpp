// Ways to find planes in a cloud, ours and those of other libraries, behind one signature.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scenelore/perception/cloud.hpp"

namespace scenelore::experiment {

struct Segmenter {
  std::string name;
  std::size_t most_points = 0;  ///< clouds larger than this would take it minutes; 0 = no limit
  /// One plane number a point, −1 = none.
  std::function<std::vector<std::int32_t>(const perception::Cloud&)> segment;
};

/// Normals of 30 neighbours and RegionGrowing as in the tutorial; the same on voxel grids of 5 and 3 cm with the labels
/// handed back to the points; SACSegmentation, one plane after another. Only where PCL is installed.
[[nodiscard]] std::vector<Segmenter> pcl_segmenters();

/// Region growing with 20 neighbours, Efficient RANSAC (Schnabel et al. 2007).
[[nodiscard]] std::vector<Segmenter> cgal_segmenters();

}  // namespace scenelore::experiment
