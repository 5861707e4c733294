// The steps of segmentation, shared by segment() and perceive().
#pragma once

#include "promises.hpp"
#include "scenelore/perception/parameters.hpp"
#include "scenelore/perception/upright.hpp"

namespace scenelore::perception {

struct FoundRegions : Settled {
  Limits limits;
  Upright upright;
  double voxel = 0, spacing = 0, noise = 0;  ///< metres
};

/// Everything up to the promises, which hold for the result. `up` and `floor_z` replace the estimates of the upright frame.
/// Throws Error for a parameter out of range.
[[nodiscard]] FoundRegions find_regions(const Cloud& cloud, const SegmentationParameters& parameters, int threads,
                                        const std::optional<Eigen::Vector3d>& up = {}, const std::optional<double>& floor_z = {});

}  // namespace scenelore::perception
