#include "export/footprint.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace scenelore::exports {
namespace {

constexpr double kSteepDeg = 60;     // steeper than this, the footprint is a strip: a chair back, a wall
constexpr double kTolerance = 0.02;  // metres by which a drawn outline may differ from the hull
constexpr std::size_t kMaxCorners = 4000;

bool all_finite(const perception::Ring& ring) {
  return std::all_of(ring.begin(), ring.end(), [](const Eigen::Vector3d& p) { return p.allFinite(); });
}

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

/// Marks the corners to keep between first and last (Douglas & Peucker 1973), without recursion.
void mark_corners(const Ring2& ring, std::vector<bool>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, ring.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double worst = kTolerance;
    std::size_t at = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distance_to_segment(ring[i], ring[first], ring[last]);
      if (distance > worst) worst = distance, at = i;
    }
    if (at == 0) continue;
    keep[at] = true;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
}

/// The ring on the floor with fewer corners; empty when it has no extent.
Ring2 simplified(const perception::Ring& ring) {
  Ring2 flat;
  const std::size_t step = ring.size() / kMaxCorners + 1;
  for (std::size_t i = 0; i < ring.size(); i += step) flat.emplace_back(ring[i].x(), ring[i].y());
  flat.push_back(flat.front());  // closed, so that the last side is simplified as well
  std::vector<bool> keep(flat.size(), false);
  const auto farthest = std::max_element(flat.begin(), flat.end(), [&](const auto& a, const auto& b) {
    return (a - flat.front()).squaredNorm() < (b - flat.front()).squaredNorm();
  });
  const auto split = static_cast<std::size_t>(farthest - flat.begin());
  keep.front() = keep[split] = true;
  Ring2 first(flat.begin(), farthest + 1), second(farthest, flat.end());
  std::vector<bool> keep_first(first.size(), false), keep_second(second.size(), false);
  mark_corners(first, keep_first);
  mark_corners(second, keep_second);
  Ring2 out;
  for (std::size_t i = 0; i + 1 < flat.size(); ++i) {
    const bool kept = keep[i] || (i < split ? keep_first[i] : keep_second[i - split]);
    if (kept) out.push_back(flat[i]);
  }
  return out.size() < 3 ? Ring2{} : out;
}

double signed_area(const Ring2& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

OrientedBox box_along(const Ring2& points, const Eigen::Vector2d& axis) {
  const Eigen::Vector2d across(-axis.y(), axis.x());
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::max()), high = -low;
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d local(p.dot(axis), p.dot(across));
    low = low.cwiseMin(local), high = high.cwiseMax(local);
  }
  const Eigen::Vector2d middle = (low + high) / 2;
  OrientedBox box{middle.x() * axis + middle.y() * across, axis, (high - low) / 2};
  if (box.half.x() < box.half.y()) {
    box.axis = across;
    std::swap(box.half.x(), box.half.y());
  }
  return box;
}

/// The smallest of the boxes along one of the ring's sides, which for a convex ring is the smallest there is.
OrientedBox smallest_box(const Ring2& ring) {
  OrientedBox best = box_along(ring, Eigen::Vector2d::UnitX());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d side = ring[(i + 1) % ring.size()] - ring[i];
    if (side.norm() < kTolerance) continue;
    const OrientedBox box = box_along(ring, side.normalized());
    if (box.half.prod() < best.half.prod()) best = box;
  }
  return best;
}

/// The direction of a strip: the first axis of the hull's horizontal scatter.
Eigen::Vector2d strip_axis(const Ring2& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : points) mean += p / static_cast<double>(points.size());
  double xx = 0, xy = 0, yy = 0;
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d d = p - mean;
    xx += d.x() * d.x(), xy += d.x() * d.y(), yy += d.y() * d.y();
  }
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
  return {std::cos(angle), std::sin(angle)};
}

/// Twice the vector area; it points to the side from which the ring runs counter-clockwise (Newell).
Eigen::Vector3d vector_area(const perception::Ring& ring) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < ring.size(); ++i) sum += (ring[i] - ring[0]).cross(ring[(i + 1) % ring.size()] - ring[0]);
  return sum;
}

Footprint strip_footprint(const perception::Ring& outer) {
  Footprint out;
  out.strip = true;
  Ring2 flat;
  for (const Eigen::Vector3d& p : outer) flat.emplace_back(p.x(), p.y());
  out.box = box_along(flat, strip_axis(flat));
  out.behind = {-out.box.axis.y(), out.box.axis.x()};
  if (out.behind.dot(vector_area(outer).head<2>()) > 0) out.behind = -out.behind;
  out.area = 4 * out.box.half.prod();
  return out;
}

}  // namespace

Eigen::Vector2d OrientedBox::corner(int index) const {
  const Eigen::Vector2d across(-axis.y(), axis.x());
  return center + (index == 1 || index == 2 ? 1 : -1) * half.x() * axis + (index >= 2 ? 1 : -1) * half.y() * across;
}

bool overlap(const OrientedBox& a, const OrientedBox& b) {
  const Eigen::Vector2d gap = b.center - a.center;
  const auto reach = [](const OrientedBox& box, const Eigen::Vector2d& direction) {
    const Eigen::Vector2d across(-box.axis.y(), box.axis.x());
    return box.half.x() * std::abs(box.axis.dot(direction)) + box.half.y() * std::abs(across.dot(direction));
  };
  for (const OrientedBox* box : {&a, &b}) {
    for (const Eigen::Vector2d& direction : {box->axis, Eigen::Vector2d(-box->axis.y(), box->axis.x())}) {
      if (std::abs(gap.dot(direction)) >= reach(a, direction) + reach(b, direction)) return false;
    }
  }
  return true;
}

std::optional<Footprint> footprint(const perception::Polygon& hull, double tilt_deg) {
  if (hull.outer.size() < 3 || !all_finite(hull.outer) ||
      !std::all_of(hull.holes.begin(), hull.holes.end(), all_finite))
    return std::nullopt;
  if (tilt_deg >= kSteepDeg) return strip_footprint(hull.outer);
  Footprint out;
  out.rings.push_back(simplified(hull.outer));
  if (out.rings[0].empty()) return std::nullopt;
  out.area = std::abs(signed_area(out.rings[0]));
  for (const perception::Ring& hole : hull.holes) {
    if (hole.size() < 3) continue;
    Ring2 ring = simplified(hole);
    if (ring.empty()) continue;
    out.area -= std::abs(signed_area(ring));
    out.rings.push_back(std::move(ring));
  }
  out.box = smallest_box(out.rings[0]);
  return out;
}

bool contains(const std::vector<Ring2>& rings, const Eigen::Vector2d& point) {
  bool inside = false;
  for (const Ring2& ring : rings) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Eigen::Vector2d &a = ring[i], &b = ring[j];
      if ((a.y() > point.y()) != (b.y() > point.y()) &&
          point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x()) {
        inside = !inside;
      }
    }
  }
  return inside;
}

}  // namespace scenelore::exports
