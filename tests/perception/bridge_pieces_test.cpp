// Pieces of one table on both sides of a shadow, by what the sensor saw between them.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "bridge_pieces.hpp"
#include "merge.hpp"
#include "planar_scenes.hpp"
#include "scenelore/perception/segment.hpp"
#include "voxelise.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;
using testing::Scene;
using Vector = Eigen::Vector3d;

const Vector kEye(0.2, -2.0, 1.5);
constexpr double kTop = 0.74;

/// Two pieces of a level surface, 0 and 1, over a floor, 2, as the eye sees them. Between them is a gap: seen through (the floor shows
/// there), or in the shadow of something.
struct Pieces {
  double from_second = 1.1, to_second = 1.7;  ///< metres along x; the first piece goes from 0 to 0.6
  double raised = 0;                          ///< metres, the second over the first
  double behind = 0;                          ///< metres along y, the second behind the first
  bool seen_through = false;
};

bool is_on(const Pieces& pieces, const Vector& p, int piece) {
  const double from = piece == 0 ? 0 : pieces.from_second, to = piece == 0 ? 0.6 : pieces.to_second, y = piece == 0 ? 0 : pieces.behind;
  return p.x() > from && p.x() < to && p.y() > y && p.y() < y + 0.8;
}

Scene scene_of(const Pieces& pieces) {
  Scene scene;
  Random random(5);
  scene.cloud.sensors = SensorPositions(kEye);
  for (int i = 0; i < 80'000; ++i) {
    const Vector floor(random.uniform(-1.5, 6), random.uniform(-1.5, 4), 0);
    const auto crossing = [&](double z) { return Vector(kEye + (z - kEye.z()) / -kEye.z() * (floor - kEye)); };
    const double noise = 0.004 * random.normal();
    const Vector first = crossing(kTop), second = crossing(kTop + pieces.raised);
    if (is_on(pieces, first, 0)) scene.add(first + noise * Vector::UnitZ(), 0);
    else if (is_on(pieces, second, 1)) scene.add(second + noise * Vector::UnitZ(), 1);
    else if (pieces.seen_through || first.x() < 0 || first.x() > pieces.to_second || first.y() < 0) scene.add(floor + noise * Vector::UnitZ(), 2);
  }
  return scene;
}

const Limits kLimits{.max_point_distance = 1.6, .max_plane_distance = 0.03, .max_mse = 1e-4, .min_points = 20, .max_neighbours = 30, .small_plane_step = 0.3};

/// Whether the pieces 0 and 1, each a region of its own as what lies behind them is, are found to be one; `noise` in metres.
bool bridged(const Scene& scene, double noise = 0.004, const Limits& limits = kLimits) {
  Regions regions;
  for (const int truth : scene.truth) regions.of_point.push_back(truth);
  regions.planes.resize(3);
  refit(scene.cloud, regions);
  const auto into = bridge_pieces(scene.cloud, Vector::UnitZ(), limits, {noise, noise, noise}, regions);
  EXPECT_EQ(into[2], 2) << "what lies behind is another surface";
  return into[0] == into[1];
}

TEST(BridgePieces, JoinsWhatOnlyAShadowParts) { EXPECT_TRUE(bridged(scene_of({}))); }

TEST(BridgePieces, LeavesApartWhatWasSeenThrough) {
  EXPECT_FALSE(bridged(scene_of({.seen_through = true})));
  EXPECT_FALSE(bridged(scene_of({.from_second = 0.72, .to_second = 1.3, .seen_through = true}))) << "too narrow for the rectangle to mind";
}

TEST(BridgePieces, LeavesApartWhatIsNotInOnePlane) { EXPECT_FALSE(bridged(scene_of({.raised = 0.015}))); }

TEST(BridgePieces, LeavesApartWhatOneTableWouldBeTooLongFor) {
  EXPECT_TRUE(bridged(scene_of({.from_second = 1.2, .to_second = 2.2})));
  EXPECT_FALSE(bridged(scene_of({.from_second = 1.2, .to_second = 2.8})));
}

TEST(BridgePieces, LeavesApartWhatTheUserWantsConnectedMoreClosely) {
  Limits limits = kLimits;
  limits.max_point_distance = limits.small_plane_step = 0.2;
  EXPECT_FALSE(bridged(scene_of({}), 0.004, limits));
}

TEST(BridgePieces, KnowsOfNoShadowsWithoutASensor) {
  Scene scene = scene_of({});
  scene.cloud.sensors = SensorPositions();
  EXPECT_FALSE(bridged(scene));
}

/// Two pieces of an upright surface at y = 0, 0 and 1, with a gap between x = 0.6 and 1.1, over a wall half a metre behind it, 2, as an eye before
/// them sees them.
struct Fronts {
  double off = 0;      ///< metres along y, the second before the first
  double length = 0.6; ///< metres, of the second
  bool seen_through = false;
};

bool one_front(const Fronts& fronts) {
  constexpr double kNoise = 0.006;
  const Vector eye(0.8, -2.5, 1.2);
  Scene scene;
  Random random(7);
  scene.cloud.sensors = SensorPositions(eye);
  const double end = 1.1 + fronts.length;
  for (int i = 0; i < 60'000; ++i) {
    const Vector wall(random.uniform(-1.5, end + 1.5), 0.5, random.uniform(0, 2.5));
    const auto crossing = [&](double y) { return Vector(eye + (y - eye.y()) / (wall.y() - eye.y()) * (wall - eye)); };
    const Vector first = crossing(0), second = crossing(-fronts.off);
    const bool high = first.z() > 0.2 && first.z() < 1.4;
    const Vector noise = kNoise * random.normal() * (wall - eye).normalized();
    if (high && first.x() > 0 && first.x() < 0.6) scene.add(first + noise, 0);
    else if (high && second.x() > 1.1 && second.x() < end) scene.add(second + noise, 1);
    else if (fronts.seen_through || first.x() < 0 || first.x() > 1.1 || !high) scene.add(wall + noise, 2);
  }
  return bridged(scene, kNoise);
}

TEST(BridgePieces, JoinsFrontsThatOnlyAShadowParts) {
  EXPECT_TRUE(one_front({}));
  EXPECT_FALSE(one_front({.seen_through = true}));
}

TEST(BridgePieces, LeavesAPictureOffItsWall) { EXPECT_FALSE(one_front({.off = 0.006})); }

TEST(BridgePieces, JoinsFrontsOfAnyLength) { EXPECT_TRUE(one_front({.length = 2})); }

/// The planes that hold most points of what is 0 and 1 in truth.
std::set<std::int32_t> main_planes(const Scene& scene, const std::vector<std::int32_t>& plane_of_point) {
  std::set<std::int32_t> planes;
  for (const int truth : {0, 1}) {
    std::map<std::int32_t, int> count;
    for (std::size_t i = 0; i < scene.truth.size(); ++i) count[plane_of_point[i]] += scene.truth[i] == truth;
    planes.insert(std::max_element(count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first);
  }
  return planes;
}

TEST(BridgePieces, SegmentationKeepsTheTableWhole) {
  const Scene shadow = scene_of({}), gap = scene_of({.seen_through = true});
  const auto one = main_planes(shadow, segment(shadow.cloud).plane_of_point), two = main_planes(gap, segment(gap.cloud).plane_of_point);
  EXPECT_EQ(one.size(), 1u);
  EXPECT_FALSE(one.contains(-1));
  EXPECT_EQ(two.size(), 2u);
}

/// Planes that are left of two desks in a corner, 2.25 m² but spread over more than 2.5, or of a floor of 2.7 m² in their place, and of a table of the
/// same height two metres away.
std::size_t left_of_two(bool corner) {
  Scene scene;
  Random random(6);
  if (corner) {
    scene.add_rectangle(Vector(0, 0, kTop), Vector(1.8, 0, 0), Vector(0, 0.7, 0), 1500, 0.002, 0, random);
    scene.add_rectangle(Vector(0, 0.7, kTop), Vector(0.7, 0, 0), Vector(0, 1.4, 0), 1500, 0.002, 0, random);
  } else {
    scene.add_rectangle(Vector(0, 0, kTop), Vector(1.8, 0, 0), Vector(0, 1.5, 0), 1500, 0.002, 0, random);
  }
  scene.add_rectangle(Vector(3.8, 0, kTop), Vector(1.2, 0, 0), Vector(0, 0.8, 0), 1500, 0.002, 1, random);
  const VoxelisedCloud voxels = voxelise(scene.cloud, 0.05, 1);
  std::vector<std::int32_t> region_of_voxel;
  for (std::size_t v = 0; v < voxels.grid.count(); ++v) region_of_voxel.push_back(voxels.grid.center(v).x() + scene.cloud.origin.x() < 2.8 ? 0 : 1);
  Slots slots = slots_of_voxels(voxels.grid, region_of_voxel);
  std::vector<PlaneFit> planes(2);
  refit(slots, planes);
  EXPECT_GT(planes[0].spread_area(), kLargePlane);
  bridge_shadows(0.005, kLargePlane, 0.05, slots, planes);
  return static_cast<std::size_t>(std::count_if(planes.begin(), planes.end(), [](const PlaneFit& p) { return p.count > 0; }));
}

TEST(BridgeShadows, GoesOnFromAFloorButNotFromDesksInACorner) {
  EXPECT_EQ(left_of_two(false), 1U);
  EXPECT_EQ(left_of_two(true), 2U);
}

}  // namespace
}  // namespace scenelore::perception
