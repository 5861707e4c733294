// How likely a region is a planar face of the scene, from its traits: log-odds as a sum over small trees of questions (gradient boosting,
// Friedman 2001; every question of a tree is asked of all regions, Prokhorenkova et al. 2018). The trees are data (face_trees.inc), learned by
// `make faces` from simulated scans. A sum of one curve a trait (Hastie & Tibshirani 1986) tells less, for what is rough for a wall is smooth for a book.
#pragma once

#include "face_traits.hpp"

namespace scenelore::perception {

/// How a region came about; each way has trees of its own.
enum class Origin : std::uint8_t {
  surface,  ///< grown, as it is at the end
  thing,    ///< found on a plane (thin_objects.hpp): small and close to a larger plane is what it should be
  earlier,  ///< what a region was before it became one that was given up (earlier_regions.hpp)
  finer,    ///< grown in finer voxels from what was left (finer_regions.hpp)
};

/// Between 0 and 1: that at least half of region and face are the same (IoU 0.5). A trait that is NaN is
/// one that nobody knows; such were among the examples.
[[nodiscard]] double face_probability(const FaceTraits& traits, Origin origin);

}  // namespace scenelore::perception
