#include "bench/truth.hpp"

#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace scenelore::experiment {

std::vector<PlaneTruth> plane_truth(const simulator::SimulatedScan& scan, const std::vector<std::int32_t>& plane_of_point,
                                    std::size_t planes) {
  const perception::Column* instance = scan.points.find("instance");
  if (!instance) throw std::runtime_error("the scan has no column `instance`");

  std::vector<std::size_t> size(planes, 0);
  std::map<std::pair<std::int32_t, int>, std::size_t> shared;  // plane, instance → points
  for (std::size_t i = 0; i < plane_of_point.size(); ++i) {
    if (plane_of_point[i] < 0) continue;
    ++size[static_cast<std::size_t>(plane_of_point[i])];
    ++shared[{plane_of_point[i], static_cast<int>(scan.points.value(*instance, i))}];
  }

  std::map<int, int> object_of_instance;
  for (std::size_t i = 0; i < scan.objects.size(); ++i) object_of_instance[scan.objects[i].instance] = static_cast<int>(i);

  std::vector<PlaneTruth> out(planes);
  for (PlaneTruth& plane : out) plane.object_class = "unknown";
  for (const auto& [key, points] : shared) {
    const auto found = object_of_instance.find(key.second);
    PlaneTruth& plane = out[static_cast<std::size_t>(key.first)];
    const double purity = static_cast<double>(points) / static_cast<double>(size[static_cast<std::size_t>(key.first)]);
    if (found == object_of_instance.end() || purity <= 0.5) continue;
    const simulator::TruthObject& object = scan.objects[static_cast<std::size_t>(found->second)];
    plane = {found->second, purity,
             static_cast<double>(points) / static_cast<double>(std::max<std::size_t>(1, object.points)), object.object_class};
  }
  return out;
}

ClassScore& ClassScore::operator+=(const ClassScore& other) {
  real += other.real;
  true_positive += other.true_positive;
  false_positive += other.false_positive;
  return *this;
}

ClassScore score_class(const simulator::SimulatedScan& scan, const std::vector<PlaneTruth>& truth,
                       const std::vector<std::string>& labels, const std::string& object_class) {
  ClassScore score;
  for (const simulator::TruthObject& object : scan.objects) score.real += object.object_class == object_class;
  std::set<int> found;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != object_class) continue;
    const bool right = truth[i].object_class == object_class && found.insert(truth[i].object).second;
    ++(right ? score.true_positive : score.false_positive);
  }
  return score;
}

double precision(const ClassScore& score) {
  const int detected = score.true_positive + score.false_positive;
  return detected == 0 ? 0 : static_cast<double>(score.true_positive) / detected;
}

double recall(const ClassScore& score) {
  return score.real == 0 ? 0 : static_cast<double>(score.true_positive) / score.real;
}

double f1(const ClassScore& score) {
  const double both = precision(score) + recall(score);
  return both == 0 ? 0 : 2 * precision(score) * recall(score) / both;
}

}  // namespace scenelore::experiment
