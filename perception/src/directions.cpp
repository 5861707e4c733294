#include "directions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "parallel.hpp"

namespace scenelore::perception {
namespace {

constexpr int kCoarse = 45;    // cells along a cube's edge, two degrees: wide enough that no view has holes between its points
constexpr int kFinest = 4096;
constexpr double kWide = 1.2;  // steps along a cell's edge, so that few cells within the view are empty

/// From a place on the face of a cube, −1 to 1, to 0..1.
double even(double u) { return u >= 0 ? 0.5 * std::sqrt(1 + 3 * u) : 1 - 0.5 * std::sqrt(1 - 3 * u); }

CellKey key_of(const Eigen::Vector3d& direction, int cells) {
  int axis = 0;
  const double longest = direction.cwiseAbs().maxCoeff(&axis);
  if (!(longest > 0) || !std::isfinite(longest)) return kNoCell;
  const auto cell = [&](int other) {
    return std::min<std::int64_t>(cells - 1, static_cast<std::int64_t>(cells * even(direction[(axis + other) % 3] / longest)));
  };
  return cell_key(cell(1), cell(2), 2 * axis + (direction[axis] > 0 ? 1 : 0));
}

std::vector<CellKey> keys_of(const Cloud& cloud, const std::vector<std::uint32_t>& points, const Eigen::Vector3d& eye, int cells, int threads) {
  std::vector<CellKey> keys(points.size());
  parallel_pieces(points.size(), 1 << 14, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) keys[i] = key_of(cloud.offset(points[i]).cast<double>() - eye, cells);
  });
  return keys;
}

}  // namespace

Directions::Directions(const Cloud& cloud, std::vector<std::uint32_t> points, const Eigen::Vector3d& eye, int threads)
    : eye_(eye), points_(std::move(points)) {
  if (points_.empty()) return;
  const double view = 4 * std::numbers::pi * static_cast<double>(CellIndex(keys_of(cloud, points_, eye, kCoarse, threads)).size()) /
                      (6.0 * kCoarse * kCoarse);
  step_ = std::sqrt(view / static_cast<double>(points_.size()));
  cells_ = static_cast<int>(std::clamp(std::numbers::pi / 2 / (kWide * step_), 1.0, static_cast<double>(kFinest)));
  index_ = CellIndex(keys_of(cloud, points_, eye, cells_, threads));
}

void Directions::append(const Eigen::Vector3d& direction, std::vector<std::uint32_t>& found) const {
  const std::int32_t cell = index_.find(key_of(direction, cells_));
  if (cell < 0) return;
  for (const std::uint32_t item : index_.items(static_cast<std::size_t>(cell))) found.push_back(points_[item]);
}

void Directions::measured_towards(const Eigen::Vector3d& place, std::vector<std::uint32_t>& found) const {
  found.clear();
  if (points_.empty()) return;
  const Eigen::Vector3d direction = place - eye_;
  append(direction, found);
  if (!found.empty()) return;
  const double width = std::numbers::pi / 2 / cells_ * direction.norm();
  const Eigen::Vector3d a = direction.unitOrthogonal() * width, b = direction.normalized().cross(a);
  for (const double s : {-1.0, 0.0, 1.0}) {
    for (const double t : {-1.0, 0.0, 1.0}) {
      if (s != 0 || t != 0) append(direction + s * a + t * b, found);
    }
  }
}

}  // namespace scenelore::perception
