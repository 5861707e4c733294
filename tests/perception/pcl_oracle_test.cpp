// The Point Cloud Library as an oracle of our readers, where it reads right (not: double coordinates in PLY files), and
// as a reader of what we write. Its headers are heavy: this is the only source that sees them.
#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include "point_file_support.hpp"
#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception {
namespace {

using PclOracle = PointFiles;

std::uint8_t pcl_type(ScalarType type) {
  switch (type) {
    case ScalarType::i8:
      return pcl::PCLPointField::INT8;
    case ScalarType::u8:
      return pcl::PCLPointField::UINT8;
    case ScalarType::i16:
      return pcl::PCLPointField::INT16;
    case ScalarType::u16:
      return pcl::PCLPointField::UINT16;
    case ScalarType::i32:
      return pcl::PCLPointField::INT32;
    case ScalarType::u32:
      return pcl::PCLPointField::UINT32;
    case ScalarType::f64:
      return pcl::PCLPointField::FLOAT64;
    default:
      return pcl::PCLPointField::FLOAT32;
  }
}

pcl::PCLPointCloud2 to_pcl(const PointTable& table) {
  pcl::PCLPointCloud2 cloud;
  cloud.width = static_cast<std::uint32_t>(table.rows);
  cloud.height = 1;
  cloud.point_step = static_cast<std::uint32_t>(table.stride);
  cloud.row_step = static_cast<std::uint32_t>(table.stride * table.rows);
  cloud.data.resize(table.bytes.size());
  std::memcpy(cloud.data.data(), table.bytes.data(), table.bytes.size());
  for (const Column& column : table.columns) {
    pcl::PCLPointField field;
    field.name = column.name;
    field.offset = static_cast<std::uint32_t>(column.offset);
    field.datatype = pcl_type(column.type);
    field.count = 1;
    cloud.fields.push_back(field);
  }
  return cloud;
}

/// Every value of every field is, bit by bit, in our table under the same name.
void expect_same_values(const pcl::PCLPointCloud2& cloud, const PointTable& table) {
  ASSERT_EQ(static_cast<std::size_t>(cloud.width) * cloud.height, table.rows);
  ASSERT_EQ(cloud.fields.size(), table.columns.size());
  for (const pcl::PCLPointField& field : cloud.fields) {
    const Column* const column = table.find(field.name);
    ASSERT_NE(column, nullptr) << field.name;
    ASSERT_EQ(field.datatype, pcl_type(column->type)) << field.name;
    for (std::size_t row = 0; row < table.rows; ++row) {
      EXPECT_EQ(0, std::memcmp(cloud.data.data() + row * cloud.point_step + field.offset,
                               table.bytes.data() + row * table.stride + column->offset, size_of(column->type)))
          << field.name << " of point " << row;
    }
  }
}

TEST_F(PclOracle, ReadsThePcdFilesThatWeWrite) {
  const PointTable table = table_of_every_type(ScalarType::f32, false);
  write_points(path("ours.pcd"), table);
  pcl::PCLPointCloud2 cloud;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  ASSERT_EQ(pcl::PCDReader().read(path("ours.pcd").string(), cloud, origin, orientation, version), 0);
  expect_same_values(cloud, table);
  EXPECT_EQ(origin.head<3>(), table.viewpoint->cast<float>());
}

TEST_F(PclOracle, WritesPcdFilesInThreeEncodingsThatWeRead) {
  const PointTable table = table_of_every_type(ScalarType::f32, false);
  const pcl::PCLPointCloud2 cloud = to_pcl(table);
  const Eigen::Vector4f origin(1, -2, 0.5F, 0);
  pcl::PCDWriter writer;
  ASSERT_EQ(writer.writeBinary(path("binary.pcd").string(), cloud, origin), 0);
  ASSERT_EQ(writer.writeBinaryCompressed(path("compressed.pcd").string(), cloud, origin), 0);
  for (const char* name : {"binary.pcd", "compressed.pcd"}) {
    SCOPED_TRACE(name);
    const PointTable ours = read_points(path(name));
    expect_same_values(cloud, ours);
    EXPECT_EQ(ours.viewpoint, Eigen::Vector3d(1, -2, 0.5));
  }
  ASSERT_EQ(writer.writeASCII(path("ascii.pcd").string(), cloud, origin, Eigen::Quaternionf::Identity(), 9), 0);
  const PointTable ours = read_points(path("ascii.pcd"));
  pcl::PCLPointCloud2 theirs;
  ASSERT_EQ(pcl::PCDReader().read(path("ascii.pcd").string(), theirs), 0);
  expect_same_values(theirs, ours);
}

/// PCL's ASCII writer prints a double with the float's number of digits, and its PLY files hold no denormal that
/// survives: plain values for the comparisons through text.
PointTable plain_table() {
  PointTable table;
  table.rows = 5;
  for (const char* name : {"x", "y", "z", "curvature"})
    table.set_column(name, std::vector<float>{0, 0.1F, -2.5F, 1e-7F, 123456.7F});
  table.set_column("label", std::vector<std::int32_t>{0, -1, 7, 2147483647, -2147483647});
  table.set_column("class", std::vector<std::uint8_t>{0, 1, 2, 128, 255});
  return table;
}

TEST_F(PclOracle, ReadsThePlyFilesThatWeWrite) {
  const PointTable table = plain_table();
  write_points(path("ours.ply"), table);
  pcl::PCLPointCloud2 cloud;
  ASSERT_EQ(pcl::PLYReader().read(path("ours.ply").string(), cloud), 0);
  expect_same_values(cloud, table);
}

TEST_F(PclOracle, TellsTheSensorOfEachPointAsWeReadIt) {
  pcl::PointCloud<pcl::PointWithViewpoint> cloud;
  for (int i = 0; i < 9; ++i) {
    const auto f = static_cast<float>(i);
    cloud.push_back(pcl::PointWithViewpoint(f, 2 * f, -f, static_cast<float>(i / 3), 0.1F, 1.5F));
  }
  pcl::PCDWriter writer;
  ASSERT_EQ(writer.writeBinary(path("binary.pcd").string(), cloud), 0);
  ASSERT_EQ(writer.writeBinaryCompressed(path("compressed.pcd").string(), cloud), 0);
  ASSERT_EQ(writer.writeASCII(path("ascii.pcd").string(), cloud, 9), 0);
  ASSERT_EQ(pcl::PLYWriter().write(path("binary.ply").string(), cloud, true), 0);
  for (const char* name : {"binary.pcd", "compressed.pcd", "ascii.pcd", "binary.ply"}) {
    SCOPED_TRACE(name);
    const Cloud ours = read_cloud(path(name));
    ASSERT_EQ(ours.sensors.positions().size(), 3U);
    for (std::size_t i = 0; i < 9; ++i) {
      const Eigen::Vector3d sensor = ours.sensors.positions()[ours.sensors.of_point(i)];
      EXPECT_EQ(sensor, Eigen::Vector3d(static_cast<double>(i / 3), static_cast<double>(0.1F), 1.5));
    }
  }
}

TEST_F(PclOracle, WritesPlyFilesInTwoEncodingsThatWeRead) {
  const pcl::PCLPointCloud2 cloud = to_pcl(plain_table());
  const Eigen::Vector4f origin(1, -2, 0.5F, 0);
  pcl::PLYWriter writer;
  ASSERT_EQ(writer.writeBinary(path("binary.ply").string(), cloud, origin), 0);
  ASSERT_EQ(writer.writeASCII(path("ascii.ply").string(), cloud, origin, Eigen::Quaternionf::Identity(), 9), 0);
  for (const char* name : {"binary.ply", "ascii.ply"}) {
    SCOPED_TRACE(name);
    const PointTable ours = read_points(path(name));
    expect_same_values(cloud, ours);
    EXPECT_EQ(ours.viewpoint, Eigen::Vector3d(1, -2, 0.5)) << "told by the element 'camera'";
  }
}

}  // namespace
}  // namespace scenelore::perception
