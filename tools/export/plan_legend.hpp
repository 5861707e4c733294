// The list of classes beside a floor plan.
#pragma once

#include <string>
#include <vector>

#include "export/plan_shapes.hpp"

namespace scenelore::exports {

/// A line a class: colour, name, number of planes, those that are not drawn included.
struct Legend {
  Legend(const FloorPlan& plan, const std::vector<Shape>& shapes);

  [[nodiscard]] double height() const;  ///< pixels
  [[nodiscard]] std::string draw(double left, double top, double width) const;

 private:
  struct Entry {
    std::string name, color;
    std::size_t count = 0;
    const Shape* example = nullptr;  ///< nothing for a class that is not drawn
  };
  std::vector<Entry> entries_;  ///< floor and walls, then the classes by name, then what is unknown or not drawn
};

}  // namespace scenelore::exports
