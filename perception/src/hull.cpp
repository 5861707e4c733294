// The only source that sees CGAL.
#include "scenelore/perception/hull.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "rings.hpp"

namespace scenelore::perception {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Face = Delaunay::Face_handle;

double squared_circumradius(const Face& face) {
  const auto &a = face->vertex(0)->point(), &b = face->vertex(1)->point(), &c = face->vertex(2)->point();
  const double abx = b.x() - a.x(), aby = b.y() - a.y(), acx = c.x() - a.x(), acy = c.y() - a.y();
  const double cross = abx * acy - aby * acx;
  if (cross == 0) return std::numeric_limits<double>::infinity();
  const double ab = abx * abx + aby * aby, ac = acx * acx + acy * acy;
  const double bc = (c.x() - b.x()) * (c.x() - b.x()) + (c.y() - b.y()) * (c.y() - b.y());
  return ab * ac * bc / (4 * cross * cross);
}

double area_of(const Face& face) {
  const auto &a = face->vertex(0)->point(), &b = face->vertex(1)->point(), &c = face->vertex(2)->point();
  return 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
}

/// A finite face, with all that is asked about it for each radius that is tried.
struct Triangle {
  std::array<int, 3> vertex, neighbour;  ///< neighbours across from the vertices; −1 = an infinite face
  double squared_radius = 0, area = 0;
};

/// In the order of the triangulation's faces; vertices by their `info`.
std::vector<Triangle> triangles_of(Delaunay& triangulation) {
  for (auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f) f->info() = -1;
  int next = 0;
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) f->info() = next++;
  std::vector<Triangle> triangles;
  triangles.reserve(static_cast<std::size_t>(next));
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    triangles.push_back({{f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()},
                         {f->neighbor(0)->info(), f->neighbor(1)->info(), f->neighbor(2)->info()},
                         squared_circumradius(f),
                         area_of(f)});
  }
  return triangles;
}

constexpr int kOutside = -2, kUnseen = -1;  // instead of the number of a part: 0, 1, …

struct Part {
  int number = -1;
  double area = 0;
};

/// The part of each triangle, where parts are connected by edges; the part with the largest area is returned.
Part mark_parts(const std::vector<Triangle>& triangles, double radius, std::vector<int>& part_of) {
  part_of.resize(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) part_of[t] = triangles[t].squared_radius <= radius * radius ? kUnseen : kOutside;
  Part best;
  int number = 0;
  std::vector<int> open;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (part_of[t] != kUnseen) continue;
    Part part{number++, 0};
    open.assign(1, static_cast<int>(t));
    part_of[t] = part.number;
    while (!open.empty()) {
      const Triangle& triangle = triangles[static_cast<std::size_t>(open.back())];
      open.pop_back();
      part.area += triangle.area;
      for (const int n : triangle.neighbour) {
        if (n < 0 || part_of[static_cast<std::size_t>(n)] != kUnseen) continue;
        part_of[static_cast<std::size_t>(n)] = part.number;
        open.push_back(n);
      }
    }
    if (part.area > best.area) best = part;
  }
  return best;
}

/// Share of the vertices, by weight, on a triangle of the part.
double covered(const std::vector<Triangle>& triangles, const std::vector<int>& part_of, int part, const std::vector<double>& weight) {
  std::vector<std::uint8_t> held(weight.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (part_of[t] != part) continue;
    for (const int v : triangles[t].vertex) held[static_cast<std::size_t>(v)] = 1;
  }
  double inside = 0, all = 0;
  for (std::size_t v = 0; v < held.size(); ++v) {
    all += weight[v];
    if (held[v] != 0) inside += weight[v];
  }
  return inside / all;
}

/// Edges of the part's triangles towards anything else, the part on their left.
std::vector<std::pair<int, int>> border(const std::vector<Triangle>& triangles, const std::vector<int>& part_of, int part) {
  std::vector<std::pair<int, int>> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (part_of[t] != part) continue;
    const Triangle& triangle = triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const int n = triangle.neighbour[i];
      if (n < 0 || part_of[static_cast<std::size_t>(n)] != part) edges.emplace_back(triangle.vertex[(i + 1) % 3], triangle.vertex[(i + 2) % 3]);
    }
  }
  return edges;
}

struct Site {
  double x = 0, y = 0, weight = 0;

  bool operator<(const Site& o) const { return x != o.x ? x < o.x : y != o.y ? y < o.y : weight < o.weight; }
};

}  // namespace

Outline alpha_hull(std::span<const Eigen::Vector2d> points, double radius, std::span<const double> weights) {
  std::vector<Site> weighted;
  weighted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].allFinite()) weighted.push_back({points[i].x(), points[i].y(), weights.empty() ? 1.0 : weights[i]});
  }
  // Sorted: the triangulation of points on a circle depends on their order otherwise.
  std::sort(weighted.begin(), weighted.end());
  std::vector<std::pair<Kernel::Point_2, int>> sites;  // with their numbers
  std::vector<double> weight_of_site;
  sites.reserve(weighted.size());
  for (const Site& site : weighted) {
    if (!sites.empty() && sites.back().first.x() == site.x && sites.back().first.y() == site.y) {
      if (!weights.empty()) weight_of_site.back() += site.weight;
    } else {
      sites.emplace_back(Kernel::Point_2(site.x, site.y), static_cast<int>(sites.size()));
      weight_of_site.push_back(site.weight);
    }
  }
  Outline outline;
  Delaunay triangulation;
  triangulation.insert(sites.begin(), sites.end());
  if (triangulation.dimension() < 2) return outline;
  std::vector<Eigen::Vector2d> corner(triangulation.number_of_vertices());
  std::vector<double> weight(corner.size());
  int next = 0;
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v) {
    corner[static_cast<std::size_t>(next)] = {v->point().x(), v->point().y()};
    weight[static_cast<std::size_t>(next)] = weight_of_site[static_cast<std::size_t>(v->info())];
    v->info() = next++;
  }
  const std::vector<Triangle> triangles = triangles_of(triangulation);
  std::vector<int> part_of;
  Part part;
  for (int raised = 0; raised <= 6; ++raised, radius *= 1.4) {
    part = mark_parts(triangles, radius, part_of);
    outline.radius = radius;
    if (part.number < 0) continue;
    outline.covered = covered(triangles, part_of, part.number, weight);
    if (outline.covered >= 0.95) break;
  }
  if (part.number < 0) return outline;
  outline.area = part.area;
  for (const std::vector<int>& loop : simple_loops(border(triangles, part_of, part.number))) {
    Ring2 ring;
    for (const int v : loop) ring.push_back(corner[static_cast<std::size_t>(v)]);
    if (signed_area(ring) > 0) {
      // Edge-connected faces have one outer boundary; touching loops inside it run clockwise.
      outline.outer = std::move(ring);
    } else {
      outline.holes.push_back(std::move(ring));
    }
  }
  return outline;
}

}  // namespace scenelore::perception
