// The depth camera against scenes whose answer is known.
#include <gtest/gtest.h>

#include <cmath>

#include "simulator/sensor.hpp"

namespace scenelore::simulator {
namespace {

std::vector<Sample> shoot(const Scene& scene, double noise, double scale = 1, int threads = 2) {
  const Bvh tree(scene.shapes());
  return scan_depth_camera({tree, 5, noise, std::vector<double>(scene.objects().size(), 0.0), threads},
                           {{0, 0, 0}, 0, 0, 0}, scale);
}

Scene wall_at(double x) {
  Scene scene;
  const Brush brush(scene, Eigen::Isometry3d::Identity());
  brush.quad(brush.object(ObjectClass::wall, "wall", Material::paint), {x, -20, -20}, {0, 0, 40}, {0, 40, 0});
  return scene;
}

double depth_deviation(double x, double noise) {
  double sum = 0, squares = 0, n = 0;
  for (const Sample& sample : shoot(wall_at(x), noise)) {
    const double error = sample.point.x() - x;
    sum += error;
    squares += error * error;
    ++n;
  }
  return std::sqrt(squares / n - sum * sum / (n * n));
}

TEST(DepthCamera, NoiseIsTheOptionAtThreeMetresAndGrowsWithTheSquare) {
  // Large noise, so that the steps of the disparity do not matter.
  EXPECT_NEAR(depth_deviation(3, 0.04), 0.04, 0.006);
  EXPECT_NEAR(depth_deviation(1.5, 0.04), 0.01, 0.0015);
  EXPECT_NEAR(depth_deviation(6, 0.04), 0.16, 0.025);
}

TEST(DepthCamera, DepthsAreStepsOfDisparity) {
  constexpr double steps_a_metre = 589.4 * 0.075 * 8;  // focal length × baseline × 8 steps a pixel
  for (const Sample& sample : shoot(wall_at(3), 0.01)) {
    const double step = steps_a_metre / sample.point.x();
    ASSERT_NEAR(step, std::round(step), 1e-6);
  }
}

/// Degrees between the plane fitted to what the camera sees of a wall and the wall.
double turned(std::uint64_t seed, bool bends) {
  const Scene scene = wall_at(3);
  const Bvh tree(scene.shapes());
  const World world{.shapes = tree, .seed = seed, .noise = 0, .bias = std::vector<double>(1, 0.0), .bends = bends};
  Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (const Sample& sample : scan_depth_camera(world, {{0, 0, 0}, 0, 0, 0}, 8)) {
    const Vector3d row(1, sample.point.y(), sample.point.z());
    sums += row * row.transpose();
    right += row * sample.point.x();
  }
  const Vector3d plane = sums.inverse() * right;
  return std::atan(std::hypot(plane.y(), plane.z())) * 180 / 3.14159265358979;
}

TEST(DepthCamera, OneThatBendsTurnsPlanesByAFewDegrees) {
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    EXPECT_LT(turned(seed, false), 0.1);
    sum += turned(seed, true);
    EXPECT_LT(turned(seed, true), 9);
  }
  // The linear terms of 1.5 % turn a plane at 3 m by atan(0.045 / 1.63) across the picture and atan(0.045 / 1.22) up it:
  // 1.9 degrees in the root mean, times 1.25, the mean length of a two-dimensional normal vector.
  EXPECT_NEAR(sum / 40, 2.3, 0.6);
}

TEST(DepthCamera, SeesTheAnglesOfItsLens) {
  double left = 0, up = 0;
  for (const Sample& sample : shoot(wall_at(2), 0)) {
    left = std::max(left, std::atan2(sample.point.y(), sample.point.x()));
    up = std::max(up, std::atan2(sample.point.z(), sample.point.x()));
  }
  const double degrees = 180 / 3.14159265358979;
  EXPECT_NEAR(2 * left * degrees, 57, 0.3);
  EXPECT_NEAR(2 * up * degrees, 44.3, 0.3);  // square pixels; data sheets say 43
}

TEST(DepthCamera, LeavesAHoleInTheProjectorsShadow) {
  Scene scene = wall_at(3);
  const Brush brush(scene, Eigen::Isometry3d::Identity());
  brush.quad(brush.object(ObjectClass::unknown, "board", Material::paint), {1, -0.2, -0.2}, {0, 0, 0.4}, {0, 0.4, 0});
  // The projector is 7.5 cm to the left: on the wall the board's shadow reaches farther right than the board hides.
  int right = 0, left = 0;
  for (const Sample& sample : shoot(scene, 0)) {
    if (sample.object != 0 || std::abs(sample.point.z()) > 0.4) continue;
    right += sample.point.y() < -0.62 && sample.point.y() > -0.72;
    left += sample.point.y() > 0.62 && sample.point.y() < 0.72;
  }
  EXPECT_GT(left, 500);
  EXPECT_LT(right, left / 5);
}

TEST(DepthCamera, SeesNothingNearerThanHalfAMetreOrFartherThanEight) {
  EXPECT_TRUE(shoot(wall_at(0.4), 0.01).empty());
  EXPECT_TRUE(shoot(wall_at(8.5), 0.01).empty());
  EXPECT_GT(shoot(wall_at(2), 0.01).size(), 290'000U);
}

TEST(DepthCamera, ResultDoesNotDependOnTheNumberOfThreads) {
  const Scene scene = wall_at(3);
  const std::vector<Sample> one = shoot(scene, 0.01, 2, 1), three = shoot(scene, 0.01, 2, 3);
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) ASSERT_EQ(one[i].point, three[i].point);
}

}  // namespace
}  // namespace scenelore::simulator
