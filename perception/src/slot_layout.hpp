// The slots that voxels need for their candidates.
#pragma once

#include "candidates.hpp"

namespace scenelore::perception {

/// A slot for each candidate of each voxel and one for no plane, without points and without room for moments.
[[nodiscard]] Slots slots_for(const VoxelGrid& grid, const Candidates& candidates);

/// Makes room for other slots in some voxels, in place: two sets of them would be the most that is in memory at this time. What is kept moves
/// to the front, then, last voxel first, to where it belongs. Rulers of the new slots follow those that there are. Returns where each voxel's
/// slots began before.
[[nodiscard]] std::vector<std::uint32_t> lay_out_anew(const std::vector<bool>& anew, const Candidates& candidates, Slots& slots);

}  // namespace scenelore::perception
