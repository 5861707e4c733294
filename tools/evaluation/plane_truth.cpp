#include "evaluation/plane_truth.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "evaluation/error.hpp"

namespace scenelore::evaluation {

std::vector<PlaneTruth> plane_truth(const SceneTruth& truth, const std::vector<std::int32_t>& plane_of_point, std::size_t planes,
                                    const std::string& fallback) {
  if (truth.object_of_point.size() != plane_of_point.size()) {
    throw Error("the truth speaks of " + std::to_string(truth.object_of_point.size()) + " points, the scan has " +
                std::to_string(plane_of_point.size()));
  }
  std::vector<std::size_t> size(planes, 0), not_known(planes, 0);
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> shared;  // plane, object → points
  for (std::size_t i = 0; i < plane_of_point.size(); ++i) {
    if (plane_of_point[i] < 0) continue;
    const auto plane = static_cast<std::size_t>(plane_of_point[i]);
    ++size[plane];
    if (truth.object_of_point[i] >= 0) ++shared[{plane_of_point[i], truth.object_of_point[i]}];
    not_known[plane] += truth.object_of_point[i] == kNotKnown;
  }
  std::vector<PlaneTruth> out(planes);
  for (std::size_t p = 0; p < planes; ++p) {
    out[p].object_class = fallback;
    out[p].known = 2 * not_known[p] < size[p];
  }
  for (const auto& [key, points] : shared) {
    const auto p = static_cast<std::size_t>(key.first);
    if (2 * points <= size[p]) continue;
    const TruthObject& object = truth.objects[static_cast<std::size_t>(key.second)];
    out[p].object = key.second;
    out[p].purity = static_cast<double>(points) / static_cast<double>(size[p]);
    out[p].coverage = static_cast<double>(points) / static_cast<double>(std::max<std::size_t>(1, object.points));
    out[p].object_class = object.object_class();
  }
  return out;
}

}  // namespace scenelore::evaluation
