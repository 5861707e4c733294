// The laser scanner against scenes whose answer is known.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "simulator/sensor.hpp"

namespace scenelore::simulator {
namespace {

struct Bench {
  Scene scene;
  Brush brush{scene, Eigen::Isometry3d::Identity()};

  int wall(double x, double half, Material material = Material::paint) {
    const int object = brush.object(ObjectClass::wall, "wall", material);
    brush.quad(object, {x, -half, 1.3 - half}, {0, 0, 2 * half}, {0, 2 * half, 0});
    return object;
  }
  [[nodiscard]] std::vector<Sample> scan(double noise, double bias = 0, double scale = 1, int threads = 2) const {
    const Bvh tree(scene.shapes());
    return scan_lidar({tree, 77, noise, std::vector<double>(scene.objects().size(), bias), threads}, pose, scale);
  }
  SensorPose pose{{0, 0, 1.3}, 0, 0, 0};
};

struct Spread {
  double mean = 0, deviation = 0;
  std::size_t n = 0;
};

// Errors of the ranges of points on the wall at distance x, for rays within `cone` of its normal.
Spread range_errors(const std::vector<Sample>& samples, double x, double least_cosine, double most_cosine) {
  double sum = 0, squares = 0;
  std::size_t n = 0;
  for (const Sample& sample : samples) {
    const Vector3d ray = sample.point - Vector3d(0, 0, 1.3);
    const double range = ray.norm(), cosine = ray.x() / range;
    if (sample.object < 0 || cosine < least_cosine || cosine > most_cosine) continue;
    const double error = range - x / cosine;
    sum += error;
    squares += error * error;
    ++n;
  }
  const double mean = sum / static_cast<double>(n);
  return {mean, std::sqrt(squares / static_cast<double>(n) - mean * mean), n};
}

TEST(Lidar, RangeNoiseIsTheOptionAtNormalIncidence) {
  for (const double noise : {0.0, 0.005, 0.01, 0.03}) {
    Bench bench;
    bench.wall(3, 2);
    const Spread spread = range_errors(bench.scan(noise), 3, 0.9, 1);
    ASSERT_GT(spread.n, 10000U);
    EXPECT_NEAR(spread.deviation, noise, 0.04 * noise + 1e-9);
    EXPECT_NEAR(spread.mean, 0, 0.05 * noise + 1e-9);
  }
}

TEST(Lidar, NoiseGrowsAtGrazingIncidenceAndBeyondTenMetres) {
  Bench near;
  near.wall(2, 60);
  const std::vector<Sample> samples = near.scan(0.01);
  EXPECT_GT(range_errors(samples, 2, 0.1, 0.2).deviation, 1.2 * range_errors(samples, 2, 0.9, 1).deviation);
  Bench far;
  far.wall(20, 6);
  EXPECT_NEAR(range_errors(far.scan(0.01), 20, 0.95, 1).deviation, 0.02, 0.002);
}

TEST(Lidar, BiasShiftsEveryRangeOfAnObject) {
  Bench bench;
  bench.wall(3, 2);
  EXPECT_NEAR(range_errors(bench.scan(0.001, 0.02), 3, 0.9, 1).mean, 0.02, 1e-4);
}

TEST(Lidar, NothingIsSeenThroughAWall) {
  Bench bench;
  bench.wall(2, 40);
  const int behind = bench.wall(4, 40);
  for (const Sample& sample : bench.scan(0.01)) ASSERT_NE(sample.object, behind);
}

TEST(Lidar, GlassGivesFewReturnsAndShowsWhatIsBehind) {
  Bench bench;
  const int pane = bench.wall(2, 1, Material::glass), behind = bench.wall(4, 4);
  std::map<int, int> counts;
  for (const Sample& sample : bench.scan(0.01)) ++counts[sample.object];
  EXPECT_GT(counts[pane], 50);
  EXPECT_GT(counts[behind], 10 * counts[pane]);
}

TEST(Lidar, BlackAndGlossySurfacesDropOutMoreAtASlant) {
  const auto share = [](Material material, double least, double most) {
    Bench painted, other;
    painted.wall(4, 40);
    other.wall(4, 40, material);
    return static_cast<double>(range_errors(other.scan(0), 4, least, most).n) /
           static_cast<double>(range_errors(painted.scan(0), 4, least, most).n);
  };
  EXPECT_GT(share(Material::screen, 0.98, 1), 0.85);
  EXPECT_LT(share(Material::screen, 0.25, 0.35), 0.5);
  EXPECT_GT(share(Material::wood, 0.25, 0.35), 0.9);
}

TEST(Lidar, MixedPixelsLieBetweenFrontAndRearAlongTheRay) {
  Bench bench;
  bench.wall(2, 0.5);
  bench.wall(3, 4);
  std::size_t mixed = 0, all = 0;
  for (const Sample& sample : bench.scan(0)) {
    ++all;
    if (sample.object >= 0) continue;
    ++mixed;
    EXPECT_GT(sample.point.x(), 2);
    EXPECT_LT(sample.point.x(), 3);
    // At the rim of the front square, as seen from the sensor.
    const Vector3d on_front = (sample.point - Vector3d(0, 0, 1.3)) * 2 / sample.point.x();
    EXPECT_NEAR(std::max(std::abs(on_front.y()), std::abs(on_front.z())), 0.5, 0.02);
  }
  EXPECT_GT(mixed, 100U);
  EXPECT_LT(mixed, all / 20);
}

TEST(Lidar, StepsAreAQuarterDegreeOverTwoHundredSeventyDegrees) {
  Bench bench;  // inside a sphere every ray answers
  bench.brush.ellipsoid(bench.brush.clutter("sphere", Material::paint), {0, 0, 1.3}, {3, 3, 3});
  const double rays = 1081.0 * 451;
  EXPECT_NEAR(static_cast<double>(bench.scan(0).size()), 0.998 * rays, 0.001 * rays);
  EXPECT_NEAR(static_cast<double>(bench.scan(0, 0, 2).size()), 0.998 * rays / 4, 0.005 * rays);
}

TEST(Lidar, ResultDoesNotDependOnTheNumberOfThreads) {
  Bench bench;
  bench.wall(2, 0.5);
  bench.wall(3, 4, Material::screen);
  const std::vector<Sample> one = bench.scan(0.01, 0, 1, 1);
  for (const int threads : {2, 3, 7}) {
    const std::vector<Sample> many = bench.scan(0.01, 0, 1, threads);
    ASSERT_EQ(many.size(), one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_EQ(many[i].point, one[i].point);
      ASSERT_EQ(many[i].object, one[i].object);
    }
  }
}

}  // namespace
}  // namespace scenelore::simulator
