#include "surroundings.hpp"

#include <algorithm>
#include <cmath>

namespace scenelore::perception {
namespace {

constexpr double kEdge = 0.1, kBlock = 1.0;  // metres
constexpr double kFewestPoints = 3;          // of a cube; fewer are strays
constexpr double kReach = 0.3;               // metres around the outline's box
constexpr double kDepth = 1.5;               // metres from the plane: what is seen through a door says little about the wall
constexpr double kDeviations = 5;            // up to which a point may be the plane's own

CellKey key_of(const Eigen::Vector3d& place, double edge) {
  std::int64_t at[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double cell = std::floor(place[axis] / edge);
    if (!(std::abs(cell) < static_cast<double>(kCellLimit))) return kNoCell;
    at[axis] = static_cast<std::int64_t>(cell);
  }
  return cell_key(at[0], at[1], at[2]);
}

/// Whether a place behind `plane` is seen beyond an edge around which it turns, on the near side of the plane there or in it.
bool beside(const Eigen::Vector3d& place, const Plane& plane, double thick, const Eigen::Vector3d& origin, std::span<const Plane* const> turns) {
  if (turns.empty() || plane.normal.dot(place + origin - plane.centroid) > 0) return false;
  return std::any_of(turns.begin(), turns.end(), [&](const Plane* turn) { return turn->normal.dot(place + origin - turn->centroid) > -thick; });
}

}  // namespace

Surroundings::Surroundings(std::span<const Moments> voxels, double voxel) : edge_(std::max(kEdge, voxel)) {
  std::vector<CellKey> keys;
  for (const Moments& m : voxels) keys.push_back(m.n > 0 ? key_of(m.sum / m.n, edge_) : kNoCell);
  const CellIndex cubes(keys);
  std::vector<CellKey> blocks;
  for (std::size_t c = 0; c < cubes.size(); ++c) {
    double n = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::uint32_t v : cubes.items(c)) n += voxels[v].n, sum += voxels[v].sum;
    if (n < kFewestPoints) continue;
    places_.push_back(sum / n);
    blocks.push_back(key_of(places_.back(), kBlock));
  }
  blocks_ = CellIndex(blocks);
}

double Surroundings::behind(const Plane& plane, const Eigen::Vector3d& origin, std::span<const Plane* const> turns) const {
  if (plane.hull.outer.empty()) return -1;
  const Eigen::Matrix3d to_plane = plane.orientation.toRotationMatrix().transpose();
  const Eigen::Vector3d centroid = plane.centroid - origin;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& corner : plane.hull.outer) box.extend((to_plane * (corner - plane.centroid)).head<2>());
  const double thick = std::max(edge_, kDeviations * plane.rmse);
  box.min().array() -= kReach;
  box.max().array() += kReach;

  const double off = kBlock * std::sqrt(3.0) / 2;  // from the middle of a block to its corners
  std::size_t own = 0, before = 0, after = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const CellCoordinates at = coordinates(blocks_.key(b));
    const Eigen::Vector3d middle = kBlock * (Eigen::Vector3d(static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z)).array() + 0.5);
    const Eigen::Vector3d m = to_plane * (middle - centroid);
    if (std::abs(m.z()) > thick + kDepth + off || box.squaredExteriorDistance(m.head<2>()) > off * off) continue;
    for (const std::uint32_t c : blocks_.items(b)) {
      const Eigen::Vector3d p = to_plane * (places_[c] - centroid);
      if (std::abs(p.z()) > thick + kDepth || !box.contains(p.head<2>())) continue;
      if (std::abs(p.z()) > thick && beside(places_[c], plane, thick, origin, turns)) continue;
      ++(std::abs(p.z()) <= thick ? own : p.z() > 0 ? before : after);
    }
  }
  const std::size_t less = std::min(before, after);
  return own + less == 0 ? -1 : static_cast<double>(less) / static_cast<double>(own + less);
}

}  // namespace scenelore::perception
