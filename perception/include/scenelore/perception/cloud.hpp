// The geometry of a scan: what segmentation works on.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scenelore/perception/point_table.hpp"
#include "scenelore/perception/sensor_positions.hpp"

namespace scenelore::perception {

/// Structure of arrays: double origin + float offsets, so that large coordinates keep their precision. Invalid points
/// (NaN or infinite coordinates) keep their index and have NaN offsets.
struct Cloud {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::vector<float> x, y, z;
  std::size_t invalid = 0;  ///< number of invalid points
  SensorPositions sensors;  ///< in the file's frame, where known; those of invalid points mean nothing

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] bool valid(std::size_t i) const { return x[i] == x[i]; }
  [[nodiscard]] Eigen::Vector3f offset(std::size_t i) const { return {x[i], y[i], z[i]}; }
  [[nodiscard]] Eigen::Vector3d position(std::size_t i) const { return origin + offset(i).cast<double>(); }
};

/// Takes x, y, z, and where the sensor stood: by point from vp_x, vp_y, vp_z (those of the Point Cloud Library's PointWithViewpoint;
/// of any type, in metres; nan three times = the table's viewpoint, or unknown), else the table's viewpoint for all. Positions of a
/// sensor on the move, more than SensorPositions holds, are rounded to 5 cm. Throws Error (saying what was found) without
/// x, y or z, without points, without valid points, and for sensor positions of two coordinates or with infinite ones.
[[nodiscard]] Cloud to_cloud(const PointTable& table, const std::string& source_name);

/// The geometry of a point file: what to_cloud(read_points(path)) gives, with the same errors, but rows of binary PLY
/// (little endian) and PCD files are read where they stand in the file, once and without a table. `threads` changes
/// nothing but the time.
[[nodiscard]] Cloud read_cloud(const std::filesystem::path& path, int threads = 2);

}  // namespace scenelore::perception
