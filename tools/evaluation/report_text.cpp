#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "evaluation/report.hpp"

namespace scenelore::evaluation {

namespace {

ClassScore score_of(const AnswerScore& answer, const std::string& name) {
  const auto found = answer.objects.find(name);
  return found == answer.objects.end() ? ClassScore{} : found->second;
}

std::string table_row(const std::string& name, const ClassScore& before, const ClassScore& after) {
  std::string line = fmt::format("{:<14} {:>5}", name, after.real);
  for (const ClassScore* s : {&before, &after}) {
    line += fmt::format(" | {:>4} {:>4} {:>4} {:>4}  {:.3f} {:.3f} {:.3f}", s->detected(), s->true_positive, s->false_positive,
                        s->false_negative(), precision(*s), recall(*s), f1(*s));
  }
  return line + "\n";
}

std::string objects_text(const Evaluation& e, const ReportOptions& options) {
  const std::string columns = fmt::format(" | {:>4} {:>4} {:>4} {:>4}  {:<5} {:<5} {:<5}", "det.", "TP", "FP", "FN", "prec.", "rec.", "F1");
  std::string out = fmt::format("objects\n{:<14} {:>5} | {:^38} | {:^38}\n{:<14} {:>5}{}{}\n", "", "", "before constraints", "after constraints",
                                "class", "real", columns, columns);
  const std::vector<std::string> classes = listed_classes(e, options);
  for (const std::string& name : classes) out += table_row(name, score_of(e.before, name), score_of(e.after, name));
  return out + table_row("all of these", total(e.before.objects, classes), total(e.after.objects, classes));
}

std::string points_text(const Evaluation& e) {
  std::string out = fmt::format("\npoints ({} of {} known): right class on {:.3f} before, {:.3f} after constraints\n{:<14} {:>9}  {:<11} {:<5} {:<5} {:<5}\n",
                                e.known_points, e.points, overall_accuracy(e.before.points), overall_accuracy(e.after.points), "class",
                                "points", "IoU before", "after", "acc.", "prec.");
  const auto before = point_scores(e.before.points);
  double sum = 0, count = 0;
  for (const auto& [name, score] : point_scores(e.after.points)) {
    if (score.truth == 0) continue;
    const auto first = before.find(name);
    out += fmt::format("{:<14} {:>9}  {:<11.3f} {:.3f} {:.3f} {:.3f}\n", name, score.truth, first == before.end() ? 0 : first->second.iou(),
                       score.iou(), score.accuracy(), score.precision());
    sum += score.iou(), count += 1;
  }
  return out + fmt::format("mean IoU {:.3f}\n", sum / std::max(1.0, count));
}

std::string segmentation_text(const Evaluation& e) {
  std::string out = "\nsegmentation\n" + fmt::format("{:>9} {:>6} {:>6}  {:<9} {:<6} | {:>7} {:>5} {:>6} {:>6} {:>6}\n", "threshold", "planes",
                                                     "faces", "precision", "recall", "correct", "over-", "under-", "missed", "noise");
  for (const SegmentationScore& s : e.segmentation) {
    out += fmt::format("{:>9} {:>6} {:>6}  {:<9.3f} {:<6.3f} | {:>7} {:>5} {:>6} {:>6} {:>6}\n", s.threshold, s.planes, s.faces, s.precision(),
                       s.recall(), s.correct, s.over, s.under, s.missed, s.noise);
  }
  return out + "precision, recall: by intersection over union; the rest after Hoover et al. 1996\n";
}

std::string confusion_text(const Evaluation& e) {
  std::string out = "\nplanes that got a wrong class\n";
  std::vector<std::pair<std::size_t, std::pair<std::string, std::string>>> wrong;
  for (const auto& [pair, n] : e.after.planes) {
    if (pair.first != pair.second) wrong.push_back({n, pair});
  }
  std::stable_sort(wrong.begin(), wrong.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  if (wrong.empty()) out += "none\n";
  for (const auto& [n, pair] : wrong) out += fmt::format("{:>4}  {} taken for {}\n", n, pair.first, pair.second);
  return out;
}

std::string calibration_text(const Evaluation& e) {
  std::string out = fmt::format("\nprobabilities of {} planes\n{:<19} {:<10} {:<6} {:<6} {:<6}\n", e.known_planes, "", "mean prob.", "right", "Brier",
                                "ECE");
  const auto line = [&](const char* name, const Calibration& c) {
    out += fmt::format("{:<19} {:<10.3f} {:<6.3f} {:<6.3f} {:<6.3f}\n", name, c.confidence(), c.accuracy(), c.brier(), c.ece());
  };
  line("before constraints", e.before.calibration);
  line("after constraints", e.after.calibration);
  return out;
}

}  // namespace

std::vector<std::string> listed_classes(const Evaluation& evaluation, const ReportOptions& options) {
  if (!options.classes.empty()) return options.classes;
  std::set<std::string> names;
  for (const AnswerScore* answer : {&evaluation.before, &evaluation.after}) {
    for (const auto& [name, score] : answer->objects) names.insert(name);
  }
  return {names.begin(), names.end()};
}

std::string to_text(const Evaluation& e, const ReportOptions& options) {
  std::string out = fmt::format("{}: {} scan{}, {} of {} planes known\n\n", options.title, e.scans, e.scans == 1 ? "" : "s", e.known_planes, e.planes);
  out += objects_text(e, options) + points_text(e);
  if (options.segmentation) out += segmentation_text(e);
  return out + confusion_text(e) + calibration_text(e);
}

}  // namespace scenelore::evaluation
