// Table 1 of Goldhoorn & Hartanto (2014) on simulated rooms: objects real and detected before and after constraints, for
// the paper's reference mode and for the default knowledge. Usage: table1 [SETS [FIRST_SEED [NOISE [errors]]]]
// With `errors`, each wrong label of the default knowledge over the paper's three classes is told on stderr.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string_view>

#include "bench/rooms.hpp"

namespace {

using namespace scenelore;
using evaluation::ClassScore;

const std::vector<std::string> kPaperClasses{"table", "flat_screen", "keyboard"};
const std::vector<std::string> kStructure{"floor", "ceiling", "wall"};

struct Scores {
  std::map<std::string, ClassScore> before, after;
  std::vector<double> f1_before, f1_after;  ///< over the three classes, one a set
  evaluation::Evaluation all;
  double solve_seconds = 0;
  std::size_t not_proved = 0;
};

struct Mode {
  std::string name;
  kb::Knowledge knowledge;
  Scores scores;
};

/// Labels one room and adds its counts to `before` and `after`.
void score_room(const experiment::Room& room, Mode& mode, rules::RuleSet& rules, std::map<std::string, ClassScore>& before,
                std::map<std::string, ClassScore>& after) {
  const experiment::Labelling labelling = experiment::label_planes(mode.knowledge, rules, room.record, room.planes);
  mode.scores.solve_seconds = std::max(mode.scores.solve_seconds, labelling.run.seconds);
  mode.scores.not_proved += labelling.run.outcome != "proved";
  mode.scores.all += evaluation::evaluate({room.plane_of_point, labelling.before, labelling.after}, room.objects, "unknown");
  for (const auto* list : {&kPaperClasses, &kStructure}) {
    for (const std::string& name : *list) {
      before[name] += evaluation::score_class(room.objects, room.truth, labelling.before.classes, name);
      after[name] += evaluation::score_class(room.objects, room.truth, labelling.after.classes, name);
    }
  }
}

/// A line a plane that has or should have one of the paper's classes and has not the right one.
void print_errors(const experiment::Room& room, const std::string& name, const Mode& mode, rules::RuleSet& rules) {
  const experiment::Labelling labelling = experiment::label_planes(mode.knowledge, rules, room.record, room.planes);
  const auto of_interest = [](const std::string& object_class) {
    return std::find(kPaperClasses.begin(), kPaperClasses.end(), object_class) != kPaperClasses.end();
  };
  std::vector<double> coverage(room.scan.objects.size(), 0);
  for (std::size_t i = 0; i < room.planes.size(); ++i) {
    const evaluation::PlaneTruth& truth = room.truth[i];
    const perception::Plane& plane = room.planes[i].plane;
    if (truth.object >= 0) coverage[static_cast<std::size_t>(truth.object)] += truth.coverage;
    if (labelling.after.classes[i] == truth.object_class || (!of_interest(labelling.after.classes[i]) && !of_interest(truth.object_class))) continue;
    fmt::print(stderr, "{} plane {}: {} (features {}), is {} ({}, purity {:.2f}, coverage {:.2f}); {} points, {:.2f} x {:.2f} m, tilt {:.0f}, "
                       "height {:.2f}, rect. {:.2f}\n",
               name, i + 1, labelling.after.classes[i], labelling.before.classes[i], truth.object_class,
               truth.object < 0 ? "nothing" : room.scan.objects[static_cast<std::size_t>(truth.object)].thing, truth.purity, truth.coverage,
               plane.point_count, plane.length, plane.width, plane.tilt_deg, plane.height, plane.rectangularity);
  }
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    const simulator::TruthObject& object = room.scan.objects[i];
    if (coverage[i] > 0 || !of_interest(object.object_class)) continue;
    fmt::print(stderr, "{} has no plane of its own for {} ({}, {} points, height {:.2f})\n", name, object.thing, object.object_class,
               object.points, object.centroid.z());
  }
}

void print_row(const std::string& name, const ClassScore& before, const ClassScore& after) {
  fmt::print("{:<12} {:>5} | {:>4} {:>4} {:>4}  {:.3f} {:.3f} {:.3f} | {:>4} {:>4} {:>4}  {:.3f} {:.3f} {:.3f}\n", name, after.real,
             before.true_positive, before.false_positive, before.false_negative(), precision(before), recall(before), f1(before),
             after.true_positive, after.false_positive, after.false_negative(), precision(after), recall(after), f1(after));
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  if (values.empty()) return 0;
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

void print_mode(const Mode& mode) {
  const Scores& scores = mode.scores;
  fmt::print("\n{}\n{:<12} {:>5} | {:^33} | {:^33}\n", mode.name, "", "", "before constraints", "after constraints");
  fmt::print("{:<12} {:>5} | {:>4} {:>4} {:>4}  {:<5} {:<5} {:<5} | {:>4} {:>4} {:>4}  {:<5} {:<5} {:<5}\n", "class", "real", "TP",
             "FP", "FN", "prec.", "rec.", "F1", "TP", "FP", "FN", "prec.", "rec.", "F1");
  for (const std::string& name : kPaperClasses) print_row(name, scores.before.at(name), scores.after.at(name));
  print_row("all three", total(scores.before, kPaperClasses), total(scores.after, kPaperClasses));
  for (const std::string& name : kStructure) print_row(name, scores.before.at(name), scores.after.at(name));
  fmt::print("F1 per set of six rooms: mean {:.3f} before, {:.3f} after, median {:.3f} and {:.3f} ({:.3f}); slowest search {:.1f} ms, {} not proved\n",
             mean(scores.f1_before), mean(scores.f1_after), median(scores.f1_before), median(scores.f1_after), fmt::join(scores.f1_after, ", "),
             1e3 * scores.solve_seconds, scores.not_proved);
  auto points = evaluation::point_scores(scores.all.after.points);
  fmt::print("after constraints: IoU of points: floor {:.3f}, ceiling {:.3f}, wall {:.3f}; points with the right class {:.3f}; expected calibration error {:.3f}\n",
             points["floor"].iou(), points["ceiling"].iou(), points["wall"].iou(), evaluation::overall_accuracy(scores.all.after.points),
             scores.all.after.calibration.ece());
}

}  // namespace

int main(int argc, char** argv) {
  const int sets = argc > 1 ? std::atoi(argv[1]) : 10;
  const std::uint64_t first_seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 5001;
  const double noise = argc > 3 ? std::atof(argv[3]) : 0.01;
  const bool errors = argc > 4 && std::string_view(argv[4]) == "errors";

  rules::RuleSet rules = rules::RuleSet::load();
  Mode modes[]{{"reference mode of the paper (equation 1, hand-set Gaussians, hard constraints)", experiment::knowledge_pack("paper"), {}},
               {"default knowledge (log-linear product, learned densities, weighted constraints)", experiment::knowledge_pack("office"), {}}};
  for (int set = 0; set < sets; ++set) {
    const auto rooms = experiment::perceive_rooms(simulator::paper_rooms(first_seed + static_cast<std::uint64_t>(set), noise));
    for (std::size_t room = 0; errors && room < rooms.size(); ++room) {
      print_errors(rooms[room], fmt::format("set {} room {}", set, room + 1), modes[1], rules);
    }
    for (Mode& mode : modes) {
      std::map<std::string, ClassScore> before, after;
      for (const experiment::Room& room : rooms) score_room(room, mode, rules, before, after);
      for (const auto& [name, score] : before) mode.scores.before[name] += score;
      for (const auto& [name, score] : after) mode.scores.after[name] += score;
      mode.scores.f1_before.push_back(f1(total(before, kPaperClasses)));
      mode.scores.f1_after.push_back(f1(total(after, kPaperClasses)));
    }
  }
  fmt::print("{} sets of six simulated rooms (12 tables, 9 screens, 7 keyboards each), seeds {} to {}, range noise {} m\n", sets,
             first_seed, first_seed + static_cast<std::uint64_t>(sets) - 1, noise);
  fmt::print("the paper on its six real rooms: precision 0.655, recall 0.679, F1 0.667\n");
  for (const Mode& mode : modes) print_mode(mode);
  return 0;
}
