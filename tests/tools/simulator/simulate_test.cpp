// Whole scans: what the columns and the ground truth promise.
#include "simulator/simulate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "scenelore/perception/cloud.hpp"

namespace scenelore::simulator {
namespace {

struct Row {
  Eigen::Vector3d point;
  int label, instance;
};

std::vector<Row> rows_of(const SimulatedScan& scan) {
  const perception::PointTable& table = scan.points;
  const auto column = [&](const char* name) { return *table.find(name); };
  const auto x = column("x"), y = column("y"), z = column("z"), label = column("label"), instance = column("instance");
  std::vector<Row> rows;
  for (std::size_t i = 0; i < table.rows; ++i) {
    rows.push_back({{table.value(x, i), table.value(y, i), table.value(z, i)},
                    static_cast<int>(table.value(label, i)),
                    static_cast<int>(table.value(instance, i))});
  }
  return rows;
}

constexpr std::size_t kFew = 40'000;  // points; enough for what these tests ask

TEST(Simulate, SameOptionsGiveTheSameBytesAndOtherSeedsOthers) {
  const SimulatedScan a = simulate({.seed = 3, .points = kFew}), b = simulate({.seed = 3, .points = kFew}),
                      c = simulate({.seed = 4, .points = kFew});
  EXPECT_EQ(a.points.bytes, b.points.bytes);
  EXPECT_NE(a.points.bytes, c.points.bytes);
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) EXPECT_EQ(a.objects[i].centroid, b.objects[i].centroid);
}

TEST(Simulate, NoiseDoesNotChangeTheRoom) {
  const SimulatedScan a = simulate({.seed = 3, .noise = 0.0, .points = kFew}),
                      b = simulate({.seed = 3, .noise = 0.02, .points = kFew});
  ASSERT_EQ(a.objects.size(), b.objects.size());
  for (std::size_t i = 0; i < a.objects.size(); ++i) EXPECT_EQ(a.objects[i].thing, b.objects[i].thing);
}

TEST(Simulate, PointsOfAPlanarObjectLieOnItsPlane) {
  // Of thin panels the rear counts too, and of windows the pane behind the bars.
  const std::map<std::string, double> thickness{{"flat_screen", 0.05}, {"chair_back", 0.05}, {"door", 0.05},
                                                {"window", 0.02},      {"shelf", 0.03},      {"cabinet", 0.03},
                                                {"unknown", 0.04}};
  for (std::uint64_t seed = 10; seed < 14; ++seed) {
    const SimulatedScan scan = simulate({.seed = seed, .noise = 0, .points = kFew, .tilt_deg = seed == 12 ? 8.0 : 0.0});
    for (const Row& row : rows_of(scan)) {
      if (row.instance == 0) continue;
      const TruthObject& object = scan.objects[static_cast<std::size_t>(row.instance) - 1];
      if (!object.planar) continue;
      const auto slack = thickness.find(object.object_class);
      const double off = std::abs(object.normal.dot(row.point - object.centroid));
      ASSERT_LE(off, (slack == thickness.end() ? 0 : slack->second) + 1e-5)
          << object.thing << " (" << object.object_class << "), seed " << seed;
    }
  }
}

TEST(Simulate, CountsAndColumnsAgreeWithTheObjects) {
  static const char* const names[] = {"unknown",     "floor",      "ceiling",    "wall",       "table",
                                      "flat_screen", "keyboard",   "chair_seat", "chair_back", "door",
                                      "window",      "whiteboard", "shelf",      "cabinet"};
  const SimulatedScan scan = simulate({.seed = 6, .points = kFew});
  std::vector<std::size_t> counts(scan.objects.size() + 1, 0);
  for (const Row& row : rows_of(scan)) {
    ASSERT_TRUE(row.point.allFinite());
    ASSERT_GE(row.instance, 0);
    ASSERT_LE(row.instance, static_cast<int>(scan.objects.size()));
    ++counts[static_cast<std::size_t>(row.instance)];
    if (row.instance == 0) {
      ASSERT_EQ(row.label, 0);
    } else {
      ASSERT_EQ(names[row.label], scan.objects[static_cast<std::size_t>(row.instance) - 1].object_class);
    }
  }
  EXPECT_GT(counts[0], 0U) << "there are mixed pixels";
  for (const TruthObject& object : scan.objects) {
    EXPECT_EQ(counts[static_cast<std::size_t>(object.instance)], object.points) << object.thing;
    EXPECT_GT(object.area_m2, 0) << object.thing;
    EXPECT_NEAR(object.normal.norm(), object.planar ? 1 : 0, 1e-9) << object.thing;
  }
}

TEST(Simulate, FloorIsAtZeroAndTheSensorAboveTheOrigin) {
  const SimulatedScan scan = simulate({.seed = 8, .points = kFew});
  ASSERT_TRUE(scan.points.viewpoint.has_value());
  EXPECT_NEAR(scan.points.viewpoint->x(), 0, 1e-9);
  EXPECT_NEAR(scan.points.viewpoint->y(), 0, 1e-9);
  EXPECT_GE(scan.points.viewpoint->z(), 1.1);
  EXPECT_LE(scan.points.viewpoint->z(), 1.5);
  for (const TruthObject& object : scan.objects) {
    if (object.object_class != "floor") continue;
    EXPECT_NEAR(object.centroid.z(), 0, 1e-9);
  }
}

TEST(Simulate, SaysOfSeveralPosesWhereEachPointWasMeasuredFrom) {
  const SimulatedScan one = simulate({.seed = 8}), two = simulate({.seed = 8, .poses = 2});
  EXPECT_EQ(one.points.find("vp_x"), nullptr) << "one pose is told once";
  EXPECT_FALSE(two.points.viewpoint.has_value());
  const perception::Cloud alone = perception::to_cloud(one.points, "one"), joined = perception::to_cloud(two.points, "two");
  ASSERT_EQ(joined.sensors.positions().size(), 2U);
  EXPECT_NEAR((joined.sensors.positions()[0] - *one.points.viewpoint).norm(), 0, 1e-6);
  EXPECT_GT((joined.sensors.positions()[1] - joined.sensors.positions()[0]).norm(), 0.1);
  ASSERT_GT(joined.size(), alone.size());
  for (std::size_t i = 0; i < joined.size(); ++i) {
    ASSERT_EQ(joined.sensors.of_point(i), i < alone.size() ? 0U : 1U);
    if (i < alone.size()) {
      ASSERT_EQ(joined.offset(i), alone.offset(i)) << "the first pose is that of the scan from one";
    }
  }
}

TEST(Simulate, TiltTurnsTheWholeCloud) {
  const SimulatedScan scan = simulate({.seed = 8, .points = kFew, .tilt_deg = 10});
  for (const TruthObject& object : scan.objects) {
    if (object.object_class != "floor" && object.object_class != "table") continue;
    EXPECT_NEAR(object.normal.z(), std::cos(10 * 3.14159265358979 / 180), 1e-9);
  }
}

TEST(Simulate, NumberOfPointsIsNearTheOneWanted) {
  for (const std::size_t wanted : {std::size_t{20'000}, std::size_t{300'000}}) {
    for (const int poses : {1, 3}) {
      const double got = static_cast<double>(simulate({.seed = 9, .poses = poses, .points = wanted}).points.rows);
      EXPECT_NEAR(got / static_cast<double>(wanted), 1, 0.05) << wanted << " points, poses: " << poses;
    }
  }
}

TEST(Simulate, DefaultScanIsOfTheUsualSize) {
  const SimulatedScan scan = simulate({.seed = 2});
  EXPECT_GT(scan.points.rows, 200'000U);
  EXPECT_LT(scan.points.rows, 500'000U);
}

TEST(Simulate, FloorWallsAndSomeFurnitureShowInEveryRoom) {
  std::map<std::string, int> rooms_showing;
  constexpr int rooms = 12;
  for (std::uint64_t seed = 1; seed <= rooms; ++seed) {
    std::set<std::string> seen;
    for (const TruthObject& object : simulate({.seed = seed, .points = kFew}).objects) {
      if (object.points >= 20) seen.insert(object.object_class);
    }
    for (const std::string& name : seen) ++rooms_showing[name];
  }
  for (const char* name : {"floor", "ceiling", "wall", "table", "unknown"})
    EXPECT_EQ(rooms_showing[name], rooms) << name;
  for (const char* name : {"chair_seat", "door", "window", "flat_screen", "shelf", "cabinet"})
    EXPECT_GT(rooms_showing[name], rooms / 4) << name;
}

TEST(Simulate, BiasMovesObjectsApart) {
  const auto floor_error = [](double bias) {
    const SimulatedScan scan = simulate({.seed = 8, .noise = 0, .material_bias = bias, .points = kFew});
    double worst = 0;
    for (const Row& row : rows_of(scan)) {
      if (row.label == 1) worst = std::max(worst, std::abs(row.point.z()));
    }
    return worst;
  };
  EXPECT_LT(floor_error(0), 1e-5);
  EXPECT_GT(floor_error(0.05), 1e-3);
}

TEST(Simulate, DepthCameraLooksAtADeskWithClutter) {
  const SimulatedScan scan = simulate({.seed = 2, .sensor = Sensor::depth_camera});
  EXPECT_GT(scan.points.rows, 100'000U);
  EXPECT_LE(scan.points.rows, 640U * 480U);
  std::size_t table = 0;
  for (const TruthObject& object : scan.objects) table += object.object_class == "table" ? object.points : 0;
  EXPECT_GT(table, 1000U);
}

TEST(Simulate, RefusesOptionsThatMakeNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)simulate({.noise = -0.01}), std::invalid_argument);
  EXPECT_THROW((void)simulate({.noise = nan}), std::invalid_argument);
  EXPECT_THROW((void)simulate({.material_bias = nan}), std::invalid_argument);
  EXPECT_THROW((void)simulate({.poses = 0}), std::invalid_argument);
  EXPECT_THROW((void)simulate({.poses = 9}), std::invalid_argument);
  EXPECT_THROW((void)simulate({.points = 100'000'000}), std::invalid_argument);
  EXPECT_THROW((void)simulate({.tilt_deg = nan}), std::invalid_argument);
}

}  // namespace
}  // namespace scenelore::simulator
