// Learns the curves of the face model (perception/src/face_model.hpp) from simulated scans and prints them as C++ (face_curves.inc).
// A region is a face when half of both are the same. Scans: paper-like rooms at several densities and noises, varied rooms and
// depth-camera frames, of seeds from 8501 on, on which nothing is reported. Which earlier regions are asked about depends on what the present
// curves give up: where those of surfaces and things change, learn once more.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "bench/segmentation_scores.hpp"
#include "find_regions.hpp"
#include "learning/additive_model.hpp"
#include "simulator/simulate.hpp"

namespace {

using namespace scenelore;

constexpr std::size_t kKnots = 9;
constexpr double kPenalty = 4, kSame = 0.5;
constexpr const char* kNames[perception::kTraits] = {"points", "area", "length", "thickness", "roughness", "agreeing", "unevenness",
                                                     "fill", "layer", "contact", "left", "foreign", "tilt", "slant", "excess"};

std::vector<simulator::SimulationOptions> scans() {
  std::vector<simulator::SimulationOptions> out;
  const std::array<std::size_t, 4> sizes{0, 100'000, 500'000, 1'500'000};
  for (std::uint64_t set = 0; set < 10; ++set) {
    for (const double noise : {0.01, 0.02}) {
      auto rooms = simulator::paper_rooms(8501 + 2 * set + (noise > 0.01 ? 1 : 0), noise);
      for (std::size_t i = 0; i < rooms.size(); ++i) {
        if (noise > 0.01 && i % 2 == 1) continue;
        rooms[i].points = sizes[i % sizes.size()];
        out.push_back(rooms[i]);
      }
    }
  }
  for (std::uint64_t i = 0; i < 60; ++i) out.push_back({.seed = 8601 + i, .sensor = simulator::Sensor::depth_camera, .varied = true});
  for (std::uint64_t i = 0; i < 20; ++i) out.push_back({.seed = 8701 + i, .varied = true});
  return out;
}

/// How often a face has higher odds than what is none.
double area_under_curve(const learning::AdditiveModel& model, const std::vector<std::vector<double>>& traits, const std::vector<bool>& faces) {
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
};

/// Every fourth scan left out tells what the model is worth on scans that it has not seen.
double area_on_unseen(const Examples& all) {
  Examples seen, unseen;
  for (std::size_t i = 0; i < all.traits.size(); ++i) {
    Examples& to = all.scan_of[i] % 4 == 3 ? unseen : seen;
    to.traits.push_back(all.traits[i]);
    to.faces.push_back(all.faces[i]);
  }
  return area_under_curve(learning::fit_additive(seen.traits, seen.faces, kKnots, kPenalty), unseen.traits, unseen.faces);
}

void print(const char* name, const Examples& examples) {
  const learning::AdditiveModel model = learning::fit_additive(examples.traits, examples.faces, kKnots, kPenalty);
  fmt::print("// {} regions, {} of them faces; area under the curve on scans left out: {:.4f}.\n"
             "constexpr Model {}{{{:.4f}, {{{{\n",
             examples.faces.size(), std::count(examples.faces.begin(), examples.faces.end(), true), area_on_unseen(examples), name, model.offset);
  const auto list = [](const std::vector<double>& values) {
    std::string text;
    for (const double v : values) text += fmt::format("{}{:.4f}", text.empty() ? "" : ", ", v);
    return text;
  };
  for (std::size_t t = 0; t < model.curves.size(); ++t) {
    fmt::print("    Curve{{{{{}}},\n          {{{}}}}},  // {}\n", list(model.curves[t].at), list(model.curves[t].odds), kNames[t]);
  }
  fmt::print("}}}}}};\n");
}

}  // namespace

int main() {
  std::map<perception::Origin, Examples> examples;
  const auto all = scans();
  for (std::size_t s = 0; s < all.size(); ++s) {
    const simulator::SimulatedScan scan = simulator::simulate(all[s]);
    perception::FaceQuestions questions;
    static_cast<void>(perception::find_regions(perception::to_cloud(scan.points, "room"), {.threads = 2}, &questions));
    for (const perception::FaceRound& round : questions.rounds) {
      const auto overlap = experiment::face_overlaps(scan, questions.points, round.region_of_point, round.traits.size());
      std::vector<double> points(round.traits.size(), 0);
      for (const std::int32_t r : round.region_of_point) {
        if (r >= 0) points[static_cast<std::size_t>(r)] += 1;
      }
      for (std::size_t r = round.first; r < points.size(); ++r) {
        if (points[r] < 3) continue;
        Examples& of = examples[round.origins[r]];
        of.traits.emplace_back(round.traits[r].begin(), round.traits[r].end());
        of.faces.push_back(overlap[r] >= kSame);
        of.scan_of.push_back(s);
      }
    }
  }
  fmt::print("// Learned by `make faces` (tools/bench/learn_faces.cpp) from {} simulated scans.\n\n", all.size());
  print("kSurfaces", examples[perception::Origin::surface]);
  fmt::print("\n");
  print("kThings", examples[perception::Origin::thing]);
  fmt::print("\n");
  print("kEarlier", examples[perception::Origin::earlier]);
  return 0;
}
