// Geometry of pairs that is carried over from one run to the next.
#pragma once

#include <string>

#include "fact_inputs.hpp"
#include "pair_geometry.hpp"

namespace scenelore::rules {

/// Geometry of the scene that remembers an earlier run's answers, when they are about the same planes.
class KeptGeometry {
 public:
  KeptGeometry(const Scene& scene, const SceneDigest& digest) : inputs_(fact_inputs({}, {}, digest.planes())), geometry_(scene.planes) {}

  /// The answers are taken over when the geometry is first needed.
  PairGeometry& with(const kb::StoredGeometry& known) {
    if (!taken_ && known.inputs_sha256 == inputs_) geometry_.remember(known.answers);
    taken_ = true;
    return geometry_;
  }
  /// What to keep for the next run: `known` itself where nothing came to it.
  [[nodiscard]] kb::StoredGeometry kept(const kb::StoredGeometry& known) const {
    if (geometry_.has_news()) return {inputs_, geometry_.answers()};
    return known.inputs_sha256 == inputs_ ? known : kb::StoredGeometry{};
  }

 private:
  std::string inputs_;
  PairGeometry geometry_;
  bool taken_ = false;
};

}  // namespace scenelore::rules
