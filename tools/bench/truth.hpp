// Segmented planes held against the simulator's truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "simulator/simulate.hpp"

namespace scenelore::experiment {

/// What a segmented plane really is: the object that most of its points lie on.
struct PlaneTruth {
  int object = -1;           ///< index into SimulatedScan::objects; −1 when no object has more than half of the plane's points
  double purity = 0;         ///< share of the plane's points on that object
  double coverage = 0;       ///< share of the object's visible points on the plane
  std::string object_class;  ///< of that object, "unknown" without one
};

/// One entry a plane. `plane_of_point` numbers planes from 0, −1 = none.
[[nodiscard]] std::vector<PlaneTruth> plane_truth(const simulator::SimulatedScan& scan,
                                                  const std::vector<std::int32_t>& plane_of_point, std::size_t planes);

/// Counts of the paper's Table 1 for one class.
struct ClassScore {
  int real = 0;            ///< objects in the rooms
  int true_positive = 0;   ///< objects that some plane of this label lies on
  int false_positive = 0;  ///< planes of this label on something else, or on an object that another plane was counted for
  [[nodiscard]] int false_negative() const { return real - true_positive; }
  ClassScore& operator+=(const ClassScore& other);
};

/// Objects of `object_class` against planes labelled so; `labels` has one class name a plane.
[[nodiscard]] ClassScore score_class(const simulator::SimulatedScan& scan, const std::vector<PlaneTruth>& truth,
                                     const std::vector<std::string>& labels, const std::string& object_class);

[[nodiscard]] double precision(const ClassScore& score);  ///< 0 when nothing was labelled so
[[nodiscard]] double recall(const ClassScore& score);     ///< 0 when there is no such object
[[nodiscard]] double f1(const ClassScore& score);

}  // namespace scenelore::experiment
