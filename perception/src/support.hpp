// A surface that things lie on or hang on, as a frame: heights are measured over its own level, towards the room.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "regions.hpp"
#include "scenelore/perception/upright.hpp"

namespace scenelore::perception {

/// A point in the frame of a support.
struct Sample {
  std::uint32_t point;
  Eigen::Vector2f at;  ///< metres along the support
  float height;        ///< metres over the support's own level
};

struct Support {
  Eigen::Vector3d normal, centroid;  ///< normal towards the room; in the cloud's offsets
  Eigen::Vector3d u, v;
  double noise = 0;    ///< metres, scatter of its own points about its level
  bool level = false;  ///< across up: a table, a floor

  [[nodiscard]] Sample sample(const Cloud& cloud, std::uint32_t i) const {
    const Eigen::Vector3d d = cloud.offset(i).cast<double>() - centroid;
    return {i, {static_cast<float>(u.dot(d)), static_cast<float>(v.dot(d))}, static_cast<float>(normal.dot(d))};
  }
};

/// Cosine of 6 degrees: planes that are level but for this carry things.
inline constexpr double kLevel = 0.9945;

/// The support that a plane with these points is; nothing for an upright plane of which nobody knows on which side the room
/// is. Where things cover part of it, the level is that of the uncovered part, and so is the slope (at most 1.5 degrees
/// from level).
[[nodiscard]] std::optional<Support> make_support(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& points,
                                                  const Eigen::Vector3d& up);

}  // namespace scenelore::perception
