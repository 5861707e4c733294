#include "evaluation/class_score.hpp"

#include <algorithm>
#include <set>

namespace scenelore::evaluation {

ClassScore& ClassScore::operator+=(const ClassScore& other) {
  real += other.real;
  true_positive += other.true_positive;
  false_positive += other.false_positive;
  return *this;
}

ClassScore score_class(const SceneTruth& truth, const std::vector<PlaneTruth>& planes, const std::vector<std::string>& labels,
                       const std::string& object_class) {
  ClassScore score;
  for (const TruthObject& object : truth.objects) score.real += object.points > 0 && object.object_class() == object_class;
  std::set<int> found;
  for (std::size_t p = 0; p < labels.size(); ++p) {
    if (!planes[p].known) continue;
    const TruthObject* object = planes[p].object < 0 ? nullptr : &truth.objects[static_cast<std::size_t>(planes[p].object)];
    const bool right = object && std::find(object->classes.begin(), object->classes.end(), labels[p]) != object->classes.end();
    if (right && object->object_class() == object_class) {
      const bool first = found.insert(planes[p].object).second;
      if (first) ++score.true_positive;
      if (!first && truth.faces) ++score.false_positive;
    } else if (!right && labels[p] == object_class) {
      ++score.false_positive;
    }
  }
  return score;
}

double precision(const ClassScore& score) {
  return score.detected() == 0 ? 0 : static_cast<double>(score.true_positive) / score.detected();
}

double recall(const ClassScore& score) { return score.real == 0 ? 0 : static_cast<double>(score.true_positive) / score.real; }

double f1(const ClassScore& score) {
  const double both = precision(score) + recall(score);
  return both == 0 ? 0 : 2 * precision(score) * recall(score) / both;
}

}  // namespace scenelore::evaluation
