#include "footprint.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace scenelore::kb {

namespace {

// Twice the signed area in xy (shoelace formula), relative to the first corner to keep precision at large coordinates.
double signed_area(const perception::Ring& ring) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Eigen::Vector3d a = ring[i] - ring[0], b = ring[i + 1] - ring[0];
    sum += a.x() * b.y() - b.x() * a.y();
  }
  return sum;
}

perception::Ring flat(const Scan& scan, const perception::Ring& ring, bool counter_clockwise) {
  perception::Ring result;
  for (const Eigen::Vector3d& corner : ring) {
    result.push_back(scan.origin + scan.rotation * (corner - scan.origin));
    result.back().z() = 0;
  }
  if ((signed_area(result) > 0) != counter_clockwise) std::reverse(result.begin(), result.end());
  return result;
}

std::pair<double, double> extent(const perception::Ring& ring, const Eigen::Vector3d& origin, const Eigen::Vector3d& axis) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::Vector3d& corner : ring) {
    const double at = (corner - origin).dot(axis);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  return {low, high};
}

}  // namespace

perception::Polygon footprint(const Scan& scan, const perception::Plane& plane) {
  if (plane.hull.outer.size() < 3) return {};
  perception::Polygon result;
  result.outer = flat(scan, plane.hull.outer, true);
  // Along the slope the projection of a plane shrinks with the cosine of its tilt; across it nothing shrinks.
  Eigen::Vector3d slope = scan.rotation * plane.normal;
  slope.z() = 0;
  const double steepness = slope.norm();
  if (steepness > 1e-6) {
    slope /= steepness;
    const Eigen::Vector3d along(-slope.y(), slope.x(), 0);
    const Eigen::Vector3d origin = result.outer.front();
    const auto [near, far] = extent(result.outer, origin, slope);
    if (far - near < kStripThickness) {
      const auto [left, right] = extent(result.outer, origin, along);
      const double middle = (near + far) / 2;
      const Eigen::Vector3d half = slope * (kStripThickness / 2);
      const Eigen::Vector3d a = origin + along * left + slope * middle, b = origin + along * right + slope * middle;
      result.outer = {a + half, a - half, b - half, b + half};
      if (signed_area(result.outer) < 0) std::reverse(result.outer.begin(), result.outer.end());
      return result;
    }
  }
  for (const perception::Ring& hole : plane.hull.holes) result.holes.push_back(flat(scan, hole, false));
  return result;
}

}  // namespace scenelore::kb
