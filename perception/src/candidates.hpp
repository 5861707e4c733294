// Which planes points of a voxel may go to.
#pragma once

#include "slots.hpp"

namespace scenelore::perception {

/// Planes that may own points, by voxel: rows in the order of the voxels.
struct Candidates {
  std::vector<std::uint32_t> first;     ///< of each voxel, and the number at the end
  std::vector<std::int32_t> regions;    ///< in order of preference
  std::vector<float> handicap;          ///< by entry, in squared units / 2: what a plane's distance is raised by; empty = nothing
};

/// The planes with points in each voxel or in one of the 26 around it, largest first, `most` at the most; those that pass
/// the voxel further away than their reach are left out.
[[nodiscard]] Candidates candidates_around(const VoxelGrid& grid, const Slots& slots, const std::vector<PlaneFit>& planes,
                                           const std::vector<double>& reach, std::size_t most, int threads);

/// The planes with points in each voxel. Where they cross, a point is more likely of the one that holds more of the voxel's points: with the
/// deviation of its points, sigma, as unit, the handicap makes the choice one by the mixture of normal distributions across the planes.
[[nodiscard]] Candidates candidates_within(const Slots& slots, const std::vector<double>& sigma);

}  // namespace scenelore::perception
