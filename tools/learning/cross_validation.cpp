#include "learning/cross_validation.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <set>
#include <thread>

#include "evaluation/calibration.hpp"

namespace scenelore::learning {

namespace {

/// Fold of each plane; −1 without a class. By scans where there are enough, else class by class in turn.
std::vector<std::vector<int>> folds_of(const std::vector<rules::LabelledScene>& scenes, int folds) {
  const bool whole = static_cast<int>(scenes.size()) >= folds;
  std::map<std::string, int> seen;
  std::vector<std::vector<int>> out;
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    std::vector<int>& of_scene = out.emplace_back();
    for (const std::string& name : scenes[s].classes) {
      of_scene.push_back(name.empty() ? -1 : (whole ? static_cast<int>(s) : seen[name]++) % folds);
    }
  }
  return out;
}

std::string class_of(const std::vector<kb::Label>& labels, kb::PlaneId plane, double& probability) {
  for (const kb::Label& label : labels) {
    if (label.plane == plane) {
      probability = label.probability;
      return label.object_class;
    }
  }
  return "";
}

void judge_scene(const kb::Knowledge& knowledge, const rules::LabelledScene& scene, std::size_t number, const std::vector<bool>& wanted,
                 std::vector<Judged>& out) {
  if (std::none_of(wanted.begin(), wanted.end(), [](bool w) { return w; })) return;
  const auto evidence = kb::preclassify(knowledge, scene.scene.features, 1);  // scenes are judged in parallel
  rules::LabellingOptions options{.alternatives = 0, .reasons = false};
  options.solver.limits.nodes = 200'000;
  const kb::Inference answer = rules::label(knowledge, scene.scene, evidence, scene.facts, {}, options);
  for (std::size_t p = 0; p < wanted.size(); ++p) {
    if (!wanted[p]) continue;
    Judged judged{.scene = number, .plane = p, .truth = scene.classes[p]};
    const auto best = std::max_element(evidence[p].begin(), evidence[p].end());
    judged.by_evidence = knowledge.classes[static_cast<std::size_t>(best - evidence[p].begin())].name;
    judged.best_evidence = *best;
    judged.truth_evidence = evidence[p][static_cast<std::size_t>(knowledge.class_index(judged.truth))];
    judged.by_world = class_of(answer.labels, scene.scene.ids[p], judged.world_probability);
    out.push_back(std::move(judged));
  }
}

/// f(0), f(1), … on some threads.
template <typename Function>
void in_parallel(int count, int threads, Function f) {
  std::atomic<int> next{0};
  std::vector<std::jthread> workers;
  for (int t = 0; t < std::min(threads, count); ++t) {
    workers.emplace_back([&] {
      for (int i = next++; i < count; i = next++) f(i);
    });
  }
}

}  // namespace

std::vector<Judged> judge(const kb::Knowledge& knowledge, const std::vector<rules::LabelledScene>& scenes, const Options& options) {
  std::vector<std::vector<Judged>> parts(scenes.size());
  in_parallel(static_cast<int>(scenes.size()), options.threads, [&](int s) {
    const auto i = static_cast<std::size_t>(s);
    std::vector<bool> wanted;
    for (const std::string& name : scenes[i].classes) wanted.push_back(!name.empty());
    judge_scene(knowledge, scenes[i], i, wanted, parts[i]);
  });
  std::vector<Judged> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

std::vector<Judged> cross_validate(const kb::Knowledge& knowledge, const std::vector<rules::LabelledScene>& scenes, const Options& options) {
  const auto fold_of = folds_of(scenes, options.folds);
  std::vector<std::vector<Judged>> parts(static_cast<std::size_t>(options.folds));
  in_parallel(options.folds, options.threads, [&](int fold) {
    std::vector<rules::LabelledScene> others;
    for (std::size_t s = 0; s < scenes.size(); ++s) {
      rules::LabelledScene held = scenes[s];
      for (std::size_t p = 0; p < held.classes.size(); ++p) {
        if (fold_of[s][p] == fold) held.classes[p].clear();
      }
      const bool empty = std::all_of(held.classes.begin(), held.classes.end(), [](const std::string& c) { return c.empty(); });
      if (!empty) others.push_back(std::move(held));
    }
    const Fit fitted = fit(knowledge, others, options);
    for (std::size_t s = 0; s < scenes.size(); ++s) {
      std::vector<bool> wanted;
      for (const int f : fold_of[s]) wanted.push_back(f == fold);
      judge_scene(fitted.knowledge, scenes[s], s, wanted, parts[static_cast<std::size_t>(fold)]);
    }
  });
  std::vector<Judged> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  std::sort(out.begin(), out.end(), [](const Judged& a, const Judged& b) { return std::pair(a.scene, a.plane) < std::pair(b.scene, b.plane); });
  return out;
}

Effect effect_of(const std::vector<Judged>& judged, const std::string& fallback) {
  Effect out{.planes = static_cast<int>(judged.size())};
  if (judged.empty()) return out;
  const double n = static_cast<double>(judged.size());
  evaluation::Calibration calibration;
  std::map<std::string, std::array<double, 3>> counts;  // truth, answer, both
  for (const Judged& j : judged) {
    out.evidence_accuracy += (j.by_evidence == j.truth) / n;
    out.accuracy += (j.by_world == j.truth) / n;
    out.log_likelihood += std::log(std::max(j.truth_evidence, kb::kLeastProbability)) / n;
    calibration.add({j.world_probability, j.by_world == j.truth});
    counts[j.truth][0] += 1;
    counts[j.by_world][1] += 1;
    if (j.by_world == j.truth) counts[j.truth][2] += 1;
  }
  out.ece = calibration.ece();
  counts.erase(fallback);
  for (const auto& [name, c] : counts) out.macro_f1 += 2 * c[2] / (c[0] + c[1]) / static_cast<double>(counts.size());
  return out;
}

}  // namespace scenelore::learning
