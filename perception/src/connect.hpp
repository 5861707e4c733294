// Parts of a set of points that steps of bounded length connect.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "regions.hpp"

namespace scenelore::perception {

/// Splits points of one plane into parts. Within a part every point is reached from every other one by steps of at most
/// `step` metres. Of two cells of the plane at most `max_neighbours`² pairs of points are compared, so that two
/// parts may stay apart that a longer search would have joined; never the other way round. Parts by falling size.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> connected_parts(const Cloud& cloud, std::span<const std::uint32_t> points,
                                                                      const PlaneFit& plane, double step, std::size_t max_neighbours);

}  // namespace scenelore::perception
