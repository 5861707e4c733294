#include "scenelore/rules/scene.hpp"

#include <utility>

namespace scenelore::rules {

namespace {

perception::Ring upright(const perception::Ring& ring, const Eigen::Isometry3d& to_upright) {
  perception::Ring out;
  out.reserve(ring.size());
  for (const Eigen::Vector3d& corner : ring) out.push_back(to_upright * corner);
  return out;
}

}  // namespace

Scene make_scene(const kb::Scan& scan, const std::vector<kb::StoredPlane>& planes, kb::FeatureTable features) {
  Eigen::Isometry3d to_upright = Eigen::Isometry3d::Identity();
  to_upright.linear() = scan.rotation.toRotationMatrix();
  to_upright.translation().z() = -scan.floor_z;

  Scene scene;
  scene.features = std::move(features);
  for (const kb::StoredPlane& stored : planes) {
    perception::Plane plane = stored.plane;
    plane.centroid = to_upright * plane.centroid;
    plane.normal = scan.rotation * plane.normal;
    plane.orientation = scan.rotation * plane.orientation;
    plane.hull.outer = upright(plane.hull.outer, to_upright);
    for (perception::Ring& hole : plane.hull.holes) hole = upright(hole, to_upright);
    scene.ids.push_back(stored.id);
    scene.planes.push_back(std::move(plane));
  }
  return scene;
}

}  // namespace scenelore::rules
