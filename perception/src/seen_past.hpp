// What the sensor saw past a plane: a ray that went on behind it met nothing where it crossed.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "regions.hpp"

namespace scenelore::perception {

/// A plane in cells of its own frame: the second and third axis of the fit, from its centroid.
struct PlaneView {
  double edge = 0;                     ///< metres, of a cell
  std::vector<Eigen::Vector2d> held;   ///< middles of the cells that hold points of the plane, by row and column
  std::vector<int> points;             ///< in each of them
  std::vector<std::uint32_t> cell_of;  ///< by point of the plane: its cell in `held`
  std::vector<Eigen::Vector2d> empty;  ///< middles of the cells that were looked through
};

/// The cells of a plane with these points, at least one; nothing is known to be empty yet.
[[nodiscard]] PlaneView view_of(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& points, double edge);

/// Finds the cells between the outermost held ones that rays crossed on their way to points more than `behind` (metres) behind
/// the plane, at least three for each of the plane's own points there and one. Rays from all places where the sensor stood count alike,
/// each behind the plane as seen from its own. What no ray reached, since something stood before it, stays unknown. A sensor within
/// twice `behind` of the plane sees nothing past it, nor does one that nobody knows the place of.
void look_past(const Cloud& cloud, const PlaneFit& plane, double behind, PlaneView& view);

}  // namespace scenelore::perception
