// What a plane covers on the floor: an outline for a flat one, a strip for a steep one.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "scenelore/perception/plane.hpp"

namespace scenelore::exports {

using Ring2 = std::vector<Eigen::Vector2d>;

/// A rectangle in any direction.
struct OrientedBox {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  ///< unit, along the length
  Eigen::Vector2d half = Eigen::Vector2d::Zero();   ///< half length and half width

  [[nodiscard]] Eigen::Vector2d corner(int index) const;  ///< 0..3
};

/// Whether the inner parts of two boxes meet (separating axes).
[[nodiscard]] bool overlap(const OrientedBox& a, const OrientedBox& b);

struct Footprint {
  bool strip = false;
  std::vector<Ring2> rings;                          ///< outer one first, then holes; simplified to 2 cm
  OrientedBox box;                                   ///< the smallest rectangle about the outer ring
  Eigen::Vector2d behind = Eigen::Vector2d::Zero();  ///< for a strip: unit vector away from the seen side
  double area = 0;                                   ///< m² on the floor, holes taken off
};

/// In metres, y up. Nothing for a hull without three corners or with coordinates that are not finite.
[[nodiscard]] std::optional<Footprint> footprint(const perception::Polygon& hull, double tilt_deg);

/// Even-odd rule over all rings.
[[nodiscard]] bool contains(const std::vector<Ring2>& rings, const Eigen::Vector2d& point);

}  // namespace scenelore::exports
