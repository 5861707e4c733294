// Things of one plane are told apart by what the sensor saw between them.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "part_gaps.hpp"
#include "planar_scenes.hpp"

namespace scenelore::perception {
namespace {

using testing::best_overlaps;
using testing::Random;
using testing::Scene;
using Vector = Eigen::Vector3d;

constexpr double kTop = 0.74, kThings = 0.77, kGap = 0.16;  // metres: a desk, the height of what lies on it, between two things
const Vector kEye(0.3, -1.2, 1.5);

struct Box {
  double x0, x1, y0, y1;
  [[nodiscard]] bool holds(const Vector& p) const { return p.x() > x0 && p.x() < x1 && p.y() > y0 && p.y() < y1; }
};
const Box kFirst{0, 0.3, 0, 0.2}, kSecond{0.3 + kGap, 0.7 + kGap, 0, 0.2};

/// Two things at one height over a desk, as seen from the eye: what lies in the shadow of a thing is missing. Without
/// `desk_between`, so is everything that was seen between them.
Scene two_things(bool desk_between, const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity()) {
  Scene scene;
  Random random(3);
  const auto add = [&](const Vector& p, int plane) { scene.add(motion * (p + 0.003 * random.normal() * Vector::UnitZ()), plane); };
  for (int i = 0; i < 12'000; ++i) {
    const Vector desk(random.uniform(-0.3, 1.2), random.uniform(-0.3, 0.5), kTop);
    const Vector above = kEye + (kThings - kEye.z()) / (kTop - kEye.z()) * (desk - kEye);
    const bool between = Box{kFirst.x1, kSecond.x0, -0.05, 0.25}.holds(above);
    if (!kFirst.holds(above) && !kSecond.holds(above) && (desk_between || !between)) add(desk, 2);
    const Vector thing(random.uniform(0, 0.7 + kGap), random.uniform(0, 0.2), kThings);
    if (i % 6 == 0 && (kFirst.holds(thing) || kSecond.holds(thing))) add(thing, kFirst.holds(thing) ? 0 : 1);
  }
  scene.cloud.sensors = SensorPositions(Vector(motion * kEye));
  return scene;
}

/// One plane of all that is no desk.
Regions joined_things(const Scene& scene) {
  Regions regions;
  for (const int truth : scene.truth) regions.of_point.push_back(truth == 2 ? -1 : 0);
  regions.planes.resize(1);
  refit(scene.cloud, regions);
  return regions;
}

const Limits kLimits{.max_point_distance = 1, .max_plane_distance = 0.03, .max_mse = 1e-4, .min_points = 20, .max_neighbours = 30, .small_plane_step = 0.3};

TEST(PartAtGaps, PartsTwoThingsWithTheDeskSeenBetween) {
  for (double turn = 0; turn < 6; turn += 0.7) {
    const Eigen::Isometry3d motion = Eigen::Translation3d(turn, -2, 0.1) * Eigen::AngleAxisd(turn, Vector(0.2, -0.1, 1).normalized());
    const Scene scene = two_things(true, motion);
    Regions regions = joined_things(scene);
    part_at_gaps(scene.cloud, kLimits, regions);
    ASSERT_EQ(regions.planes.size(), 2u) << "turned by " << turn;
    EXPECT_EQ(best_overlaps(scene, regions.of_point, 3), (std::vector<double>{1, 1, 0})) << "turned by " << turn;
    EXPECT_NEAR(regions.planes[0].count + regions.planes[1].count, static_cast<double>(std::count_if(scene.truth.begin(), scene.truth.end(), [](int t) { return t < 2; })), 1e-9);
  }
}

TEST(PartAtGaps, LeavesWhatNobodyLookedBetweenWhole) {
  const Scene scene = two_things(false);
  Regions regions = joined_things(scene);
  part_at_gaps(scene.cloud, kLimits, regions);
  EXPECT_EQ(regions.planes.size(), 1u);
}

TEST(PartAtGaps, LeavesCloudsWithoutASensorAsTheyAre) {
  Scene scene = two_things(true);
  scene.cloud.sensors = SensorPositions();
  Regions regions = joined_things(scene);
  const std::vector<std::int32_t> before = regions.of_point;
  part_at_gaps(scene.cloud, kLimits, regions);
  EXPECT_EQ(regions.planes.size(), 1u);
  EXPECT_EQ(regions.of_point, before);
}

TEST(PartAtGaps, GivesStraysToTheNearestThing) {
  Scene scene = two_things(true);
  // A crumb in the gap, by the second thing.
  for (int k = 0; k < 3; ++k) scene.add(Vector(kSecond.x0 - 0.06, 0.1 + 0.001 * k, kThings), 1);
  Regions regions = joined_things(scene);
  part_at_gaps(scene.cloud, kLimits, regions);
  ASSERT_EQ(regions.planes.size(), 2u);
  EXPECT_EQ(best_overlaps(scene, regions.of_point, 3), (std::vector<double>{1, 1, 0}));
}

TEST(PartAtGaps, TakesNothing) {
  Scene scene = two_things(true);
  Regions regions;
  regions.of_point.assign(scene.cloud.size(), -1);
  part_at_gaps(scene.cloud, kLimits, regions);
  EXPECT_TRUE(regions.planes.empty());
}

}  // namespace
}  // namespace scenelore::perception
