// Clouds joined from several poses: each point counts with the place that it was measured from.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "planar_scenes.hpp"
#include "scenelore/perception/perceive.hpp"
#include "seen_from.hpp"
#include "seen_past.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;
using testing::Scene;
using Vector = Eigen::Vector3d;

constexpr double kTop = 0.74, kRear = 0.78, kBoard = 1.6;  // metres: height of the desks, place and height of a board that stands on one

/// Two desks of one height that touch along x = 1.6; what lies beside the shorter one speaks for two rectangles.
bool on_first(const Vector& p) { return p.x() > 0 && p.x() < 1.6 && p.y() > 0 && p.y() < 0.8; }
bool on_second(const Vector& p) { return p.x() >= 1.6 && p.x() < 2.4 && p.y() > 0 && p.y() < 1.1; }
bool in_notch(const Vector& p) { return p.x() > 0 && p.x() < 1.6 && p.y() > 0.8 && p.y() < 1.1; }

// One pose sees both desks, but a board at the rear of the first hides the notch; the other looks through it from behind, and sees
// nothing of the first desk.
const Vector kBefore(1.2, -1.5, 1.4), kBehind(0.8, 3, 1.4);

/// Where the way from the eye to p has this coordinate.
Vector crossing(const Vector& eye, const Vector& p, int axis, double at) { return eye + (at - eye[axis]) / (p[axis] - eye[axis]) * (p - eye); }

bool visible(const Vector& eye, const Vector& p) {
  if (p.z() < kTop) {
    const Vector above = crossing(eye, p, 2, kTop);
    if (on_first(above) || on_second(above)) return false;
  }
  if ((p.y() - kRear) * (eye.y() - kRear) > 0) return true;
  const Vector at = crossing(eye, p, 1, kRear);
  return at.x() < 0 || at.x() > 1.6 || at.z() < kTop || at.z() > kBoard;
}

struct Sight {
  Vector point;
  int plane;  ///< 0 the floor, 1 and 2 the desks
};

std::vector<Sight> seen_from(const Vector& eye, std::uint64_t seed) {
  constexpr double kNoise = 0.004;
  Random random(seed);
  std::vector<Sight> sights;
  for (int i = 0; i < 80'000; ++i) {
    const Vector floor(random.uniform(-1.5, 4), random.uniform(-3, 4), 0), top(random.uniform(0, 2.4), random.uniform(0, 1.1), kTop);
    if (visible(eye, floor)) sights.push_back({floor + kNoise * random.normal() * Vector::UnitZ(), 0});
    if (i % 4 == 0 && (on_first(top) || on_second(top)) && visible(eye, top)) sights.push_back({top + kNoise * random.normal() * Vector::UnitZ(), on_first(top) ? 1 : 2});
  }
  return sights;
}

/// What the sensor sees from these places, one after another, moved as a whole.
Scene desks_from(const std::vector<Vector>& eyes, const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity()) {
  Scene scene;
  std::vector<Vector> sensors;
  std::vector<std::uint32_t> of_point;
  for (const Vector& eye : eyes) {
    for (const Sight& sight : seen_from(eye, 5 + sensors.size())) {
      scene.add(motion * sight.point, sight.plane);
      of_point.push_back(static_cast<std::uint32_t>(sensors.size()));
    }
    sensors.push_back(motion * eye);
  }
  scene.cloud.sensors = SensorPositions(sensors, of_point);
  return scene;
}

/// Whether the desks are planes of their own: each with nine tenths of its points on a plane that has few of the other's.
bool desks_are_apart(const Scene& scene, const Perception& found) {
  std::vector<std::array<int, 3>> held(found.planes.size(), std::array<int, 3>{});
  std::array<int, 3> all{};
  for (std::size_t i = 0; i < scene.truth.size(); ++i) {
    const auto t = static_cast<std::size_t>(scene.truth[i]);
    ++all[t];
    if (found.plane_of_point[i] >= 0) ++held[static_cast<std::size_t>(found.plane_of_point[i])][t];
  }
  const auto has_own = [&](std::size_t desk) {
    return std::any_of(held.begin(), held.end(), [&](const auto& h) { return h[desk] > 0.9 * all[desk] && h[3 - desk] < 0.1 * all[3 - desk]; });
  };
  return has_own(1) && has_own(2);
}

TEST(SensorPoses, PartDesksThatOnePoseAloneLeavesJoined) {
  const Scene one = desks_from({kBefore}), both = desks_from({kBefore, kBehind});
  EXPECT_FALSE(desks_are_apart(one, perceive(one.cloud)));
  EXPECT_TRUE(desks_are_apart(both, perceive(both.cloud)));
  Scene nobody_knows = both;
  nobody_knows.cloud.sensors = {};
  EXPECT_FALSE(desks_are_apart(nobody_knows, perceive(nobody_knows.cloud)));
}

TEST(SensorPoses, GiveTheSamePlanesWithAnyNumberOfThreads) {
  const Scene scene = desks_from({kBefore, kBehind});
  const Perception once = perceive(scene.cloud, {.threads = 1});
  for (const int threads : {2, 3, 5}) {
    const Perception again = perceive(scene.cloud, {.threads = threads});
    EXPECT_EQ(again.plane_of_point, once.plane_of_point);
    ASSERT_EQ(again.planes.size(), once.planes.size());
    for (std::size_t p = 0; p < once.planes.size(); ++p) EXPECT_EQ(again.planes[p].normal, once.planes[p].normal);
  }
}

TEST(SensorPoses, PartTheSameDesksShiftedAndTurned) {
  for (const double angle : {0.3, 1.1, 2.6}) {
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.translate(Vector(-3 * angle, 7.3, 0)).rotate(Eigen::AngleAxisd(angle, Vector::UnitZ()));
    const Scene scene = desks_from({kBefore, kBehind}, motion);
    EXPECT_TRUE(desks_are_apart(scene, perceive(scene.cloud))) << "turned by " << angle;
  }
}

/// The middles of the cells that were looked through, on the plane of the desks.
std::vector<Vector> looked_through(const Scene& scene) {
  std::vector<std::uint32_t> points;
  Moments moments;
  for (std::uint32_t i = 0; i < scene.cloud.size(); ++i) {
    if (scene.truth[i] > 0) points.push_back(i), moments.add(scene.cloud.offset(i).cast<double>());
  }
  const PlaneFit plane = fit_plane(moments);
  PlaneView view = view_of(scene.cloud, plane, points, 0.05);
  look_past(scene.cloud, plane, 0.05, view);
  std::vector<Vector> cells;
  for (const Eigen::Vector2d& e : view.empty) cells.push_back(plane.centroid + e.x() * plane.axes.col(1) + e.y() * plane.axes.col(2));
  return cells;
}

TEST(LookPast, JoinsWhatAllPosesSaw) {
  const auto in_the_notch = [](const std::vector<Vector>& cells) { return std::count_if(cells.begin(), cells.end(), in_notch); };
  EXPECT_EQ(in_the_notch(looked_through(desks_from({kBefore}))), 0);
  const std::vector<Vector> both = looked_through(desks_from({kBefore, kBehind}));
  EXPECT_GT(in_the_notch(both), 0.7 * 1.6 * 0.3 / (0.05 * 0.05));
  for (const Vector& cell : both) {
    const auto well_inside = [&](double x, double y) { return on_first(cell + Vector(x, y, 0)) || on_second(cell + Vector(x, y, 0)); };
    EXPECT_FALSE(well_inside(0.05, 0.05) && well_inside(-0.05, -0.05) && well_inside(0.05, -0.05) && well_inside(-0.05, 0.05)) << cell.transpose();
  }
  Scene from_below = desks_from({kBehind});
  EXPECT_GT(looked_through(from_below).size(), 0U);
  std::vector<std::uint32_t> unknown(from_below.cloud.size(), 1);
  from_below.cloud.sensors = SensorPositions({kBehind}, unknown);
  EXPECT_EQ(looked_through(from_below).size(), 0U) << "a position that no point has says nothing";
}

TEST(LookPast, SaysTheSameOfOnePlaceUnderTwoNumbers) {
  Scene scene = desks_from({kBefore});
  const std::vector<Vector> once = looked_through(scene);
  std::vector<std::uint32_t> of_point(scene.cloud.size());
  for (std::size_t i = 0; i < of_point.size(); ++i) of_point[i] = i % 2;
  scene.cloud.sensors = SensorPositions({kBefore, kBefore}, of_point);
  EXPECT_EQ(looked_through(scene), once);
}

TEST(SeenFromFront, IsWhereMostPointsWereMeasuredFrom) {
  Random random(11);
  for (int round = 0; round < 200; ++round) {
    Scene scene;
    scene.cloud.origin = Vector(random.normal(), random.normal(), random.normal());
    const int sensors = 1 + round % 5;
    std::vector<Vector> positions;
    for (int s = 0; s < sensors; ++s) positions.emplace_back(random.normal(), random.normal(), random.normal());
    PlaneEquation plane;
    plane.normal = Vector(random.normal(), random.normal(), random.normal()).normalized();
    plane.offset = 0.3 * random.normal();
    std::vector<std::uint32_t> of_point, points;
    int front = 0, back = 0;
    for (std::uint32_t i = 0; i < 41; ++i) {
      scene.add(scene.cloud.origin, 0);
      of_point.push_back(static_cast<std::uint32_t>(random.uniform(0, sensors + 1)));  // the last one is none
      if (i % 3 == 0) continue;
      points.push_back(i);
      if (of_point[i] == positions.size()) continue;
      (plane.normal.dot(positions[of_point[i]] - scene.cloud.origin) > plane.offset ? front : back) += 1;
    }
    scene.cloud.sensors = SensorPositions(positions, of_point);
    const std::optional<bool> said = seen_from_front(scene.cloud, plane, points);
    ASSERT_EQ(said.has_value(), front != back) << front << " to " << back;
    if (said) {
      EXPECT_EQ(*said, front > back) << front << " to " << back;
    }
  }
  EXPECT_FALSE(seen_from_front(Cloud{}, {}, {}).has_value());
}

TEST(SlantOf, IsTheMeanCosineBetweenRaysAndNormal) {
  Scene scene;
  scene.cloud.origin = Vector(10, 0, 0);
  scene.add(Vector(10, 0, 0), 0);
  scene.add(Vector(10, 2, 0), 0);
  scene.cloud.sensors = SensorPositions(Vector(10, 0, 2));
  const std::vector<std::uint32_t> both{0, 1}, first{0};
  EXPECT_NEAR(*slant_of(scene.cloud, Vector::UnitZ(), first), 1, 1e-9);
  EXPECT_NEAR(*slant_of(scene.cloud, -Vector::UnitZ(), both), (1 + std::sqrt(0.5)) / 2, 1e-9) << "from either side";
  EXPECT_NEAR(*slant_of(scene.cloud, Vector::UnitX(), both), 0, 1e-9);
  const std::vector<double> slants = slants_of(scene.cloud, Vector::UnitZ(), both);
  ASSERT_EQ(slants.size(), both.size());
  EXPECT_NEAR(slants.front(), 1, 1e-9);
  EXPECT_NEAR(slants.back(), std::sqrt(0.5), 1e-9);
  EXPECT_EQ(noise_across(0.01, 1), 0.01);
  EXPECT_NEAR(noise_across(0.01, 0.5), 0.005, 1e-12);
  EXPECT_NEAR(noise_across(0.01, 0), 0.001, 1e-12);
}

TEST(SlantOf, IsNotKnownWhereThePositionOfSomePointIsNot) {
  Scene scene;
  scene.add(Vector(0, 0, 0), 0);
  scene.add(Vector(0, 1, 0), 0);
  const std::vector<std::uint32_t> both{0, 1}, first{0};
  EXPECT_FALSE(slant_of(scene.cloud, Vector::UnitZ(), both).has_value());
  EXPECT_TRUE(slants_of(scene.cloud, Vector::UnitZ(), both).empty());
  const std::vector<std::uint32_t> of_point{0, 1};  // 1 = none
  scene.cloud.sensors = SensorPositions({Vector(0, 0, 2)}, of_point);
  EXPECT_FALSE(slant_of(scene.cloud, Vector::UnitZ(), both).has_value());
  EXPECT_TRUE(slant_of(scene.cloud, Vector::UnitZ(), first).has_value());
  EXPECT_FALSE(slant_of(scene.cloud, Vector::UnitZ(), {}).has_value());
}

/// Two rooms of 4 m × 3 m side by side, with a wall 20 cm thick between them; a sensor in each.
Scene two_rooms() {
  Scene scene;
  Random random(4);
  std::vector<std::uint32_t> of_point;
  const auto add = [&](const Vector& corner, const Vector& a, const Vector& b, int plane, std::uint32_t sensor) {
    scene.add_rectangle(corner, a, b, 1500, 0.004, plane, random);
    of_point.resize(scene.cloud.size(), sensor);
  };
  for (const std::uint32_t room : {0U, 1U}) {
    const double x = room == 0 ? -4.1 : 0.1;
    const int first = 4 * static_cast<int>(room);
    add(Vector(x, 0, 0), Vector(4, 0, 0), Vector(0, 3, 0), first, room);        // floor
    add(Vector(x, 0, 2.5), Vector(4, 0, 0), Vector(0, 3, 0), first + 1, room);  // ceiling
    add(Vector(x, 0, 0), Vector(0, 3, 0), Vector(0, 0, 2.5), first + 2, room);  // walls across x
    add(Vector(x + 4, 0, 0), Vector(0, 3, 0), Vector(0, 0, 2.5), first + 3, room);
  }
  scene.cloud.sensors = SensorPositions({Vector(-2, 1.5, 1.3), Vector(2, 1.5, 1.3)}, of_point);
  return scene;
}

TEST(SensorPoses, TurnTheNormalsOfEachRoomIntoIt) {
  const Scene scene = two_rooms();
  const Perception found = perceive(scene.cloud);
  int walls = 0;
  for (const Plane& plane : found.planes) {
    if (plane.tilt_deg < 45) continue;
    ++walls;
    const double to_room = plane.centroid.x() < 0 ? -2 - plane.centroid.x() : 2 - plane.centroid.x();
    EXPECT_GT(plane.normal.x() * to_room, 0) << "wall at x = " << plane.centroid.x();
  }
  EXPECT_EQ(walls, 4);
  for (const Plane& plane : found.planes) {
    if (plane.tilt_deg < 45 && plane.height > 2) {
      EXPECT_LT(plane.facing_up, -0.99) << "a ceiling is seen from below";
    }
  }
}

TEST(SensorPoses, AFewPlacedWrongDoNotHideTheFloor) {
  Scene scene = two_rooms();
  std::vector<std::uint32_t> of_point(scene.cloud.size(), 0);
  for (std::size_t i = 0; i < of_point.size(); i += 5) of_point[i] = 1;
  scene.cloud.sensors = SensorPositions({Vector(0, 1.5, 1.3), Vector(0, 0, -2)}, of_point);
  const Perception found = perceive(scene.cloud);
  EXPECT_TRUE(found.upright.floor_found);
  EXPECT_NEAR(found.upright.floor_z, 0, 0.01);
}

}  // namespace
}  // namespace scenelore::perception
