// The only source that sees CGAL.
#include "scenelore/perception/hull.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "rings.hpp"

namespace scenelore::perception {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Face = Delaunay::Face_handle;

constexpr int kOutside = -2, kUnseen = -1;  // face info; parts are 0, 1, …

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

struct Part {
  int number = -1;
  double area = 0;
};

/// Marks the faces of each edge-connected part; the part with the largest area.
Part mark_parts(Delaunay& triangulation, double radius) {
  for (auto f = triangulation.all_faces_begin(); f != triangulation.all_faces_end(); ++f) f->info() = kOutside;
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    if (squared_circumradius(f) <= radius * radius) f->info() = kUnseen;
  }
  Part best;
  int number = 0;
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    if (f->info() != kUnseen) continue;
    Part part{number++, 0};
    std::vector<Face> open{f};
    f->info() = part.number;
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      part.area += area_of(face);
      for (int i = 0; i < 3; ++i) {
        const Face next = face->neighbor(i);
        if (next->info() != kUnseen) continue;
        next->info() = part.number;
        open.push_back(next);
      }
    }
    if (part.area > best.area) best = part;
  }
  return best;
}

/// Share of the vertices, by weight, on a face of the part.
double covered(const Delaunay& triangulation, int part, const std::vector<double>& weight) {
  std::vector<bool> held(triangulation.number_of_vertices(), false);
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    if (f->info() != part) continue;
    for (int i = 0; i < 3; ++i) held[static_cast<std::size_t>(f->vertex(i)->info())] = true;
  }
  double inside = 0, all = 0;
  for (std::size_t v = 0; v < held.size(); ++v) {
    all += weight[v];
    if (held[v]) inside += weight[v];
  }
  return inside / all;
}

/// Edges of the part's faces towards anything else, the part on their left.
std::vector<std::pair<int, int>> border(const Delaunay& triangulation, int part) {
  std::vector<std::pair<int, int>> edges;
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
    if (f->info() != part) continue;
    for (int i = 0; i < 3; ++i) {
      if (f->neighbor(i)->info() != part) edges.emplace_back(f->vertex((i + 1) % 3)->info(), f->vertex((i + 2) % 3)->info());
    }
  }
  return edges;
}

}  // namespace

Outline alpha_hull(std::span<const Eigen::Vector2d> points, double radius, std::span<const double> weights) {
  std::vector<std::pair<Kernel::Point_2, double>> weighted;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].allFinite()) weighted.emplace_back(Kernel::Point_2(points[i].x(), points[i].y()), weights.empty() ? 1.0 : weights[i]);
  }
  // Sorted: the triangulation of points on a circle depends on their order otherwise.
  std::sort(weighted.begin(), weighted.end());
  std::vector<Kernel::Point_2> sites;
  std::vector<double> weight_of_site;
  for (const auto& [site, weight] : weighted) {
    if (!sites.empty() && sites.back() == site) {
      if (!weights.empty()) weight_of_site.back() += weight;
    } else {
      sites.push_back(site);
      weight_of_site.push_back(weight);
    }
  }
  Outline outline;
  Delaunay triangulation(sites.begin(), sites.end());
  if (triangulation.dimension() < 2) return outline;
  std::vector<Eigen::Vector2d> corner(triangulation.number_of_vertices());
  std::vector<double> weight(corner.size());
  int next = 0;
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v) {
    v->info() = next;
    corner[static_cast<std::size_t>(next)] = {v->point().x(), v->point().y()};
    weight[static_cast<std::size_t>(next++)] = weight_of_site[static_cast<std::size_t>(std::lower_bound(sites.begin(), sites.end(), v->point()) - sites.begin())];
  }
  Part part;
  for (int raised = 0; raised <= 6; ++raised, radius *= 1.4) {
    part = mark_parts(triangulation, radius);
    outline.radius = radius;
    if (part.number < 0) continue;
    outline.covered = covered(triangulation, part.number, weight);
    if (outline.covered >= 0.95) break;
  }
  if (part.number < 0) return outline;
  outline.area = part.area;
  for (const std::vector<int>& loop : simple_loops(border(triangulation, part.number))) {
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
