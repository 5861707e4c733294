// Which space of a room is taken: upright boxes, turned about the vertical. Nothing is put where something is.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace scenelore::simulator {

struct Volume {
  Eigen::Vector2d centre;
  Eigen::Vector2d axis;   ///< unit vector of the box's local x
  double half_x, half_y;  ///< metres
  double low, high;       ///< heights
};

/// The box between two corners of a frame whose z axis is vertical.
[[nodiscard]] Volume volume(const Eigen::Isometry3d& frame, const Eigen::Vector3d& low, const Eigen::Vector3d& high);
/// Whether they share space; touching by less than a millimetre is allowed.
[[nodiscard]] bool overlap(const Volume& x, const Volume& y);

class Occupancy {
 public:
  Occupancy(double width, double depth) : width_(width), depth_(depth) {}
  void add(const Volume& taken) { taken_.push_back(taken); }
  /// Inside the room's rectangle and clear of all that was added.
  [[nodiscard]] bool free(const Volume& wanted) const;
  [[nodiscard]] bool free(std::span<const Volume> wanted) const;

 private:
  double width_, depth_;
  std::vector<Volume> taken_;
};

}  // namespace scenelore::simulator
