// A floor plan of labelled planes as a picture: what a person looks at first.
//
//   exports::FloorPlan plan{.title = "office", .items = {…}};
//   std::ofstream("office.svg") << exports::floor_plan_svg(plan);
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenelore/perception/plane.hpp"

namespace scenelore::exports {

/// One labelled plane, in the upright frame: z up, metres.
struct FloorPlanItem {
  perception::Polygon
      hull{};  ///< items without a hull of three corners or with coordinates that are not finite are left out
  std::string class_name{};  ///< "floor" becomes the background, "wall" a thick strip, "ceiling" is not drawn
  std::string color{};       ///< "#rrggbb"; anything else is drawn grey
  double probability = 1;    ///< of the label, 0..1: the less certain, the paler
  std::int64_t id = 0;       ///< the number behind the class name
  double tilt_deg = 0;       ///< of the plane, 0 = horizontal .. 90 = vertical: steep planes are drawn as strips
  double height = 0;         ///< metres above the floor: lower planes are drawn first
};

struct FloorPlan {
  std::string title;
  std::vector<FloorPlanItem> items;
};

/// A complete SVG document, UTF-8. Deterministic: the same plan gives the same bytes, numbers have fixed precision.
/// Names may hold anything; characters that XML cannot hold become '?'.
[[nodiscard]] std::string floor_plan_svg(const FloorPlan& plan);

}  // namespace scenelore::exports
