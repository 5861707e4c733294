// Finds the distinct ones among the sensor positions of many points.
#pragma once

#include <array>
#include <optional>
#include <unordered_map>

#include "scenelore/perception/sensor_positions.hpp"

namespace scenelore::perception {

/// Takes the positions of points one after another. With a `cell` (metres; 0 = none) positions become the middles of such cubes, so
/// that a sensor on the move has few of them.
class SensorCollector {
 public:
  SensorCollector(std::size_t points, double cell) : points_(points), cell_(cell) {}

  /// The next point's position; nothing = not known. False when it would be one more than SensorPositions::kMost; the
  /// collector is of no more use then.
  [[nodiscard]] bool add(const std::optional<Eigen::Vector3d>& position);
  /// The next point's is that of the point before; the first point's is the first position there is.
  void repeat() { put(last_); }
  /// Requires: as many points were taken as promised.
  [[nodiscard]] SensorPositions finish() &&;

 private:
  using Key = std::array<std::uint64_t, 3>;
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };

  [[nodiscard]] std::optional<std::size_t> number_of(const Eigen::Vector3d& position);
  void put(std::size_t number);
  void widen();

  std::size_t points_, taken_ = 0;
  double cell_;
  std::size_t last_ = 0;
  bool unknown_ = false;  ///< of some point
  SensorPositions found_;
  std::unordered_map<Key, std::size_t, Hash> numbers_;
};

}  // namespace scenelore::perception
