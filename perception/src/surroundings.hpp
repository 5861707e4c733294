// What a scan holds around a plane: whether things lie on both of its sides, or the room ends with it.
#pragma once

#include <span>

#include "cell_index.hpp"
#include "moments.hpp"
#include "scenelore/perception/plane.hpp"

namespace scenelore::perception {

/// Cubes of 10 cm (of a voxel's edge, where that is longer) that hold at least three points, each as the mean of these.
class Surroundings {
 public:
  /// From the moments of voxels with this edge (metres), in the cloud's offsets.
  Surroundings(std::span<const Moments> voxels, double voxel);

  /// Plane::behind, for a plane in the scan's frame whose offsets count from `origin`; −1 without an outline. Each of `turns` is
  /// a plane that this one turns into around an edge: what lies before it is beside this one, not behind.
  [[nodiscard]] double behind(const Plane& plane, const Eigen::Vector3d& origin, std::span<const Plane* const> turns = {}) const;

 private:
  double edge_;
  std::vector<Eigen::Vector3d> places_;
  CellIndex blocks_;  ///< of places, a metre wide: what is far off is passed over at once
};

}  // namespace scenelore::perception
