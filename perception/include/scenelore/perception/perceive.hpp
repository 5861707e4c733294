// Cloud in, planes out: the whole of perception as one function over its steps.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/plane.hpp"

namespace scenelore::perception {

/// The paper's five parameters (section 3.1). Metres. A value that is not set is derived from the cloud (spacing, noise).
struct SegmentationParameters {
  std::optional<double> max_point_distance;  ///< largest distance between two neighbouring points of a plane
  std::optional<double> max_plane_distance;  ///< largest distance of a point to its plane
  std::optional<double> max_mse;             ///< m², largest mean squared error of a plane
  std::optional<int> min_points;             ///< smallest number of points of a plane
  std::optional<int> max_neighbours;         ///< what one point may be compared with
};

/// The rotation that makes z point up, and the floor: height = (rotation * p).z − floor_z.
struct Upright {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  double floor_z = 0;
  bool floor_found = false;  ///< false: no floor was visible, floor_z is the lowest level of the cloud
  double confidence = 0;     ///< 0..1
  std::string explanation;   ///< a sentence: from which planes, how far tilted
};

struct PerceptionOptions {
  SegmentationParameters parameters;
  std::optional<Eigen::Vector3d> up;  ///< up direction in the file's frame, instead of an estimate
  std::optional<double> floor_z;      ///< floor level along the up direction, instead of an estimate
  int threads = 2;                    ///< changes speed only, never the result
};

struct Perception {
  SegmentationParameters parameters;        ///< all five set, as used
  double spacing = 0;                       ///< metres, typical distance between neighbouring points
  double noise = 0;                         ///< metres, typical deviation of a point from its surface
  Upright upright;
  std::vector<std::int32_t> plane_of_point; ///< one a point of the cloud, −1 = none
  std::vector<Plane> planes;                ///< by falling point count, ties by position
  std::vector<std::string> warnings;        ///< wrong units, no floor, invalid points: one sentence each
};

/// Throws Error only for impossible options; a cloud without planes gives none and a warning.
[[nodiscard]] Perception perceive(const Cloud& cloud, const PerceptionOptions& options = {});

}  // namespace scenelore::perception
