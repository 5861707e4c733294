// Truth written down as runs of points.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "evaluation/evaluation.hpp"

namespace scenelore::evaluation {

/// So many points of one object (index, kNothing, kNotKnown) on one plane (index, −1).
struct Run {
  std::size_t points;
  std::int32_t object, plane;
};

struct MadeScene {
  SceneTruth truth;
  std::vector<std::int32_t> plane_of_point;
};

inline MadeScene scene(const std::vector<std::string>& objects, const std::vector<Run>& runs) {
  MadeScene out;
  for (const std::string& name : objects) out.truth.objects.push_back({.instance = static_cast<int>(out.truth.objects.size()) + 1, .classes = {name}});
  for (const Run& run : runs) {
    out.truth.object_of_point.insert(out.truth.object_of_point.end(), run.points, run.object);
    out.plane_of_point.insert(out.plane_of_point.end(), run.points, run.plane);
    if (run.object >= 0) out.truth.objects[static_cast<std::size_t>(run.object)].points += run.points;
  }
  return out;
}

}  // namespace scenelore::evaluation
