#include "scenelore/perception/hull.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "planar_scenes.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;
using Points = std::vector<Eigen::Vector2d>;

Points grid(double x0, double y0, double x1, double y1, double step) {
  Points points;
  for (double x = x0; x <= x1 + step / 4; x += step) {
    for (double y = y0; y <= y1 + step / 4; y += step) points.emplace_back(x, y);
  }
  return points;
}

double enclosed(const Outline& outline) {
  double area = signed_area(outline.outer);
  for (const Ring2& hole : outline.holes) area += signed_area(hole);
  return area;
}

bool crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  const auto side = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

void expect_valid(const Outline& outline) {
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> edges;
  std::vector<Ring2> rings = outline.holes;
  rings.push_back(outline.outer);
  for (const Ring2& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
      for (std::size_t j = 0; j < i; ++j) EXPECT_NE(ring[i], ring[j]) << "a ring touches itself";
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      ASSERT_FALSE(crossing(edges[i].first, edges[i].second, edges[j].first, edges[j].second)) << "edges cross";
    }
  }
  EXPECT_GT(signed_area(outline.outer), 0);
  for (const Ring2& hole : outline.holes) EXPECT_LT(signed_area(hole), 0);
  EXPECT_NEAR(enclosed(outline), outline.area, 1e-9 * outline.area);
}

TEST(AlphaHull, IsExactForARectangleOfGridPoints) {
  const Outline outline = alpha_hull(grid(0, 0, 1.2, 0.6, 0.02), 0.05);
  EXPECT_NEAR(outline.area, 0.72, 1e-9);
  EXPECT_TRUE(outline.holes.empty());
  EXPECT_EQ(outline.covered, 1);
  expect_valid(outline);
}

TEST(AlphaHull, FollowsAnLShape) {
  Points points = grid(0, 0, 2, 0.5, 0.02);
  const Points leg = grid(0, 0.52, 0.5, 1.5, 0.02);
  points.insert(points.end(), leg.begin(), leg.end());
  const Outline outline = alpha_hull(points, 0.05);
  EXPECT_NEAR(outline.area, 1.5, 0.005);
  expect_valid(outline);
}

TEST(AlphaHull, KeepsTheHoleOfARing) {
  Points points;
  for (const Eigen::Vector2d& p : grid(-1, -1, 1, 1, 0.02)) {
    if (p.norm() <= 1 && p.norm() >= 0.5) points.push_back(p);
  }
  const Outline outline = alpha_hull(points, 0.06);
  EXPECT_NEAR(outline.area, std::numbers::pi * 0.75, 0.035 * std::numbers::pi * 0.75) << "grid points lie up to a step inside";
  ASSERT_EQ(outline.holes.size(), 1U);
  EXPECT_NEAR(-signed_area(outline.holes[0]), std::numbers::pi * 0.25, 0.04);
  expect_valid(outline);
}

TEST(AlphaHull, KeepsTheLargestOfPartsFarApartAndSaysSo) {
  Points points = grid(0, 0, 1, 1, 0.02);
  const Points other = grid(5, 0, 5.5, 0.5, 0.02);
  points.insert(points.end(), other.begin(), other.end());
  const Outline outline = alpha_hull(points, 0.05);
  EXPECT_NEAR(outline.area, 1, 1e-9);
  EXPECT_NEAR(outline.covered, 2601.0 / (2601 + 676), 1e-9);
}

TEST(AlphaHull, RaisesTheRadiusForSparsePoints) {
  const Outline outline = alpha_hull(grid(0, 0, 2, 2, 0.2), 0.05);
  EXPECT_NEAR(outline.area, 4, 1e-9);
  EXPECT_GT(outline.radius, 0.14);
}

TEST(AlphaHull, IsValidForRandomPointsOfAnyDensity) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    Points points;
    for (int i = 0; i < 400; ++i) points.emplace_back(random.uniform(0, 2), random.uniform(0, 1));
    const Outline outline = alpha_hull(points, random.uniform(0.03, 0.2));
    ASSERT_FALSE(outline.outer.empty());
    SCOPED_TRACE(seed);
    expect_valid(outline);
  }
}

TEST(AlphaHull, DoesNotDependOnTheOrderOrOnCopies) {
  Random random(4);
  Points points;
  for (int i = 0; i < 500; ++i) points.emplace_back(random.uniform(), random.uniform());
  Points reversed(points.rbegin(), points.rend());
  reversed.insert(reversed.end(), points.begin(), points.end());
  const Outline a = alpha_hull(points, 0.1), b = alpha_hull(reversed, 0.1);
  EXPECT_EQ(a.outer, b.outer);
  EXPECT_EQ(a.area, b.area);
}

TEST(AlphaHull, IsEmptyForPointsWithoutArea) {
  EXPECT_TRUE(alpha_hull(Points{}, 0.1).outer.empty());
  EXPECT_TRUE(alpha_hull(Points{{1, 2}}, 0.1).outer.empty());
  EXPECT_TRUE(alpha_hull(Points(50, Eigen::Vector2d(1, 2)), 0.1).outer.empty());
  EXPECT_TRUE(alpha_hull(grid(0, 0, 1, 0, 0.02), 0.1).outer.empty());
  EXPECT_EQ(alpha_hull(Points{{0, 0}, {std::nan(""), 1}, {1, 1}}, 0.1).area, 0);
  EXPECT_NEAR(alpha_hull(Points{{0, 0}, {0.1, 0}, {0, 0.1}}, 0.1).area, 0.005, 1e-12);
}

TEST(Thinned, KeepsOnePointAnInnerCellAndTheOutermostOfTheRim) {
  Random random(2);
  Points points;
  for (int i = 0; i < 20000; ++i) points.emplace_back(random.uniform(), random.uniform());
  const Points kept = thinned(points, 0.05);
  EXPECT_LE(kept.size(), 324U + 76U * 8U);
  EXPECT_GE(kept.size(), 400U);
  EXPECT_EQ(kept, thinned(Points(points.rbegin(), points.rend()), 0.05));
  EXPECT_NEAR(alpha_hull(thinned(points, 0.02), 0.1).area, alpha_hull(points, 0.1).area, 0.005);
}

TEST(MinimumRectangle, FindsTheSidesOfATurnedRectangle) {
  for (double angle = 0; angle < 3.2; angle += 0.37) {
    const Eigen::Rotation2Dd turn(angle);
    Points points;
    for (const Eigen::Vector2d& p : grid(0, 0, 1.6, 0.8, 0.1)) points.push_back(turn * p + Eigen::Vector2d(1000, -2000));
    const Rectangle r = minimum_rectangle(points);
    EXPECT_NEAR(r.length, 1.6, 1e-4);
    EXPECT_NEAR(r.width, 0.8, 1e-4);
    EXPECT_NEAR(std::abs(r.along.dot(turn * Eigen::Vector2d::UnitX())), 1, 1e-6);
  }
}

TEST(MinimumRectangle, TakesPointsOnALineAndSinglePoints) {
  const Rectangle line = minimum_rectangle(grid(0, 0, 2, 0, 0.1));
  EXPECT_NEAR(line.length, 2, 1e-5);
  EXPECT_NEAR(line.width, 0, 1e-5);
  EXPECT_EQ(minimum_rectangle(Points{{3, 4}}).length, 0);
}

TEST(Rectangularity, IsOneForRectanglesAndKnownForOtherShapes) {
  const auto of = [](const Points& points, double radius) {
    const Outline outline = alpha_hull(points, radius);
    return rectangularity(outline, minimum_rectangle(outline.outer));
  };
  EXPECT_NEAR(of(grid(0, 0, 1.3, 0.4, 0.02), 0.05), 1, 0.002);
  Points disc, triangle;
  for (const Eigen::Vector2d& p : grid(-1, -1, 1, 1, 0.01)) {
    if (p.norm() <= 1) disc.push_back(p);
    if (p.x() + p.y() <= 1e-9) triangle.push_back(p);
  }
  EXPECT_NEAR(of(disc, 0.05), std::numbers::pi / 4, 0.01);
  EXPECT_NEAR(of(triangle, 0.05), 0.5, 0.01);
  Points ring = grid(0, 0, 3, 3, 0.03);
  std::erase_if(ring, [](const Eigen::Vector2d& p) { return p.x() > 1.001 && p.x() < 1.999 && p.y() > 1.001 && p.y() < 1.999; });
  EXPECT_NEAR(of(ring, 0.05), 8.0 / 9, 0.005) << "the hole does not count";
}

TEST(Rectangularity, CountsPixelCentresWithoutBias) {
  // Half a rectangle has exactly half of the pixels, whatever its size.
  Outline half;
  half.outer = {{0, 0}, {0.5, 0}, {0.5, 1}, {0, 1}};
  const Rectangle whole{.center = {0.5, 0.5}, .along = {1, 0}, .length = 1, .width = 1};
  EXPECT_DOUBLE_EQ(rectangularity(half, whole), 0.5);
  EXPECT_EQ(rectangularity(Outline(), whole), 0);
}

}  // namespace
}  // namespace scenelore::perception
