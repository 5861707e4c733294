// Distances and footprints of planes against closed forms and brute force.
#include "plane_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "pair_geometry.hpp"
#include "scenelore/rules/made_plane.hpp"

namespace scenelore::rules {
namespace {

using Eigen::Vector3d;

PlaneShape shape(const MadePlane& made) { return PlaneShape(make_plane(made)); }

/// Least distance of a grid of points of a (holes left out) to a grid of points of b.
double sampled_gap(const PlaneShape& a, const PlaneShape& b, int steps) {
  const auto points = [&](const PlaneShape& s) {
    std::vector<Vector3d> out;
    const Box2& box = s.in_plane.box();
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        const Eigen::Vector2d p = box.min() + box.sizes().cwiseProduct(Eigen::Vector2d(i, j) / steps);
        if (s.in_plane.contains(p)) out.push_back(s.centroid + s.u * p.x() + s.v * p.y());
      }
    }
    for (const Edge3& edge : s.edges) {
      for (int i = 0; i < steps; ++i) out.push_back(edge.from + (edge.to - edge.from) * (static_cast<double>(i) / steps));
    }
    return out;
  };
  double best = INFINITY;
  const auto of_b = points(b);
  for (const Vector3d& p : points(a)) {
    for (const Vector3d& q : of_b) best = std::min(best, (p - q).squaredNorm());
  }
  return std::sqrt(best);
}

TEST(PlaneShape, HasTheGapOfTheClosedForm) {
  const PlaneShape desk = shape({.center = {0, 0, 0.7}, .length = 2, .width = 1});
  EXPECT_NEAR(hull_gap(desk, shape({.center = {0, 0, 1}, .length = 0.2, .width = 0.2})), 0.3, 1e-12) << "face to face";
  EXPECT_NEAR(hull_gap(desk, shape({.center = {2, 0, 0.7}, .length = 1, .width = 1})), 0.5, 1e-12) << "edge to edge";
  EXPECT_EQ(hull_gap(desk, shape({.center = {0, 0, 0.7}, .normal = {1, 0, 0}, .length = 3, .width = 1})), 0) << "crossing";
  EXPECT_EQ(hull_gap(desk, desk), 0);
  perception::Plane bare;
  bare.centroid = {0, 0, 2};
  EXPECT_NEAR(hull_gap(desk, PlaneShape(bare)), 1.3, 1e-12) << "no outline: a point";
  EXPECT_NEAR(hull_gap(PlaneShape(bare), PlaneShape(bare)), 0, 1e-12);
}

TEST(PlaneShape, LeavesHolesOut) {
  perception::Plane ring = make_plane({.center = {0, 0, 0}, .length = 4, .width = 4});
  ring.hull.holes.push_back({{-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}});
  const PlaneShape frame(ring), lid = shape({.center = {0, 0, 0.3}, .length = 1.2, .width = 1.2});
  EXPECT_NEAR(hull_gap(frame, lid), std::hypot(0.3, 0.4), 1e-12);
  EXPECT_EQ(footprint_share(lid, frame, 0), 0);
  EXPECT_NEAR(footprint_share(lid, frame, 0.5), 1 - 1.0 / 1.44, 1e-9);
}

TEST(PlaneShape, HasTheGapThatSamplesSay) {
  std::mt19937 random(2);
  const auto uniform = [&] { return static_cast<double>(random() % 2000) / 1000 - 1; };
  for (int round = 0; round < 25; ++round) {
    const auto made = [&] {
      return shape({.center = {uniform(), uniform(), uniform()}, .normal = {uniform(), uniform(), uniform() + 1.1},
                    .length = 0.5 + std::abs(uniform()), .width = 0.4, .along = {uniform(), uniform(), 0.2}});
    };
    const PlaneShape a = made(), b = made();
    const double exact = hull_gap(a, b), sampled = sampled_gap(a, b, 30);
    EXPECT_LE(exact, sampled + 1e-9) << round;
    EXPECT_GE(exact, sampled - 0.05) << round;
    EXPECT_NEAR(exact, hull_gap(b, a), 1e-12) << round;
  }
}

TEST(PlaneShape, HasBetweenLimitsTheGapThatItHasWithoutThem) {
  std::mt19937 random(8);
  const auto uniform = [&] { return static_cast<double>(random() % 2000) / 1000 - 1; };
  for (int round = 0; round < 300; ++round) {
    const auto made = [&] {
      return shape({.center = {uniform(), uniform(), uniform()}, .normal = {uniform(), uniform(), uniform() + 1.1},
                    .length = 0.1 + std::abs(uniform()), .width = 0.3, .along = {uniform(), uniform(), 0.2}});
    };
    const PlaneShape a = made(), b = made();
    const double exact = hull_gap(a, b);
    for (const Limits limits : {Limits{0.3, 1.0}, {0.05, 0.15}, {0, 0.5}, {0.7, 0.7}, {exact, 2}, {0, exact}}) {
      const double told = hull_gap(a, b, limits);
      EXPECT_EQ(limits(told), limits(exact)) << round;
      EXPECT_GE(told, std::min(exact, limits.high)) << round << ": what is told below the limits is a bound for other questions";
    }
  }
}

TEST(BoxRow, HasTheDistanceOfEachBox) {
  std::mt19937 random(4);
  const auto point = [&] { return Vector3d(static_cast<double>(random() % 1000), static_cast<double>(random() % 1000), static_cast<double>(random() % 1000)); };
  const auto box = [&] {
    const Vector3d a = point(), b = point();
    return Box3(a.cwiseMin(b), a.cwiseMax(b));
  };
  std::vector<Box3> boxes(101);
  for (Box3& one : boxes) one = box();
  const BoxRow row(boxes);
  std::vector<double> apart(row.size());
  const Box3 from = box();
  row.put_squared_distances(from, apart.data());
  for (std::size_t i = 0; i < boxes.size(); ++i) EXPECT_DOUBLE_EQ(apart[i], boxes[i].squaredExteriorDistance(from));
}

TEST(KnownRanges, KeepsOneRangeForEachQuestion) {
  std::mt19937 random(6);
  KnownRanges ranges;
  std::map<std::tuple<int, int, double>, double> expected;
  for (int i = 0; i < 5000; ++i) {
    const int a = static_cast<int>(random() % 20), b = static_cast<int>(random() % 20);
    const double reach = 0.25 * static_cast<double>(random() % 5) - 1, low = static_cast<double>(i);
    const auto [known, fresh] = expected.try_emplace({a, b, reach}, 0);
    EXPECT_EQ(ranges.of({a, b, reach}).low, known->second);
    ranges.of({a, b, reach}).low = known->second = low;
  }
  EXPECT_EQ(ranges.size(), expected.size());
  std::size_t seen = 0;
  ranges.for_each([&](const KnownRanges::Key& key, const KnownRanges::Range& range) {
    EXPECT_EQ(range.low, (expected.at({key.a, key.b, key.reach})));
    ++seen;
  });
  EXPECT_EQ(seen, expected.size());
}

TEST(PairGeometry, KnowsWhatItFoundOutBetweenOtherLimits) {
  const std::vector<perception::Plane> planes{make_plane({.center = {0, 0, 0}, .length = 1, .width = 1}),
                                              make_plane({.center = {0, 0, 0.4}, .length = 1, .width = 1})};
  PairGeometry g(planes);
  EXPECT_EQ(g.gap(0, 1, {0.5, 1}), 0.5);
  EXPECT_EQ(g.gap(1, 0, {0.1, 0.2}), 0.2);
  EXPECT_NEAR(g.gap(0, 1, {0.3, 1}), 0.4, 1e-12);
  EXPECT_NEAR(g.gap(0, 1), 0.4, 1e-12);
  PairGeometry later(planes);
  later.remember(g.answers());
  EXPECT_EQ(later.gap(0, 1), g.gap(0, 1));
  EXPECT_FALSE(later.has_news());
  EXPECT_EQ(later.footprint_overlap(0, 1, 0.1, {0.2, 0.5}), 0.5);
  EXPECT_TRUE(later.has_news());
  EXPECT_EQ(later.footprint_overlap(0, 1, 0.1, {0.7, 0.8}), 0.8);
  EXPECT_EQ(later.footprint_overlap(0, 1, 0.1), 1);
}

TEST(PlaneShape, TakesASteepPlaneAsALineOnThePlan) {
  const PlaneShape desk = shape({.center = {0, 0, 0.7}, .length = 2, .width = 1});
  const PlaneShape screen = shape({.center = {0.9, 0, 1}, .normal = {0, 1, 0.05}, .length = 0.6, .width = 0.4});
  ASSERT_TRUE(screen.steep);
  EXPECT_NEAR(screen.line.length(), 0.6, 1e-9);
  EXPECT_NEAR(footprint_share(screen, desk, 0), 0.4 / 0.6, 1e-9) << "0.6 to 1.2, the desk ends at 1";
  EXPECT_NEAR(footprint_share(screen, desk, 0.1), 0.5 / 0.6, 1e-9);
  EXPECT_EQ(footprint_share(desk, screen, 0), 0);
  const PlaneShape behind = shape({.center = {0, 0.6, 1}, .normal = {0, 1, 0}, .length = 0.6, .width = 0.4});
  EXPECT_EQ(footprint_share(behind, desk, 0), 0) << "the desk below it is hidden";
  EXPECT_EQ(footprint_share(behind, desk, 0.2), 1) << "but it stands near its outline";
}

TEST(PairGeometry, MeasuresAnglesAndDistances) {
  const std::vector<perception::Plane> planes{
      make_plane({.center = {0, 0, 0}, .length = 4, .width = 4}),
      make_plane({.center = {1, 0, 0.7}, .normal = {0, 0, -1}}),
      make_plane({.center = {0, 2, 1}, .normal = {0, -1, 1}, .length = 1, .width = 2 * std::sqrt(0.5)}),
  };
  PairGeometry g(planes);
  EXPECT_NEAR(g.angle(0, 1), 0, 1e-9);
  EXPECT_NEAR(g.angle(0, 2), 45, 1e-9);
  EXPECT_NEAR(g.vertical_gap(1, 0), 0.7, 1e-12);
  EXPECT_NEAR(g.vertical_gap(0, 1), -0.7, 1e-12);
  EXPECT_NEAR(g.side(0, 1), 0.7, 1e-12);
  EXPECT_NEAR(g.side(1, 0), 0.7, 1e-12);
  EXPECT_NEAR(g.plane_distance(0, 2), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(g.centroid_distance(0, 1), std::hypot(1, 0.7), 1e-12);
  EXPECT_NEAR(g.gap(0, 2), 0.5, 1e-12);
  EXPECT_EQ(g.gap(2, 0), g.gap(0, 2));
  EXPECT_EQ(g.footprint_overlap(1, 0, 0), 1);
  EXPECT_NEAR(g.footprint_overlap(0, 1, 0), 1.0 / 16, 1e-12);
}

TEST(PairsInReach, AreThoseThatABruteForceFinds) {
  std::mt19937 random(9);
  const auto uniform = [&] { return static_cast<double>(random() % 1000) / 100; };
  std::vector<Box3> boxes;
  for (int i = 0; i < 120; ++i) {
    const Vector3d low(uniform(), uniform(), uniform());
    boxes.emplace_back(low, low + Vector3d(uniform(), uniform(), uniform()) / 10);
  }
  for (const auto& [within, plan] : {std::pair{1.0, INFINITY}, {INFINITY, 0.5}, {2.0, 0.3}, {0.0, 0.0}, {INFINITY, INFINITY}}) {
    std::vector<std::pair<int, int>> brute;
    for (int i = 0; i < 120; ++i) {
      for (int j = i + 1; j < 120; ++j) {
        const Box3 &a = boxes[static_cast<std::size_t>(i)], &b = boxes[static_cast<std::size_t>(j)];
        const Eigen::AlignedBox2d pa(a.min().head<2>(), a.max().head<2>()), pb(b.min().head<2>(), b.max().head<2>());
        if (a.exteriorDistance(b) <= within && pa.exteriorDistance(pb) <= plan) brute.emplace_back(i, j);
      }
    }
    EXPECT_EQ(pairs_in_reach(boxes, within, plan), brute);
  }
}

}  // namespace
}  // namespace scenelore::rules
