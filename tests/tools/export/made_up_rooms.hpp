// Floor plans of rooms that nobody scanned, as test input.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "export/floor_plan.hpp"

namespace scenelore::exports {

/// Adds planes in room coordinates; the whole room may be turned about the vertical.
class RoomMaker {
 public:
  explicit RoomMaker(double turned_deg = 0)
      : rotation_(Eigen::AngleAxisd(turned_deg * 3.14159265358979323846 / 180, Eigen::Vector3d::UnitZ())) {}

  /// A horizontal rectangle by centre and size, turned about its centre.
  RoomMaker& flat(const std::string& name, const std::string& color, double x, double y, double w, double d, double z,
                  double probability = 0.9, double turned_deg = 0) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(turned_deg * 3.14159265358979323846 / 180, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    perception::Polygon hull;
    for (const auto& [u, v] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
      hull.outer.push_back(rotation_ * (Eigen::Vector3d(x, y, z) + turn * Eigen::Vector3d(u * w, v * d, 0)));
    }
    return add(name, color, hull, 0, z, probability);
  }

  /// A vertical rectangle over the line from a to b, seen from the left of that line.
  RoomMaker& steep(const std::string& name, const std::string& color, double ax, double ay, double bx, double by,
                   double z0, double z1, double probability = 0.9) {
    perception::Polygon hull;
    for (const auto& [x, y, z] : {std::tuple{bx, by, z0}, {ax, ay, z0}, {ax, ay, z1}, {bx, by, z1}}) {
      hull.outer.push_back(rotation_ * Eigen::Vector3d(x, y, z));
    }
    return add(name, color, hull, 90, (z0 + z1) / 2, probability);
  }

  RoomMaker& add(const std::string& name, const std::string& color, perception::Polygon hull, double tilt,
                 double height, double probability) {
    plan.items.push_back({.hull = std::move(hull),
                          .class_name = name,
                          .color = color,
                          .probability = probability,
                          .id = static_cast<std::int64_t>(plan.items.size()) + 1,
                          .tilt_deg = tilt,
                          .height = height});
    return *this;
  }

  FloorPlan plan;

 private:
  Eigen::Quaterniond rotation_;
};

/// A furnished office of 7.2 m by 4.8 m.
inline FloorPlan office(double turned_deg = 0) {
  RoomMaker room(turned_deg);
  room.plan.title = "Office";
  room.flat("floor", "#c8b48c", 3.6, 2.4, 7.2, 4.8, 0, 0.99).flat("ceiling", "#eceff1", 3.6, 2.4, 7.2, 4.8, 2.6, 0.98);
  room.steep("wall", "#90a4ae", 0, 0, 7.2, 0, 0, 2.6).steep("wall", "#90a4ae", 7.2, 0, 7.2, 4.8, 0, 2.6);
  room.steep("wall", "#90a4ae", 7.2, 4.8, 0, 4.8, 0, 2.6).steep("wall", "#90a4ae", 0, 4.8, 0, 0, 0, 2.6, 0.8);
  room.steep("door", "#a1662f", 6.0, 0.02, 5.1, 0.02, 0, 2.0)
      .steep("window", "#4fc3f7", 1.2, 4.78, 3.0, 4.78, 0.9, 2.2);
  room.steep("window", "#4fc3f7", 4.0, 4.78, 5.8, 4.78, 0.9, 2.2)
      .steep("whiteboard", "#b2dfdb", 7.18, 3.4, 7.18, 1.6, 1.0, 2.0, 0.7);
  for (const double x : {1.6, 3.2}) {
    room.flat("table", "#ffb74d", x, 3.9, 1.6, 0.8, 0.73)
        .steep("flat_screen", "#5c6bc0", x - 0.3, 4.1, x + 0.3, 4.1, 0.85, 1.25);
    room.flat("keyboard", "#ba68c8", x, 3.72, 0.45, 0.16, 0.76, 0.6)
        .flat("chair_seat", "#81c784", x - 0.05, 3.1, 0.48, 0.46, 0.47);
    room.steep("chair_back", "#388e3c", x - 0.25, 2.85, x + 0.2, 2.85, 0.55, 1.0);
  }
  room.flat("table", "#ffb74d", 5.3, 2.6, 1.8, 0.9, 0.74, 0.95, 24)
      .flat("chair_seat", "#81c784", 4.9, 1.8, 0.46, 0.46, 0.46, 0.7, 15);
  room.flat("chair_seat", "#81c784", 5.7, 3.5, 0.46, 0.46, 0.46, 0.8, 40)
      .flat("unknown", "#9e9e9e", 5.2, 2.6, 0.3, 0.22, 0.78, 0.5, 24);
  room.flat("cabinet", "#8d6e63", 0.25, 1.0, 0.45, 1.6, 1.2).steep("cabinet", "#8d6e63", 0.48, 0.2, 0.48, 1.8, 0, 1.2);
  for (const double z : {0.4, 0.8, 1.2, 1.6, 2.0}) room.flat("shelf", "#bcaaa4", 3.1, 0.18, 1.8, 0.3, z, 0.85);
  room.flat("unknown", "#9e9e9e", 3.4, 2.2, 1.2, 0.3, 2.3, 0.4);
  return room.plan;
}

}  // namespace scenelore::exports
