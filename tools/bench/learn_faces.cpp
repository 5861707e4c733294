// Learns the trees of the face model (perception/src/face_model.hpp) from simulated scans and prints them as C++ (face_trees.inc).
// A region is a face when half of both are the same. Scans: paper-like rooms at several densities and noises, varied rooms and
// depth-camera frames, of seeds from 8501 to 8760, on which nothing is reported. Which earlier regions are asked about depends on what the present
// trees give up: where those of surfaces and things change, learn once more.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "bench/segmentation_scores.hpp"
#include "find_regions.hpp"
#include "learning/boosted_trees.hpp"
#include "scenelore/perception/parallel.hpp"
#include "simulator/simulate.hpp"

namespace {

using namespace scenelore;

constexpr double kSame = 0.5;
constexpr std::size_t kDepth = 4;        // as kQuestions of face_model.cpp
constexpr std::size_t kUnknownIn = 4;    // scans: in every so many it is also asked what is told without the sensor's position

std::vector<simulator::SimulationOptions> scans() {
  std::vector<simulator::SimulationOptions> out;
  const std::array<std::size_t, 6> sizes{0, 100'000, 500'000, 1'500'000, 4'000'000, 250'000};
  for (std::uint64_t set = 0; set < 30; ++set) {
    for (const double noise : {0.01, 0.02}) {
      auto rooms = simulator::paper_rooms(8501 + 2 * set + (noise > 0.01 ? 1 : 0), noise);
      for (std::size_t i = 0; i < rooms.size(); ++i) {
        if (noise > 0.01 && i % 2 == 1) continue;
        rooms[i].points = sizes[(i + set) % sizes.size()];
        out.push_back(rooms[i]);
      }
    }
  }
  for (std::uint64_t i = 0; i < 100; ++i) out.push_back({.seed = 8601 + i, .sensor = simulator::Sensor::depth_camera, .varied = true});
  for (std::uint64_t i = 0; i < 60; ++i) out.push_back({.seed = 8701 + i, .varied = true});
  return out;
}

/// How often a face has higher odds than what is none.
double area_under_curve(const learning::BoostedTrees& model, const std::vector<std::vector<double>>& traits, const std::vector<bool>& faces) {
  std::vector<std::pair<double, bool>> ranked;
  for (std::size_t i = 0; i < traits.size(); ++i) ranked.emplace_back(model.odds(traits[i]), faces[i]);
  std::sort(ranked.begin(), ranked.end());
  double below = 0, pairs = 0, yes = 0;
  for (const auto& [odds, face] : ranked) {
    if (face) {
      pairs += below, yes += 1;
    } else {
      below += 1;
    }
  }
  return pairs / std::max(1.0, yes * below);
}

/// Regions of which all or none are things on planes.
struct Examples {
  std::vector<std::vector<double>> traits;
  std::vector<bool> faces;
  std::vector<std::size_t> scan_of;

  void add(std::span<const double> some, bool face, std::size_t scan) {
    traits.emplace_back(some.begin(), some.end());
    faces.push_back(face);
    scan_of.push_back(scan);
  }
};

/// Every fourth scan left out tells what the model is worth on scans that it has not seen.
double area_on_unseen(const Examples& all) {
  Examples seen, unseen;
  for (std::size_t i = 0; i < all.traits.size(); ++i) {
    Examples& to = all.scan_of[i] % 4 == 3 ? unseen : seen;
    to.add(all.traits[i], all.faces[i], all.scan_of[i]);
  }
  return area_under_curve(learning::fit_boosted_trees(seen.traits, seen.faces, {.depth = kDepth}), unseen.traits, unseen.faces);
}

/// Of a region that nobody knows from where it was seen.
perception::FaceTraits without_position(perception::FaceTraits traits) {
  for (const perception::Trait trait : {perception::Trait::slant, perception::Trait::excess}) {
    traits[static_cast<std::size_t>(trait)] = std::numeric_limits<double>::quiet_NaN();
  }
  return traits;
}

template <typename Values, typename Format>
std::string list(const Values& values, Format format) {
  std::string text;
  for (const auto& v : values) text += (text.empty() ? "" : ", ") + format(v);
  return "{" + text + "}";
}

/// A tree with fewer questions asks the last one again, to which the leaves that differ in it have the same answer.
void print(const char* name, const Examples& examples) {
  learning::BoostedTrees model = learning::fit_boosted_trees(examples.traits, examples.faces, {.depth = kDepth});
  fmt::print("// {} regions, {} of them faces; area under the curve on scans left out: {:.4f}.\n"
             "constexpr double k{}Offset = {:.4f};\nconstexpr Tree k{}[] = {{\n",
             examples.faces.size(), std::count(examples.faces.begin(), examples.faces.end(), true), area_on_unseen(examples), name, model.offset, name);
  for (learning::QuestionTree& tree : model.trees) {
    while (tree.questions.size() < kDepth) {
      tree.questions.push_back(tree.questions.back());
      const std::vector<double> odds = tree.odds;
      tree.odds.insert(tree.odds.end(), odds.begin(), odds.end());
    }
    fmt::print("    {{{}, {},\n     {}}},\n", list(tree.questions, [](const auto& q) { return fmt::format("{}", q.trait); }),
               list(tree.questions, [](const auto& q) { return fmt::format("{:.6g}", q.above); }),
               list(tree.odds, [](double v) { return fmt::format("{:.3g}", v); }));
  }
  fmt::print("}};\n");
}

/// The regions of one scan, by how they came about.
std::map<perception::Origin, Examples> examples_of(const simulator::SimulationOptions& options, std::size_t number) {
  std::map<perception::Origin, Examples> examples;
  const simulator::SimulatedScan scan = simulator::simulate(options);
  perception::FaceQuestions questions;
  static_cast<void>(perception::find_regions(perception::to_cloud(scan.points, "room"), {.threads = 1}, &questions));
  for (const perception::FaceRound& round : questions.rounds) {
    const auto overlap = experiment::face_overlaps(scan, questions.points, round.region_of_point, round.traits.size());
    std::vector<double> points(round.traits.size(), 0);
    for (const std::int32_t r : round.region_of_point) {
      if (r >= 0) points[static_cast<std::size_t>(r)] += 1;
    }
    for (std::size_t r = round.first; r < points.size(); ++r) {
      if (points[r] < 3) continue;
      Examples& of = examples[round.origins[r]];
      of.add(round.traits[r], overlap[r] >= kSame, number);
      if (number % kUnknownIn == 0) of.add(without_position(round.traits[r]), overlap[r] >= kSame, number);
    }
  }
  return examples;
}

}  // namespace

int main() {
  const std::vector<simulator::SimulationOptions> all = scans();
  std::vector<std::map<perception::Origin, Examples>> of_scan(all.size());
  perception::parallel_pieces(all.size(), 1, 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) of_scan[s] = examples_of(all[s], s);
  });
  std::map<perception::Origin, Examples> examples;
  for (const auto& of_one : of_scan) {
    for (const auto& [origin, some] : of_one) {
      for (std::size_t i = 0; i < some.faces.size(); ++i) examples[origin].add(some.traits[i], some.faces[i], some.scan_of[i]);
    }
  }
  fmt::print("// Learned by `make faces` (tools/bench/learn_faces.cpp) from {} simulated scans.\n\n", all.size());
  print("Surfaces", examples[perception::Origin::surface]);
  fmt::print("\n");
  print("Things", examples[perception::Origin::thing]);
  fmt::print("\n");
  print("Earlier", examples[perception::Origin::earlier]);
  fmt::print("\n");
  print("Finer", examples[perception::Origin::finer]);
  return 0;
}
