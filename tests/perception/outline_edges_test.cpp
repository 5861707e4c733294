// Scenes of rectangles that a sensor at the origin looks at, ray by ray.
#include "outline_edges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace scenelore::perception {
namespace {

using Vector = Eigen::Vector3d;

/// What stands in the scene; the first ones are also the planes that were found.
struct Panel {
  Vector corner, a, b;  ///< parallelogram; a × b is the normal

  [[nodiscard]] Vector normal() const { return a.cross(b).normalized(); }

  /// Metres along a ray from the origin; infinite when it misses.
  [[nodiscard]] double hit(const Vector& ray) const {
    const double t = normal().dot(corner) / normal().dot(ray);
    const Vector p = t * ray - corner;
    const double u = p.dot(a) / a.squaredNorm(), v = p.dot(b) / b.squaredNorm();
    return t > 0 && u >= 0 && u <= 1 && v >= 0 && v <= 1 ? t : std::numeric_limits<double>::infinity();
  }
};

Plane plane_of(const Panel& panel) {
  Plane plane;
  plane.centroid = panel.corner + (panel.a + panel.b) / 2;
  plane.normal = panel.normal();
  plane.hull.outer = {panel.corner, panel.corner + panel.a, panel.corner + panel.a + panel.b, panel.corner + panel.b};
  return plane;
}

/// Every `step_deg` in azimuth and elevation, towards x within 70 degrees; the scene is moved before it is seen. `panel_of_point`
/// takes the number of the panel that each point is on.
Cloud seen(const std::vector<Panel>& panels, const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity(), double step_deg = 0.3,
           std::vector<std::int32_t>* panel_of_point = nullptr) {
  Cloud cloud;
  cloud.origin = motion * Vector(1, 2, 3);
  cloud.sensors = SensorPositions(motion * Vector(0, 0, 0));
  for (double azimuth = -70; azimuth <= 70; azimuth += step_deg) {
    for (double elevation = -70; elevation <= 70; elevation += step_deg) {
      const double a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
      const Vector ray(std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e));
      double nearest = std::numeric_limits<double>::infinity();
      std::int32_t number = -1;
      for (std::size_t k = 0; k < panels.size(); ++k) {
        if (panels[k].hit(ray) < nearest) nearest = panels[k].hit(ray), number = static_cast<std::int32_t>(k);
      }
      if (!std::isfinite(nearest)) continue;
      if (panel_of_point) panel_of_point->push_back(number);
      const Eigen::Vector3f p = (motion * (nearest * ray) - cloud.origin).cast<float>();
      cloud.x.push_back(p.x()), cloud.y.push_back(p.y()), cloud.z.push_back(p.z());
    }
  }
  return cloud;
}

const Panel kWall{{4, -3, -1.5}, {0, 0, 3}, {0, 6, 0}};
const Panel kFloor{{0.5, -3, -1.5}, {3.5, 0, 0}, {0, 6, 0}};
const Panel kCeiling{{0.5, -3, 1.5}, {0, 6, 0}, {3.5, 0, 0}};

Plane looked_at(const std::vector<Panel>& panels) {
  std::vector<Plane> planes{plane_of(panels[0])};
  look_beyond_outlines(seen(panels), Eigen::Quaterniond::Identity(), {}, planes, 2);
  return planes[0];
}

TEST(OutlineEdges, AreFreeWhereTheSensorLooksPast) {
  const Plane screen = looked_at({{{2, -0.4, -0.2}, {0, 0, 0.6}, {0, 0.8, 0}}, kWall, kFloor, kCeiling});
  EXPECT_EQ(screen.edge_free, 1);
  EXPECT_EQ(screen.edge_free_top, 1);
  EXPECT_EQ(screen.edge_joined, 0);
}

TEST(OutlineEdges, AreNotFreeWhereTheRoomEnds) {
  const Plane wall = looked_at({kWall, kFloor, kCeiling});
  EXPECT_EQ(wall.edge_free, 0);
  EXPECT_EQ(wall.edge_free_top, 0);
  EXPECT_EQ(wall.edge_joined, 0) << "floor and ceiling leave its plane at once";
  EXPECT_EQ(looked_at({kFloor, kWall, kCeiling}).edge_free, 0);
}

TEST(OutlineEdges, AreJoinedWhereTheSurfaceGoesOn) {
  const Plane board = looked_at({{{3.98, -0.6, -0.2}, {0, 0, 0.9}, {0, 1.2, 0}}, kWall, kFloor, kCeiling});
  EXPECT_EQ(board.edge_joined, 1);
  EXPECT_EQ(board.edge_free, 0);
  EXPECT_EQ(board.edge_free_top, 0);
}

TEST(OutlineEdges, CountByLengthAndKnowWhatIsHidden) {
  // Of a panel of 1 x 1 m the sensor sees the upper half, 1 x 0.5 m; a box before it hides the rest: its lower edge of 1 m of 3.
  const Panel upper{{2, -0.5, 0}, {0, 0, 0.5}, {0, 1, 0}}, lower{{2, -0.5, -0.5}, {0, 0, 0.5}, {0, 1, 0}};
  const Panel box{{1, -1, -1.4}, {0, 0, 1.4}, {0, 2, 0}};
  const Plane plane = looked_at({upper, lower, box, kWall, kFloor, kCeiling});
  EXPECT_NEAR(plane.edge_free, 2.0 / 3, 0.05);
  EXPECT_EQ(plane.edge_free_top, 1);
  EXPECT_EQ(plane.edge_joined, 0);
}

TEST(OutlineEdges, OfLevelPlanesHaveNoTop) {
  const Plane desk = looked_at({{{1.5, -0.6, -0.6}, {0.8, 0, 0}, {0, 1.2, 0}}, kWall, kFloor, kCeiling});
  EXPECT_EQ(desk.edge_free, 1);
  EXPECT_EQ(desk.edge_free_top, -1);
}

TEST(OutlineEdges, AreNotKnownWithoutASensorOutlineOrMeasurements) {
  const Panel screen{{2, -0.4, -0.2}, {0, 0, 0.6}, {0, 0.8, 0}};
  std::vector<Plane> planes{plane_of(screen), plane_of(screen)};
  planes[1].hull.outer.clear();
  Cloud cloud = seen({screen, kWall});
  look_beyond_outlines(cloud, Eigen::Quaterniond::Identity(), {}, planes, 2);
  EXPECT_EQ(planes[0].edge_free, 1);
  EXPECT_EQ(planes[1].edge_free, -1);
  planes = {plane_of(screen)};
  cloud.sensors = {};
  look_beyond_outlines(cloud, Eigen::Quaterniond::Identity(), {}, planes, 2);
  EXPECT_EQ(planes[0].edge_free, -1);
  EXPECT_EQ(looked_at({screen}).edge_free, -1) << "a screen in the dark: no ray came back from beyond it";
}

TEST(OutlineEdges, AreUnseenWhereTheViewEnds) {
  EXPECT_EQ(looked_at({{{2, -0.4, -0.2}, {0, 0, 0.6}, {0, 0.8, 0}}, kWall, kFloor, kCeiling}).edge_unseen, 0);
  // Of a wall 1 m away that goes on past the view's 70 degrees to the left, the left edge of what is seen; floor and ceiling go as far.
  const double end = std::tan(70 * std::numbers::pi / 180);
  const Panel nearer{{1, 0, -1.5}, {0, 0, 3}, {0, end, 0}};
  EXPECT_NEAR(looked_at({nearer, kWall, kFloor, kCeiling}).edge_unseen, 3 / (6 + 2 * end), 0.03);
  EXPECT_EQ(looked_at({{{2, -0.4, -0.2}, {0, 0, 0.6}, {0, 0.8, 0}}}).edge_unseen, 1) << "in the dark";
  const Panel edge_on{{1, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(looked_at({edge_on, kWall, kFloor, kCeiling}).edge_unseen, -1) << "nobody looked beyond it";
}

TEST(OutlineEdges, TakeOfSeveralPosesTheOneThatSawMost) {
  // From the origin a box hides the panel's lower half; the other pose looks over the box.
  const Panel panel{{2, -0.5, -0.5}, {0, 0, 1}, {0, 1, 0}}, box{{1, -0.6, -1.4}, {0, 0, 1.4}, {0, 1.2, 0}};
  const std::vector<Panel> panels = {panel, box, kWall, kFloor, kCeiling};
  const Vector beside(0.4, 1, 0.9);
  Cloud cloud = seen(panels);
  std::vector<std::uint32_t> of_point(cloud.size(), 0);
  std::vector<Panel> moved = panels;
  for (Panel& each : moved) each.corner -= beside;
  const Cloud other = seen(moved);
  for (std::size_t i = 0; i < other.size(); ++i) {
    const Eigen::Vector3f p = (other.position(i) + beside - cloud.origin).cast<float>();
    cloud.x.push_back(p.x()), cloud.y.push_back(p.y()), cloud.z.push_back(p.z());
    of_point.push_back(1);
  }
  const auto edges = [&](const SensorPositions& sensors) {
    cloud.sensors = sensors;
    std::vector<Plane> planes{plane_of(panel)};
    look_beyond_outlines(cloud, Eigen::Quaterniond::Identity(), {}, planes, 2);
    return planes[0].edge_free;
  };
  EXPECT_LT(looked_at(panels).edge_free, 0.7) << "from the origin alone";
  EXPECT_GT(edges(SensorPositions({Vector(0, 0, 0), beside}, of_point)), 0.95);
  std::fill(of_point.begin(), of_point.end(), 2U);
  EXPECT_EQ(edges(SensorPositions({Vector(0, 0, 0), beside}, of_point)), -1) << "positions of other points";
}

/// A pillar, its front from y = −1.4 to −0.7 at x = 2; the sensor sees its side at y = −0.7 as well, which runs back by `depth`,
/// and aside by `turned`.
struct Pillar {
  explicit Pillar(double depth, double turned = 0)
      : panels{{{2, -1.4, -1.5}, {0, 0, 3}, {0, 0.7, 0}}, {{2, -0.7, -1.5}, {0, 0, 3}, {depth, turned, 0}}, kWall, kFloor, kCeiling} {
    for (const Panel& panel : panels) planes.push_back(plane_of(panel));
    const Cloud cloud = seen(panels, Eigen::Isometry3d::Identity(), 0.3, &plane_of_point);
    without_planes = planes;
    look_beyond_outlines(cloud, Eigen::Quaterniond::Identity(), {}, without_planes, 2);
    turns = look_beyond_outlines(cloud, Eigen::Quaterniond::Identity(), plane_of_point, planes, 2);
  }

  std::vector<Panel> panels;
  std::vector<Plane> planes, without_planes;
  std::vector<std::int32_t> plane_of_point;
  Turns turns;
};

TEST(OutlineEdges, AreNotFreeWhereASurfaceTurnsAroundAnUprightEdge) {
  const Pillar pillar(1.5);
  EXPECT_EQ(pillar.turns[0], std::vector<std::uint32_t>{1}) << "the front into the side";
  EXPECT_TRUE(pillar.turns[2].empty()) << "the wall meets floor and ceiling in corners that point away";
  EXPECT_GT(pillar.without_planes[0].edge_free, 0.7) << "without the planes of the points both long edges look free";
  EXPECT_NEAR(pillar.planes[0].edge_free, 0.4, 0.1) << "the other long edge is: its side is not seen";
}

TEST(OutlineEdges, AreFreeWhereWhatIsSeenPastThemOnlyLiesInTheSameDirection) {
  EXPECT_TRUE(Pillar(1.5, 1.5).turns[0].empty()) << "half a turn is the next surface, no corner of a body";
  Pillar apart(1.5);
  for (std::int32_t& plane : apart.plane_of_point) plane = plane == 1 ? 2 : plane;  // as if the side's points were the wall's
  std::vector<Plane> planes = apart.planes;
  const Turns turns = look_beyond_outlines(seen(apart.panels), Eigen::Quaterniond::Identity(), apart.plane_of_point, planes, 2);
  EXPECT_TRUE(turns[0].empty()) << "the wall's plane does not pass through the edge";
  EXPECT_EQ(planes[0].edge_free, apart.without_planes[0].edge_free);
}

TEST(OutlineEdges, AreTheSameHoweverTheSceneIsTurned) {
  const std::vector<Panel> panels = {{{2, -0.5, 0}, {0, 0, 0.5}, {0, 1, 0}}, {{1, -1, -1.4}, {0, 0, 1.4}, {0, 2, 0}}, kWall, kFloor, kCeiling};
  for (int turn = 0; turn < 8; ++turn) {
    const Eigen::Isometry3d motion = Eigen::Translation3d(100 * turn, -7, 3) *
                                     Eigen::AngleAxisd(0.8 * turn, Vector(std::sin(turn), std::cos(turn), 0.3).normalized());
    std::vector<Plane> planes{plane_of(panels[0])};
    planes[0].centroid = motion * planes[0].centroid;
    planes[0].normal = motion.rotation() * planes[0].normal;
    for (Vector& corner : planes[0].hull.outer) corner = motion * corner;
    const Eigen::Quaterniond upright(motion.rotation().transpose());
    std::vector<Plane> again = planes;
    const Cloud cloud = seen(panels, motion);
    look_beyond_outlines(cloud, upright, {}, planes, 1);
    EXPECT_NEAR(planes[0].edge_free, 2.0 / 3, 0.05) << turn;
    EXPECT_EQ(planes[0].edge_free_top, 1) << turn;
    look_beyond_outlines(cloud, upright, {}, again, 3);
    EXPECT_EQ(again[0].edge_free, planes[0].edge_free);
    EXPECT_EQ(again[0].edge_joined, planes[0].edge_joined);
  }
}

}  // namespace
}  // namespace scenelore::perception
