// What lies beyond a plane's outline, as the sensor saw it: nothing, more of the same surface, or what hides the rest.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/plane.hpp"

namespace scenelore::perception {

/// Sets Plane::edge_free, edge_free_top and edge_joined of planes in the scan's frame. Every 3 cm of an outline, at a place some
/// centimetres beyond it, the points that were measured in that direction are held against the plane. `upright` turns the scan's
/// frame upright. Nothing is known of a plane without an outline, and without the sensor's position.
void look_beyond_outlines(const Cloud& cloud, const Eigen::Quaterniond& upright, std::vector<Plane>& planes, int threads);

}  // namespace scenelore::perception
