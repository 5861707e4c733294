// What a floor plan shows of its items, and where on the page.
#pragma once

#include <string>
#include <vector>

#include "export/floor_plan.hpp"
#include "export/footprint.hpp"

namespace scenelore::exports {

// Pixels.
inline constexpr double kPageMargin = 36, kTitleHeight = 64;

// Metres.
inline constexpr double kBorder = 0.45;   // around everything, so that names find room outside the walls
inline constexpr double kOverhead = 1.9;  // flat things above this are drawn as dashed outlines, as architects do

enum class Kind { floor, wall, strip, flat, overhead };

struct Shape {
  const FloorPlanItem* item = nullptr;
  Footprint print;  ///< metres
  Kind kind = Kind::flat;
};

/// What is drawn, in the order of drawing: background, walls, then from the bottom up; ties by number.
[[nodiscard]] std::vector<Shape> shapes_of(const FloorPlan& plan);

/// A class name as people write it.
[[nodiscard]] std::string spoken(std::string name);

/// From metres, y up, to pixels, y down.
struct Page {
  Eigen::Vector2d low{-1, -1}, high{1, 1};  ///< metres shown
  double scale = 100;                       ///< pixels a metre
  double left = kPageMargin + 26, top = kTitleHeight + kPageMargin - 8;

  [[nodiscard]] Eigen::Vector2d to(const Eigen::Vector2d& p) const {
    return {left + (p.x() - low.x()) * scale, top + (high.y() - p.y()) * scale};
  }
  [[nodiscard]] double width() const { return (high.x() - low.x()) * scale; }
  [[nodiscard]] double height() const { return (high.y() - low.y()) * scale; }
  [[nodiscard]] double right() const { return left + width(); }
  [[nodiscard]] double bottom() const { return top + height(); }
};

[[nodiscard]] Page page_for(const std::vector<Shape>& shapes);

/// The same footprint in pixels.
[[nodiscard]] Footprint on_page(const Footprint& print, const Page& page);

/// 1, 2 or 5 times a power of ten, in metres: the smallest such step of at least so many pixels.
[[nodiscard]] double round_step(double pixels, const Page& page);

}  // namespace scenelore::exports
