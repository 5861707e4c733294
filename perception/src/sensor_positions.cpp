#include "scenelore/perception/sensor_positions.hpp"

#include <string>

#include "scenelore/perception/error.hpp"
#include "sensor_collector.hpp"

namespace scenelore::perception {

SensorPositions::SensorPositions(std::vector<Eigen::Vector3d> positions, std::span<const std::uint32_t> of_point) {
  if (positions.size() > kMost) {
    throw Error(std::to_string(positions.size()) + " sensor positions; a cloud has at most " + std::to_string(kMost));
  }
  for (const Eigen::Vector3d& position : positions) {
    if (!position.allFinite()) throw Error("the coordinates of a sensor position are not finite");
  }
  bool same = true;
  for (const std::uint32_t number : of_point) {
    if (number > positions.size()) {
      throw Error("sensor position " + std::to_string(number) + " of " + std::to_string(positions.size()) + " (counted from 0)");
    }
    same = same && number == 0;
  }
  positions_ = std::move(positions);
  if (positions_.empty() || (same && positions_.size() == 1)) return;
  if (positions_.size() <= kMostNarrow) {
    narrow_.assign(of_point.begin(), of_point.end());
  } else {
    wide_.assign(of_point.begin(), of_point.end());
  }
}

SensorPositions SensorPositions::of_points(std::span<const std::uint32_t> points) const {
  SensorPositions some;
  some.positions_ = positions_;
  const auto pick = [&](const auto& from, auto& to) {
    if (from.empty()) return;
    to.reserve(points.size());
    for (const std::uint32_t i : points) to.push_back(from[i]);
  };
  pick(narrow_, some.narrow_);
  pick(wide_, some.wide_);
  return some;
}

}  // namespace scenelore::perception
