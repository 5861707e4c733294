// The planes of one scan in the upright frame (z up, floor at 0): what relations are asked about.
#pragma once

#include <vector>

#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::rules {

struct Scene {
  std::vector<kb::PlaneId> ids;
  std::vector<perception::Plane> planes;  ///< rotated: centroid.z() == height
  kb::FeatureTable features;              ///< of the same planes, for Lua
};

[[nodiscard]] Scene make_scene(const kb::Scan& scan, const std::vector<kb::StoredPlane>& planes, kb::FeatureTable features);

}  // namespace scenelore::rules
