// How a plane lies to the other planes of its scene: what is beneath, above and behind it, and what meets its edges.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <span>
#include <vector>

#include "scenelore/perception/plane.hpp"

namespace scenelore::perception {

/// Metres, or shares of the outline's length in [0, 1]; NaN = not known, or nothing there.
struct Arrangement {
  /// Height of its lower edge over the highest level plane beneath its middle: 2 to 3 cm of keyboards, about 0 of what stands on
  /// something. Beneath a level plane counts what is as large and at least 3 mm lower. Not known over the floor alone, which heights tell.
  double lift = std::numeric_limits<double>::quiet_NaN();
  /// From its upper edge up to the lowest level plane above its middle. Below 0 where that plane meets it before its upper edge.
  double headroom = std::numeric_limits<double>::quiet_NaN();
  /// Of what is steeper than 60 degrees: how far it stands before the nearest parallel plane of 1.5 times its area, up to 1.5 m; to
  /// −5 cm where it lies behind that one, as panes do. Not known where the sensor's side is not.
  double standoff = std::numeric_limits<double>::quiet_NaN();
  /// How far its middle is before the nearest plane through a wall, be it beside that wall or before it: of those parallel to it
  /// (`wall_offset`), and of those at right angles (`corner_offset`; all walls, for what is level). Walls are upright planes of more
  /// than 2 m². Below 0 behind a wall; where the wall's side is not known, the distance without a sign.
  double wall_offset = std::numeric_limits<double>::quiet_NaN(), corner_offset = std::numeric_limits<double>::quiet_NaN();
  /// Shares of the outline along which a surface at 53 degrees or more to it comes forward (as the wall at the edge of a floor: concave)
  /// or goes back (as the front of a cabinet at the edge of its top: convex); after Stein et al. 2014, whose patches join where convex. Not known of what
  /// is not level where the sensor's side is not.
  double edge_concave = std::numeric_limits<double>::quiet_NaN(), edge_convex = std::numeric_limits<double>::quiet_NaN();
};

/// One for each plane of a scene. `upright` turns the scan's frame into the upright one. All NaN without an outline of three corners.
[[nodiscard]] std::vector<Arrangement> arrangements(std::span<const Plane* const> planes, const Eigen::Quaterniond& upright);

}  // namespace scenelore::perception
