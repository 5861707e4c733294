#include "evaluation/evaluation.hpp"

#include <algorithm>
#include <set>

namespace scenelore::evaluation {

namespace {

double ratio(std::size_t part, std::size_t whole) { return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole); }

/// What an answer counts as against an object.
const std::string& counted(const TruthObject& object, const std::string& answer) {
  const bool right = std::find(object.classes.begin(), object.classes.end(), answer) != object.classes.end();
  return right ? object.object_class() : answer;
}

AnswerScore score_answer(const LabelledScan& scan, const Answer& answer, const SceneTruth& truth, const std::vector<PlaneTruth>& planes,
                         const std::string& fallback) {
  AnswerScore score;
  std::set<std::string> classes(answer.classes.begin(), answer.classes.end());
  for (const TruthObject& object : truth.objects) classes.insert(object.object_class());
  classes.erase(fallback);
  for (const std::string& name : classes) {
    const ClassScore of_class = score_class(truth, planes, answer.classes, name);
    if (of_class.real + of_class.detected() > 0) score.objects[name] = of_class;
  }
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> shared;  // object, plane
  for (std::size_t i = 0; i < scan.plane_of_point.size(); ++i) {
    if (truth.object_of_point[i] >= 0) ++shared[{truth.object_of_point[i], scan.plane_of_point[i]}];
  }
  for (const auto& [pair, n] : shared) {
    const TruthObject& object = truth.objects[static_cast<std::size_t>(pair.first)];
    const std::string& given = pair.second < 0 ? fallback : answer.classes[static_cast<std::size_t>(pair.second)];
    score.points[{object.object_class(), counted(object, given)}] += n;
  }
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (!planes[p].known) continue;
    const std::string& given =
        planes[p].object < 0 ? answer.classes[p] : counted(truth.objects[static_cast<std::size_t>(planes[p].object)], answer.classes[p]);
    ++score.planes[{planes[p].object_class, given}];
    score.calibration.add({answer.probabilities[p], given == planes[p].object_class});
  }
  return score;
}

}  // namespace

double PointScore::iou() const { return ratio(both, truth + answer - both); }
double PointScore::accuracy() const { return ratio(both, truth); }
double PointScore::precision() const { return ratio(both, answer); }

AnswerScore& AnswerScore::operator+=(const AnswerScore& other) {
  for (const auto& [name, score] : other.objects) objects[name] += score;
  for (const auto& [pair, n] : other.points) points[pair] += n;
  for (const auto& [pair, n] : other.planes) planes[pair] += n;
  calibration += other.calibration;
  return *this;
}

Evaluation& Evaluation::operator+=(const Evaluation& other) {
  scans += other.scans;
  points += other.points, known_points += other.known_points;
  planes += other.planes, known_planes += other.known_planes;
  before += other.before;
  after += other.after;
  for (std::size_t i = 0; i < segmentation.size(); ++i) segmentation[i] += other.segmentation[i];
  return *this;
}

Evaluation evaluate(const LabelledScan& scan, const SceneTruth& truth, const std::string& fallback) {
  const std::vector<PlaneTruth> planes = plane_truth(truth, scan.plane_of_point, scan.after.classes.size(), fallback);
  Evaluation out{.scans = 1, .points = scan.plane_of_point.size(), .planes = planes.size()};
  out.known_points = static_cast<std::size_t>(
      std::count_if(truth.object_of_point.begin(), truth.object_of_point.end(), [](std::int32_t o) { return o >= 0; }));
  out.known_planes = static_cast<std::size_t>(std::count_if(planes.begin(), planes.end(), [](const PlaneTruth& p) { return p.known; }));
  out.before = score_answer(scan, scan.before, truth, planes, fallback);
  out.after = score_answer(scan, scan.after, truth, planes, fallback);
  for (SegmentationScore& score : out.segmentation) score = score_segmentation(truth, scan.plane_of_point, score.threshold);
  return out;
}

ClassScore total(const std::map<std::string, ClassScore>& scores, const std::vector<std::string>& classes) {
  ClassScore sum;
  for (const auto& [name, score] : scores) {
    if (classes.empty() || std::find(classes.begin(), classes.end(), name) != classes.end()) sum += score;
  }
  return sum;
}

std::map<std::string, PointScore> point_scores(const Confusion& points) {
  std::map<std::string, PointScore> out;
  for (const auto& [pair, n] : points) {
    out[pair.first].truth += n;
    out[pair.second].answer += n;
    if (pair.first == pair.second) out[pair.first].both += n;
  }
  return out;
}

double overall_accuracy(const Confusion& points) {
  std::size_t all = 0, right = 0;
  for (const auto& [pair, n] : points) {
    all += n;
    if (pair.first == pair.second) right += n;
  }
  return ratio(right, all);
}

}  // namespace scenelore::evaluation
