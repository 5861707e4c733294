// Where the names go: near what they name, none over another, and off the small things where there is room.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "export/footprint.hpp"

namespace scenelore::exports {

/// A thing that wants its name on the page. All lengths in pixels, y down.
struct LabelWish {
  std::string text;
  Footprint shape;
  double thickness = 0;      ///< of a strip as drawn
  bool keep_inside = false;  ///< no place beside the shape will do
};

struct PlacedLabel {
  OrientedBox box;
  bool beside = false;  ///< not on what it names: deserves a line to it
};

/// Something better not written over, except by its own name, and by the names of what lies on it.
struct Obstacle {
  OrientedBox box;
  std::size_t wish = 0;  ///< index of its own wish
  bool small = false;    ///< a name would hide it: avoided with more effort
};

struct LabelArea {
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();  ///< of the page
};

/// One entry a wish: where its text goes, nothing where there is no room. Earlier wishes choose first; `obstacles` are
/// avoided where possible, other labels always.
[[nodiscard]] std::vector<std::optional<PlacedLabel>> place_labels(const std::vector<LabelWish>& wishes,
                                                                   double font_size,
                                                                   const std::vector<Obstacle>& obstacles,
                                                                   const LabelArea& area);

}  // namespace scenelore::exports
