// The cloud cut into cubes, with the moments of the points in each and the neighbours of each.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cell_index.hpp"
#include "moments.hpp"
#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception {

inline constexpr std::size_t kNeighbours = 27;  ///< of a voxel, itself included
inline constexpr std::size_t kSelf = 13;        ///< its own place among them

/// Voxels are numbered by position. Moments are in the cloud's offsets (its origin left out), in double.
struct VoxelGrid {
  double size = 0;  ///< metres, edge of a voxel
  CellIndex cells;
  std::vector<Moments> moments;
  std::vector<std::array<std::int32_t, kNeighbours>> neighbours;  ///< −1 = empty

  [[nodiscard]] std::size_t count() const { return cells.size(); }
};

/// Points with `taken[i]` ≥ 0 are left out; an empty `taken` leaves none out. Invalid points and points further than a
/// million voxels from the origin are in no voxel.
[[nodiscard]] VoxelGrid make_voxel_grid(const Cloud& cloud, double size, std::span<const std::int32_t> taken, int threads);

/// The cells alone, without moments and neighbours.
[[nodiscard]] CellIndex make_cells(const Cloud& cloud, double size, std::span<const std::int32_t> taken, int threads);

}  // namespace scenelore::perception
