// How likely a region is a planar face of the scene, from its traits: a generalised additive model (Hastie & Tibshirani 1986),
// log-odds as a sum of one piecewise linear curve a trait. The curves are data (face_curves.inc), learned by `make faces` from
// simulated scans; each can be read, and each tells why a region was given up.
#pragma once

#include "face_traits.hpp"

namespace scenelore::perception {

/// How a region came about; each way has curves of its own.
enum class Origin : std::uint8_t {
  surface,  ///< grown, as it is at the end
  thing,    ///< found on a plane (thin_objects.hpp): small and close to a larger plane is what it should be
  earlier,  ///< what a region was before it became one that was given up (earlier_regions.hpp)
};

/// Between 0 and 1: that at least half of region and face are the same (IoU 0.5). A trait that is NaN speaks neither for nor against.
[[nodiscard]] double face_probability(const FaceTraits& traits, Origin origin);

}  // namespace scenelore::perception
