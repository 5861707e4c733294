// One rectangle or two: what of them the sensor has looked through tells.
#pragma once

#include <optional>
#include <vector>

#include "seen_past.hpp"

namespace scenelore::perception {

/// A straight line that parts the cells of a view into two, each with a rectangle of its own. Where the sensor saw things
/// behind the plane within a rectangle, the rectangle claims what is not there.
struct RectanglePair {
  Eigen::Vector2d across = Eigen::Vector2d::UnitX();  ///< unit vector across the line
  double at = 0;           ///< metres along `across`; cells before it are of the first part
  double empty_one = 0;    ///< m² seen through within the single rectangle that fits best
  double empty_two = 0;    ///< m² seen through within the two
};

/// The best pair for some of the held cells of a view: the one that claims least that is empty, needs the smallest
/// rectangles and has the shortest seam, in this order of weight. Nothing where no line leaves a real part on either side.
[[nodiscard]] std::optional<RectanglePair> best_rectangle_pair(const PlaneView& view, const std::vector<std::size_t>& cells);

/// Parts the held cells of a view into those of rectangles, as long as two claim clearly less that is empty than one. Each
/// cell is in one part; one part where no pair is better, and where the view knows of nothing empty.
[[nodiscard]] std::vector<std::vector<std::size_t>> part_into_rectangles(const PlaneView& view);

}  // namespace scenelore::perception
