#include "seen_from.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace scenelore::perception {
namespace {

int sign(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

}  // namespace

std::optional<bool> seen_from_front(const Cloud& cloud, const PlaneEquation& plane, std::span<const std::uint32_t> points) {
  std::vector<int> side;
  for (const Eigen::Vector3d& sensor : cloud.sensors.positions()) side.push_back(sign(plane.distance(sensor - cloud.origin)));
  std::int64_t front = 0;
  if (cloud.sensors.single()) {
    front = side[0];
  } else if (cloud.sensors.known()) {
    side.push_back(0);  // of what was measured from nobody knows where
    for (const std::uint32_t i : points) front += side[cloud.sensors.of_point(i)];
  }
  if (front == 0) return std::nullopt;
  return front > 0;
}

std::vector<double> slants_of(const Cloud& cloud, const Eigen::Vector3d& normal, std::span<const std::uint32_t> points) {
  std::vector<double> slants;
  for (const std::uint32_t i : points) {
    const std::size_t position = cloud.sensors.of_point(i);
    if (position >= cloud.sensors.positions().size()) return {};
    const Eigen::Vector3d ray = cloud.offset(i).cast<double>() - (cloud.sensors.positions()[position] - cloud.origin);
    slants.push_back(std::abs(ray.normalized().dot(normal)));
  }
  return slants;
}

std::optional<double> slant_of(const Cloud& cloud, const Eigen::Vector3d& normal, std::span<const std::uint32_t> points) {
  const std::vector<double> slants = slants_of(cloud, normal, points);
  if (slants.empty()) return std::nullopt;
  return std::accumulate(slants.begin(), slants.end(), 0.0) / static_cast<double>(slants.size());
}

double noise_across(double noise, double slant) { return noise * std::max(slant, 0.1); }

}  // namespace scenelore::perception
