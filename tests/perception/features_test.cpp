#include "scenelore/perception/features.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "planar_scenes.hpp"
#include "scenelore/perception/perceive.hpp"
#include "promise_checks.hpp"
#include "surroundings.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;
using testing::room;
using testing::Scene;
using Vector = Eigen::Vector3d;

/// Least squares by hand, in another way than the module's moments.
PlaneFit fit(const Cloud& cloud) {
  PlaneFit plane;
  for (std::size_t i = 0; i < cloud.size(); ++i) plane.centroid += cloud.offset(i).cast<double>() / static_cast<double>(cloud.size());
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vector d = cloud.offset(i).cast<double>() - plane.centroid;
    c += d * d.transpose() / static_cast<double>(cloud.size());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(c);
  plane.count = static_cast<double>(cloud.size());
  plane.variances = solver.eigenvalues().cwiseMax(0);
  plane.axes = solver.eigenvectors();
  plane.normal = plane.axes.col(0);
  plane.offset = plane.normal.dot(plane.centroid);
  return plane;
}

Plane describe_all(const Cloud& cloud, const Upright& upright = {}) {
  std::vector<std::uint32_t> points(cloud.size());
  std::iota(points.begin(), points.end(), 0U);
  return describe(cloud, points, fit(cloud), upright);
}

/// A table top of grid points, 1.6 × 0.8 m, in the plane z = 0.75, turned by `turn` about its centre.
Cloud top(const Eigen::Quaterniond& turn, double noise = 0) {
  Scene scene;
  Random random(1);
  for (double x = -0.8; x <= 0.801; x += 0.02) {
    for (double y = -0.4; y <= 0.401; y += 0.02) scene.add(turn * Vector(x, y, noise * random.normal()) + Vector(3, 2, 0.75), 0);
  }
  return scene.cloud;
}

TEST(Describe, GivesTheFeaturesOfATableTop) {
  const Plane p = describe_all(top(Eigen::Quaterniond::Identity()), {.floor_z = 0.05});
  EXPECT_NEAR(p.area_m2, 1.28, 1e-4);
  EXPECT_NEAR(p.length, 1.6, 1e-4);
  EXPECT_NEAR(p.width, 0.8, 1e-4);
  EXPECT_NEAR(p.rectangularity, 1, 0.002);
  EXPECT_NEAR(p.tilt_deg, 0, 1e-3);
  EXPECT_NEAR(p.height, 0.7, 1e-5);
  EXPECT_NEAR(p.z_min, 0.7, 1e-5);
  EXPECT_NEAR(p.z_max, 0.7, 1e-5);
  EXPECT_NEAR(p.facing_up, 1, 1e-6);
  EXPECT_NEAR(p.rmse, 0, 1e-6);
  EXPECT_NEAR(p.seen_share, 1, 1e-9);
  EXPECT_EQ(p.point_count, 81U * 41U);
  EXPECT_NEAR(p.point_density, 81 * 41 / 1.28, 1);
  EXPECT_TRUE(p.centroid.isApprox(Vector(3, 2, 0.75), 1e-5));
}

TEST(Describe, FollowsThePlaneThroughEveryRotation) {
  Random random(3);
  for (int i = 0; i < 25; ++i) {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
    const Plane p = describe_all(top(turn, 0.002));
    EXPECT_NEAR(p.area_m2, 1.28, 0.01);
    EXPECT_NEAR(p.length, 1.6, 0.01);
    EXPECT_NEAR(p.width, 0.8, 0.01);
    EXPECT_NEAR(p.rmse, 0.002, 0.0003);
    EXPECT_GE(p.normal.z(), -1e-3) << "the upper half space";
    EXPECT_NEAR(std::abs(p.normal.dot(turn * Vector::UnitZ())), 1, 1e-4);
    EXPECT_NEAR(p.tilt_deg, std::acos(std::min(1.0, std::abs((turn * Vector::UnitZ()).z()))) * 180 / std::numbers::pi, 0.5);
    const Eigen::Matrix3d axes = p.orientation.toRotationMatrix();
    EXPECT_NEAR(axes.determinant(), 1, 1e-9);
    EXPECT_TRUE(axes.col(2).isApprox(p.normal, 1e-6)) << "local z is the normal";
    EXPECT_NEAR(std::abs(axes.col(1).dot(turn * Vector::UnitX())), 1, 1e-3) << "local y is the longest axis";
    for (const Vector& corner : p.hull.outer) EXPECT_NEAR(p.normal.dot(corner - p.centroid), 0, 1e-9) << "the hull lies on the plane";
  }
}

TEST(Describe, TurnsTheNormalTowardsTheSensor) {
  Cloud cloud = top(Eigen::Quaterniond::Identity());
  cloud.sensors = SensorPositions(Vector(0, 0, -5));
  const Plane p = describe_all(cloud);
  EXPECT_LT(p.normal.z(), 0);
  EXPECT_NEAR(p.facing_up, -1, 1e-6);
}

TEST(Describe, TellsHowMuchOfTheHullWasSeen) {
  Scene scene;
  for (int x = 0; x <= 20; ++x) {
    for (int y = 0; y <= 20; ++y) scene.add(Vector(0.1 * x, 0.1 * y, 0), 0);
  }
  const Plane p = describe_all(scene.cloud);
  EXPECT_NEAR(p.area_m2, 4, 1e-5);
  EXPECT_NEAR(p.seen_share, 0.25, 0.05) << "one point every 10 cm, cells of 5 cm";
}

TEST(Describe, TakesDegeneratePlanes) {
  Scene line, one;
  for (int i = 0; i < 50; ++i) line.add(Vector(0.02 * i, 0, 1), 0);
  const Plane p = describe_all(line.cloud);
  EXPECT_TRUE(p.hull.outer.empty());
  EXPECT_EQ(p.area_m2, 0);
  EXPECT_EQ(p.rectangularity, 0);
  EXPECT_NEAR(p.length, 0.98, 1e-5);
  for (int i = 0; i < 3; ++i) one.add(Vector(1, 2, 3), 0);
  const Plane q = describe_all(one.cloud);
  EXPECT_EQ(q.area_m2, 0);
  EXPECT_EQ(q.length, 0);
  EXPECT_TRUE(std::isfinite(q.tilt_deg));
}

TEST(EstimateUpright, LeavesALevelScanAsItIs) {
  const Scene scene = room(0.01);
  const Perception p = perceive(scene.cloud);
  EXPECT_TRUE(p.upright.rotation.isApprox(Eigen::Quaterniond::Identity(), 0)) << "not turned at all";
  EXPECT_TRUE(p.upright.floor_found);
  EXPECT_NEAR(p.upright.floor_z, 0, 0.005);
  EXPECT_GT(p.upright.confidence, 0.7);
  EXPECT_FALSE(p.upright.explanation.empty());
}

TEST(EstimateUpright, PutsATiltedScanRight) {
  const Scene scene = room(0.01);
  for (int i = 0; i < 6; ++i) {
    const Vector axis(std::cos(i), std::sin(i), 0);
    const Eigen::Isometry3d tilt(Eigen::AngleAxisd((2 + 1.6 * i) * std::numbers::pi / 180, axis));
    const Perception p = perceive(scene.moved(tilt).cloud);
    const Vector up = p.upright.rotation * (tilt.rotation() * Vector::UnitZ());
    EXPECT_LT(std::acos(std::min(1.0, up.z())) * 180 / std::numbers::pi, 0.5) << "tilt " << 2 + 1.6 * i;
    EXPECT_NEAR(p.upright.floor_z, 0, 0.02);
  }
}

/// A rectangle as a plane fit knows it.
PlaneFit fit_of(const Vector& centre, const Vector& normal, double length, double width) {
  PlaneFit plane;
  plane.centroid = centre;
  plane.normal = normal.normalized();
  plane.offset = plane.normal.dot(centre);
  plane.variances = {0, width * width / 12, length * length / 12};
  return plane;
}

TEST(EstimateUpright, LetsNoOnePlaneDecideInAScanThatIsBent) {
  // A depth camera that bends space: the desk, a shelf and three walls agree, the floor, which suits the file's z, is 6 degrees off.
  const Vector up = Eigen::AngleAxisd(6 * std::numbers::pi / 180, Vector::UnitX()) * Vector::UnitZ();
  const Vector along = Vector::UnitX(), across = up.cross(along);
  const std::vector<PlaneFit> planes = {fit_of({0, 2, 1}, across, 2.5, 2), fit_of({0, -2, 1}, -across, 2, 1.5), fit_of({2, 0, 1}, along, 2, 2),
                                        fit_of({0, 0, 0}, Vector::UnitZ(), 1.5, 1.2), fit_of({1, 0, 0.8}, up, 1.2, 0.5),
                                        fit_of({-1, 0, 1.9}, up, 0.8, 0.4)};
  Scene scene;
  for (const PlaneFit& plane : planes) scene.add(plane.centroid, 0);
  const Vector found = estimate_upright(scene.cloud, planes).rotation.inverse() * Vector::UnitZ();
  EXPECT_LT(std::acos(std::min(1.0, found.dot(up))) * 180 / std::numbers::pi, 2) << "nearer to what most say than to the floor";
}

TEST(EstimateUpright, IsNotMovedByWhatSlants) {
  // A pin board leaning by 9 degrees and a roof of 35 against five planes that are upright to a tenth of a degree.
  const Vector leaning = Eigen::AngleAxisd(9 * std::numbers::pi / 180, Vector::UnitX()) * Vector::UnitY();
  const Vector roof = Eigen::AngleAxisd(35 * std::numbers::pi / 180, Vector::UnitY()) * Vector::UnitZ();
  const Vector tilted = Eigen::AngleAxisd(4 * std::numbers::pi / 180, Vector(1, 1, 0).normalized()) * Vector::UnitZ();
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vector::UnitZ(), tilted);
  const auto turned = [&](const Vector& centre, const Vector& normal, double length, double width) { return fit_of(centre, turn * normal, length, width); };
  const std::vector<PlaneFit> planes = {turned({0, 0, 0}, Vector::UnitZ(), 4, 3),   turned({0, 1.5, 1.2}, -Vector::UnitY(), 4, 2.5),
                                        turned({2, 0, 1.2}, -Vector::UnitX(), 3, 2.5), turned({0, -1.5, 1.2}, Vector::UnitY(), 4, 2.5),
                                        turned({0, 1.4, 1.2}, leaning, 3, 1.5),        turned({0, 0, 2.6}, roof, 4, 3)};
  Scene scene;
  for (const PlaneFit& plane : planes) scene.add(plane.centroid, 0);
  const Vector found = estimate_upright(scene.cloud, planes).rotation.inverse() * Vector::UnitZ();
  EXPECT_LT(std::acos(std::min(1.0, found.dot(tilted))) * 180 / std::numbers::pi, 0.1);
}

/// Two walls from z = `low` upwards.
Perception perceive_walls(double low) {
  Scene scene;
  Random random(2);
  scene.add_rectangle(Vector(0, 0, low), Vector(4, 0, 0), Vector(0, 0, 2.2), 2000, 0.005, 0, random);
  scene.add_rectangle(Vector(0, 0, low), Vector(0, 3, 0), Vector(0, 0, 2.2), 2000, 0.005, 1, random);
  return perceive(scene.cloud);
}

TEST(EstimateUpright, TakesTheZeroLevelOfALevelledScanWhoseFloorIsHidden) {
  const Perception p = perceive_walls(0.3);
  EXPECT_FALSE(p.upright.floor_found);
  EXPECT_EQ(p.upright.floor_z, 0);
  EXPECT_NE(p.upright.explanation.find("zero level"), std::string::npos);
}

TEST(EstimateUpright, SaysWhenNoFloorIsVisible) {
  const Perception p = perceive_walls(-1.3);
  EXPECT_FALSE(p.upright.floor_found);
  EXPECT_NEAR(p.upright.floor_z, -1.3, 0.03);
  ASSERT_FALSE(p.warnings.empty());
  EXPECT_NE(p.warnings.back().find("floor"), std::string::npos);
}

TEST(EstimateUpright, TakesTheLowestOfSeveralFloorLevels) {
  Scene scene;
  Random random(2);
  scene.add_rectangle(Vector(0, 0, 0), Vector(2, 0, 0), Vector(0, 3, 0), 2000, 0.005, 0, random);
  scene.add_rectangle(Vector(2, 0, 0.45), Vector(3, 0, 0), Vector(0, 3, 0), 2000, 0.005, 1, random);
  scene.add_rectangle(Vector(0, 0, 0), Vector(0, 3, 0), Vector(0, 0, 2.5), 2000, 0.005, 2, random);
  EXPECT_NEAR(perceive(scene.cloud).upright.floor_z, 0, 0.01);
}

TEST(EstimateUpright, TakesWhatIsGiven) {
  PerceptionOptions options;
  options.up = Vector(0, 1, 0);
  options.floor_z = -1.5;
  const Perception p = perceive(room(0.01).cloud, options);
  EXPECT_TRUE((p.upright.rotation * Vector::UnitY()).isApprox(Vector::UnitZ(), 1e-9));
  EXPECT_EQ(p.upright.floor_z, -1.5);
  options.up = Vector::Zero();
  EXPECT_ANY_THROW((void)perceive(room(0.01, 100).cloud, options));
}

TEST(Perceive, DescribesARoomAndIsTheSameForAnyNumberOfThreads) {
  const Scene scene = room(0.008);
  PerceptionOptions options;
  options.threads = 1;
  const Perception one = perceive(scene.cloud, options);
  testing::expect_promises(scene.cloud, one.parameters, one.plane_of_point);
  ASSERT_EQ(one.planes.size(), 7U);
  const Plane& table = one.planes.back();
  EXPECT_NEAR(table.height, 0.74, 0.005);
  EXPECT_NEAR(table.length, 1.6, 0.05);
  EXPECT_NEAR(table.width, 0.8, 0.05);
  EXPECT_NEAR(table.area_m2, 1.28, 0.06);
  for (const int threads : {2, 4}) {
    options.threads = threads;
    const Perception other = perceive(scene.cloud, options);
    EXPECT_EQ(one.plane_of_point, other.plane_of_point);
    for (std::size_t i = 0; i < one.planes.size(); ++i) {
      EXPECT_EQ(one.planes[i].area_m2, other.planes[i].area_m2);
      EXPECT_EQ(one.planes[i].centroid, other.planes[i].centroid);
    }
  }
}

/// A dense room has several times the points that its planes are found by.
TEST(Surroundings, CountCubesOnBothSidesOfAPlane) {
  // Plates of a square metre, a cube of 10 cm holding four points at its middle: the plane itself, one 0.6 m above it, two below.
  const auto plates = [](std::vector<double> heights, double points) {
    std::vector<Moments> voxels;
    for (const double height : heights) {
      for (int x = 0; x < 10; ++x) {
        for (int y = 0; y < 10; ++y) {
          Moments m;
          m.n = points;
          m.sum = points * Eigen::Vector3d(0.1 * x + 0.05, 0.1 * y + 0.05, height);
          voxels.push_back(m);
        }
      }
    }
    return voxels;
  };
  Plane plane;
  plane.centroid = {0.5, 0.5, 0.05};
  plane.hull.outer = {{0, 0, 0.05}, {1, 0, 0.05}, {1, 1, 0.05}, {0, 1, 0.05}};
  const auto behind = [&](std::vector<double> heights, double points) {
    return Surroundings(plates(std::move(heights), points), 0.05).behind(plane, Eigen::Vector3d::Zero());
  };
  EXPECT_DOUBLE_EQ(behind({0.05, 0.65, -0.55, -0.85}, 4), 0.5) << "a hundred above, a hundred of its own";
  EXPECT_DOUBLE_EQ(behind({0.05, -0.55, -0.85}, 4), 0) << "nothing above";
  EXPECT_DOUBLE_EQ(behind({0.05, 0.12, -0.55}, 4), 0) << "too near to be told from the plane";
  EXPECT_DOUBLE_EQ(behind({0.05, 1.95, -0.55}, 4), 0) << "too far off to matter";
  EXPECT_DOUBLE_EQ(behind({0.05, 0.65, -0.55}, 2), -1) << "strays alone";
  plane.hull.outer.clear();
  EXPECT_DOUBLE_EQ(behind({0.05, 0.65, -0.55}, 4), -1) << "no outline";
}

/// The front of a pillar, from x = 0 to 1 at y = 0, seen from y > 0: its side runs back at x = 1, a niche lies beyond.
TEST(Surroundings, DoNotTakeForBehindWhatIsBesideACorner) {
  std::vector<Moments> voxels;
  const auto fill = [&](double x, double y) {
    for (int z = 0; z < 10; ++z) {
      voxels.emplace_back();
      voxels.back().n = 4;
      voxels.back().sum = 4 * Eigen::Vector3d(x, y, 0.1 * z + 0.05);
    }
  };
  for (int i = 0; i < 10; ++i) {
    fill(0.1 * i + 0.05, 0.0);   // the front
    fill(0.1 * i + 0.05, 0.65);  // the room before it
    fill(1.0, -0.1 * i - 0.05);  // the side
    fill(1.25, -0.1 * i - 0.05); // what stands in the niche
  }
  const auto upright = [](double x, double y, const Eigen::Vector3d& normal) {
    Plane plane;
    plane.centroid = {x, y, 0.5};
    plane.normal = normal;
    plane.orientation = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal);
    const Eigen::Vector3d along = 0.5 * Eigen::Vector3d::UnitZ().cross(normal), up = 0.5 * Eigen::Vector3d::UnitZ();
    plane.hull.outer = {plane.centroid - along - up, plane.centroid + along - up, plane.centroid + along + up, plane.centroid - along + up};
    return plane;
  };
  const Plane front = upright(0.5, 0, Eigen::Vector3d::UnitY()), side = upright(1, -0.5, Eigen::Vector3d::UnitX());
  const Surroundings around(voxels, 0.05);
  const Plane* const turns[] = {&side};
  EXPECT_GT(around.behind(front, Eigen::Vector3d::Zero()), 0.4);
  EXPECT_EQ(around.behind(front, Eigen::Vector3d::Zero(), turns), 0);
  for (int i = 0; i < 10; ++i) fill(0.1 * i + 0.05, -0.95);  // the room goes on behind the front itself: no pillar, a thin thing
  EXPECT_GT(Surroundings(voxels, 0.05).behind(front, Eigen::Vector3d::Zero(), turns), 0.3);
}

TEST(Perceive, TellsWhereTheRoomEndsHoweverItIsTurned) {
  const Eigen::Isometry3d turned(Eigen::Translation3d(30, -7, 2) * Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.1, 0.05, 1).normalized()));
  Scene room = testing::room(0.005);
  Random random(2);
  room.add_rectangle(Vector(2.75, 1, 0.1), Vector(0, 1.2, 0), Vector(0, 0, 1.2), 2500, 0.005, 7, random);  // a partition in the room
  for (const Scene& scene : {room, room.moved(turned)}) {
    const Perception found = perceive(scene.cloud);
    ASSERT_EQ(found.planes.size(), 8U);
    for (const Plane& plane : found.planes) {
      if (plane.area_m2 > 2) {
        EXPECT_LT(plane.behind, 0.02) << plane.height;
      } else {  // the partition, and the table, which has the partition's upper half over it
        EXPECT_GT(plane.behind, plane.tilt_deg > 45 ? 0.3 : 0.02) << plane.height;
      }
    }
  }
}

TEST(Perceive, GivesEveryPointOfADenseRoomToAPlaneFoundInASample) {
  const Scene scene = room(0.008, 10'000);
  PerceptionOptions options;
  const Perception found = perceive(scene.cloud, options);
  testing::expect_promises(scene.cloud, found.parameters, found.plane_of_point);
  ASSERT_EQ(found.planes.size(), 7U);
  std::map<int, std::map<std::int32_t, std::size_t>> counts;
  for (std::size_t i = 0; i < scene.truth.size(); ++i) ++counts[scene.truth[i]][found.plane_of_point[i]];
  for (const auto& [truth, planes] : counts) {
    std::size_t all = 0, most = 0;
    for (const auto& [plane, n] : planes) all += n, most = std::max(most, plane < 0 ? 0 : n);
    EXPECT_GT(static_cast<double>(most), 0.97 * static_cast<double>(all)) << "rectangle " << truth;
  }
  std::size_t counted = 0;
  for (const Plane& plane : found.planes) counted += plane.point_count;
  EXPECT_EQ(counted, static_cast<std::size_t>(std::count_if(found.plane_of_point.begin(), found.plane_of_point.end(), [](auto p) { return p >= 0; })));
  options.threads = 1;
  EXPECT_EQ(perceive(scene.cloud, options).plane_of_point, found.plane_of_point);
}

TEST(Perceive, NamesItsStagesAndGivesTheSameWhetherTheyAreListenedToOrNot) {
  const Scene scene = room(0.008);
  std::vector<std::string> stages;
  PerceptionOptions options;
  options.on_stage = [&](std::string_view stage) { stages.emplace_back(stage); };
  const Perception listened = perceive(scene.cloud, options);
  EXPECT_EQ(listened.plane_of_point, perceive(scene.cloud).plane_of_point);
  ASSERT_GE(stages.size(), 3U);
  EXPECT_EQ(stages.front(), "voxels");
  EXPECT_EQ(stages.back(), "features");
  EXPECT_NE(std::find(stages.begin(), stages.end(), "thin objects"), stages.end());
}

TEST(Perceive, WarnsAboutMillimetres) {
  Scene scene;
  const Scene metres = room(0.005, 800);
  for (std::size_t i = 0; i < metres.cloud.size(); ++i) scene.add(1000 * metres.cloud.position(i), metres.truth[i]);
  const Perception p = perceive(scene.cloud);
  ASSERT_FALSE(p.warnings.empty());
  EXPECT_NE(p.warnings.front().find("millimetres"), std::string::npos) << p.warnings.front();
  EXPECT_GE(p.planes.size(), 6U);
}

TEST(Perceive, FindsNoPlanesInNothingAndSaysSo) {
  Scene scene;
  for (int i = 0; i < 10; ++i) scene.add(Vector(i, 2 * i, 0), 0);
  scene.add(Vector::Constant(std::nan("")), -1);
  const Perception p = perceive(scene.cloud);
  EXPECT_TRUE(p.planes.empty());
  EXPECT_EQ(p.plane_of_point, std::vector<std::int32_t>(11, -1));
  EXPECT_EQ(p.warnings.size(), 2U) << "one for the invalid point, one for the planes";
}

}  // namespace
}  // namespace scenelore::perception
