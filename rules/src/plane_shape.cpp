#include "plane_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace scenelore::rules {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d any_across(const Vector3d& normal) {
  const Vector3d level = Vector3d::UnitZ().cross(normal);  // horizontal, along the plane
  return level.norm() > 1e-9 ? level.normalized() : Vector3d::UnitX();
}

std::vector<Vector2d> seen_from_above(const perception::Ring& ring) {
  std::vector<Vector2d> out;
  out.reserve(ring.size());
  for (const Vector3d& corner : ring) out.emplace_back(corner.x(), corner.y());
  return out;
}

/// The extent of a steep outline along the plan direction of its plane, through its centroid.
Segment2 plan_line(const perception::Ring& outer, const Vector3d& centroid, const Vector3d& along) {
  double low = 0, high = 0;
  for (const Vector3d& corner : outer) {
    const double s = along.dot(corner - centroid);
    low = std::min(low, s);
    high = std::max(high, s);
  }
  const Vector2d middle = centroid.head<2>(), direction = along.head<2>();
  return {middle + low * direction, middle + high * direction};
}

// What gaps between outlines spend most of their time in, so no call should come on top.
[[gnu::always_inline]] inline double squared_distance(const Box3& a, const Box3& b) {
  return (a.min() - b.max()).cwiseMax(b.min() - a.max()).cwiseMax(0.0).squaredNorm();
}

double squared_to_segment(const Vector3d& p, const Vector3d& from, const Vector3d& to) {
  const Vector3d d = to - from;
  const double length = d.squaredNorm();
  const double t = length > 0 ? std::clamp(d.dot(p - from) / length, 0.0, 1.0) : 0.0;
  return (p - from - t * d).squaredNorm();
}

/// Least squared distance of two edges but for their second ends, which are the first ends of other edges: inside both where the common
/// perpendicular falls there, else at one of the ends.
double squared_distance(const Edge3& e, const Edge3& f) {
  const Vector3d d = e.to - e.from, g = f.to - f.from, r = f.from - e.from;
  const double dd = d.squaredNorm(), gg = g.squaredNorm(), dg = d.dot(g);
  const double determinant = dd * gg - dg * dg;
  if (determinant > 1e-12 * dd * gg) {
    const double s = (r.dot(d) * gg - r.dot(g) * dg) / determinant;
    const double t = (r.dot(d) * dg - r.dot(g) * dd) / determinant;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return (r + t * g - s * d).squaredNorm();
  }
  return std::min(squared_to_segment(e.from, f.from, f.to), squared_to_segment(f.from, e.from, e.to));
}

double least_between_corners(const PlaneShape& a, const EdgeBlock& p, const PlaneShape& b, const EdgeBlock& q) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = p.begin; i < p.end; ++i) {
    for (std::size_t j = q.begin; j < q.end; ++j) best = std::min(best, (a.edges[i].from - b.edges[j].from).squaredNorm());
  }
  return best;
}

/// Least squared distance from the edges of `a` to the inside of `b`, if below `best`.
double edges_to_inside(const PlaneShape& a, const PlaneShape& b, double best) {
  for (const EdgeBlock& block : a.blocks) {
    if (squared_distance(block.box, b.box) >= best) continue;
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const Edge3& edge = a.edges[i];
      const double from = b.signed_distance(edge.from), to = b.signed_distance(edge.to);
      const bool crosses = (from > 0) != (to > 0), near = from * from < best;
      if ((!crosses && !near) || squared_distance(edge.box, b.box) >= best) continue;
      if (crosses && b.covers(edge.from + (edge.to - edge.from) * (from / (from - to)))) return 0;
      // The edge's end is some other edge's start: one end of each is enough.
      if (near && b.covers(edge.from)) best = from * from;
    }
  }
  return best;
}

}  // namespace

PlaneShape::PlaneShape(const perception::Plane& plane) : centroid(plane.centroid), normal(plane.normal.normalized()) {
  u = any_across(normal);
  v = normal.cross(u);
  Region flattened;
  const auto add = [&](const perception::Ring& ring) {
    std::vector<Vector2d> flat;
    flat.reserve(ring.size());
    edges.reserve(edges.size() + ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector3d& next = ring[i + 1 == ring.size() ? 0 : i + 1];
      edges.push_back({ring[i], next, Box3(ring[i].cwiseMin(next), ring[i].cwiseMax(next))});
      box.extend(ring[i]);
      flat.emplace_back(u.dot(ring[i] - centroid), v.dot(ring[i] - centroid));
    }
    if (!flat.empty()) flattened.add_ring(std::move(flat));
  };
  if (plane.hull.outer.empty()) {
    add({centroid});
  } else {
    add(plane.hull.outer);
    for (const perception::Ring& hole : plane.hull.holes) add(hole);
  }
  std::vector<Box3> boxes;
  blocks.reserve((edges.size() + EdgeBlock::kMost - 1) / EdgeBlock::kMost);
  boxes.reserve(blocks.capacity());
  for (std::size_t i = 0; i < edges.size(); i += EdgeBlock::kMost) {
    EdgeBlock block{i, std::min(i + EdgeBlock::kMost, edges.size()), {}};
    for (std::size_t k = i; k < block.end; ++k) block.box.extend(edges[k].box);
    blocks.push_back(block);
    boxes.push_back(block.box);
  }
  block_boxes = BoxRow(boxes);
  in_plane = EdgesByHeight(flattened);
  const bool flat_outline = plane.hull.outer.size() >= 3;
  steep = !flat_outline || std::abs(normal.z()) <= std::cos(kSteepDegrees * std::numbers::pi / 180);
  Region on_plan;
  if (steep) {
    line = plan_line(plane.hull.outer, centroid, u);
    on_plan.add_ring({line.from, line.to});
  } else {
    on_plan.add_ring(seen_from_above(plane.hull.outer));
    for (const perception::Ring& hole : plane.hull.holes) on_plan.add_ring(seen_from_above(hole));
  }
  footprint = ScannedRegion(std::move(on_plan));
}

Box3 box_of(const perception::Plane& plane) {
  Box3 box;
  if (plane.hull.outer.empty()) return box.extend(plane.centroid);
  for (const Vector3d& corner : plane.hull.outer) box.extend(corner);
  for (const perception::Ring& hole : plane.hull.holes) {
    for (const Vector3d& corner : hole) box.extend(corner);
  }
  return box;
}

bool PlaneShape::covers(const Eigen::Vector3d& point) const {
  return in_plane.contains({u.dot(point - centroid), v.dot(point - centroid)});
}

double hull_gap(const PlaneShape& a, const PlaneShape& b, const Limits& limits) {
  // As squares, with room for rounding: what is found to lie outside is surely told as the limit.
  const double enough = limits.low * limits.low * (1 - 1e-12), most = limits.high * limits.high * (1 + 1e-12);
  if (squared_distance(a.box, b.box) >= most) return limits.high;
  struct BlockPair {
    double apart;
    const EdgeBlock *p, *q;
  };
  double best = most;
  std::vector<BlockPair> pairs;
  pairs.reserve(a.blocks.size() * b.blocks.size());
  std::vector<double> distances(a.blocks.size() + b.blocks.size());
  double *const from_b = distances.data(), *const apart = from_b + a.blocks.size();
  a.block_boxes.put_squared_distances(b.box, from_b);
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    if (from_b[i] >= best) continue;
    b.block_boxes.put_squared_distances(a.blocks[i].box, apart);
    for (std::size_t j = 0; j < b.blocks.size(); ++j) {
      if (apart[j] < best) pairs.push_back({apart[j], &a.blocks[i], &b.blocks[j]});
    }
  }
  const auto nearer = [](const BlockPair& x, const BlockPair& y) { return x.apart < y.apart; };
  const auto look = [&](const BlockPair& pair) {
    std::array<const Edge3*, EdgeBlock::kMost> room;
    std::size_t count = 0;
    for (std::size_t j = pair.q->begin; j < pair.q->end; ++j) {
      if (squared_distance(b.edges[j].box, pair.p->box) < best) room[count++] = &b.edges[j];
    }
    const std::span near(room.data(), count);
    for (std::size_t i = pair.p->begin; i < pair.p->end; ++i) {
      const Edge3& e = a.edges[i];
      if (squared_distance(e.box, pair.q->box) >= best) continue;
      for (const Edge3* f : near) {
        if (squared_distance(e.box, f->box) < best) best = std::min(best, squared_distance(e, *f));
      }
    }
  };
  // After the nearest two blocks hardly any others are left, so that it does not pay to sort them all; and after their corners, hardly
  // any of their edges.
  if (!pairs.empty()) {
    const auto nearest = std::min_element(pairs.begin(), pairs.end(), nearer);
    best = std::min(best, least_between_corners(a, *nearest->p, b, *nearest->q) * (1 + 1e-9));
    if (best > enough) look(*nearest);
    nearest->apart = std::numeric_limits<double>::infinity();
    std::erase_if(pairs, [&](const BlockPair& pair) { return pair.apart >= best; });
    std::sort(pairs.begin(), pairs.end(), nearer);
    for (const BlockPair& pair : pairs) {
      if (pair.apart >= best || best <= enough) break;
      look(pair);
    }
  }
  if (best > enough) best = edges_to_inside(a, b, best);
  if (best > enough) best = edges_to_inside(b, a, best);
  return std::min(limits.high, std::sqrt(best));
}

double footprint_share(const PlaneShape& a, const PlaneShape& b, double reach, const Limits& limits) {
  return limits(a.steep ? share_within(a.line, b.footprint, reach) : share_within(a.footprint, b.footprint, reach, limits));
}

}  // namespace scenelore::rules
