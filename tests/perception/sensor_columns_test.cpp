// Where the sensor stood, as files tell it: once for all points, or for each.
#include <cmath>
#include <limits>

#include "point_file_support.hpp"
#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception {
namespace {

using SensorColumns = PointFiles;
using Vector = Eigen::Vector3d;
using Positions = std::vector<Vector>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr const char* kNames[] = {"vp_x", "vp_y", "vp_z"};

/// Points on a line, each with the sensor position of its number among these.
PointTable points_from(const Positions& sensors, const std::vector<std::size_t>& of_point) {
  PointTable table;
  table.rows = of_point.size();
  std::vector<float> values(table.rows);
  for (const char* name : {"x", "y", "z"}) {
    for (std::size_t i = 0; i < table.rows; ++i) values[i] = static_cast<float>(i) * 0.25F;
    table.set_column(name, values);
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < table.rows; ++i) values[i] = static_cast<float>(sensors[of_point[i]][axis]);
    table.set_column(kNames[axis], values);
  }
  return table;
}

std::vector<std::size_t> numbers_in(const Cloud& cloud) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < cloud.size(); ++i) numbers.push_back(cloud.sensors.of_point(i));
  return numbers;
}

std::string error_in(const PointTable& table) {
  try {
    (void)to_cloud(table, "room.ply");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(SensorColumns, TellThePositionOfEachPointInEveryFormat) {
  const Positions sensors{{1, 2, 1.5}, {-3, 0.5, 1.25}, {0, 0, 0}};
  const std::vector<std::size_t> of_point{0, 0, 1, 2, 1, 0, 2, 2};
  PointTable table = points_from(sensors, of_point);
  table.viewpoint = Vector(9, 9, 9);  // the points know better
  for (const char* name : {"scan.ply", "scan.pcd", "scan.csv"}) {
    SCOPED_TRACE(name);
    write_points(path(name), table);
    for (const Cloud& cloud : {to_cloud(read_points(path(name)), name), read_cloud(path(name), 1), read_cloud(path(name), 4)}) {
      EXPECT_EQ(cloud.sensors.positions(), sensors);
      EXPECT_EQ(numbers_in(cloud), of_point);
      EXPECT_FALSE(cloud.sensors.single());
    }
  }
}

TEST_F(SensorColumns, OfOnePositionAreThatOfTheCloud) {
  const Cloud cloud = to_cloud(points_from({{1, 2, 3}}, {0, 0, 0}), "test");
  EXPECT_TRUE(cloud.sensors.single());
  EXPECT_EQ(cloud.sensors.positions(), Positions{Vector(1, 2, 3)});
  PointTable plain;
  plain.rows = 1;
  for (const char* name : {"x", "y", "z"}) plain.set_column(name, std::vector<float>{1});
  EXPECT_FALSE(to_cloud(plain, "test").sensors.known());
  plain.viewpoint = Vector(4, 5, 6);
  EXPECT_TRUE(to_cloud(plain, "test").sensors.single());
  EXPECT_EQ(to_cloud(plain, "test").sensors.positions(), Positions{Vector(4, 5, 6)});
}

TEST_F(SensorColumns, OfNanSayThatThePositionIsNotKnown) {
  const Positions sensors{{1, 2, 3}, Vector::Constant(kNan)};
  PointTable table = points_from(sensors, {1, 0, 1, 0});
  const Cloud some = to_cloud(table, "test");
  EXPECT_EQ(some.sensors.positions(), Positions{Vector(1, 2, 3)});
  EXPECT_EQ(numbers_in(some), (std::vector<std::size_t>{1, 0, 1, 0}));
  EXPECT_FALSE(some.sensors.single());
  table.viewpoint = Vector(7, 8, 9);
  const Cloud rest = to_cloud(table, "test");
  EXPECT_EQ(rest.sensors.positions(), (Positions{{7, 8, 9}, {1, 2, 3}})) << "the file's own, for points without one";
  EXPECT_EQ(numbers_in(rest), (std::vector<std::size_t>{0, 1, 0, 1}));
  EXPECT_FALSE(to_cloud(points_from(sensors, {1, 1}), "test").sensors.known());
}

TEST_F(SensorColumns, AreRefusedWhereTheyAreNoPositions) {
  PointTable table = points_from({{1, 2, 3}}, {0, 0, 0});
  table.set_column("vp_y", std::vector<float>{2, kNan, 2});
  EXPECT_EQ(error_in(table),
            "room.ply: point 1: vp_x, vp_y and vp_z are 1, nan and 3; the sensor's position is three finite numbers, or nan three times where it is "
            "not known");
  table.set_column("vp_y", std::vector<float>{2, 2, std::numeric_limits<float>::infinity()});
  EXPECT_NE(error_in(table).find("point 2: vp_x, vp_y and vp_z are 1, inf and 3"), std::string::npos);
  table.set_column("x", std::vector<float>{0, 0, kNan});
  EXPECT_EQ(error_in(table), "no error") << "a point without coordinates was measured from nowhere";
  std::erase_if(table.columns, [](const Column& c) { return c.name == "vp_z"; });
  EXPECT_EQ(error_in(table), "room.ply: no property 'vp_z'; the sensor's position is told by vp_x, vp_y and vp_z together, or by none of them");
}

TEST_F(SensorColumns, MayBeOfAnyTypeAndAreInMetres) {
  const std::string text = "x y z vp_x vp_y vp_z\n0.5 1 2 0 0 1\n0.5 1 3 0 0 1\n0.5 2 2 300 -2 1\n";
  put("scan.txt", text);
  ASSERT_EQ(size_of(read_points(path("scan.txt")).find("vp_z")->type), 4U) << "whole numbers are read as such";
  const Cloud cloud = read_cloud(path("scan.txt"));
  EXPECT_EQ(cloud.sensors.positions(), (Positions{{0, 0, 1}, {300, -2, 1}}));
  EXPECT_EQ(numbers_in(cloud), (std::vector<std::size_t>{0, 0, 1}));
}

TEST_F(SensorColumns, ThatPointsWithoutCoordinatesHaveCostNothing) {
  PointTable table = points_from({{1, 2, 3}, Vector::Constant(kNan), {4, 5, 6}}, {1, 0, 2, 0, 0});
  table.set_column("x", std::vector<float>{kNan, 0, kNan, 0, 0});
  const Cloud cloud = to_cloud(table, "test");
  EXPECT_EQ(cloud.invalid, 2U);
  EXPECT_TRUE(cloud.sensors.single());
  EXPECT_EQ(cloud.sensors.positions(), Positions{Vector(1, 2, 3)});
}

/// Every number in turn, up and down again, with points between that do not know theirs.
std::vector<std::size_t> there_and_back(std::size_t sensors) {
  std::vector<std::size_t> of_point;
  for (std::size_t s = 0; s < sensors; ++s) of_point.push_back(s);
  for (std::size_t s = sensors; s-- > 0;) of_point.push_back(s), of_point.push_back(sensors);
  return of_point;
}

TEST_F(SensorColumns, KeepAllPositionsUpToTheMostThereMayBe) {
  for (const std::size_t count : {std::size_t{2}, std::size_t{254}, std::size_t{255}, std::size_t{256}, std::size_t{300}, SensorPositions::kMost}) {
    SCOPED_TRACE(count);
    Positions sensors;
    for (std::size_t s = 0; s < count; ++s) sensors.emplace_back(static_cast<double>(s) / 1024, -2, 1);
    sensors.emplace_back(Vector::Constant(kNan));
    const std::vector<std::size_t> of_point = there_and_back(count);
    const Cloud cloud = to_cloud(points_from(sensors, of_point), "test");
    sensors.pop_back();
    EXPECT_TRUE(cloud.sensors.positions() == sensors);
    EXPECT_TRUE(numbers_in(cloud) == of_point);
  }
}

TEST_F(SensorColumns, OfASensorOnTheMoveAreRoundedToFiveCentimetresOrMore) {
  constexpr std::size_t kCount = SensorPositions::kMost + 1;
  for (const double step : {0.0005, 0.5}) {
    SCOPED_TRACE(step);
    Positions sensors;
    std::vector<std::size_t> of_point;
    for (std::size_t s = 0; s < kCount; ++s) {
      sensors.emplace_back(static_cast<float>(static_cast<double>(s) * step), 1.5F, 1.25F);
      of_point.push_back(s);
    }
    const Cloud cloud = to_cloud(points_from(sensors, of_point), "test");
    const double cell = step < 0.05 ? 0.05 : 0.8;  // half a metre apart, all are in cells of their own of 0.4 m
    ASSERT_LE(cloud.sensors.positions().size(), SensorPositions::kMost);
    double worst = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      worst = std::max(worst, (cloud.sensors.positions()[cloud.sensors.of_point(i)] - sensors[i]).cwiseAbs().maxCoeff());
    }
    EXPECT_LE(worst, cell / 2 + 1e-9);
  }
}

TEST(SensorPositions, AreTakenWithTheNumbersOfTheirPoints) {
  const Positions two{{0, 0, 1}, {0, 0, 2}};
  const SensorPositions sensors(two, std::vector<std::uint32_t>{1, 0, 2, 1});
  EXPECT_EQ(sensors.of_point(0), 1U);
  EXPECT_EQ(sensors.of_point(2), 2U) << "not known";
  const SensorPositions some = sensors.of_points(std::vector<std::uint32_t>{3, 1});
  EXPECT_EQ(some.positions(), two);
  EXPECT_EQ(some.of_point(0), 1U);
  EXPECT_EQ(some.of_point(1), 0U);
  EXPECT_TRUE(SensorPositions(Vector(1, 2, 3)).of_points(std::vector<std::uint32_t>{0}).single());
  EXPECT_THROW(SensorPositions(two, std::vector<std::uint32_t>{3}), Error);
  EXPECT_THROW(SensorPositions({Vector(0, kNan, 0)}, {}), Error);
  EXPECT_THROW(SensorPositions(Positions(SensorPositions::kMost + 1, Vector::Zero()), {}), Error);
}

}  // namespace
}  // namespace scenelore::perception
