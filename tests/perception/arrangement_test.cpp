// Rooms of rectangles whose arrangement is known.
#include "scenelore/perception/arrangement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace scenelore::perception {
namespace {

using Vector = Eigen::Vector3d;

/// A parallelogram whose normal is a × b, seen by a sensor, with the floor at z = 0.
Plane panel(const Vector& corner, const Vector& a, const Vector& b) {
  Plane plane;
  plane.centroid = corner + (a + b) / 2;
  plane.normal = a.cross(b).normalized();
  plane.hull.outer = {corner, corner + a, corner + a + b, corner + b};
  plane.area_m2 = a.cross(b).norm();
  plane.tilt_deg = std::acos(std::min(1.0, std::abs(plane.normal.z()))) * 180 / std::numbers::pi;
  plane.height = plane.centroid.z();
  plane.z_min = plane.z_max = corner.z();
  for (const Vector& p : plane.hull.outer) plane.z_min = std::min(plane.z_min, p.z()), plane.z_max = std::max(plane.z_max, p.z());
  plane.edge_unseen = 0;
  return plane;
}

Plane level(double x, double y, double z, double length, double width) { return panel({x, y, z}, {length, 0, 0}, {0, width, 0}); }

/// Facing −y.
Plane upright(double x, double y, double z, double length, double high) { return panel({x, y, z}, {length, 0, 0}, {0, 0, high}); }

/// Everything moved, and turned about z, as in a scan of another frame; then arranged.
std::vector<Arrangement> arranged(std::vector<Plane> planes, const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity()) {
  std::vector<const Plane*> all;
  for (Plane& plane : planes) {
    plane.centroid = motion * plane.centroid;
    plane.normal = motion.linear() * plane.normal;
    for (Vector& corner : plane.hull.outer) corner = motion * corner;
    all.push_back(&plane);
  }
  return arrangements(all, Eigen::Quaterniond(Eigen::Matrix3d(motion.linear().transpose())));
}

const Plane kFloor = level(0, 0, 0, 5, 4), kCeiling = panel({0, 0, 2.6}, {0, 4, 0}, {5, 0, 0}), kWall = upright(0, 4, 0, 5, 2.6);
const Plane kDesk = level(1, 2, 0.72, 1.6, 0.8), kKeyboard = level(1.5, 2.1, 0.745, 0.45, 0.15);
const Plane kTop = level(3, 3, 0.8, 1, 0.5), kFront = upright(3, 3, 0, 1, 0.8);

TEST(Arrangement, LiftIsTheHeightOverWhatIsBeneath) {
  const Plane screen = upright(1.6, 2.5, 0.84, 0.5, 0.3), picture = upright(2, 3.98, 1.2, 0.6, 0.4);
  const auto found = arranged({kFloor, kDesk, kKeyboard, screen, picture});
  EXPECT_NEAR(found[2].lift, 0.025, 1e-12);
  EXPECT_NEAR(found[3].lift, 0.12, 1e-12);
  for (const std::size_t on_the_floor : {0U, 1U, 4U}) {
    EXPECT_TRUE(std::isnan(found[on_the_floor].lift)) << on_the_floor;
  }
}

TEST(Arrangement, WhatIsLargerOrAtTheSameHeightIsNotBeneath) {
  const Plane paper = level(1.5, 2.1, 0.7, 0.2, 0.2), piece = level(1.4, 2.2, 0.7185, 1.7, 0.9);
  const auto found = arranged({kFloor, kDesk, paper, piece});
  EXPECT_TRUE(std::isnan(found[1].lift)) << "a smaller thing beneath, and a piece of the same surface";
}

TEST(Arrangement, HeadroomReachesToTheLowestLevelPlaneAbove) {
  const Plane shelf = level(1, 2, 1.1, 1.6, 0.8);
  const auto found = arranged({kFloor, kDesk, shelf, kCeiling, kWall});
  EXPECT_NEAR(found[0].headroom, 0.72, 1e-12);
  EXPECT_NEAR(found[1].headroom, 0.38, 1e-12);
  EXPECT_NEAR(found[2].headroom, 1.5, 1e-12);
  EXPECT_TRUE(std::isnan(found[3].headroom));
  EXPECT_NEAR(found[4].headroom, 0, 1e-12) << "ends at the ceiling";
}

TEST(Arrangement, StandoffIsTheDistanceFromTheLargerPlaneBehind) {
  const Plane board = upright(1, 3.98, 1, 1.5, 1), pane = upright(3, 4.015, 1, 1, 1.2), screen = upright(1.6, 3.6, 0.84, 0.5, 0.3);
  const Plane away = upright(1.6, 2.2, 0.84, 0.5, 0.3);
  const auto found = arranged({kWall, board, pane, screen, away, kDesk});
  EXPECT_TRUE(std::isnan(found[0].standoff));
  EXPECT_NEAR(found[1].standoff, 0.02, 1e-12);
  EXPECT_NEAR(found[2].standoff, -0.015, 1e-12);
  EXPECT_NEAR(found[3].standoff, 0.38, 1e-12) << "from the board, which is nearer than the wall and large enough";
  EXPECT_TRUE(std::isnan(found[4].standoff)) << "too far from any";
  EXPECT_TRUE(std::isnan(found[5].standoff)) << "level";
}

TEST(Arrangement, EdgesAreConcaveWhereAPlaneComesForwardAndConvexWhereItGoesBack) {
  const auto found = arranged({kFloor, kWall, kTop, kFront});
  EXPECT_NEAR(found[0].edge_concave, 5.0 / 18, 0.05) << "the wall at one of the floor's long sides; the front meets no edge of it";
  EXPECT_EQ(found[0].edge_convex, 0);
  EXPECT_NEAR(found[2].edge_convex, 1.0 / 3, 0.08) << "the front hangs from the top";
  EXPECT_EQ(found[2].edge_concave, 0);
  EXPECT_NEAR(found[3].edge_convex, 1 / 3.6, 0.07);
  EXPECT_NEAR(found[3].edge_concave, 1 / 3.6, 0.07) << "the floor";
}

TEST(Arrangement, IsTheSameInAnyFrame) {
  const std::vector<Plane> room{kFloor, kDesk, kKeyboard, kTop, kFront, kWall, upright(1, 3.98, 1, 1.5, 1)};
  const auto here = arranged(room);
  const auto there = arranged(room, Eigen::Translation3d(4.5e5, 5.6e6, 0) * Eigen::AngleAxisd(0.7, Vector::UnitZ()));
  const auto same = [](double a, double b) { return std::isnan(a) ? std::isnan(b) : std::abs(a - b) < 1e-6; };
  for (std::size_t p = 0; p < room.size(); ++p) {
    EXPECT_TRUE(same(here[p].lift, there[p].lift)) << p;
    EXPECT_TRUE(same(here[p].headroom, there[p].headroom)) << p;
    EXPECT_TRUE(same(here[p].standoff, there[p].standoff)) << p;
    EXPECT_TRUE(same(here[p].wall_offset, there[p].wall_offset)) << p;
    EXPECT_TRUE(same(here[p].corner_offset, there[p].corner_offset)) << p;
    EXPECT_EQ(here[p].edge_concave, there[p].edge_concave) << p;
    EXPECT_EQ(here[p].edge_convex, there[p].edge_convex) << p;
  }
}

TEST(Arrangement, WallsAreMeasuredFromAlongAndAcross) {
  const Plane side = panel({0, 0, 0}, {0, 4, 0}, {0, 0, 2.6}), opposite = panel({5, 0, 0}, {0, 0, 2.6}, {0, 4, 0});  // facing +x and −x
  const Plane screen = upright(1.6, 3.6, 0.84, 0.5, 0.3), pane = upright(3, 4.015, 1, 1, 1.2);
  auto found = arranged({kWall, side, kDesk, screen, pane, opposite});
  EXPECT_NEAR(found[3].wall_offset, 0.4, 1e-12);
  EXPECT_NEAR(found[3].corner_offset, 1.85, 1e-12);
  EXPECT_NEAR(found[4].wall_offset, -0.015, 1e-12) << "behind the wall";
  EXPECT_NEAR(found[2].corner_offset, 1.6, 1e-12) << "the nearest of all";
  EXPECT_TRUE(std::isnan(found[2].wall_offset)) << "level";
  EXPECT_NEAR(found[1].wall_offset, 5, 1e-12);
  EXPECT_NEAR(found[1].corner_offset, 2, 1e-12);
  EXPECT_TRUE(std::isnan(found[0].wall_offset)) << "no other wall is parallel";
  Plane away = kWall;
  away.edge_unseen = -1;
  EXPECT_NEAR(arranged({away, pane})[1].wall_offset, 0.015, 1e-12) << "nobody knows on which side";
}

TEST(Arrangement, SaysNothingAboutSidesThatNobodyKnows) {
  Plane front = kFront, board = upright(1, 3.98, 1, 1.5, 1), top = kTop;
  for (Plane* plane : {&front, &board, &top}) plane->edge_unseen = -1;
  const auto found = arranged({kFloor, kWall, top, front, board});
  EXPECT_NEAR(found[2].edge_convex, 1.0 / 3, 0.08) << "normals of what is level point up";
  EXPECT_TRUE(std::isnan(found[3].edge_convex));
  EXPECT_TRUE(std::isnan(found[3].edge_concave));
  EXPECT_TRUE(std::isnan(found[4].standoff));
  EXPECT_TRUE(std::isnan(found[4].lift));
}

TEST(Arrangement, OfDegeneratePlanesIsNotKnown) {
  Plane line = kDesk, corners = kDesk;
  line.hull.outer.clear();
  corners.hull.outer = Ring(4, corners.centroid);
  const auto found = arranged({line, corners, kFloor});
  EXPECT_TRUE(std::isnan(found[0].lift));
  EXPECT_TRUE(std::isnan(found[0].edge_convex));
  EXPECT_TRUE(std::isnan(found[1].lift));
  EXPECT_EQ(found[1].edge_convex, 0);
  EXPECT_TRUE(arranged({}).empty());
}

}  // namespace
}  // namespace scenelore::perception
