// What a person said about the planes of a scan survives a new segmentation of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace scenelore::kb {

/// For each old plane number the new plane that is the same thing, −1 when there is none: more than half of the points
/// of each belong to the other, so that no two old planes claim one new plane. Sizes differ: nothing is the same.
[[nodiscard]] std::vector<std::int32_t> match_planes(std::span<const std::int32_t> old_plane_of_point,
                                                     std::span<const std::int32_t> new_plane_of_point, std::size_t old_planes);

}  // namespace scenelore::kb
