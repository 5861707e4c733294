#include "region.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace scenelore::rules {

namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double ring_area(const std::vector<Vector2d>& ring) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return std::abs(twice) / 2;
}

/// A line p + s·d (d of length 1) and on which side of it each corner lies, how far: most edges are soon seen to have nothing to do with it.
class Line {
 public:
  Line(const Region& region, const Vector2d& p, const Vector2d& d) : region_(region), p_(p), d_(d) {
    std::size_t corners = 0;
    for (const std::vector<Vector2d>& ring : region.rings) corners += ring.size();
    sides_.reserve(corners);
    for (const std::vector<Vector2d>& ring : region.rings) {
      for (const Vector2d& corner : ring) sides_.push_back(cross(d, corner - p));
    }
  }

  [[nodiscard]] double along(const Vector2d& point) const { return d_.dot(point - p_); }
  /// With the edge's ends and their sides.
  template <typename Visit>
  void for_each_edge(Visit visit) const {
    const double* sides = sides_.data();
    for (const std::vector<Vector2d>& ring : region_.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t next = i + 1 == ring.size() ? 0 : i + 1;
        visit(ring[i], ring[next], sides[i], sides[next]);
      }
      sides += ring.size();
    }
  }

 private:
  const Region& region_;
  Vector2d p_, d_;
  std::vector<double> sides_;  // by ring and corner
};

/// Where the line runs inside the region, by the even-odd rule.
Intervals inside_on(const Line& line) {
  std::vector<double> crossings;
  line.for_each_edge([&](const Vector2d& from, const Vector2d& to, double side_from, double side_to) {
    if ((side_from > 0) == (side_to > 0)) return;
    const double along_from = line.along(from), along_to = line.along(to);
    crossings.push_back(along_from + (along_to - along_from) * side_from / (side_from - side_to));
  });
  std::sort(crossings.begin(), crossings.end());
  Intervals out;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) out.emplace_back(crossings[i], crossings[i + 1]);
  return out;
}

/// The part of the line p + s·d that lies within `reach` of an edge: the edge's stadium is convex, hence one interval,
/// the hull of those of its strip and its two discs.
std::optional<std::pair<double, double>> near_edge(const Vector2d& p, const Vector2d& d, const Vector2d& from,
                                                   const Vector2d& to, double reach) {
  double low = INFINITY, high = -INFINITY;
  for (const Vector2d& end : {from, to}) {
    const double away = cross(d, end - p), along = d.dot(end - p);
    if (std::abs(away) > reach) continue;
    const double half = std::sqrt(reach * reach - away * away);
    low = std::min(low, along - half);
    high = std::max(high, along + half);
  }
  const double length = (to - from).norm();
  if (length > 0) {
    // Strip: |cross(u, p + s·d − from)| ≤ reach and 0 ≤ u·(p + s·d − from) ≤ length.
    const Vector2d u = (to - from) / length;
    double strip_low = -INFINITY, strip_high = INFINITY;
    const auto clip = [&](double at_zero, double slope, double least, double most) {
      if (slope == 0) {
        if (at_zero < least || at_zero > most) strip_high = -INFINITY;
        return;
      }
      const double s = (least - at_zero) / slope, t = (most - at_zero) / slope;
      strip_low = std::max(strip_low, std::min(s, t));
      strip_high = std::min(strip_high, std::max(s, t));
    };
    clip(cross(u, p - from), cross(u, d), -reach, reach);
    clip(u.dot(p - from), u.dot(d), 0, length);
    if (strip_low <= strip_high) {
      low = std::min(low, strip_low);
      high = std::max(high, strip_high);
    }
  }
  if (low > high) return std::nullopt;
  return std::pair{low, high};
}

/// Where the line runs inside the region or within `reach` of it, as far as that adds to `whole`.
Intervals within_on_line(const Region& region, const Vector2d& p, const Vector2d& d, double reach, const Intervals& whole) {
  const Line line(region, p, d);
  Intervals out = inside_on(line);
  if (reach <= 0) return out;
  Lack lack(whole, out);
  const auto add_near = [&](const Vector2d& from, const Vector2d& to, double side_from, double side_to) {
    if (std::min(side_from, side_to) > reach || std::max(side_from, side_to) < -reach || lack.none()) return;
    const double along_from = line.along(from), along_to = line.along(to);
    if (!lack.concerns(std::min(along_from, along_to) - reach, std::max(along_from, along_to) + reach)) return;
    if (const auto interval = near_edge(p, d, from, to, reach)) {
      out.push_back(*interval);
      lack.fill(*interval);
    }
  };
  if (!lack.none()) line.for_each_edge(add_near);
  merge(out);
  return out;
}

struct Edge {
  Vector2d low, high;  ///< low.y < high.y
  bool of_a;
  [[nodiscard]] double x_at(double y) const {
    return low.x() + (high.x() - low.x()) * (y - low.y()) / (high.y() - low.y());
  }
};

void collect_edges(const Region& region, bool of_a, double y_low, double y_high, std::vector<Edge>& edges) {
  for_each_edge(region, [&](const Vector2d& from, const Vector2d& to) {
    if (from.y() == to.y()) return;
    const bool up = from.y() < to.y();
    const Edge edge{up ? from : to, up ? to : from, of_a};
    if (edge.high.y() > y_low && edge.low.y() < y_high) edges.push_back(edge);
  });
}

/// Height at which two edges cross, if they do.
std::optional<double> crossing_height(const Edge& e, const Edge& f) {
  const Vector2d d = e.high - e.low, g = f.high - f.low;
  const double denominator = cross(d, g);
  if (denominator == 0) return std::nullopt;
  const double s = cross(f.low - e.low, g) / denominator, t = cross(f.low - e.low, d) / denominator;
  if (s <= 0 || s >= 1 || t <= 0 || t >= 1) return std::nullopt;
  return e.low.y() + s * d.y();
}

}  // namespace

void merge(Intervals& intervals) {
  std::sort(intervals.begin(), intervals.end());
  std::size_t kept = 0;
  for (const auto& [low, high] : intervals) {
    if (high <= low) continue;
    if (kept > 0 && low <= intervals[kept - 1].second) {
      intervals[kept - 1].second = std::max(intervals[kept - 1].second, high);
    } else {
      intervals[kept++] = {low, high};
    }
  }
  intervals.resize(kept);
}

double shared_length(std::span<const std::pair<double, double>> a, std::span<const std::pair<double, double>> b) {
  double length = 0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    length += std::max(0.0, std::min(a[i].second, b[j].second) - std::max(a[i].first, b[j].first));
    a[i].second < b[j].second ? ++i : ++j;
  }
  return length;
}

Lack::Lack(std::span<const std::pair<double, double>> of, std::span<const std::pair<double, double>> in) {
  std::size_t j = 0;
  const auto add = [&](double from, double to) {
    from_ = std::min(from_, from);
    to_ = to;
  };
  for (const auto& [from, to] : of) {
    double at = from;
    for (; j < in.size() && in[j].second <= at; ++j) {}
    for (std::size_t k = j; k < in.size() && in[k].first < to; ++k) {
      if (in[k].first > at) add(at, in[k].first);
      at = std::max(at, in[k].second);
    }
    if (at < to) add(at, to);
  }
}

void Region::add_ring(std::vector<Eigen::Vector2d> ring) {
  for (const Vector2d& corner : ring) box.extend(corner);
  rings.push_back(std::move(ring));
}

double Region::area() const {
  double area = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) area += i == 0 ? ring_area(rings[i]) : -ring_area(rings[i]);
  return std::max(0.0, area);
}

bool Region::contains(const Eigen::Vector2d& point) const {
  if (!box.contains(point)) return false;
  bool inside = false;
  for_each_edge(*this, [&](const Vector2d& from, const Vector2d& to) { inside ^= is_left_of(point, from, to); });
  return inside;
}

/// Slab decomposition: between two neighbouring heights at which edges start, end or cross, both regions are stacks of
/// trapezoids, whose width is linear in y; the width at the middle times the slab's height is their exact area.
double shared_area(const Region& a, const Region& b) {
  if (a.box.isEmpty() || b.box.isEmpty() || !a.box.intersects(b.box)) return 0;
  const double y_low = std::max(a.box.min().y(), b.box.min().y());
  const double y_high = std::min(a.box.max().y(), b.box.max().y());
  std::vector<Edge> edges;
  collect_edges(a, true, y_low, y_high, edges);
  const std::size_t of_a = edges.size();
  collect_edges(b, false, y_low, y_high, edges);
  std::vector<double> heights{y_low, y_high};
  for (const Edge& edge : edges) {
    heights.push_back(std::clamp(edge.low.y(), y_low, y_high));
    heights.push_back(std::clamp(edge.high.y(), y_low, y_high));
  }
  for (std::size_t i = 0; i < of_a; ++i) {
    if (!meets_box(edges[i].low, edges[i].high, b.box)) continue;
    for (std::size_t j = of_a; j < edges.size(); ++j) {
      if (const auto y = crossing_height(edges[i], edges[j])) heights.push_back(std::clamp(*y, y_low, y_high));
    }
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) { return e.low.y() < f.low.y(); });

  double area = 0;
  std::vector<const Edge*> active;
  std::size_t next = 0;
  std::vector<std::pair<double, bool>> cuts;
  for (std::size_t h = 0; h + 1 < heights.size(); ++h) {
    const double y = (heights[h] + heights[h + 1]) / 2;
    for (; next < edges.size() && edges[next].low.y() < y; ++next) active.push_back(&edges[next]);
    std::erase_if(active, [&](const Edge* edge) { return edge->high.y() <= y; });
    cuts.clear();
    for (const Edge* edge : active) cuts.emplace_back(edge->x_at(y), edge->of_a);
    std::sort(cuts.begin(), cuts.end());
    bool in_a = false, in_b = false;
    double width = 0;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      if (in_a && in_b) width += cuts[i].first - cuts[i - 1].first;
      (cuts[i].second ? in_a : in_b) ^= true;
    }
    area += width * (heights[h + 1] - heights[h]);
  }
  return area;
}

double share_within(const Segment2& a, const Region& b, double reach) {
  if (b.box.isEmpty()) return 0;
  const Box2 grown(b.box.min().array() - std::max(reach, 0.0), b.box.max().array() + std::max(reach, 0.0));
  if (!grown.intersects(Box2(a.from.cwiseMin(a.to), a.from.cwiseMax(a.to)))) return 0;
  const double length = a.length();
  if (length <= 0) {
    if (b.contains(a.from)) return 1;
    const Intervals near = within_on_line(b, a.from, Vector2d::UnitX(), std::max(reach, 0.0), {{-1, 1}});
    for (const auto& [low, high] : near) {
      if (low <= 0 && high >= 0) return 1;
    }
    return 0;
  }
  const Vector2d direction = (a.to - a.from) / length;
  const Intervals whole{{0.0, length}};
  const Intervals near = within_on_line(b, a.from, direction, std::max(reach, 0.0), whole);
  return std::clamp(shared_length(whole, near) / length, 0.0, 1.0);
}

}  // namespace scenelore::rules
