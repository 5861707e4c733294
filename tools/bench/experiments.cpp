// The experiments of Goldhoorn & Hartanto (2014) again, and beyond, as one report. Usage: experiments FOLDER [SETS [FIRST_SEED [REAL]]]
// Writes FOLDER/README.md and FOLDER/table1.html. SETS of six rooms are made for each condition, from FIRST_SEED on; REAL is a folder
// of labelled scans. Nothing is learned here; what has been looked at in order to choose something is reported no more.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <random>

#include "bench/rooms.hpp"
#include "evaluation/report.hpp"
#include "evaluation/stored_scan.hpp"
#include "pipeline/text_file.hpp"
#include "scenelore/perception/perceive.hpp"

namespace {

using namespace scenelore;
namespace fs = std::filesystem;
using experiment::Situation;

const std::vector<std::string> kPaperClasses{"table", "flat_screen", "keyboard"};

struct Lab {
  rules::RuleSet rules = rules::RuleSet::load();
  kb::Knowledge paper = experiment::knowledge_pack("paper"), office = experiment::knowledge_pack("office");
  int sets = 2;
  std::uint64_t first_seed = 9601;
  std::string report;

  /// Of both packs.
  [[nodiscard]] std::vector<std::string> relations() const {
    std::vector<std::string> out = rules::used_relations(office, rules);
    for (const std::string& name : rules::used_relations(paper, rules)) {
      if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
    }
    return out;
  }

  template <typename... Args>
  void write(fmt::format_string<Args...> text, Args&&... args) {
    report += fmt::format(text, std::forward<Args>(args)...);
  }
};

std::string title_of(const std::string& title) {
  fmt::print(stderr, "{}\n", title);
  return "\n## " + title + "\n\n";
}

double f1_of(const std::map<std::string, evaluation::ClassScore>& scores) { return f1(total(scores, kPaperClasses)); }

/// One rectangle of points with noise along its normal.
perception::PointTable rectangle(double length, double width, double tilt_deg, double height, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::vector<float> x, y, z;
  const double tilt = tilt_deg * M_PI / 180;
  for (double u = -length / 2; u <= length / 2; u += 0.01) {
    for (double v = -width / 2; v <= width / 2; v += 0.01) {
      const double off = noise * normal(random);
      x.push_back(static_cast<float>(u)), y.push_back(static_cast<float>(v * std::cos(tilt) - off * std::sin(tilt)));
      z.push_back(static_cast<float>(height + v * std::sin(tilt) + off * std::cos(tilt)));
    }
  }
  perception::PointTable table;
  table.rows = x.size();
  table.set_column("x", x), table.set_column("y", y), table.set_column("z", z);
  return table;
}

void features_of_known_planes(Lab& lab) {
  lab.report += title_of("Features of synthetic planes");
  lab.write("Rectangles of points 1 cm apart with Gaussian noise along the normal; mean absolute error over eight rectangles that were found (tables, "
            "screens, keyboards, walls).\n\n| noise | found | tilt, deg | height, mm | length, % | width, % | area, % |\n| --- | --- | --- | --- | --- | --- | --- |\n");
  const std::vector<std::array<double, 4>> shapes{{1.6, 0.8, 0, 0.73}, {1.2, 0.7, 0, 0.7}, {0.5, 0.3, 80, 1.0}, {0.6, 0.35, 85, 1.05},
                                                  {0.45, 0.15, 0, 0.75}, {0.4, 0.14, 5, 0.75}, {4, 2.6, 90, 1.3}, {2, 0.9, 90, 1.2}};
  for (const double noise : {0.0, 0.005, 0.01, 0.02, 0.03}) {
    std::array<double, 5> error{};
    int found = 0;
    for (const auto& [length, width, tilt, height] : shapes) {
      const perception::Cloud cloud = perception::to_cloud(rectangle(length, width, tilt, height, noise, 1), "rectangle");
      const auto seen = perception::perceive(cloud, {.up = Eigen::Vector3d::UnitZ(), .floor_z = 0, .threads = 1});
      const auto biggest = std::max_element(seen.planes.begin(), seen.planes.end(),
                                            [](const auto& a, const auto& b) { return a.point_count < b.point_count; });
      if (biggest == seen.planes.end()) continue;
      ++found;
      error[0] += std::abs(biggest->tilt_deg - tilt), error[1] += 1e3 * std::abs(biggest->height - height);
      error[2] += 100 * std::abs(biggest->length / length - 1), error[3] += 100 * std::abs(biggest->width / width - 1);
      error[4] += 100 * std::abs(biggest->area_m2 / (length * width) - 1);
    }
    const double n = std::max(1, found);
    lab.write("| {} cm | {} of {} | {:.2f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} |\n", 100 * noise, found, shapes.size(), error[0] / n, error[1] / n,
              error[2] / n, error[3] / n, error[4] / n);
  }
}

/// Evidence of a level rectangle of 1.4 × 0.7 m wherever it is.
std::vector<double> evidence_at(const kb::Knowledge& knowledge, double x, double z) {
  const kb::FeatureTable table{{"area_m2", "length", "width", "rectangularity", "tilt_deg", "height", "x", "y", "z_min", "z_max", "aspect", "spread_length", "spread_width"},
                               {{0.98, 1.4, 0.7, 0.95, 0.5, z, x, 0, z - 0.01, z + 0.01, 2, 1.4, 0.7}}};
  return kb::preclassify(knowledge, table)[0];
}

void position(Lab& lab) {
  lab.report += title_of("Influence of the position on the class (the paper's Fig. 3)");
  lab.write("A level rectangle of 1.4 × 0.7 m is moved up; the three most likely classes by evidence. Along x nothing changes: the feature's weight is 0 "
            "in both packs (largest change over ±5 m: {:.3f}).\n\n| height | reference mode of the paper | default knowledge |\n| --- | --- | --- |\n",
            [&] {
              double most = 0;
              for (double x = -5; x <= 5; x += 0.5) {
                const auto a = evidence_at(lab.office, 0, 0.73), b = evidence_at(lab.office, x, 0.73);
                for (std::size_t c = 0; c < a.size(); ++c) most = std::max(most, std::abs(a[c] - b[c]));
              }
              return most;
            }());
  for (const double z : {0.0, 0.2, 0.45, 0.6, 0.7, 0.75, 0.8, 0.9, 1.1, 1.5, 2.0, 2.5, 2.7}) {
    lab.write("| {:.2f} m |", z);
    for (const kb::Knowledge* knowledge : {&lab.paper, &lab.office}) {
      const auto p = evidence_at(*knowledge, 0, z);
      std::vector<std::size_t> order(p.size());
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
      std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] > p[b]; });
      for (std::size_t i = 0; i < 3; ++i) lab.write("{}{} {:.2f}", i == 0 ? " " : ", ", knowledge->classes[order[i]].name, p[order[i]]);
      lab.write(" |");
    }
    lab.write("\n");
  }
}

using Change = std::function<void(simulator::SimulationOptions&)>;

/// The rooms of one set as planes with facts; perceived once, labelled as often as wanted.
std::vector<Situation> situations(Lab& lab, int set, double noise, const Change& change = {}) {
  auto options = simulator::paper_rooms(lab.first_seed + static_cast<std::uint64_t>(set), noise);
  for (auto& one : options) {
    if (change) change(one);
  }
  std::vector<Situation> out;
  for (experiment::Room& room : experiment::perceive_rooms(options)) out.push_back(experiment::assess(std::move(room), lab.relations(), lab.rules));
  return out;
}

evaluation::Evaluation evaluate(const Situation& s, const kb::Knowledge& knowledge, double* seconds = nullptr) {
  const experiment::Labelling labelling = experiment::label(knowledge, s);
  if (seconds) *seconds = labelling.seconds;
  return evaluation::evaluate({s.room.plane_of_point, labelling.before, labelling.after}, s.room.objects, "unknown");
}

/// Scores of sets under one condition.
struct Scores {
  evaluation::Evaluation sum;
  std::vector<double> f1;  ///< after constraints, one a set
  double relate_ms = 0, label_ms = 0;
  std::size_t planes = 0, rooms = 0;
};

Scores score(Lab& lab, const kb::Knowledge& knowledge, double noise, const Change& change = {},
             std::vector<std::vector<Situation>>* keep = nullptr) {
  Scores out;
  for (int set = 0; set < lab.sets; ++set) {
    std::vector<Situation> rooms = situations(lab, set, noise, change);
    evaluation::Evaluation of_set;
    for (const Situation& s : rooms) {
      double seconds = 0;
      of_set += evaluate(s, knowledge, &seconds);
      out.label_ms += 1e3 * seconds, out.relate_ms += 1e3 * s.relate_seconds, out.planes += s.scene.ids.size(), ++out.rooms;
    }
    out.f1.push_back(f1_of(of_set.after.objects));
    out.sum += of_set;
    if (keep) keep->push_back(std::move(rooms));
  }
  return out;
}

std::string spread(std::vector<double> values) {
  double mean = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return fmt::format("{:.3f} ({:.3f} to {:.3f})", mean, *low, *high);
}

void condition(Lab& lab, const std::string& name, const Scores& s) {
  const auto iou = evaluation::point_scores(s.sum.after.points);
  const auto of = [&](const char* c) { return iou.contains(c) ? iou.at(c).iou() : 0.0; };
  const auto f = [&](const char* c) { return s.sum.after.objects.contains(c) ? f1(s.sum.after.objects.at(c)) : 0.0; };
  lab.write("| {} | {:.3f} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", name, f1_of(s.sum.before.objects), spread(s.f1),
            f("table"), f("flat_screen"), f("keyboard"), of("floor"), of("ceiling"), of("wall"), s.sum.segmentation[0].recall(),
            s.sum.after.calibration.ece());
}

const char* const kConditionHead =
    "| condition | F1 before | F1 after, mean over sets (range) | table | flat_screen | keyboard | IoU floor | ceiling | wall | faces found (IoU 0.5) | ECE |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

void table1(Lab& lab, const fs::path& folder, std::vector<std::vector<Situation>>& rooms) {
  const Scores office = score(lab, lab.office, 0.01, {}, &rooms);
  evaluation::Evaluation paper;
  for (const auto& set : rooms) {
    for (const Situation& s : set) paper += evaluate(s, lab.paper);
  }
  lab.report += title_of("Table 1 of the paper, on simulated rooms");
  lab.write("{} sets of six rooms, 1 cm range noise. The paper on its six real rooms after constraints: precision 0.655, recall 0.679, F1 0.667.\n\n", lab.sets);
  lab.write("Reference mode of the paper (equation 1, hand-set Gaussians, hard constraints):\n\n```text\n{}```\n\nDefault knowledge:\n\n```text\n{}```\n",
            to_text(paper, {.title = "reference mode", .classes = kPaperClasses}), to_text(office.sum, {.title = "default knowledge", .classes = kPaperClasses}));
  pipeline::write_text_file(folder / "table1.html", to_html(office.sum, {.title = "Simulated offices, 1 cm range noise", .classes = {}}));
  lab.write("\nAs a page with plots: [table1.html](table1.html). F1 of single sets: {}. A room has {:.0f} planes; relations take {:.1f} ms, pre-classification, "
            "compiling, solving, margins and probabilities {:.1f} ms (means).\n",
            spread(office.f1), static_cast<double>(office.planes) / static_cast<double>(office.rooms), office.relate_ms / static_cast<double>(office.rooms),
            office.label_ms / static_cast<double>(office.rooms));
}

void conditions(Lab& lab) {
  lab.report += title_of("Noise, bias, poses, sensors");
  lab.write("Default knowledge, learned at 1 cm, varied rooms at 1 and 2 cm. Bias is constant per object, of 1 cm standard deviation. F1 over table, flat_screen, keyboard.\n\n{}", kConditionHead);
  for (const double noise : {0.0, 0.005, 0.01, 0.02, 0.03}) condition(lab, fmt::format("noise {} cm", 100 * noise), score(lab, lab.office, noise));
  condition(lab, "noise 1 cm, bias 1 cm", score(lab, lab.office, 0.01, [](auto& o) { o.material_bias = 0.01; }));
  for (const int poses : {2, 3}) condition(lab, fmt::format("{} poses", poses), score(lab, lab.office, 0.01, [=](auto& o) { o.poses = poses; }));
  condition(lab, "100,000 points", score(lab, lab.office, 0.01, [](auto& o) { o.points = 100'000; }));
  condition(lab, "one depth-camera frame", score(lab, lab.office, 0.01, [](auto& o) { o.sensor = simulator::Sensor::depth_camera; }));
}

void occlusion(Lab& lab, const std::vector<std::vector<Situation>>& rooms) {
  lab.report += title_of("Occlusion");
  lab.write("Share of the objects of the three classes that were found, by how many of their points are seen (1 cm noise).\n\n| points seen | objects | found |\n| --- | --- | --- |\n");
  const std::vector<std::size_t> borders{1, 100, 300, 1000, 3000, 10'000, 1'000'000'000};
  std::vector<int> all(borders.size()), found(borders.size());
  for (const auto& set : rooms) {
    for (const Situation& s : set) {
      const experiment::Labelling labelling = experiment::label(lab.office, s);
      std::map<int, bool> hit;
      for (std::size_t p = 0; p < s.room.truth.size(); ++p) {
        if (s.room.truth[p].object >= 0 && labelling.after.classes[p] == s.room.truth[p].object_class) hit[s.room.truth[p].object] = true;
      }
      for (std::size_t o = 0; o < s.room.objects.objects.size(); ++o) {
        const evaluation::TruthObject& object = s.room.objects.objects[o];
        if (object.points == 0 || std::find(kPaperClasses.begin(), kPaperClasses.end(), object.object_class()) == kPaperClasses.end()) continue;
        const auto bin = static_cast<std::size_t>(std::upper_bound(borders.begin(), borders.end(), object.points) - borders.begin());
        ++all[bin], found[bin] += hit[static_cast<int>(o)];
      }
    }
  }
  for (std::size_t b = 1; b < borders.size(); ++b) {
    if (all[b] > 0) lab.write("| {} {} | {} | {:.2f} |\n", b + 1 == borders.size() ? "from" : "below", b + 1 == borders.size() ? borders[b - 1] : borders[b], all[b], static_cast<double>(found[b]) / all[b]);
  }
}

double f1_with(const std::vector<std::vector<Situation>>& rooms, const kb::Knowledge& knowledge) {
  std::map<std::string, evaluation::ClassScore> scores;
  for (const auto& set : rooms) {
    for (const Situation& s : set) {
      const std::vector<std::string> classes = experiment::best_classes(knowledge, s);
      for (const std::string& name : kPaperClasses) scores[name] += evaluation::score_class(s.room.objects, s.room.truth, classes, name);
    }
  }
  return f1_of(scores);
}

void ablation(Lab& lab, const std::vector<std::vector<Situation>>& rooms) {
  const double whole = f1_with(rooms, lab.office);
  lab.report += title_of("Ablation");
  lab.write("F1 over the three classes with everything: {:.3f}. What is lost (+) when one row or feature is left out, the others staying as they are "
            "learned; one object is about {:.3f}.\n\n| left out | loss |\n| --- | --- |\n", whole, 1.0 / (28.0 * lab.sets));
  std::vector<std::pair<double, std::string>> losses;
  for (std::size_t r = 0; r < lab.office.constraints.size(); ++r) {
    kb::Knowledge without = lab.office;
    if (!without.constraints[r].enabled) continue;
    without.constraints[r].enabled = false;
    losses.emplace_back(whole - f1_with(rooms, without), "constraint " + without.constraints[r].name);
  }
  for (std::size_t f = 0; f < lab.office.features.size(); ++f) {
    kb::Knowledge without = lab.office;
    if (without.features[f].weight <= 0) continue;
    without.features[f].weight = 0;
    losses.emplace_back(whole - f1_with(rooms, without), "feature " + without.features[f].name);
  }
  kb::Knowledge none = lab.office;
  for (kb::ClassConstraint& row : none.constraints) row.enabled = false;
  losses.emplace_back(whole - f1_with(rooms, none), "all constraints");
  std::stable_sort(losses.begin(), losses.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [loss, name] : losses) lab.write("| {} | {:+.3f} |\n", name, loss);
}

void real_scans(Lab& lab, const fs::path& folder) {
  std::vector<std::string> classes;
  for (const kb::ObjectClass& c : lab.office.classes) classes.push_back(c.name);
  const evaluation::ClassMap map = evaluation::read_class_map("indoor", classes);
  std::vector<fs::path> scans;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".ply") scans.push_back(entry.path());
  }
  std::sort(scans.begin(), scans.end());
  evaluation::Evaluation sum;
  std::string names;
  for (const fs::path& path : scans) {
    const perception::PointTable points = perception::read_points(path);
    if (!points.find("label")) continue;
    const evaluation::SceneTruth truth =
        evaluation::truth_of_table(points, {.path = path, .map = &map, .names = evaluation::read_label_names(evaluation::find_label_names(path))}, lab.office);
    const perception::Perception seen = perception::perceive(perception::to_cloud(points, path.string()));
    Situation s = experiment::assess({.scan = {}, .record = {.name = "scan", .rotation = seen.upright.rotation, .floor_z = seen.upright.floor_z},
                                      .planes = experiment::stored(seen.planes), .objects = truth, .plane_of_point = seen.plane_of_point, .truth = {}},
                                     lab.relations(), lab.rules);
    sum += evaluate(s, lab.office);
    names += (names.empty() ? "" : ", ") + path.stem().string();
  }
  lab.report += title_of("Real scans");
  lab.write("Labelled scans of the development collection ({}); points without a label are not judged, a chair counts as found when any part of it is. "
            "Segmentation, two settings, how up is weighed, how much features may weigh, how sharp kinds are in shares, columns and partitions of varied rooms, the feature behind and which rows speak of walls were chosen with an eye on these scans, no density was learned from them.\n\n```text\n{}```\n",
            names, to_text(sum, {.title = "real scans", .classes = {}}));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') {
    fmt::print(stderr, "usage: experiments FOLDER [SETS [FIRST_SEED [REAL]]]\n");
    return 2;
  }
  const fs::path folder = argv[1];
  fs::create_directories(folder);
  Lab lab;
  if (argc > 2) lab.sets = std::max(1, std::atoi(argv[2]));
  if (argc > 3) lab.first_seed = std::strtoull(argv[3], nullptr, 10);
  lab.write("# Experiments\n\nWritten by `make experiments` (tools/bench/experiments.cpp): {} sets of six paper-like rooms a condition, seeds {} to {}.\n"
            "Split: densities, priors and weights are learned from the rooms and frames that the head of schemas/knowledge/office_learned.sql names; "
            "perception and the recipe of learning were chosen on seeds below 9400, and on 9951 to 9990 once they had been reported; other seeds from 9401 to 9999 serve reports alone.\n"
            "More sets: `build/bench/bin/experiments FOLDER SETS FIRST_SEED REAL`; ten sets take about five times as long as two.\n",
            lab.sets, lab.first_seed, lab.first_seed + static_cast<std::uint64_t>(lab.sets) - 1);
  std::vector<std::vector<Situation>> rooms;
  table1(lab, folder, rooms);
  features_of_known_planes(lab);
  position(lab);
  occlusion(lab, rooms);
  ablation(lab, rooms);
  conditions(lab);
  if (argc > 4) real_scans(lab, argv[4]);
  pipeline::write_text_file(folder / "README.md", lab.report);
  return 0;
}
