#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "formats.hpp"
#include "rows_to_cloud.hpp"
#include "scenelore/perception/error.hpp"
#include "sensor_collector.hpp"

namespace scenelore::perception {
namespace {

// The names that the Point Cloud Library's PointWithViewpoint has in files.
constexpr std::array<const char*, 3> kNames{"vp_x", "vp_y", "vp_z"};
// A sensor on the move: a ray turns by 2 degrees at most over a metre.
constexpr double kMovingCell = 0.05;  // metres
constexpr std::size_t kPiece = 1 << 18;

using Axes = std::array<const Column*, 3>;

/// Nothing without these columns.
std::optional<Axes> sensor_columns(const PointTable& table, const std::string& source_name) {
  Axes axes{};
  for (std::size_t axis = 0; axis < 3; ++axis) axes[axis] = table.find(kNames[axis]);
  const auto missing = std::find(axes.begin(), axes.end(), nullptr);
  if (std::count(axes.begin(), axes.end(), nullptr) == 3) return std::nullopt;
  if (missing != axes.end()) {
    throw Error(source_name + ": no property '" + kNames[static_cast<std::size_t>(missing - axes.begin())] +
                "'; the sensor's position is told by vp_x, vp_y and vp_z together, or by none of them");
  }
  return axes;
}

/// The sensor positions of rows, read one after another.
class SensorRows {
 public:
  SensorRows(const RowSource& rows, const Axes& axes, const std::string& source_name) : rows_(rows), axes_(axes), name_(source_name) {
    const auto size = [&](std::size_t axis) { return size_of(axes[axis]->type); };
    const bool in_a_row = axes[1]->offset == axes[0]->offset + size(0) && axes[2]->offset == axes[1]->offset + size(1);
    if (in_a_row) together_ = size(0) + size(1) + size(2);
  }

  /// As the row before, bit by bit. Requires: row > 0.
  [[nodiscard]] bool repeats(std::size_t row) const {
    const std::byte* const at = rows_.bytes + row * rows_.table.stride;
    if (together_ > 0) return std::memcmp(at + axes_[0]->offset, at - rows_.table.stride + axes_[0]->offset, together_) == 0;
    return std::all_of(axes_.begin(), axes_.end(), [&](const Column* c) {
      return std::memcmp(at + c->offset, at - rows_.table.stride + c->offset, size_of(c->type)) == 0;
    });
  }

  /// The file's where this row has none. Throws Error for numbers that are no position.
  [[nodiscard]] std::optional<Eigen::Vector3d> position(std::size_t row) const {
    Eigen::Vector3d at;
    for (std::size_t axis = 0; axis < 3; ++axis) at[static_cast<Eigen::Index>(axis)] = value_at(rows_, *axes_[axis], row);
    if (at.array().isNaN().all()) return rows_.table.viewpoint;
    if (at.cast<float>().allFinite()) return at;
    throw Error(name_ + ": point " + std::to_string(row) + ": vp_x, vp_y and vp_z are " + shortest(at.x()) + ", " + shortest(at.y()) + " and " +
                shortest(at.z()) + "; the sensor's position is three finite numbers, or nan three times where it is not known");
  }

 private:
  const RowSource& rows_;
  const Axes& axes_;
  const std::string& name_;
  std::size_t together_ = 0;  ///< bytes of all three columns where they stand side by side, else 0
};

}  // namespace

SensorPositions sensors_of(const RowSource& rows, const Cloud& cloud, const std::string& source_name) {
  const PointTable& table = rows.table;
  const std::optional<Axes> axes = sensor_columns(table, source_name);
  if (!axes) return table.viewpoint ? SensorPositions(*table.viewpoint) : SensorPositions();
  const SensorRows sensors(rows, *axes, source_name);
  const auto collect = [&](double cell) -> std::optional<SensorPositions> {
    SensorCollector collector(table.rows, cell);
    for (std::size_t first = 0; first < table.rows; first += kPiece) {
      const std::size_t last = std::min(table.rows, first + kPiece);
      for (std::size_t row = first; row < last; ++row) {
        if (!cloud.valid(row) || (row > 0 && cloud.valid(row - 1) && sensors.repeats(row))) {
          collector.repeat();
        } else if (!collector.add(sensors.position(row))) {
          return std::nullopt;
        }
      }
      if (rows.file != nullptr) rows.file->let_go(rows.bytes + first * table.stride, rows.bytes + last * table.stride);
    }
    return std::move(collector).finish();
  };
  std::optional<SensorPositions> found = collect(0);
  for (double cell = kMovingCell; !found; cell *= 2) found = collect(cell);
  return *std::move(found);
}

}  // namespace scenelore::perception
