// Segmented planes held against the truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/scene_truth.hpp"

namespace scenelore::evaluation {

/// What a segmented plane really is: the object that more than half of its points lie on.
struct PlaneTruth {
  int object = -1;           ///< index into SceneTruth::objects; −1 when no object has more than half of the points
  double purity = 0;         ///< share of the plane's points on that object
  double coverage = 0;       ///< share of the object's points on the plane
  bool known = true;         ///< false: at least half of the points are not known, so that the plane is not judged
  std::string object_class;  ///< of that object; the fallback class without one
};

/// One entry a plane. `plane_of_point` numbers planes from 0, −1 = none. Throws Error when sizes differ.
[[nodiscard]] std::vector<PlaneTruth> plane_truth(const SceneTruth& truth, const std::vector<std::int32_t>& plane_of_point,
                                                  std::size_t planes, const std::string& fallback);

}  // namespace scenelore::evaluation
