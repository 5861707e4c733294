#include "simulator/poses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace scenelore::simulator {
namespace {

// Tables, screens and keyboards count for a place to measure from: the more of them show, the better, with little gain
// from more points of what is seen well anyway.
double worth(const Office& office, const std::vector<std::size_t>& counts) {
  double sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const ObjectClass c = office.scene.objects()[i].object_class;
    const double weight = c == ObjectClass::table         ? 0.5
                          : c == ObjectClass::flat_screen ? 1.5
                          : c == ObjectClass::keyboard    ? 3
                                                          : 0.02;
    sum += weight * std::sqrt(std::min(static_cast<double>(counts[i]), 50.0));
  }
  return sum;
}

SensorPose draw_pose(const Office& office, std::size_t stand, Sensor sensor, Random& random) {
  SensorPose pose;
  const Eigen::Vector2d at = office.stands[stand];
  const Eigen::Vector2d to_middle = Eigen::Vector2d(office.width, office.depth) / 2 - at;
  pose.position =
      Vector3d(at.x(), at.y(), sensor == Sensor::lidar ? random.between(1.1, 1.5) : random.between(1.2, 1.6));
  pose.heading = std::atan2(to_middle.y(), to_middle.x()) + random.normal() * 0.4;
  if (sensor == Sensor::depth_camera && !office.desks.empty()) {  // somebody points it at a desk
    const Desk& desk =
        office.desks[static_cast<std::size_t>(random.integer(0, static_cast<int>(office.desks.size()) - 1))];
    const Eigen::Vector2d to = desk.frame.translation().head<2>() - at;
    pose.heading = std::atan2(to.y(), to.x()) + random.normal() * 0.1;
  }
  if (sensor == Sensor::depth_camera) pose.pitch = random.between(12, 28) * std::numbers::pi / 180;
  return pose;
}

}  // namespace

std::vector<Sample> scan(const World& world, const SensorPose& pose, Sensor sensor, double scale) {
  return sensor == Sensor::lidar ? scan_lidar(world, pose, scale) : scan_depth_camera(world, pose, scale);
}

std::vector<std::size_t> count_points(const std::vector<Sample>& samples, std::size_t objects) {
  std::vector<std::size_t> counts(objects, 0);
  for (const Sample& sample : samples) {
    if (sample.object >= 0) ++counts[static_cast<std::size_t>(sample.object)];
  }
  return counts;
}

PosePlan plan_poses(const Office& office, const World& world, const SimulationOptions& options) {
  constexpr double coarse = 5;
  Random random(options.seed, 2000);
  PosePlan planned;
  std::vector<std::size_t> seen(office.scene.objects().size(), 0);
  for (int number = 0; number < options.poses; ++number) {
    double best = -1;
    SensorPose chosen;
    std::vector<std::size_t> chosen_counts;
    for (int candidate = 0; candidate < 5; ++candidate) {
      const auto stand = static_cast<std::size_t>(random.integer(0, static_cast<int>(office.stands.size()) - 1));
      SensorPose pose = draw_pose(office, stand, options.sensor, random);
      pose.number = number;
      std::vector<std::size_t> counts = count_points(scan(world, pose, options.sensor, coarse), seen.size());
      for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += seen[i];
      const double value = worth(office, counts);
      if (value <= best) continue;
      best = value;
      chosen = pose;
      chosen_counts = std::move(counts);
    }
    planned.poses.push_back(chosen);
    seen = std::move(chosen_counts);
  }
  const std::size_t total = std::accumulate(seen.begin(), seen.end(), std::size_t{0});
  planned.points = static_cast<double>(total) * coarse * coarse / options.poses;
  return planned;
}

}  // namespace scenelore::simulator
