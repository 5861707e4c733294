// Counts of the paper's Table 1 (Goldhoorn & Hartanto 2014).
#pragma once

#include <string>
#include <vector>

#include "evaluation/plane_truth.hpp"

namespace scenelore::evaluation {

/// Of one class.
struct ClassScore {
  int real = 0;            ///< objects in the scenes of which something is seen
  int true_positive = 0;   ///< objects that some plane of this label lies on
  int false_positive = 0;  ///< planes of this label on something else, or on an object that another plane was counted for
  [[nodiscard]] int false_negative() const { return real - true_positive; }
  [[nodiscard]] int detected() const { return true_positive + false_positive; }
  ClassScore& operator+=(const ClassScore& other);
};

/// Objects that count for `object_class` against planes labelled so (or by another class that is right for the object);
/// `labels` has one class name a plane. Planes that are not known are left out. Where objects are no single faces,
/// a further right plane on an object that was found already counts neither way.
[[nodiscard]] ClassScore score_class(const SceneTruth& truth, const std::vector<PlaneTruth>& planes,
                                     const std::vector<std::string>& labels, const std::string& object_class);

[[nodiscard]] double precision(const ClassScore& score);  ///< 0 when nothing was labelled so
[[nodiscard]] double recall(const ClassScore& score);     ///< 0 when there is no such object
[[nodiscard]] double f1(const ClassScore& score);         ///< harmonic mean of both; 0 when both are

}  // namespace scenelore::evaluation
