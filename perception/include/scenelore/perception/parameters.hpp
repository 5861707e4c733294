// The five parameters of the paper's region growing.
#pragma once

#include <optional>

namespace scenelore::perception {

/// The paper's five parameters (section 3.1). Metres. A value that is not set is derived from the cloud (spacing, noise).
struct SegmentationParameters {
  std::optional<double> max_point_distance;  ///< largest distance between two neighbouring points of a plane
  std::optional<double> max_plane_distance;  ///< largest distance of a point to its plane
  std::optional<double> max_mse;             ///< m², largest mean squared error of a plane
  std::optional<int> min_points;             ///< smallest number of points of a plane
  std::optional<int> max_neighbours;         ///< what one point may be compared with
};

}  // namespace scenelore::perception
