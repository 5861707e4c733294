// Joins regions that one plane explains as well as two.
#pragma once

#include "adjacency.hpp"

namespace scenelore::perception {

/// By region: the noise where its points lie, `least` (metres) at the least. Rays graze tables and what lies on them, which
/// are then known far better than the walls.
[[nodiscard]] std::vector<double> noise_of_regions(const Slots& slots, const std::vector<float>& noise_of_voxel, double least, std::size_t count);

/// A region's own deviation counts as its noise at the least. Regions are neighbours when they meet in the same or in
/// adjacent cubes of two voxels.
void merge_regions(const Pyramid& pyramid, std::vector<double> noise, Slots& slots, std::vector<PlaneFit>& planes);

/// Joins pieces of one wall, floor or ceiling across the shadows of what stands before it: any two planes in one line of
/// which one has at least `smallest` m². Whether their gap is too wide is left to the promises. Tables side by side stay
/// apart.
void bridge_shadows(double noise, double smallest, Slots& slots, std::vector<PlaneFit>& planes);

/// Joins level planes of one height (within 7 mm) that meet in adjacent cubes of four voxels: pieces of a table whose
/// plane fits had been tilted by what stands on it. Regions from number `count` on are thin things, of which only large
/// ones take part.
void join_level_pieces(const Pyramid& pyramid, const Eigen::Vector3d& up, std::size_t count, Slots& slots, std::vector<PlaneFit>& planes);

}  // namespace scenelore::perception
