// Parts of a plane that steps of bounded length connect, told from its voxels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "slots.hpp"

namespace scenelore::perception {

/// Steps must be this many edges of a voxel long at least: then all points of one voxel, and of two that touch, are
/// within one step of each other (a diagonal of two voxels).
inline constexpr double kShortestStepVoxels = 3.4642;

/// The slots of one region (all of them, rising) in parts, largest first. All points of a part are connected by steps of at most
/// `step`: two voxels are joined when even their furthest corners are no further apart. Parts whose nearest points lie
/// within a step, but not surely, may stay apart. `place` has room for one number a slot; those of the members are used.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> connected_slots(const VoxelGrid& grid, const Slots& slots,
                                                                      std::span<const std::uint32_t> members, double step,
                                                                      std::vector<std::uint32_t>& place);

}  // namespace scenelore::perception
