// Where the sensor is put, and the measuring from there.
#pragma once

#include <vector>

#include "simulator/office.hpp"
#include "simulator/sensor.hpp"

namespace scenelore::simulator {

struct PosePlan {
  std::vector<SensorPose> poses;
  double points = 0;  ///< a pose, at scale 1; estimated
};

/// Poses one after another, each the best of a few drawn ones given the poses before it, judged by coarse scans.
/// Best means to show tables, screens and keyboards; nothing promises that all of them show.
[[nodiscard]] PosePlan plan_poses(const Office& office, const World& world, const SimulationOptions& options);
[[nodiscard]] std::vector<Sample> scan(const World& world, const SensorPose& pose, Sensor sensor, double scale);
/// Points of each object; mixed pixels are not counted.
[[nodiscard]] std::vector<std::size_t> count_points(const std::vector<Sample>& samples, std::size_t objects);

}  // namespace scenelore::simulator
