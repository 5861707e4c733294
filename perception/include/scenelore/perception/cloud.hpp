// The geometry of a scan: what segmentation works on.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "scenelore/perception/point_table.hpp"

namespace scenelore::perception {

/// Structure of arrays: double origin + float offsets, so that large coordinates keep their precision. Invalid points
/// (NaN or infinite coordinates) keep their index and have NaN offsets.
struct Cloud {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::vector<float> x, y, z;
  std::size_t invalid = 0;                   ///< number of invalid points
  std::optional<Eigen::Vector3d> viewpoint;  ///< sensor position in the file's frame, where known

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] bool valid(std::size_t i) const { return x[i] == x[i]; }
  [[nodiscard]] Eigen::Vector3f offset(std::size_t i) const { return {x[i], y[i], z[i]}; }
  [[nodiscard]] Eigen::Vector3d position(std::size_t i) const { return origin + offset(i).cast<double>(); }
};

/// Takes x, y, z. Throws Error (saying what was found) without these columns, without points, or without valid points.
[[nodiscard]] Cloud to_cloud(const PointTable& table, const std::string& source_name);

/// The geometry of a point file: what to_cloud(read_points(path)) gives, with the same errors, but rows of binary PLY
/// (little endian) and PCD files are read where they stand in the file, once and without a table. `threads` changes
/// nothing but the time.
[[nodiscard]] Cloud read_cloud(const std::filesystem::path& path, int threads = 2);

}  // namespace scenelore::perception
