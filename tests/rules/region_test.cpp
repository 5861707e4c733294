// Shared areas and lengths against closed forms and against counting points.
#include "region.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "scanned_region.hpp"

namespace scenelore::rules {
namespace {

using Eigen::Vector2d;

Region rectangle(double x0, double y0, double x1, double y1) {
  Region out;
  out.add_ring({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
  return out;
}

/// A star-shaped outline with a hole, about a centre.
Region blob(std::mt19937& random, const Vector2d& center, bool hole, int corners_a_ring = 17) {
  const auto uniform = [&] { return static_cast<double>(random() % 1000) / 1000; };
  const auto ring = [&](double least, double most) {
    std::vector<Vector2d> corners;
    for (int i = 0; i < corners_a_ring; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners_a_ring, radius = least + (most - least) * uniform();
      corners.push_back(center + radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
    return corners;
  };
  Region out;
  out.add_ring(ring(0.6, 1.4));
  if (hole) out.add_ring(ring(0.1, 0.4));
  return out;
}

double distance_to(const Region& region, const Vector2d& p) {
  if (region.contains(p)) return 0;
  double best = INFINITY;
  for (const auto& ring : region.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector2d from = ring[i], to = ring[(i + 1) % ring.size()], d = to - from;
      const double t = d.squaredNorm() > 0 ? std::clamp(d.dot(p - from) / d.squaredNorm(), 0.0, 1.0) : 0;
      best = std::min(best, (p - from - t * d).norm());
    }
  }
  return best;
}

TEST(Region, SharesAreaAsTheClosedFormSays) {
  EXPECT_DOUBLE_EQ(shared_area(rectangle(0, 0, 2, 1), rectangle(1, 0.5, 3, 4)), 0.5);
  EXPECT_DOUBLE_EQ(shared_area(rectangle(0, 0, 2, 1), rectangle(0, 0, 2, 1)), 2);
  EXPECT_DOUBLE_EQ(shared_area(rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)), 0);
  EXPECT_DOUBLE_EQ(shared_area(rectangle(0, 0, 1, 1), rectangle(5, 5, 6, 6)), 0);
  Region frame = rectangle(0, 0, 4, 4);
  frame.add_ring({{1, 1}, {1, 3}, {3, 3}, {3, 1}});
  EXPECT_DOUBLE_EQ(frame.area(), 12);
  EXPECT_DOUBLE_EQ(shared_area(frame, rectangle(0, 0, 2, 2)), 3);
  EXPECT_DOUBLE_EQ(shared_area(frame, frame), 12);
  EXPECT_DOUBLE_EQ(share_within(rectangle(1.5, 1.5, 2.5, 2.5), frame, 0), 0) << "inside the hole";
  Region triangle;
  triangle.add_ring({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_NEAR(shared_area(triangle, rectangle(0, 0, 0.5, 1)), 0.375, 1e-15);
}

TEST(Region, SharesAreaAsCountedPointsSay) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    const Region a = blob(random, {0, 0}, round % 2 == 0), b = blob(random, {0.1 * round, 0.07 * round}, round % 3 == 0);
    int in_a = 0, in_both = 0;
    constexpr int kGrid = 400;
    for (int i = 0; i < kGrid; ++i) {
      for (int j = 0; j < kGrid; ++j) {
        const Vector2d p(-1.5 + 3.0 * (i + 0.5) / kGrid, -1.5 + 3.0 * (j + 0.5) / kGrid);
        in_a += a.contains(p);
        in_both += a.contains(p) && b.contains(p);
      }
    }
    const double cell = 9.0 / (kGrid * kGrid);
    EXPECT_NEAR(shared_area(a, b), in_both * cell, 0.01) << round;
    EXPECT_NEAR(a.area(), in_a * cell, 0.01) << round;
    EXPECT_NEAR(shared_area(a, b), shared_area(b, a), 1e-9) << round;
    EXPECT_NEAR(shared_area(a, a), a.area(), 1e-9) << round;
  }
}

TEST(Region, GrowsByTheReach) {
  // A unit square 0.1 beside another: with reach 0.35, a strip of 0.25 of it counts.
  EXPECT_NEAR(share_within(rectangle(1.1, 0, 2.1, 1), rectangle(0, 0, 1, 1), 0.35), 0.25, 1e-9);
  EXPECT_EQ(share_within(rectangle(1.1, 0, 2.1, 1), rectangle(0, 0, 1, 1), 0.05), 0);
  EXPECT_EQ(share_within(rectangle(0.2, 0.2, 0.8, 0.8), rectangle(0, 0, 1, 1), 0.35), 1);
  // Around a corner the reach is round: a quarter disc of the square beyond it.
  EXPECT_NEAR(share_within(rectangle(1, 1, 2, 2), rectangle(0, 0, 1, 1), 1), std::numbers::pi / 4, 5e-3);
}

TEST(Region, SharesAreaWithinReachAsCountedPointsSay) {
  std::mt19937 random(9);
  for (int round = 0; round < 18; ++round) {
    const int corners = round % 3 == 0 ? 5 : round % 3 == 1 ? 17 : 90;  // cut at each corner; or in even slabs
    const Region a = blob(random, {0, 0}, round % 2 == 0, corners), b = blob(random, {0.15 * round, 0.11 * round}, round % 4 < 2, corners);
    const double reach = 0.04 + 0.07 * (round % 5);
    int in_a = 0, near = 0;
    constexpr int kGrid = 150;
    for (int i = 0; i < kGrid; ++i) {
      for (int j = 0; j < kGrid; ++j) {
        const Vector2d p(-1.5 + 3.0 * (i + 0.5) / kGrid, -1.5 + 3.0 * (j + 0.5) / kGrid);
        if (!a.contains(p)) continue;
        ++in_a;
        near += distance_to(b, p) <= reach;
      }
    }
    const ScannedRegion scanned_a(a), scanned_b(b);
    const double share = share_within(scanned_a, scanned_b, reach);
    EXPECT_NEAR(share, static_cast<double>(near) / in_a, 0.012) << round;
    EXPECT_EQ(share_within(a, b, reach), share) << round;
    (void)share_within(scanned_b, scanned_a, reach);
    EXPECT_EQ(share_within(scanned_a, scanned_b, reach), share) << round;
  }
}

TEST(Region, SharesBetweenLimitsWhatItSharesWithoutThem) {
  std::mt19937 random(11);
  const auto uniform = [&] { return static_cast<double>(random() % 1000) / 1000; };
  int limited = 0;
  for (int round = 0; round < 300; ++round) {
    const int corners = round % 3 == 0 ? 5 : round % 3 == 1 ? 17 : 90;
    const ScannedRegion a(blob(random, {0, 0}, round % 2 == 0, corners));
    const ScannedRegion b(blob(random, {3 * uniform(), 2 * uniform()}, round % 4 < 2, round % 5 == 0 ? 4 : corners));
    const double reach = 0.02 + 0.4 * uniform();
    const double one = uniform(), other = uniform();
    const Limits limits{std::min(one, other), std::max(one, other)};
    const double exact = share_within(a, b, reach), told = share_within(a, b, reach, limits);
    EXPECT_EQ(limits(told), limits(exact)) << round;
    limited += exact <= limits.low || exact >= limits.high;
  }
  EXPECT_GT(limited, 100);
}

TEST(Region, SharesTheLinesOfTheClosedFormWhereB_CoversMostOfA) {
  // Slabs of a that are wholly inside b, wholly outside, and cut by b's slanted edge.
  const ScannedRegion a(rectangle(-1, 0, 1, 8));
  Region wedge;
  wedge.add_ring({{-5, -1}, {5, -1}, {5, 5}, {-5, 3}});
  const ScannedRegion b(wedge);
  EXPECT_NEAR(share_within(a, b, 1e-9), 0.5, 1e-6);
  EXPECT_NEAR(share_within(a, b, 1), (4 + std::sqrt(1 + 0.04)) / 8, 1e-3) << "parallel to the edge, one beyond it";
}

TEST(Region, SharesLengthAsManyPointsOnALineSay) {
  std::mt19937 random(5);
  for (int round = 0; round < 40; ++round) {
    const Region b = blob(random, {0, 0}, round % 2 == 0);
    const auto uniform = [&] { return static_cast<double>(random() % 4000) / 1000 - 2; };
    const Segment2 a{{uniform(), uniform()}, {uniform(), uniform()}};
    const double reach = 0.1 * (round % 4);
    int near = 0;
    constexpr int kSteps = 4000;
    for (int i = 0; i < kSteps; ++i) near += distance_to(b, a.from + (a.to - a.from) * ((i + 0.5) / kSteps)) <= reach;
    EXPECT_NEAR(share_within(a, b, reach), static_cast<double>(near) / kSteps, 2e-3) << round;
  }
}

TEST(EdgesByHeight, ContainWhatTheRegionContains) {
  std::mt19937 random(21);
  const auto uniform = [&] { return static_cast<double>(random() % 4000) / 1000 - 2; };
  for (int round = 0; round < 200; ++round) {
    const Region region = blob(random, {0, 0}, round % 2 == 0, 3 + round);
    const EdgesByHeight edges(region);
    std::vector<Vector2d> points = region.rings[0];  // heights of corners, too
    for (int i = 0; i < 100; ++i) points.emplace_back(uniform(), uniform());
    for (const Vector2d& p : points) ASSERT_EQ(edges.contains(p), region.contains(p)) << "round " << round << " at " << p.transpose();
  }
}

TEST(EdgesByHeight, EnterTheBoxesThatAnyEdgesBoxMeets) {
  std::mt19937 random(22);
  const auto uniform = [&] { return static_cast<double>(random() % 4000) / 1000 - 2; };
  for (int round = 0; round < 500; ++round) {
    const Region region = blob(random, {0, 0}, round % 2 == 0, 3 + round % 90);
    const Vector2d at(uniform(), uniform()), size = Vector2d(uniform() + 2, uniform() + 2) / (1 + round % 40);
    const Box2 box(at, at + size);
    bool any = false;
    for_each_edge(region, [&](const Vector2d& from, const Vector2d& to) { any = any || Box2(from.cwiseMin(to), from.cwiseMax(to)).intersects(box); });
    ASSERT_EQ(EdgesByHeight(region).enter(box), any) << "round " << round;
  }
}

TEST(EdgesByHeight, AreNoneOfAnEmptyRegionAndAllOfALevelLine) {
  EXPECT_FALSE(EdgesByHeight().contains({0, 0}));
  EXPECT_FALSE(EdgesByHeight(Region()).enter(Box2(Vector2d(-1, -1), Vector2d(1, 1))));
  Region line;
  line.add_ring({{0, 1}, {2, 1}});
  EXPECT_EQ(EdgesByHeight(line).at(1).size(), 2);
  EXPECT_FALSE(EdgesByHeight(line).contains({1, 1}));
  EXPECT_TRUE(EdgesByHeight(line).enter(Box2(Vector2d(1, 0), Vector2d(3, 1))));
}

TEST(ScannedRegion, SharesTheSameBitsOfSegmentsAsTheRegion) {
  std::mt19937 random(23);
  const auto uniform = [&] { return static_cast<double>(random() % 4000) / 1000 - 2; };
  for (int round = 0; round < 2000; ++round) {
    const ScannedRegion b(blob(random, {0, 0}, round % 2 == 0, 3 + round % 60));
    const Vector2d from(uniform(), uniform());
    const Segment2 a{from, round % 7 == 0 ? from : Vector2d(from + Vector2d(uniform(), uniform()) / (1 + round % 5))};
    const double reach = round % 3 == 0 ? 0 : 0.05 * (round % 4);
    ASSERT_EQ(share_within(a, b, reach), share_within(a, b.region(), reach)) << "round " << round;
  }
}

TEST(Region, HasValuesForPointsAndLines) {
  const Region square = rectangle(0, 0, 1, 1);
  EXPECT_EQ(share_within(Segment2{{0.5, 0.5}, {0.5, 0.5}}, square, 0), 1);
  EXPECT_EQ(share_within(Segment2{{1.2, 0.5}, {1.2, 0.5}}, square, 0.1), 0);
  EXPECT_EQ(share_within(Segment2{{1.2, 0.5}, {1.2, 0.5}}, square, 0.3), 1);
  Region line;
  line.add_ring({{0, 0}, {1, 0}});
  EXPECT_EQ(share_within(square, line, 0), 0);
  EXPECT_NEAR(share_within(square, line, 0.25), 0.25, 1e-9);
  EXPECT_DOUBLE_EQ(share_within(Segment2{{-1, 0}, {1, 0}}, line, 0.5), 0.75);
  EXPECT_EQ(share_within(square, Region{}, 1), 0);
}

}  // namespace
}  // namespace scenelore::rules
