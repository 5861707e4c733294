// A screen seen from beside it: its front is a sheet, its rim a slab.
#include "sharp_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planar_scenes.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;
using testing::Scene;

constexpr double kNoise = 0.01;  // metres along the ray
constexpr int kOfFront = 500, kOfRim = 400;

/// The sensor at the origin looks at a front of 0.5 x 0.3 m in the plane y = `aside`, 1.2 m away, and along a body that is `thick` behind it, more so at
/// the far end of one that is `wedged`.
struct Screen {
  explicit Screen(double thick, double aside = 0.15, double noise = kNoise, bool wedged = false) {
    Random random(3);
    const auto measure = [&](const Eigen::Vector3d& p) {
      const Eigen::Vector3d seen = p + noise * random.normal() * p.normalized();
      cloud.x.push_back(static_cast<float>(seen.x())), cloud.y.push_back(static_cast<float>(seen.y())), cloud.z.push_back(static_cast<float>(seen.z()));
    };
    const auto front = [&] { return Eigen::Vector3d(1.2 + random.uniform(0, 0.5), aside, random.uniform(-0.15, 0.15)); };
    for (int i = 0; i < kOfFront; ++i) measure(front());
    for (int i = 0; i < kOfRim; ++i) {
      const double side = random.uniform(0, 1) < 0.5 ? -0.15 : 0.15;
      const double along = random.uniform(0, 0.5), share = wedged ? random.uniform(along, along + 0.5) : random.uniform(0, 1);
      measure({1.2 + along, aside + thick * share, side});
    }
    cloud.sensors = SensorPositions(Eigen::Vector3d::Zero());
    regions.of_point.assign(cloud.size(), 0);
    regions.planes.resize(1);
    refit(cloud, regions);
  }

  [[nodiscard]] auto kept(int begin, int end) const { return std::count(regions.of_point.begin() + begin, regions.of_point.begin() + end, 0); }

  Cloud cloud;
  Regions regions;
};

TEST(SharpFaces, LeaveTheRimOfAScreenSeenFromBesideIt) {
  Screen screen(0.04);
  ASSERT_GT(screen.regions.planes[0].rmse(), 0.005) << "one plane of both";
  keep_sharp_faces(screen.cloud, kNoise, screen.regions);
  EXPECT_GT(screen.kept(0, kOfFront), 0.95 * kOfFront);
  EXPECT_LT(screen.kept(kOfFront, kOfFront + kOfRim), 0.25 * kOfRim);
  EXPECT_LT(screen.regions.planes[0].rmse(), 0.002);
  EXPECT_GT(std::abs(screen.regions.planes[0].normal.y()), 0.9999) << "within 0.8 degrees of the front";
}

TEST(SharpFaces, AreFoundWhereThePlaneOfAllIsTurnedAgainstThem) {
  Screen screen(0.06, 0.15, kNoise, true);
  ASSERT_LT(std::abs(screen.regions.planes[0].normal.y()), 0.99985) << "by more than a degree";
  keep_sharp_faces(screen.cloud, kNoise, screen.regions);
  EXPECT_GT(screen.kept(0, kOfFront), 0.95 * kOfFront);
  EXPECT_GT(std::abs(screen.regions.planes[0].normal.y()), 0.9999);
}

TEST(SharpFaces, TakeNothingFromWhatIsAsThickAsItsNoise) {
  Screen screen(0);
  keep_sharp_faces(screen.cloud, kNoise, screen.regions);
  EXPECT_EQ(screen.kept(0, kOfFront + kOfRim), kOfFront + kOfRim);
}

TEST(SharpFaces, TakeNothingWhereTheSensorLooksSquarely) {
  constexpr double exact = 0.001;  // so that the front is a sheet here, too
  Screen screen(0.04, 3, exact);
  keep_sharp_faces(screen.cloud, exact, screen.regions);
  EXPECT_EQ(screen.kept(0, kOfFront + kOfRim), kOfFront + kOfRim);
}

TEST(SharpFaces, TakeNothingWithoutTheSensorsPosition) {
  Screen screen(0.04);
  screen.cloud.sensors = {};
  keep_sharp_faces(screen.cloud, kNoise, screen.regions);
  EXPECT_EQ(screen.kept(0, kOfFront + kOfRim), kOfFront + kOfRim);
}

/// Directions are counted by places along the plane, of which there are 10¹⁴ around a sensor that is so far away.
TEST(SharpFaces, AreLookedForFromASensorThatIsNowhereNear) {
  for (const double away : {1e5, 1e12}) {
    Screen screen(0.04);
    screen.cloud.sensors = SensorPositions(Eigen::Vector3d(-away, 0.15 - away / 10, 0));
    keep_sharp_faces(screen.cloud, kNoise, screen.regions);
    EXPECT_GT(screen.kept(0, kOfFront), 0.9 * kOfFront) << away;
  }
}

TEST(SharpFaces, AreTheSameInEveryRunWithAnyNumberOfThreads) {
  Screen once(0.04), again(0.04);
  keep_sharp_faces(once.cloud, kNoise, once.regions, 1);
  keep_sharp_faces(again.cloud, kNoise, again.regions, 4);
  EXPECT_EQ(once.regions.of_point, again.regions.of_point);
}

TEST(Reaches, OfSmallPlanesAreThreeDeviationsOfMostPoints) {
  Screen screen(0);
  const Limits limits{.max_plane_distance = 0.05};
  for (std::size_t i = 0; i < 20; ++i) screen.cloud.y[i] += 0.04F;  // the front edge of a shelf
  refit(screen.cloud, screen.regions);
  const double reach = reaches(screen.cloud, screen.regions.of_point, screen.regions.planes, limits)[0];
  EXPECT_GT(reach, 0.003);
  EXPECT_LT(reach, 0.006) << "the deviation across is 1 mm; that of all points is 6 mm";
  EXPECT_GT(reaches(screen.cloud, screen.regions.of_point, screen.regions.planes, {.max_plane_distance = 0.05, .plane_distance_given = true})[0], 0.03)
      << "a distance that the user sets decides alone";
  EXPECT_EQ(reaches(screen.cloud, std::vector<std::int32_t>(screen.cloud.size(), -1), screen.regions.planes, limits)[0], 0) << "no points";
}

TEST(Reaches, OfLargePlanesGoAsFarAsTheirPoints) {
  Cloud cloud;
  Random random(8);
  for (int i = 0; i < 2000; ++i) {
    cloud.x.push_back(static_cast<float>(random.uniform(0, 3))), cloud.y.push_back(static_cast<float>(random.uniform(0, 3)));
    cloud.z.push_back(static_cast<float>(0.002 * random.normal()));
  }
  cloud.z[0] = 0.03F;
  Regions regions{std::vector<std::int32_t>(cloud.size(), 0), std::vector<PlaneFit>(1)};
  refit(cloud, regions);
  EXPECT_NEAR(reaches(cloud, regions.of_point, regions.planes, {.max_plane_distance = 0.05})[0], 0.03, 0.001);
  EXPECT_NEAR(reaches(cloud, regions.of_point, regions.planes, {.max_plane_distance = 0.02})[0], 0.014, 0.001) << "at most the tolerance";
}

/// A wall 0.4 m beside the sensor at the origin, of which one point in seven is seen within 20 degrees of squarely.
Scene wall_beside() {
  Scene scene;
  Random random(4);
  for (int i = 0; i < 4000; ++i) {
    const double angle = (i % 7 == 0 ? random.uniform(-20, 20) : random.uniform(20, 84)) * std::numbers::pi / 180;
    const Eigen::Vector3d p(0.4 * std::tan(angle), 0.4, random.uniform(-0.2, 0.2));
    scene.add(p + kNoise * random.normal() * p.normalized(), 0);
  }
  scene.cloud.sensors = SensorPositions(Eigen::Vector3d::Zero());
  return scene;
}

TEST(Reaches, TakeInWhatIsSeenSquarelyOfAWallThatIsMostlySeenAtASlant) {
  const Limits limits{.max_point_distance = 1.6, .max_plane_distance = 0.04, .max_mse = 4e-4, .min_points = 20, .max_neighbours = 30, .small_plane_step = 0.3};
  Scene scene = wall_beside();
  Regions regions{std::vector<std::int32_t>(scene.cloud.size(), 0), std::vector<PlaneFit>(1)};
  refit(scene.cloud, regions);
  ASSERT_LT(regions.planes[0].spread_area(), kLargePlane);
  const auto beyond = [&](double reach) {
    int count = 0, squarely = 0;
    for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
      if (std::abs(scene.cloud.x[i]) > 0.14) continue;
      ++squarely;
      count += std::abs(regions.planes[0].distance(scene.cloud.offset(i).cast<double>())) > reach;
    }
    return static_cast<double>(count) / squarely;
  };
  const double scatter = scatters(scene.cloud, regions.of_point, regions.planes)[0];
  ASSERT_GT(beyond(3 * scatter), 0.03) << "what most of it scatters by is too little";
  EXPECT_LT(beyond(reaches(scene.cloud, regions.of_point, regions.planes, limits)[0]), 0.01);
  scene.cloud.sensors = SensorPositions();
  EXPECT_NEAR(reaches(scene.cloud, regions.of_point, regions.planes, limits)[0], 3 * scatter, 1e-6) << "nobody knows of slants";
}

TEST(Reaches, StayNarrowWhereAFaceIsSeenAtOneSlant) {
  const Limits limits{.max_point_distance = 1.6, .max_plane_distance = 0.04, .max_mse = 4e-4, .min_points = 20, .max_neighbours = 30, .small_plane_step = 0.3};
  const Screen screen(0.04);
  const double scatter = scatters(screen.cloud, screen.regions.of_point, screen.regions.planes)[0];
  EXPECT_LT(reaches(screen.cloud, screen.regions.of_point, screen.regions.planes, limits)[0], 3 * 1.3 * scatter);
}

}  // namespace
}  // namespace scenelore::perception
