// Which regions touch.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "cell_index.hpp"

namespace scenelore::perception {

/// Pairs of regions, smaller number first, rising, that hold points in the same or in adjacent cubes of `reach` cells.
[[nodiscard]] std::vector<std::pair<std::int32_t, std::int32_t>> touching_regions(const CellIndex& cells, int reach,
                                                                                  std::span<const std::int32_t> of_point);

}  // namespace scenelore::perception
