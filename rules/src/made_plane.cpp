#include "scenelore/rules/made_plane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenelore::rules {

perception::Plane make_plane(const MadePlane& made) {
  const Eigen::Vector3d normal = made.normal.normalized();
  Eigen::Vector3d along = made.along - normal * normal.dot(made.along);
  if (along.norm() < 1e-9) along = Eigen::Vector3d::UnitZ().cross(normal);
  if (along.norm() < 1e-9) along = Eigen::Vector3d::UnitX();
  along.normalize();
  const Eigen::Vector3d across = normal.cross(along);

  perception::Plane plane;
  plane.centroid = made.center;
  plane.normal = normal;
  Eigen::Matrix3d axes;
  axes << across, -along, normal;  // local y = larger extent, right-handed
  if (made.width > made.length) axes << along, across, normal;
  plane.orientation = Eigen::Quaterniond(axes);
  const Eigen::Vector3d l = along * (made.length / 2), w = across * (made.width / 2);
  plane.hull.outer = {made.center - l - w, made.center + l - w, made.center + l + w, made.center - l + w};
  plane.area_m2 = made.length * made.width;
  plane.length = std::max(made.length, made.width);
  plane.width = std::min(made.length, made.width);
  plane.rectangularity = 1;
  plane.tilt_deg = std::acos(std::clamp(std::abs(normal.z()), 0.0, 1.0)) * 180 / std::numbers::pi;
  plane.height = made.center.z();
  const auto by_z = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.z() < b.z(); };
  const auto [low, high] = std::minmax_element(plane.hull.outer.begin(), plane.hull.outer.end(), by_z);
  plane.z_min = low->z();
  plane.z_max = high->z();
  plane.facing_up = normal.z();
  plane.spread_length = plane.length;
  plane.spread_width = plane.width;
  plane.rmse = made.rmse;
  plane.seen_share = 1;
  plane.point_density = 1000;
  plane.point_count = static_cast<std::size_t>(std::lround(1000 * plane.area_m2));
  return plane;
}

Scene make_scene(const std::vector<MadePlane>& planes) {
  Scene scene;
  for (const MadePlane& made : planes) {
    scene.ids.push_back(static_cast<kb::PlaneId>(scene.ids.size()) + 1);
    scene.planes.push_back(make_plane(made));
  }
  return scene;
}

}  // namespace scenelore::rules
