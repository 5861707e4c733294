// Rectangles inside and around regions against points.
#include "slabs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace scenelore::rules {
namespace {

using Eigen::Vector2d;

/// A star-shaped outline with a hole, sometimes a ragged one.
Region star(std::mt19937& random, const Vector2d& center, int corners) {
  const auto uniform = [&] { return static_cast<double>(random() % 1000) / 1000; };
  Region out;
  for (const double size : {1.0, 0.2}) {
    std::vector<Vector2d> ring;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      ring.push_back(center + size * (0.6 + 0.8 * uniform()) * Vector2d(std::cos(angle), 0.5 * std::sin(angle)));
    }
    out.add_ring(ring);
  }
  return out;
}

TEST(Slabs, HoldPointsOfTheRegionInsideAndAllOfThemAround) {
  std::mt19937 random(6);
  const auto uniform = [&] { return static_cast<double>(random() % 4000) / 4000; };
  for (int round = 0; round < 30; ++round) {
    const Region region = star(random, {0.1 * round, -1}, round % 2 == 0 ? 7 : 60);
    const Slabs slabs(region);
    for (int i = 0; i < 4000; ++i) {
      const Vector2d p = region.box.min() + region.box.sizes().cwiseProduct(Vector2d(uniform(), uniform()));
      for (const Slabs::Slab& slab : slabs.all()) {
        if (p.y() < slab.low || p.y() > slab.high) continue;
        const bool inside = region.contains(p);
        EXPECT_TRUE(!inside || (p.x() >= slab.outer.first && p.x() <= slab.outer.second)) << round;
        EXPECT_TRUE(inside || p.x() <= slab.inner.first || p.x() >= slab.inner.second) << round;
      }
    }
  }
}

TEST(Slabs, CoverMostOfARectangleFromBothSides) {
  Region rectangle;
  rectangle.add_ring({{0, 0}, {3, 0}, {3, 1}, {0, 1}});
  const Slabs slabs(rectangle);
  for (const Slabs::Slab& slab : slabs.all()) {
    EXPECT_NEAR(slab.inner.first, 0, 1e-6);
    EXPECT_NEAR(slab.inner.second, 3, 1e-6);
    EXPECT_NEAR(slab.outer.first, 0, 1e-6);
    EXPECT_NEAR(slab.outer.second, 3, 1e-6);
  }
}

TEST(Slabs, AreEmptyInsideForALineAndAPoint) {
  for (const std::vector<Vector2d>& ring : {std::vector<Vector2d>{{0, 0}, {1, 1}}, {{2, 2}}}) {
    Region region;
    region.add_ring(ring);
    const Slabs slabs(region);
    for (const Slabs::Slab& slab : slabs.all()) EXPECT_GE(slab.inner.first, slab.inner.second);
    EXPECT_LE(slabs.all()[0].outer.first, ring[0].x());
  }
}

}  // namespace
}  // namespace scenelore::rules
