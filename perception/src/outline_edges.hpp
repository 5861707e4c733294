// What lies beyond a plane's outline, as the sensor saw it: nothing, more of the same surface, or what hides the rest.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/plane.hpp"

namespace scenelore::perception {

/// For each plane the numbers, rising, of those that it turns into around an upright edge which points into the room: the side
/// of a pillar, of a chimney or of a wardrobe, the other wall where a gangway turns.
using Turns = std::vector<std::vector<std::uint32_t>>;

/// Sets Plane::edge_free, edge_free_top, edge_joined and edge_unseen of planes in the scan's frame. Every 3 cm of an outline, at a place some
/// centimetres beyond it, the points that were measured in that direction are held against the plane. `upright` turns the scan's
/// frame upright. Nothing is known of a plane without an outline, and without the sensor's position; of no plane where it turns
/// when `plane_of_point` (one a point, −1 = none) is empty.
Turns look_beyond_outlines(const Cloud& cloud, const Eigen::Quaterniond& upright, std::span<const std::int32_t> plane_of_point,
                           std::vector<Plane>& planes, int threads);

}  // namespace scenelore::perception
