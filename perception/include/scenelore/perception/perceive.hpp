// Cloud in, planes out: the whole of perception as one function over its steps.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/parameters.hpp"
#include "scenelore/perception/plane.hpp"
#include "scenelore/perception/upright.hpp"

namespace scenelore::perception {

/// Told the name of each stage as it begins; for progress and measurement.
using StageObserver = std::function<void(std::string_view)>;

struct PerceptionOptions {
  SegmentationParameters parameters;
  std::optional<Eigen::Vector3d> up;  ///< up direction in the file's frame, instead of an estimate
  std::optional<double> floor_z;      ///< floor level along the up direction, instead of an estimate
  int threads = 2;                    ///< changes speed only, never the result
  StageObserver on_stage;             ///< may be empty; called from the calling thread alone
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
