#include <nlohmann/json.hpp>

#include "evaluation/report.hpp"

namespace scenelore::evaluation {

namespace {

using Json = nlohmann::ordered_json;

Json object_json(const ClassScore& s) {
  return {{"real", s.real},       {"detected", s.detected()},     {"true_positive", s.true_positive}, {"false_positive", s.false_positive},
          {"false_negative", s.false_negative()}, {"precision", precision(s)}, {"recall", recall(s)}, {"f1", f1(s)}};
}

Json confusion_json(const Confusion& confusion) {
  Json out = Json::array();
  for (const auto& [pair, n] : confusion) out.push_back({{"truth", pair.first}, {"answer", pair.second}, {"count", n}});
  return out;
}

Json calibration_json(const Calibration& c) {
  Json bins = Json::array();
  for (std::size_t b = 0; b < Calibration::kBins; ++b) {
    const Calibration::Bin& bin = c.bins[b];
    Json entry{{"low", static_cast<double>(b) / Calibration::kBins}, {"high", static_cast<double>(b + 1) / Calibration::kBins}, {"planes", bin.claims}};
    entry["probability"] = bin.claims > 0 ? Json(bin.probability / bin.claims) : Json(nullptr);
    entry["right"] = bin.claims > 0 ? Json(bin.right / bin.claims) : Json(nullptr);
    bins.push_back(std::move(entry));
  }
  return {{"ece", c.ece()}, {"brier", c.brier()}, {"accuracy", c.accuracy()}, {"confidence", c.confidence()}, {"bins", std::move(bins)}};
}

Json answer_json(const AnswerScore& answer, const std::vector<std::string>& classes) {
  Json objects = Json::object(), points = Json::object();
  for (const std::string& name : classes) {
    const auto found = answer.objects.find(name);
    objects[name] = object_json(found == answer.objects.end() ? ClassScore{} : found->second);
  }
  for (const auto& [name, s] : point_scores(answer.points)) {
    points[name] = {{"points", s.truth}, {"iou", s.iou()}, {"accuracy", s.accuracy()}, {"precision", s.precision()}};
  }
  return {{"objects", std::move(objects)},
          {"all_objects", object_json(total(answer.objects, classes))},
          {"points", std::move(points)},
          {"point_accuracy", overall_accuracy(answer.points)},
          {"calibration", calibration_json(answer.calibration)},
          {"confusion_planes", confusion_json(answer.planes)},
          {"confusion_points", confusion_json(answer.points)}};
}

}  // namespace

std::string to_json(const Evaluation& e, const ReportOptions& options) {
  const std::vector<std::string> classes = listed_classes(e, options);
  Json segmentation = Json::array();
  for (const SegmentationScore& s : e.segmentation) {
    segmentation.push_back({{"threshold", s.threshold}, {"planes", s.planes}, {"faces", s.faces}, {"right", s.right}, {"found", s.found},
                            {"precision", s.precision()}, {"recall", s.recall()}, {"correct", s.correct}, {"over_segmented", s.over},
                            {"under_segmented", s.under}, {"missed", s.missed}, {"noise", s.noise}});
  }
  Json out{{"title", options.title}, {"scans", e.scans}, {"points", e.points}, {"known_points", e.known_points}, {"planes", e.planes},
           {"known_planes", e.known_planes}, {"before", answer_json(e.before, classes)}, {"after", answer_json(e.after, classes)}};
  if (options.segmentation) out["segmentation"] = std::move(segmentation);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace scenelore::evaluation
