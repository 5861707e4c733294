#include "directions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenelore/perception/parallel.hpp"

namespace scenelore::perception {
namespace {

constexpr int kCoarse = 45;    // cells along a cube's edge, two degrees: wide enough that no view has holes between its points
constexpr int kFinest = 4096;
constexpr double kWide = 1.2;  // steps along a cell's edge, so that few cells within the view are empty

/// From a place on the face of a cube, −1 to 1, to 0..1.
double even(double u) { return u >= 0 ? 0.5 * std::sqrt(1 + 3 * u) : 1 - 0.5 * std::sqrt(1 - 3 * u); }

/// Where a direction meets the cube.
struct Seen {
  double u = 0, v = 0;  ///< on the face, 0..1
  int face = -1;        ///< 0 to 5; −1 = it has no direction

  [[nodiscard]] CellKey key(int cells) const { return face < 0 ? kNoCell : cell_key(cell(u, cells), cell(v, cells), face); }
  [[nodiscard]] static std::int64_t cell(double place, int cells) { return std::min<std::int64_t>(cells - 1, static_cast<std::int64_t>(cells * place)); }
};

Seen seen(const Eigen::Vector3d& direction) {
  int axis = 0;
  double longest = std::abs(direction[0]);
  for (const int other : {1, 2}) {
    if (std::abs(direction[other]) > longest) longest = std::abs(direction[other]), axis = other;
  }
  if (!(longest > 0) || !std::isfinite(direction.sum())) return {};
  return {even(direction[(axis + 1) % 3] / longest), even(direction[(axis + 2) % 3] / longest), 2 * axis + (direction[axis] > 0 ? 1 : 0)};
}

/// Number of coarse cells that hold something.
std::size_t held_cells(const std::vector<Seen>& all) {
  std::vector<bool> held(6 * kCoarse * kCoarse, false);
  for (const Seen& s : all) {
    if (s.face >= 0) held[static_cast<std::size_t>((s.face * kCoarse + Seen::cell(s.u, kCoarse)) * kCoarse + Seen::cell(s.v, kCoarse))] = true;
  }
  return static_cast<std::size_t>(std::count(held.begin(), held.end(), true));
}

}  // namespace

Directions::Directions(const Cloud& cloud, std::vector<std::uint32_t> points, const Eigen::Vector3d& eye, int threads)
    : eye_(eye), points_(std::move(points)) {
  if (points_.empty()) return;
  std::vector<Seen> all(points_.size());
  parallel_pieces(points_.size(), 1 << 14, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) all[i] = seen(cloud.offset(points_[i]).cast<double>() - eye);
  });
  const double view = 4 * std::numbers::pi * static_cast<double>(held_cells(all)) / (6.0 * kCoarse * kCoarse);
  step_ = std::sqrt(view / static_cast<double>(points_.size()));
  cells_ = static_cast<int>(std::clamp(std::numbers::pi / 2 / (kWide * step_), 1.0, static_cast<double>(kFinest)));
  std::vector<CellKey> keys(points_.size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = all[i].key(cells_);
  index_ = CellIndex(keys);
}

void Directions::append(const Eigen::Vector3d& direction, std::vector<std::uint32_t>& found) const {
  const std::int32_t cell = index_.find(seen(direction).key(cells_));
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
