// Pieces of one table on both sides of the shadow of what stands on it.
#pragma once

#include "regions.hpp"

namespace scenelore::perception {

/// Says for each region which one it belongs to: itself, or another piece of the same level surface. Two level pieces of up to 4 m²
/// belong together when one plane explains both to their `noise` (metres, by region), when no ray went through between them, and when one
/// rectangle of at most 2.4 m and 4 m² that nobody looked through holds both. What is in the shadow speaks for nothing, and one desk
/// is likelier than two in a row of which only the outer halves are seen. Shadows wider than 1 m, or than `max_point_distance`, part.
/// Regions of no points take no part. Without a sensor's position nobody knows of shadows: all regions stay as they are. `up` is a unit vector.
[[nodiscard]] std::vector<std::int32_t> bridge_tables(const Cloud& cloud, const Eigen::Vector3d& up, const Limits& limits,
                                                      const std::vector<double>& noise, const Regions& regions);

}  // namespace scenelore::perception
