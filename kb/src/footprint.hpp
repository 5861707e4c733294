// Footprints of planes for the floor plan.
#pragma once

#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::kb {

/// Thickness at which a steep plane is drawn, metres; a projection thinner than this becomes a strip of this width.
inline constexpr double kStripThickness = 0.05;

/// The hull seen from above in the upright frame, turned about the scan's origin (z of the result is 0). Outer ring
/// counter-clockwise, holes clockwise. Walls and other steep planes: a rectangle along their horizontal extent.
/// A degenerate plane gives a polygon without corners.
[[nodiscard]] perception::Polygon footprint(const Scan& scan, const perception::Plane& plane);

}  // namespace scenelore::kb
