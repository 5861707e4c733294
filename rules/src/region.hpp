// Flat geometry: polygons with holes in the plane, exact areas and lengths of what two of them share.
#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace scenelore::rules {

using Box2 = Eigen::AlignedBox2d;
using Intervals = std::vector<std::pair<double, double>>;  ///< disjoint, rising

/// Where a value matters to the one who asks: what lies outside is told as the limit next to it, which is often plain at once.
struct Limits {
  double low = 0, high = std::numeric_limits<double>::infinity();
  [[nodiscard]] double operator()(double value) const { return std::clamp(value, low, high); }
};

/// Sorts intervals in any order and joins those that overlap or touch; empty ones go.
void merge(Intervals& intervals);
/// Length that lies in both.
[[nodiscard]] double shared_length(std::span<const std::pair<double, double>> a, std::span<const std::pair<double, double>> b);

/// Smallest interval around what some disjoint, rising intervals have and others lack, narrowed down as more of it is made up for.
class Lack {
 public:
  Lack(std::span<const std::pair<double, double>> of, std::span<const std::pair<double, double>> in);

  [[nodiscard]] bool none() const { return !(from_ < to_); }
  /// Whether something between the two bounds could make up for a part, with room for the rounding of positions in metres.
  [[nodiscard]] bool concerns(double low, double high) const { return high >= from_ - 1e-9 && low <= to_ + 1e-9; }
  void fill(const std::pair<double, double>& interval) {
    if (interval.first <= from_) from_ = std::max(from_, interval.second);
    if (interval.second >= to_) to_ = std::min(to_, interval.first);
  }

 private:
  double from_ = std::numeric_limits<double>::infinity(), to_ = -from_;
};

/// Rings of corners, outer boundary and holes alike: a point is inside when it is inside an odd number of them.
/// A ring of one or two corners is a point or a line, which has a boundary but no inside.
struct Region {
  std::vector<std::vector<Eigen::Vector2d>> rings;
  Box2 box;

  void add_ring(std::vector<Eigen::Vector2d> ring);
  [[nodiscard]] double area() const;  ///< first ring less the others
  [[nodiscard]] bool contains(const Eigen::Vector2d& point) const;
};

template <typename Visit>
void for_each_edge(const Region& region, Visit visit) {
  for (const std::vector<Eigen::Vector2d>& ring : region.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]);
  }
}

/// Whether the ray from the point along x crosses the edge: it does so with an odd number of a region's edges where the point is inside.
[[nodiscard]] inline bool is_left_of(const Eigen::Vector2d& point, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  if ((from.y() > point.y()) == (to.y() > point.y())) return false;
  return point.x() < from.x() + (to.x() - from.x()) * (point.y() - from.y()) / (to.y() - from.y());
}

/// Whether the box around an edge meets the given one.
[[nodiscard]] inline bool meets_box(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Box2& box) {
  return std::max(from.x(), to.x()) >= box.min().x() && std::min(from.x(), to.x()) <= box.max().x() &&
         std::max(from.y(), to.y()) >= box.min().y() && std::min(from.y(), to.y()) <= box.max().y();
}

/// A straight line piece; length 0 is a point.
struct Segment2 {
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
  [[nodiscard]] double length() const { return (to - from).norm(); }
};

/// Area that is inside both regions; exact but for rounding.
[[nodiscard]] double shared_area(const Region& a, const Region& b);

/// Share of `a`'s area that is inside `b` or within `reach` metres of it, in [0, 1]. Exact for reach 0; with a reach the
/// area is integrated over 32 lines or more across `a`, each of them exact (Gauss–Legendre, two a slab). For regions that are asked about again, see ScannedRegion.
[[nodiscard]] double share_within(const Region& a, const Region& b, double reach);

/// Share of a segment that is inside `b` or within `reach` of it, in [0, 1]; exact. A point gives 0 or 1.
[[nodiscard]] double share_within(const Segment2& a, const Region& b, double reach);

}  // namespace scenelore::rules
