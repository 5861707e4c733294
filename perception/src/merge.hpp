// Joins regions that one plane explains as well as two.
#pragma once

#include "adjacency.hpp"

namespace scenelore::perception {

/// `noise` is what a plane's own deviation is taken for at least. Regions are neighbours when they meet in the same or in
/// adjacent cubes of two voxels.
void merge_regions(const Pyramid& pyramid, double noise, Slots& slots, std::vector<PlaneFit>& planes);

/// Joins pieces of one wall, floor or ceiling across the shadows of what stands before it: any two planes in one line of
/// which one has at least `smallest` m². Whether their gap is too wide is left to the promises. Tables side by side stay
/// apart.
void bridge_shadows(double noise, double smallest, Slots& slots, std::vector<PlaneFit>& planes);

/// Joins level planes of one height (within 7 mm) that meet in adjacent cubes of four voxels: pieces of a table whose
/// plane fits had been tilted by what stands on it. Regions from number `count` on are thin things, of which only large
/// ones take part.
void join_level_pieces(const Pyramid& pyramid, const Eigen::Vector3d& up, std::size_t count, Slots& slots, std::vector<PlaneFit>& planes);

}  // namespace scenelore::perception
