// CGAL's own alpha shape, which computes all alphas, as oracle for the one triangulation of alpha_hull.
#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include "planar_scenes.hpp"
#include "scenelore/perception/hull.hpp"

namespace scenelore::perception {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Structure = CGAL::Triangulation_data_structure_2<CGAL::Alpha_shape_vertex_base_2<Kernel>, CGAL::Alpha_shape_face_base_2<Kernel>>;
using AlphaShape = CGAL::Alpha_shape_2<CGAL::Delaunay_triangulation_2<Kernel, Structure>>;

double oracle_area(const std::vector<Eigen::Vector2d>& points, double radius) {
  std::vector<Kernel::Point_2> sites;
  for (const Eigen::Vector2d& p : points) sites.emplace_back(p.x(), p.y());
  const AlphaShape shape(sites.begin(), sites.end(), radius * radius, AlphaShape::GENERAL);
  double area = 0;
  for (auto f = shape.finite_faces_begin(); f != shape.finite_faces_end(); ++f) {
    if (shape.classify(f) == AlphaShape::INTERIOR) area += std::abs(shape.triangle(f).area());
  }
  return area;
}

TEST(AlphaHullOracle, HasTheAreaOfCgalsAlphaShapeWhereThatIsOnePart) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    testing::Random random(seed);
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 1500; ++i) {
      const Eigen::Vector2d p(random.uniform(0, 2), random.uniform(0, 1));
      if ((p - Eigen::Vector2d(1, 0.5)).norm() > 0.25) points.push_back(p);
    }
    const double radius = 0.1;
    const Outline outline = alpha_hull(points, radius);
    ASSERT_EQ(outline.radius, radius);
    ASSERT_EQ(outline.covered, 1) << "a part of its own: choose other points";
    EXPECT_NEAR(outline.area, oracle_area(points, radius), 1e-9) << "seed " << seed;
    EXPECT_EQ(outline.holes.size(), 1U);
  }
}

}  // namespace
}  // namespace scenelore::perception
