#include "simulator/occupancy.hpp"

#include <algorithm>
#include <cmath>

namespace scenelore::simulator {
namespace {

constexpr double kSlack = 1e-3;

Eigen::Vector2d other_axis(const Volume& v) { return {-v.axis.y(), v.axis.x()}; }

double reach(const Volume& v, const Eigen::Vector2d& direction) {
  return v.half_x * std::abs(v.axis.dot(direction)) + v.half_y * std::abs(other_axis(v).dot(direction));
}

}  // namespace

Volume volume(const Eigen::Isometry3d& frame, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  const Eigen::Vector3d centre = frame * ((low + high) / 2).eval();
  return {centre.head<2>(),
          frame.linear().col(0).head<2>().normalized(),
          (high.x() - low.x()) / 2,
          (high.y() - low.y()) / 2,
          frame.translation().z() + low.z(),
          frame.translation().z() + high.z()};
}

// Separating axes: two rectangles are apart when one of their four edge directions tells them apart.
bool overlap(const Volume& x, const Volume& y) {
  if (x.high <= y.low + kSlack || y.high <= x.low + kSlack) return false;
  const Eigen::Vector2d between = y.centre - x.centre;
  return std::ranges::all_of(std::initializer_list<Eigen::Vector2d>{x.axis, other_axis(x), y.axis, other_axis(y)},
                             [&](const Eigen::Vector2d& direction) {
                               return std::abs(between.dot(direction)) <
                                      reach(x, direction) + reach(y, direction) - kSlack;
                             });
}

bool Occupancy::free(const Volume& wanted) const {
  const double x = reach(wanted, Eigen::Vector2d::UnitX()), y = reach(wanted, Eigen::Vector2d::UnitY());
  const bool inside = wanted.centre.x() - x > -kSlack && wanted.centre.x() + x < width_ + kSlack &&
                      wanted.centre.y() - y > -kSlack && wanted.centre.y() + y < depth_ + kSlack;
  return inside && std::ranges::none_of(taken_, [&](const Volume& other) { return overlap(wanted, other); });
}

bool Occupancy::free(std::span<const Volume> wanted) const {
  return std::ranges::all_of(wanted, [&](const Volume& v) { return free(v); });
}

}  // namespace scenelore::simulator
