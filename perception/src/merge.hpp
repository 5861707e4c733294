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
/// which one spreads over `smallest` m² and has voxels (of this edge, metres) for as much: desks in an L spread over more than they
/// cover. Whether their gap is too wide is left to the promises. Tables side by side stay apart.
void bridge_shadows(double noise, double smallest, double voxel, Slots& slots, std::vector<PlaneFit>& planes);

/// How much worse one plane for two sets of points is for the set that suffers more, in that set's own deviations; 1 = not worse. A set's
/// deviation counts as 0.8 of its noise (metres) at least: a few exact points would refuse everything. Up to kMostDeviation tells nothing apart.
[[nodiscard]] double joint_deviation(const Moments& a, double noise_a, const Moments& b, double noise_b);
inline constexpr double kMostDeviation = 1.12;

/// Joins level planes of one height (within 7 mm) that meet in adjacent cubes of four voxels: pieces of a table whose
/// plane fits had been tilted by what stands on it. A step that is far beyond the `noise` of both (metres, by region) keeps them apart.
/// Regions from number `flush` on were parted from what they touch, and
/// stay so. Those from number `count` on are thin things, of which only large ones take part.
void join_level_pieces(const Pyramid& pyramid, const Eigen::Vector3d& up, std::size_t flush, std::size_t count, const std::vector<double>& noise,
                       Slots& slots, std::vector<PlaneFit>& planes);

}  // namespace scenelore::perception
