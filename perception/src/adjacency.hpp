// Which regions touch, on several scales.
#pragma once

#include <utility>
#include <vector>

#include "slots.hpp"

namespace scenelore::perception {

/// The finest voxels and the cubes of 2, 4 and 8 of them that they lie in.
struct Pyramid {
  static constexpr int kLevels = 3;
  std::vector<Coarser> levels;  ///< [0]: cubes of 2 voxels, with the cube of each voxel; [1]: of 4, with that of each cube of 2; …
};
[[nodiscard]] Pyramid make_pyramid(const VoxelGrid& grid, int threads);

/// Pairs of regions, smaller number first, rising, that hold points in the same or in adjacent cubes of 2^level voxels
/// (level 1 to 3).
[[nodiscard]] std::vector<std::pair<std::int32_t, std::int32_t>> touching_regions(const Pyramid& pyramid, const Slots& slots, int level);

}  // namespace scenelore::perception
