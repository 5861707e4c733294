// The catalogue's built-in features, from the stored planes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "scenelore/kb/knowledge_base.hpp"
#include "scenelore/perception/arrangement.hpp"

namespace scenelore::kb {

namespace {

// Middle of the box around all planes, in the upright frame; the mean of centroids would move with what is visible.
Eigen::Vector3d centre_of(const Scan& scan, const std::vector<StoredPlane>& planes) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  const auto add = [&](const Eigen::Vector3d& point) {
    const Eigen::Vector3d upright = scan.rotation * point;
    low = low.cwiseMin(upright);
    high = high.cwiseMax(upright);
  };
  for (const StoredPlane& stored : planes) {
    add(stored.plane.centroid);
    for (const Eigen::Vector3d& corner : stored.plane.hull.outer) add(corner);
  }
  return (low + high) / 2;
}

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Planes of older files have no such value, which is stored as 0.
double known(double length) { return length > 0 ? length : kUnknown; }
double share(double value) { return value >= 0 ? value : kUnknown; }

}  // namespace

double stray_deg(const std::vector<StoredPlane>& planes) {
  constexpr double kLeastArea = 0.25, kMeantLevel = 15, kShare = 0.8, kNormalQuantile = 1.2816;  // of |x| at 80 %
  constexpr double kBuilt = 0.3;  // DIN 18202, table 2: 8 mm out of true on 1 to 3 m
  constexpr std::size_t kFew = 4;
  std::vector<std::pair<double, double>> off;  // degrees, weight
  double sum = 0;
  for (const StoredPlane& stored : planes) {
    const double tilt = stored.plane.tilt_deg, degrees = std::min(tilt, 90 - tilt);
    if (stored.plane.area_m2 < kLeastArea || degrees > kMeantLevel) continue;
    off.emplace_back(degrees, std::sqrt(stored.plane.area_m2));
    sum += off.back().second;
  }
  if (off.size() < kFew) return kBuilt;
  std::sort(off.begin(), off.end());
  double below = 0;
  for (const auto& [degrees, weight] : off)
    if ((below += weight) >= kShare * sum) return std::max(kBuilt, degrees / kNormalQuantile);
  return kBuilt;
}

FeatureTable built_in_features(const Scan& scan, const std::vector<StoredPlane>& planes) {
  FeatureTable table;
  table.names = {"area_m2", "length", "width", "rectangularity", "tilt_deg",      "height",    "x",
                 "y",       "z_min",  "z_max", "rmse",           "point_density", "facing_up", "seen_share",
                 "spread_length", "spread_width", "behind", "edge_free", "edge_free_top", "edge_joined", "edge_unseen",
                 "lift", "headroom", "standoff", "wall_offset", "corner_offset", "edge_concave", "edge_convex"};
  const Eigen::Vector3d centre = centre_of(scan, planes);
  std::vector<const perception::Plane*> all;
  for (const StoredPlane& stored : planes) all.push_back(&stored.plane);
  const std::vector<perception::Arrangement> arranged = perception::arrangements(all, scan.rotation);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const perception::Plane& p = planes[i].plane;
    const perception::Arrangement& a = arranged[i];
    const Eigen::Vector3d at = scan.rotation * p.centroid - centre;
    table.values.push_back({p.area_m2, p.length, p.width, p.rectangularity, p.tilt_deg, p.height, at.x(), at.y(),
                            p.z_min, p.z_max, p.rmse, p.point_density, p.facing_up, p.seen_share,
                            known(p.spread_length), known(p.spread_width), share(p.behind), share(p.edge_free), share(p.edge_free_top),
                            share(p.edge_joined), share(p.edge_unseen),
                            a.lift, a.headroom, a.standoff, a.wall_offset, a.corner_offset, a.edge_concave, a.edge_convex});
  }
  table.errors["tilt_deg"].assign(planes.size(), stray_deg(planes));
  return table;
}

}  // namespace scenelore::kb
