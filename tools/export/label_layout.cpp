#include "export/label_layout.hpp"

#include <algorithm>
#include <cmath>

#include "export/svg.hpp"

namespace scenelore::exports {
namespace {

constexpr double kGap = 3;  // pixels between a shape and the text beside it

OrientedBox text_box(const std::string& text, double font_size) {
  OrientedBox box;
  box.half = {text_width_em(text) * font_size / 2 + 2, font_size * 0.62};
  return box;
}

/// Half of the box's extent in a direction.
double reach(const OrientedBox& box, const Eigen::Vector2d& direction) {
  const Eigen::Vector2d across(-box.axis.y(), box.axis.x());
  return box.half.x() * std::abs(box.axis.dot(direction)) + box.half.y() * std::abs(across.dot(direction));
}

bool inside_shape(const OrientedBox& box, const Footprint& shape) {
  for (int i = 0; i < 4; ++i) {
    if (!contains(shape.rings, box.corner(i)) || !contains(shape.rings, (box.corner(i) + box.corner((i + 1) % 4)) / 2))
      return false;
  }
  return contains(shape.rings, box.center);
}

/// Places within a flat shape, the middle first.
void add_inner_places(const LabelWish& wish, const OrientedBox& text, std::vector<PlacedLabel>& places) {
  constexpr int kSteps = 12;
  const OrientedBox& around = wish.shape.box;
  const Eigen::Vector2d extent(reach(around, Eigen::Vector2d::UnitX()), reach(around, Eigen::Vector2d::UnitY()));
  std::vector<PlacedLabel> found;
  for (int row = -kSteps; row <= kSteps; ++row) {
    for (int column = -kSteps; column <= kSteps; ++column) {
      OrientedBox box = text;
      box.center = around.center + Eigen::Vector2d(column * extent.x() / kSteps, row * extent.y() / kSteps);
      if (inside_shape(box, wish.shape)) found.push_back({box, false});
    }
  }
  // Up and down counts double: names in the middle of a shape's height look centred.
  std::stable_sort(found.begin(), found.end(), [&](const PlacedLabel& a, const PlacedLabel& b) {
    const auto cost = [&](const PlacedLabel& p) {
      return (p.box.center - around.center).cwiseProduct(Eigen::Vector2d(1, 2)).squaredNorm();
    };
    return cost(a) < cost(b) - 1e-6;
  });
  places.insert(places.end(), found.begin(), found.end());
}

/// Places around any shape: touching it first, then farther off, where they need a line to it.
void add_outer_places(const OrientedBox& around, const OrientedBox& text, std::vector<PlacedLabel>& places) {
  constexpr int kDirections = 16;
  // Below, above, right, left, then what is between.
  constexpr int kOrder[kDirections] = {4, 12, 0, 8, 3, 5, 11, 13, 2, 6, 10, 14, 1, 7, 9, 15};
  for (const double extra : {0.0, 10.0, 24.0}) {
    for (const int index : kOrder) {
      const double angle = index * 2 * 3.14159265358979323846 / kDirections;
      const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
      OrientedBox box = text;
      box.center = around.center;
      while (overlap(box, around)) box.center += 2 * direction;
      box.center += (kGap + extra) * direction;
      places.push_back({box, extra > 0});
    }
  }
}

/// Places along a strip, turned with it so that the text reads from left to right; behind it first.
void add_strip_places(const LabelWish& wish, const OrientedBox& text, std::vector<PlacedLabel>& places) {
  const OrientedBox& strip = wish.shape.box;
  if (text.half.x() > strip.half.x() * 1.1) return;
  const Eigen::Vector2d axis = strip.axis.x() < -1e-9 || (std::abs(strip.axis.x()) <= 1e-9 && strip.axis.y() > 0)
                                   ? Eigen::Vector2d(-strip.axis)
                                   : strip.axis;
  const double beside = wish.thickness / 2 + text.half.y() + kGap;
  for (const double side : {1.0, -1.0}) {
    for (const double along : {0.0, -0.3, 0.3, -0.6, 0.6}) {
      OrientedBox box = text;
      box.axis = axis;
      const double room = std::max(0.0, strip.half.x() - text.half.x());
      box.center = strip.center + along * room * axis + side * beside * wish.shape.behind;
      places.push_back({box, false});
    }
  }
}

std::vector<PlacedLabel> places_for(const LabelWish& wish, double font_size) {
  const OrientedBox text = text_box(wish.text, font_size);
  std::vector<PlacedLabel> places;
  if (wish.shape.strip)
    add_strip_places(wish, text, places);
  else
    add_inner_places(wish, text, places);
  if (wish.keep_inside) return places;
  OrientedBox around = wish.shape.box;
  if (wish.shape.strip) around.half.y() = wish.thickness / 2;
  add_outer_places(around, text, places);
  return places;
}

bool holds(const OrientedBox& box, const Eigen::Vector2d& point) {
  const Eigen::Vector2d d = point - box.center, across(-box.axis.y(), box.axis.x());
  return std::abs(d.dot(box.axis)) <= box.half.x() && std::abs(d.dot(across)) <= box.half.y();
}

bool within(const OrientedBox& box, const LabelArea& area) {
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector2d corner = box.corner(i);
    if ((corner.array() < area.low.array()).any() || (corner.array() > area.high.array()).any()) return false;
  }
  return true;
}

}  // namespace

std::vector<std::optional<PlacedLabel>> place_labels(const std::vector<LabelWish>& wishes, double font_size,
                                                     const std::vector<Obstacle>& obstacles, const LabelArea& area) {
  std::vector<std::optional<PlacedLabel>> placed(wishes.size());
  std::vector<OrientedBox> taken;
  for (std::size_t i = 0; i < wishes.size(); ++i) {
    const std::vector<PlacedLabel> places = places_for(wishes[i], font_size);
    const auto over_label = [&](const OrientedBox& box) {
      return std::any_of(taken.begin(), taken.end(), [&](const OrientedBox& other) { return overlap(box, other); });
    };
    // In vain avoided: a thing on which the named one lies.
    const auto over_obstacle = [&](const OrientedBox& box, bool small_only) {
      return std::any_of(obstacles.begin(), obstacles.end(), [&](const Obstacle& o) {
        return o.wish != i && (o.small || !small_only) && overlap(box, o.box) &&
               (o.small || !holds(o.box, wishes[i].shape.box.center));
      });
    };
    for (const int effort : {2, 1, 0}) {
      for (const PlacedLabel& place : places) {
        if (placed[i] || !within(place.box, area) || over_label(place.box)) continue;
        if (effort == 0 && place.beside) continue;  // far off and on top of something else: better none
        if (effort > 0 && over_obstacle(place.box, effort == 1)) continue;
        placed[i] = place;
      }
    }
    if (placed[i]) taken.push_back(placed[i]->box);
  }
  return placed;
}

}  // namespace scenelore::exports
