// Pieces of one surface on both sides of the shadow of what stands on it or before it.
#pragma once

#include "regions.hpp"

namespace scenelore::perception {

/// Says for each region which one it belongs to: itself, or another piece of the same surface. Two pieces belong together when one plane
/// explains both to their `noise` (metres, by region), when no ray went through between them, and when one rectangle that nobody looked
/// through holds both. What is in the shadow speaks for nothing. Shadows wider than 1 m, or than `max_point_distance`, part.
///
/// Level pieces are tables: of up to 4 m² and 2.4 m together, since one desk is likelier than two in a row of which only the outer halves are
/// seen. Of others the smaller must not lie off the plane of the larger by more than 1.5 mm and what chance allows, for pictures and door
/// leaves lie off their walls by not much more. A piece of a wall of more than kLargePlane needs no rectangle: there are windows in walls.
///
/// Regions of no points take no part. Without a sensor's position nobody knows of shadows: all regions stay as they are. `up` is a unit vector.
[[nodiscard]] std::vector<std::int32_t> bridge_pieces(const Cloud& cloud, const Eigen::Vector3d& up, const Limits& limits,
                                                      const std::vector<double>& noise, const Regions& regions);

}  // namespace scenelore::perception
