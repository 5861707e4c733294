// Where the sensor stood: one position for a whole cloud, or one for each point of a cloud that was joined from several
// poses or measured on the move.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace scenelore::perception {

/// The distinct positions of a cloud's sensor, in the cloud's own frame (metres), and the number of one for each point. Points
/// take no memory where all share one position, a byte each for 2 to 255 positions, two beyond.
class SensorPositions {
 public:
  static constexpr std::size_t kMost = 65'535, kMostNarrow = 255;  ///< positions; of which a byte tells one, or none

  /// Nothing is known.
  SensorPositions() = default;
  /// One position, of all points.
  explicit SensorPositions(const Eigen::Vector3d& position) : positions_{position} {}
  /// Positions, and by point the number of its own; positions.size() = not known. Throws Error for more than kMost
  /// positions, coordinates that are not finite, and higher numbers.
  SensorPositions(std::vector<Eigen::Vector3d> positions, std::span<const std::uint32_t> of_point);

  /// Whether the position of any point is known.
  [[nodiscard]] bool known() const { return !positions_.empty(); }
  /// Whether there is one position that all points share.
  [[nodiscard]] bool single() const { return positions_.size() == 1 && narrow_.empty() && wide_.empty(); }
  /// In the order in which the points name them.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& positions() const { return positions_; }
  /// Number of the position that a point was measured from; positions().size() where that is not known.
  [[nodiscard]] std::size_t of_point(std::size_t point) const {
    if (!narrow_.empty()) return narrow_[point];
    return wide_.empty() ? 0 : wide_[point];
  }
  /// Those of some of the points, in the order given; the positions keep their numbers.
  [[nodiscard]] SensorPositions of_points(std::span<const std::uint32_t> points) const;

 private:
  friend class SensorCollector;

  std::vector<Eigen::Vector3d> positions_;
  std::vector<std::uint8_t> narrow_;   ///< by point; both are empty where all points share one position
  std::vector<std::uint16_t> wide_;
};

}  // namespace scenelore::perception
