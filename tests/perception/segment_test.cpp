#include "scenelore/perception/segment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "planar_scenes.hpp"
#include "promise_checks.hpp"
#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

using testing::best_overlaps;
using testing::expect_promises;
using testing::Random;
using testing::room;
using testing::Scene;
using Vector = Eigen::Vector3d;

constexpr int kRoomPlanes = 7;

void expect_room(const Scene& scene, const Segmentation& s, double overlap) {
  const std::vector<double> best = best_overlaps(scene, s.plane_of_point, kRoomPlanes);
  for (int plane = 0; plane < kRoomPlanes; ++plane) EXPECT_GT(best[static_cast<std::size_t>(plane)], overlap) << "plane " << plane;
  EXPECT_EQ(s.planes.size(), static_cast<std::size_t>(kRoomPlanes));
}

TEST(Segment, FindsThePlanesOfARoomAndNothingElse) {
  const Scene scene = room(0.005);
  const Segmentation s = segment(scene.cloud);
  expect_room(scene, s, 0.93);
  expect_promises(scene.cloud, s.parameters, s.plane_of_point);
  EXPECT_NEAR(s.noise, 0.005, 0.002);
}

TEST(Segment, FindsThePlanesOfARoomAtOneCentimetreOfNoise) {
  const Scene scene = room(0.01);
  const Segmentation s = segment(scene.cloud);
  expect_room(scene, s, 0.88);
  expect_promises(scene.cloud, s.parameters, s.plane_of_point);
}

TEST(Segment, FindsExactPlanesOnVoxelFaces) {
  const Scene scene = room(0);  // floor, ceiling and walls lie on multiples of every voxel size
  const Segmentation s = segment(scene.cloud);
  expect_room(scene, s, 0.95);
  expect_promises(scene.cloud, s.parameters, s.plane_of_point);
}

TEST(Segment, GivesTheSamePlanesForARoomShiftedAndTurnedInSmallSteps) {
  const Scene scene = room(0.004, 1500);
  for (int step = 0; step < 8; ++step) {
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.translate(Vector(0.007, 0.011, 0.013) * step);
    motion.rotate(Eigen::AngleAxisd(0.09 * step, Vector(0.02 * step, 0.01, 1).normalized()));
    const Scene moved = scene.moved(motion);
    SCOPED_TRACE(step);
    expect_room(moved, segment(moved.cloud), 0.9);
  }
}

TEST(Segment, DoesNotDependOnTheNumberOfThreads) {
  const Scene scene = room(0.008);
  const Segmentation one = segment(scene.cloud, {}, 1);
  for (const int threads : {2, 4}) EXPECT_EQ(one.plane_of_point, segment(scene.cloud, {}, threads).plane_of_point);
}

TEST(Segment, HardlyDependsOnTheOrderOfPoints) {
  const Scene scene = room(0.008);
  std::vector<std::size_t> order(scene.cloud.size());
  std::iota(order.begin(), order.end(), 0);
  Random random(3);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
  Scene shuffled;
  for (const std::size_t i : order) shuffled.add(scene.cloud.position(i), scene.truth[i]);
  const Segmentation a = segment(scene.cloud), b = segment(shuffled.cloud);
  ASSERT_EQ(a.planes.size(), b.planes.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < order.size(); ++i) different += b.plane_of_point[i] != a.plane_of_point[order[i]];
  EXPECT_LT(different, order.size() / 1000);
}

TEST(Segment, KeepsPrecisionFarFromTheOrigin) {
  const Scene scene = room(0.005);
  Scene far;
  far.cloud.origin = Vector(1e6, -2e6, 500);
  for (std::size_t i = 0; i < scene.cloud.size(); ++i) far.add(far.cloud.origin + scene.cloud.position(i), scene.truth[i]);
  expect_room(far, segment(far.cloud), 0.93);
}

TEST(Segment, TakesSparseAndDensePartsOfOnePlaneTogether) {
  Scene scene;
  Random random(5);
  scene.add_rectangle(Vector(0, 0, 0), Vector(3, 0, 0), Vector(0, 3, 0), 4000, 0.005, 0, random);
  scene.add_rectangle(Vector(3, 0, 0), Vector(4, 0, 0), Vector(0, 3, 0), 60, 0.005, 0, random);
  const Segmentation s = segment(scene.cloud);
  ASSERT_EQ(s.planes.size(), 1U);
  EXPECT_GT(best_overlaps(scene, s.plane_of_point, 1)[0], 0.97);
}

TEST(Segment, SeparatesABoardFromTheWallBehindIt) {
  Scene scene;
  Random random(6);
  scene.cloud.sensors = SensorPositions(Vector(2, 3, 1.2));
  scene.add_rectangle(Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 0, 2.5), 3000, 0.006, 0, random);
  scene.add_rectangle(Vector(1, 0.03, 1), Vector(1.5, 0, 0), Vector(0, 0, 1), 6000, 0.006, 1, random);
  const Segmentation s = segment(scene.cloud);
  expect_promises(scene.cloud, s.parameters, s.plane_of_point);
  EXPECT_GT(best_overlaps(scene, s.plane_of_point, 2)[1], 0.5);
}

TEST(Segment, KeepsADeskOfWhichShadowsLeaveTheRim) {
  Scene scene;
  Random random(7);
  scene.add_rectangle(Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 3, 0), 1500, 0.005, 0, random);
  const auto strip = [&](double x, double y, double length, double width) {
    scene.add_rectangle(Vector(x, y, 0.74), Vector(length, 0, 0), Vector(0, width, 0), 3000, 0.004, 1, random);
  };
  strip(1, 1, 1.4, 0.18), strip(1, 1.72, 1.4, 0.18), strip(1, 1.18, 0.18, 0.54), strip(2.22, 1.18, 0.18, 0.54);
  EXPECT_GT(best_overlaps(scene, segment(scene.cloud).plane_of_point, 2)[1], 0.8);
}

TEST(Segment, TakesStripsOf9CentimetresForPlanesAndOf5ForRims) {
  const auto overlap = [](double width) {
    Scene scene;
    Random random(9);
    scene.add_rectangle(Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 3, 0), 3000, 0.003, 0, random);
    scene.add_rectangle(Vector(1, 1, 0.7), Vector(1, 0, 0), Vector(0, 0, width), 6000, 0.003, 1, random);
    return best_overlaps(scene, segment(scene.cloud).plane_of_point, 2)[1];
  };
  EXPECT_GT(overlap(0.095), 0.8);
  EXPECT_EQ(overlap(0.05), 0);
}

/// A wall of 4 m × 2.5 m with a board on it that hides what is behind, and the floor and ceiling before it.
Scene wall_with_board(double offset, double noise, const Vector& size) {
  Scene scene;
  Random random(8);
  const Vector corner(0.5, offset, 1);
  scene.add_rectangle(corner, Vector(size.x(), 0, 0), Vector(0, 0, size.z()), 3000, noise, 1, random);
  Scene wall;
  wall.add_rectangle(Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 0, 2.5), 3000, noise, 0, random);
  for (std::size_t i = 0; i < wall.cloud.size(); ++i) {
    const Vector p = wall.cloud.position(i) - corner;
    if (!(p.x() > 0 && p.x() < size.x() && p.z() > 0 && p.z() < size.z())) scene.add(wall.cloud.position(i), 0);
  }
  scene.add_rectangle(Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 3, 0), 800, noise, 2, random);
  scene.add_rectangle(Vector(0, 0, 2.5), Vector(4, 0, 0), Vector(0, 3, 0), 800, noise, 3, random);
  return scene;
}

TEST(Segment, FindsABoardThatHangsCloserToItsWallThanPointsScatter) {
  // Points go to the nearer plane: at 1.67 deviations between the two a fifth of each ends up on the other, so that no
  // assignment by distance reaches more than 0.67 for planes with equally many points.
  for (const bool known : {true, false}) {
    Scene scene = wall_with_board(0.015, 0.009, Vector(1.8, 0, 1.1));
    if (known) scene.cloud.sensors = SensorPositions(Vector(2, 2.5, 1.2));
    const std::vector<double> overlap = best_overlaps(scene, segment(scene.cloud).plane_of_point, 4);
    EXPECT_GT(overlap[0], 0.7) << "wall, sensor known: " << known;
    EXPECT_GT(overlap[1], 0.6) << "board, sensor known: " << known;
  }
}

TEST(Segment, DoesNotInventBoardsOnANoisyWall) {
  Scene scene;
  Random random(7);
  scene.cloud.sensors = SensorPositions(Vector(2, 3, 1.2));
  scene.add_rectangle(Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 0, 2.5), 6000, 0.02, 0, random);
  EXPECT_EQ(segment(scene.cloud).planes.size(), 1U);
}

TEST(Segment, FindsAKeyboardOnADesk) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Scene scene;
    Random random(seed);
    scene.add_rectangle(Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 3, 0), 1500, 0.004, 0, random);
    scene.add_rectangle(Vector(1, 1, 0.74), Vector(1.6, 0, 0), Vector(0, 0.8, 0), 1500, 0.003, 1, random);
    scene.add_rectangle(Vector(1.5, 1.2, 0.762), Vector(0.45, 0, 0), Vector(0, 0.15, 0), 1500, 0.003, 2, random);
    // The desk does not shine through.
    Scene seen;
    for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
      const Vector p = scene.cloud.position(i);
      const bool below = scene.truth[i] == 1 && p.x() > 1.5 && p.x() < 1.95 && p.y() > 1.2 && p.y() < 1.35;
      if (!below) seen.add(p, scene.truth[i]);
    }
    const Segmentation s = segment(seen.cloud);
    const std::vector<double> best = best_overlaps(seen, s.plane_of_point, 3);
    EXPECT_GT(best[2], 0.6) << "seed " << seed;
    EXPECT_GT(best[1], 0.9) << "seed " << seed;
    expect_promises(seen.cloud, s.parameters, s.plane_of_point);
  }
}

/// A floor that rays graze, which therefore scatters by millimetres, and walls that scatter by a centimetre.
Scene noisy_walls(std::uint64_t seed) {
  Scene scene;
  Random random(seed);
  scene.add_rectangle(Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 3, 0), 1500, 0.004, 0, random);
  scene.add_rectangle(Vector(0, 0, 0), Vector(4, 0, 0), Vector(0, 0, 2.5), 1500, 0.011, 1, random);
  scene.add_rectangle(Vector(0, 0, 0), Vector(0, 3, 0), Vector(0, 0, 2.5), 1500, 0.011, 2, random);
  return scene;
}

TEST(Segment, KeepsThingsOfTwoHeightsApartBesideNoisyWalls) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Scene scene = noisy_walls(seed);
    Random random(seed + 100);
    // One plane is within a centimetre or so of both: as near as the walls' points are to the walls, and not these. They slope,
    // so that nothing is taken for a support with things on it.
    const Vector down(0, 0.4, -0.2), off = Vector(0, 0.2, 0.4).normalized();
    scene.add_rectangle(Vector(1, 1, 0.9), Vector(0.5, 0, 0), down, 2500, 0.004, 3, random);
    scene.add_rectangle(Vector(1.52, 1, 0.9) + 0.03 * off, Vector(0.5, 0, 0), down, 2500, 0.004, 4, random);
    const std::vector<double> best = best_overlaps(scene, segment(scene.cloud).plane_of_point, 5);
    EXPECT_GT(best[3], 0.7) << "seed " << seed;
    EXPECT_GT(best[4], 0.7) << "seed " << seed;
  }
}

// Depth in steps makes small exact planes across the line of sight where a noisy surface runs through a step.
TEST(Segment, TakesSmallExactPlanesForStepsOfRoundingUnlessAllIsExact) {
  const auto planes_with = [](double noise, const Eigen::Vector3d& side) {
    Scene scene = room(noise);
    Random random(3);
    scene.add_rectangle({1.5, 1.5, 1.4}, side, {0, 0, side.y()}, 2500, 0, 7, random);
    const Segmentation found = segment(scene.cloud);
    std::map<int, int> owner;
    for (std::size_t i = 0; i < scene.truth.size(); ++i) {
      if (scene.truth[i] == 7) ++owner[found.plane_of_point[i]];
    }
    return std::max_element(owner.begin(), owner.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first;
  };
  EXPECT_EQ(planes_with(0.01, {0, 0.4, 0}), -1);
  EXPECT_GE(planes_with(0.01, {0, 0.9, 0}), 0) << "a surface that stands across the line of sight";
  EXPECT_GE(planes_with(0, {0, 0.4, 0}), 0) << "all is exact";
}

TEST(Segment, DoesNotTakeABallForAPlane) {
  Scene scene;
  Random random(8);
  for (int i = 0; i < 20000; ++i) {
    const Vector d(random.normal(), random.normal(), random.normal());
    scene.add(0.25 * d.normalized() + Vector(0, 0, 1), -1);
  }
  const Segmentation s = segment(scene.cloud);
  expect_promises(scene.cloud, s.parameters, s.plane_of_point);
  for (const PlaneFit& plane : s.planes) EXPECT_LT(plane.spread_area(), 0.06);
}

TEST(Segment, KeepsToTheParametersGiven) {
  const Scene scene = room(0.01);
  SegmentationParameters p;
  p.max_point_distance = 0.08;
  p.max_plane_distance = 0.015;
  p.max_mse = 0.00006;
  p.min_points = 400;
  p.max_neighbours = 12;
  const Segmentation s = segment(scene.cloud, p);
  EXPECT_EQ(s.parameters.max_point_distance, p.max_point_distance);
  EXPECT_EQ(s.parameters.max_plane_distance, p.max_plane_distance);
  EXPECT_EQ(s.parameters.max_mse, p.max_mse);
  EXPECT_EQ(s.parameters.min_points, p.min_points);
  EXPECT_EQ(s.parameters.max_neighbours, p.max_neighbours);
  EXPECT_GE(s.planes.size(), 5U);
  expect_promises(scene.cloud, s.parameters, s.plane_of_point);
}

TEST(Segment, SplitsAPlaneWhereTheStepsAreTooLong) {
  Scene scene;
  Random random(9);
  scene.add_rectangle(Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), 4000, 0.002, 0, random);
  scene.add_rectangle(Vector(1.3, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), 4000, 0.002, 1, random);
  SegmentationParameters p;
  p.max_point_distance = 0.25;
  EXPECT_EQ(segment(scene.cloud, p).planes.size(), 2U);
}

TEST(Segment, RefusesParametersOutOfRange) {
  const Scene scene = room(0.01, 100);
  SegmentationParameters p;
  p.max_plane_distance = -1;
  try {
    (void)segment(scene.cloud, p);
    FAIL() << "a negative distance was accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("max_plane_distance"), std::string::npos);
  }
  p = {};
  p.min_points = 2;
  EXPECT_THROW((void)segment(scene.cloud, p), Error);
}

TEST(Segment, SurvivesDegenerateClouds) {
  Random random(10);
  const auto check = [](const Scene& scene, const char* what) {
    SCOPED_TRACE(what);
    const Segmentation s = segment(scene.cloud);
    expect_promises(scene.cloud, s.parameters, s.plane_of_point);
    return s.planes.size();
  };
  EXPECT_EQ(check(Scene(), "no points"), 0U);
  Scene equal, line, ten, invalid, huge;
  for (int i = 0; i < 5000; ++i) equal.add(Vector(1, 2, 3), -1);
  EXPECT_EQ(check(equal, "equal points"), 0U);
  for (int i = 0; i < 5000; ++i) line.add(Vector(0.001 * i, 0.002 * i, 0.5), -1);
  EXPECT_EQ(check(line, "points on a line"), 0U);
  for (int i = 0; i < 10; ++i) ten.add(Vector(random.uniform(), random.uniform(), 0), -1);
  EXPECT_EQ(check(ten, "ten points"), 0U);
  for (int i = 0; i < 100; ++i) invalid.add(Vector::Constant(std::nan("")), -1);
  EXPECT_EQ(check(invalid, "invalid points"), 0U);
  huge = room(0.005, 800);
  for (int i = 0; i < 20; ++i) huge.add(Vector(1e30, 1e20 * i, -1e35), -1);
  for (int i = 0; i < 20; ++i) huge.add(Vector::Constant(std::nan("")), -1);
  EXPECT_EQ(check(huge, "a room with points far away and invalid ones"), static_cast<std::size_t>(kRoomPlanes));
}

TEST(Segment, TakesEveryPointTwiceAsWellAsOnce) {
  const Scene scene = room(0.005);
  Scene doubled;
  for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
    for (int copy = 0; copy < 2; ++copy) doubled.add(scene.cloud.position(i), scene.truth[i]);
  }
  expect_room(doubled, segment(doubled.cloud), 0.93);
}

TEST(Segment, TakesAPlaneOfHeavyNoise) {
  const Scene scene = room(0.025, 3000);
  const Segmentation s = segment(scene.cloud);
  expect_promises(scene.cloud, s.parameters, s.plane_of_point);
  const std::vector<double> best = best_overlaps(scene, s.plane_of_point, kRoomPlanes);
  for (int plane = 0; plane < kRoomPlanes - 1; ++plane) EXPECT_GT(best[static_cast<std::size_t>(plane)], 0.7) << plane;
}

}  // namespace
}  // namespace scenelore::perception
