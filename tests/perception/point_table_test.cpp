#include "scenelore/perception/point_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

PointTable numbered(std::size_t rows) {
  PointTable table;
  table.rows = rows;
  std::vector<float> x(rows), y(rows), z(rows);
  for (std::size_t i = 0; i < rows; ++i) x[i] = static_cast<float>(i), y[i] = static_cast<float>(2 * i), z[i] = -0.5F;
  table.set_column("x", x);
  table.set_column("y", y);
  table.set_column("z", z);
  return table;
}

TEST(PointTable, KeepsOtherColumnsWhenOneIsAppended) {
  PointTable table = numbered(5);
  table.set_column("label", std::vector<std::int32_t>{5, 4, 3, 2, -1});
  EXPECT_EQ(table.stride, 16U);
  EXPECT_EQ(table.bytes.size(), 80U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(table.value(*table.find("x"), i), static_cast<double>(i));
    EXPECT_EQ(table.value(*table.find("y"), i), static_cast<double>(2 * i));
    EXPECT_EQ(table.value(*table.find("z"), i), -0.5);
  }
  EXPECT_EQ(table.value(*table.find("label"), 4), -1.0);
}

TEST(PointTable, ReplacesAColumnOfTheSameNameAndType) {
  PointTable table = numbered(3);
  table.set_column("y", std::vector<float>{7, 8, 9});
  EXPECT_EQ(table.columns.size(), 3U);
  EXPECT_EQ(table.value(*table.find("y"), 2), 9.0);
  EXPECT_EQ(table.value(*table.find("z"), 2), -0.5);
}

TEST(PointTable, ReplacesAColumnOfAnotherType) {
  PointTable table = numbered(3);
  table.set_column("y", std::vector<std::uint8_t>{7, 8, 255});
  ASSERT_EQ(table.columns.size(), 3U);
  EXPECT_EQ(table.stride, 9U);
  EXPECT_EQ(table.find("y")->type, ScalarType::u8);
  EXPECT_EQ(table.value(*table.find("y"), 2), 255.0);
  EXPECT_EQ(table.value(*table.find("x"), 2), 2.0);
  EXPECT_EQ(table.value(*table.find("z"), 2), -0.5);
}

TEST(PointTable, RefusesAColumnOfAnotherLength) {
  PointTable table = numbered(3);
  EXPECT_THROW(table.set_column("label", std::vector<std::int32_t>{1, 2}), Error);
  EXPECT_EQ(table.find("label"), nullptr);
}

TEST(ToCloud, KeepsSmallFloatsBitExactAboutOriginZero) {
  PointTable table = numbered(3);
  table.set_column("x", std::vector<float>{0.1F, 1e-20F, 999.9F});
  const Cloud cloud = to_cloud(table, "test");
  EXPECT_EQ(cloud.origin, Eigen::Vector3d::Zero());
  EXPECT_EQ(cloud.x, (std::vector<float>{0.1F, 1e-20F, 999.9F}));
  EXPECT_EQ(cloud.invalid, 0U);
}

TEST(ToCloud, FlagsInvalidPointsAndKeepsTheirIndex) {
  PointTable table = numbered(4);
  table.set_column(
      "y", std::vector<float>{1, std::numeric_limits<float>::quiet_NaN(), 3, std::numeric_limits<float>::infinity()});
  const Cloud cloud = to_cloud(table, "test");
  EXPECT_EQ(cloud.size(), 4U);
  EXPECT_EQ(cloud.invalid, 2U);
  EXPECT_TRUE(cloud.valid(0));
  EXPECT_FALSE(cloud.valid(1));
  EXPECT_TRUE(cloud.valid(2));
  EXPECT_FALSE(cloud.valid(3));
  EXPECT_TRUE(std::isnan(cloud.z[3]));
}

TEST(ToCloud, AFewWildPointsDoNotMoveTheOrigin) {
  PointTable table = numbered(1000);
  std::vector<float> x(1000, 1.5F);
  x[500] = 1e30F;
  table.set_column("x", x);
  table.set_column("y", x);
  const Cloud cloud = to_cloud(table, "test");
  EXPECT_EQ(cloud.origin, Eigen::Vector3d::Zero());
  EXPECT_EQ(cloud.x[0], 1.5F);
}

std::string error_of(const PointTable& table) {
  try {
    (void)to_cloud(table, "room.ply");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(ToCloud, NamesThePropertiesThereAreWhenACoordinateIsMissing) {
  PointTable table;
  table.rows = 1;
  table.set_column("x", std::vector<float>{1});
  table.set_column("y", std::vector<float>{1});
  table.set_column("height", std::vector<float>{1});
  EXPECT_EQ(error_of(table), "room.ply: no property 'z'; a scan needs x, y and z (properties found: x, y, height)");
}

TEST(ToCloud, RefusesNoPointsAndNoValidPoints) {
  EXPECT_EQ(error_of(numbered(0)), "room.ply holds no points");
  PointTable table = numbered(2);
  table.set_column("x", std::vector<float>(2, std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(error_of(table), "room.ply: none of the 2 points has finite coordinates");
}

}  // namespace
}  // namespace scenelore::perception
