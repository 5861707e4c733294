// Which way is up, and where the floor is, from the planes themselves.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <string>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/plane_fit.hpp"

namespace scenelore::perception {

/// The rotation that makes z point up, and the floor: height = (rotation * p).z − floor_z.
struct Upright {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  double floor_z = 0;
  bool floor_found = false;  ///< false: no floor was visible, floor_z is the file's zero level or that of the lowest points
  double confidence = 0;     ///< 0..1
  std::string explanation;   ///< a sentence: from which planes, how far tilted
};

/// Looks for the direction within 35 degrees of the file's z axis that most of the area of `planes` (in the cloud's
/// offsets) is at right angles to (floors, tables, ceilings) or parallel to (walls); where z does nearly as well, z is
/// the start. Planes within 10 degrees of level or upright settle it, weighed by how far planes of this scan differ. An
/// estimate that differs from z by no more than its own uncertainty counts as z. `up` and `floor_z` replace the estimates;
/// `floor_z` is a level along up.
[[nodiscard]] Upright estimate_upright(const Cloud& cloud, std::span<const PlaneFit> planes,
                                       const std::optional<Eigen::Vector3d>& up = {}, const std::optional<double>& floor_z = {});

}  // namespace scenelore::perception
