#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "scenelore/perception/hull.hpp"

namespace scenelore::perception {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners of the convex hull, counter-clockwise (Andrew 1979, "Another efficient algorithm for convex hulls in two dimensions").
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  const auto before = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) { return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y()); };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Eigen::Vector2d> hull;
  const auto walk = [&](const auto& from, const auto& to) {
    const std::size_t start = hull.size();
    for (auto p = from; p != to; ++p) {
      while (hull.size() > start + 1 && cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // the first corner of the other half
  };
  walk(points.begin(), points.end());
  walk(points.rbegin(), points.rend());
  return hull;
}

/// The rectangle around the corners with a side along the unit vector u; length is along u.
Rectangle bounds_along(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& u) {
  const Eigen::Vector2d v(-u.y(), u.x());
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Eigen::Vector2d& p : corners) {
    const Eigen::Vector2d q(u.dot(p), v.dot(p));
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  const Eigen::Vector2d middle = (low + high) / 2, size = high - low;
  return {.center = middle.x() * u + middle.y() * v, .along = u, .length = size.x(), .width = size.y()};
}

}  // namespace

// One side of the smallest rectangle lies along an edge of the convex hull (Freeman and Shapira 1975, "Determining the minimum-area
// encasing rectangle for an arbitrary closed curve"), so each edge is tried; hulls have some dozen.
Rectangle minimum_rectangle(std::span<const Eigen::Vector2d> points) {
  if (points.empty()) return {};
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : points) middle += p / static_cast<double>(points.size());
  std::vector<Eigen::Vector2d> about_middle;  // far from the origin products would lose their last digits
  for (const Eigen::Vector2d& p : points) about_middle.push_back(p - middle);
  const std::vector<Eigen::Vector2d> hull = convex_hull(std::move(about_middle));
  Rectangle best{.center = hull.front()};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; hull.size() > 1 && i < hull.size(); ++i) {
    const Rectangle found = bounds_along(hull, (hull[(i + 1) % hull.size()] - hull[i]).normalized());
    if (found.length * found.width >= least) continue;
    least = found.length * found.width;
    best = found;
  }
  if (best.width > best.length) {
    std::swap(best.length, best.width);
    best.along = {-best.along.y(), best.along.x()};
  }
  best.center += middle;
  return best;
}

namespace {

constexpr int kColumns = 640, kRows = 480;  // the paper's bitmap

/// Where the middles of the rows of pixels cross the ring.
void add_crossings(const Ring2& ring, std::vector<std::vector<double>>& crossings) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
    const auto first = static_cast<int>(std::clamp(std::ceil(low - 0.5), 0.0, double(kRows)));
    for (int row = first; row < kRows; ++row) {
      const double y = row + 0.5;
      if (y >= high) break;
      crossings[static_cast<std::size_t>(row)].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
}

/// Pixels with centres at i + ½ in [from, to).
int centers_between(double from, double to) {
  const auto first = static_cast<int>(std::ceil(std::clamp(from, 0.0, double(kColumns)) - 0.5));
  const auto last = static_cast<int>(std::ceil(std::clamp(to, 0.0, double(kColumns)) - 0.5));
  return std::max(0, last - first);
}

}  // namespace

double rectangularity(const Outline& outline, const Rectangle& rectangle) {
  if (outline.outer.empty() || !(rectangle.width > 0)) return 0;
  const Eigen::Vector2d across(-rectangle.along.y(), rectangle.along.x());
  std::vector<Ring2> rings{outline.outer};
  rings.insert(rings.end(), outline.holes.begin(), outline.holes.end());
  for (Ring2& ring : rings) {
    for (Eigen::Vector2d& p : ring) {
      const Eigen::Vector2d d = p - rectangle.center;
      p = {(d.dot(rectangle.along) / rectangle.length + 0.5) * kColumns, (d.dot(across) / rectangle.width + 0.5) * kRows};
    }
  }
  std::vector<std::vector<double>> crossings(kRows);
  for (const Ring2& ring : rings) add_crossings(ring, crossings);
  int filled = 0;
  for (std::vector<double>& row : crossings) {
    std::sort(row.begin(), row.end());
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) filled += centers_between(row[i], row[i + 1]);
  }
  return static_cast<double>(filled) / (kColumns * kRows);
}

}  // namespace scenelore::perception
