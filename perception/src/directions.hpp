// What was measured in each direction from where the sensor stood.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "cell_index.hpp"
#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception {

/// Points by the direction that they were seen in. Cells of about equal solid angle, those of a cube around the sensor whose
/// faces are divided by the quadratic projection of the S2 geometry library (the largest cell is 2.1 times the smallest).
class Directions {
 public:
  /// These points of a cloud, seen from `eye` (metres, in the cloud's offsets).
  Directions(const Cloud& cloud, std::vector<std::uint32_t> points, const Eigen::Vector3d& eye, int threads);

  /// Radians between neighbouring measurements, if they were evenly spread over where something was measured; 0 without points.
  [[nodiscard]] double step() const { return step_; }

  /// The points in the cell of the direction from the eye to `place` (in the cloud's offsets), a step or so wide; where it is
  /// empty, those in the eight around it. Replaces the content of `found`.
  void measured_towards(const Eigen::Vector3d& place, std::vector<std::uint32_t>& found) const;

 private:
  void append(const Eigen::Vector3d& direction, std::vector<std::uint32_t>& found) const;

  Eigen::Vector3d eye_;
  std::vector<std::uint32_t> points_;  ///< of the cloud
  double step_ = 0;
  int cells_ = 1;   ///< along the edge of the cube
  CellIndex index_;  ///< of points_
};

}  // namespace scenelore::perception
