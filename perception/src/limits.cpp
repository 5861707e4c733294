#include "limits.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "scenelore/perception/error.hpp"

namespace scenelore::perception {
namespace {

void check_positive(const std::optional<double>& value, const char* name) {
  if (value && !(*value > 0 && std::isfinite(*value))) {
    throw Error(std::string("segmentation parameter ") + name + " is " + std::to_string(*value) + "; it must be a number greater than 0");
  }
}

void check_count(const std::optional<int>& value, const char* name, int lowest) {
  if (value && *value < lowest) {
    throw Error(std::string("segmentation parameter ") + name + " is " + std::to_string(*value) + "; it must be at least " + std::to_string(lowest));
  }
}

constexpr double kPointDistanceVoxels = 32;  // 1.6 m at the usual voxel: the shadow of a cabinet on the wall behind it
constexpr double kSmallStepVoxels = 6;       // 30 cm: that of a screen on a table, but not the way between two tables
constexpr double kFewestPoints = 20;        // of a keyboard at 3 m
constexpr int kComparisons = 30;

}  // namespace

void check(const SegmentationParameters& p) {
  check_positive(p.max_point_distance, "max_point_distance");
  check_positive(p.max_plane_distance, "max_plane_distance");
  check_positive(p.max_mse, "max_mse");
  check_count(p.min_points, "min_points", 3);
  check_count(p.max_neighbours, "max_neighbours", 1);
}

Limits derive_limits(const SegmentationParameters& p, const Scale& scale, const NoiseMap& noise) {
  Limits limits;
  const double floor = scale.voxel / 50;
  const double high = std::max({noise.high, 1.2 * noise.typical, floor});
  limits.max_point_distance = p.max_point_distance.value_or(std::max(kPointDistanceVoxels * scale.voxel, 4 * scale.spacing));
  limits.small_plane_step = std::min(limits.max_point_distance, std::max(kSmallStepVoxels * scale.voxel, 4 * scale.spacing));
  if (p.max_point_distance) limits.small_plane_step = *p.max_point_distance;
  limits.max_plane_distance = p.max_plane_distance.value_or(3 * high);
  limits.plane_distance_given = p.max_plane_distance.has_value();
  limits.max_mse = p.max_mse.value_or(2 * high * high);
  limits.min_points = p.min_points.value_or(static_cast<int>(kFewestPoints));
  limits.max_neighbours = static_cast<std::size_t>(p.max_neighbours.value_or(kComparisons));
  return limits;
}

SegmentationParameters to_parameters(const Limits& limits) {
  SegmentationParameters p;
  p.max_point_distance = limits.max_point_distance;
  p.max_plane_distance = limits.max_plane_distance;
  p.max_mse = limits.max_mse;
  p.min_points = static_cast<int>(limits.min_points);
  p.max_neighbours = static_cast<int>(limits.max_neighbours);
  return p;
}

}  // namespace scenelore::perception
