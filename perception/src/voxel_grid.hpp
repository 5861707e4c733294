// The cloud cut into cubes, with the moments of the points in each and the neighbours of each.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "block_table.hpp"
#include "moments.hpp"

namespace scenelore::perception {

inline constexpr std::size_t kNeighbours = 27;  ///< of a voxel, itself included
inline constexpr std::size_t kSelf = 13;        ///< its own place among them

/// Voxels are numbered by position: block after block, those of one block in a row. Moments are in the cloud's offsets
/// (its origin left out), in double.
struct VoxelGrid {
  double size = 0;  ///< metres, edge of a voxel
  BlockTable table;
  std::vector<std::uint32_t> block_start;  ///< first voxel of each block, and the number of voxels at the end
  std::vector<VoxelPlace> places;
  std::vector<Moments> moments;
  std::vector<std::array<std::int32_t, kNeighbours>> neighbours;  ///< −1 = empty

  [[nodiscard]] std::size_t count() const { return places.size(); }
  /// Lower corner, in the cloud's offsets.
  [[nodiscard]] Eigen::Vector3d corner(std::size_t v) const {
    const auto at = [this](std::uint32_t c) { return (static_cast<double>(c) - kPlaceOrigin) * size; };
    return {at(places[v].x), at(places[v].y), at(places[v].z)};
  }
  [[nodiscard]] Eigen::Vector3d center(std::size_t v) const { return corner(v) + Eigen::Vector3d::Constant(size / 2); }
};

/// Numbers the voxels of `table` (any distinct numbers before) by position and fills in blocks, places and neighbours;
/// moments are left to the caller. The new number of each old one is returned.
std::vector<std::uint32_t> number_voxels(BlockTable table, std::size_t voxels, int threads, VoxelGrid& grid);

/// A grid of voxels twice as wide, from moments of the finer voxels alone (those of voxel v are `moments(v)`; voxels without points are left out).
struct Coarser {
  VoxelGrid grid;
  std::vector<std::uint32_t> parent;  ///< of each finer voxel; kNoVoxel = left out
};
[[nodiscard]] Coarser coarsened(const VoxelGrid& fine, const std::function<const Moments&(std::size_t)>& moments, int threads);
[[nodiscard]] Coarser coarsened(const VoxelGrid& fine, int threads);  ///< from its own

}  // namespace scenelore::perception
