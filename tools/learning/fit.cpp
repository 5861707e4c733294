#include "learning/fit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace scenelore::learning {

namespace {

/// From this share on a scan tells how frequent classes are; else people may have labelled only what was wrong.
constexpr double kMostly = 0.8;

kb::LabelledPlanes all_planes(const std::vector<const rules::LabelledScene*>& scenes) {
  kb::LabelledPlanes out;
  for (const rules::LabelledScene* scene : scenes) {
    out.features.names = scene->scene.features.names;
    out.features.values.insert(out.features.values.end(), scene->scene.features.values.begin(), scene->scene.features.values.end());
    out.classes.insert(out.classes.end(), scene->classes.begin(), scene->classes.end());
  }
  return out;
}

kb::LearnedRows learn_rows(const kb::Knowledge& knowledge, const std::vector<const rules::LabelledScene*>& scenes, const Options& options,
                           bool priors) {
  return kb::learn(knowledge, all_planes(scenes), {.min_examples = options.min_examples, .present_strength = options.present_strength,
                                                   .priors = priors, .outliers = options.outliers});
}

}  // namespace

double labelled_share(const rules::LabelledScene& scene) {
  const auto without = std::count(scene.classes.begin(), scene.classes.end(), "");
  return scene.classes.empty() ? 0 : 1 - static_cast<double>(without) / static_cast<double>(scene.classes.size());
}

Fit fit(const kb::Knowledge& knowledge, const std::vector<rules::LabelledScene>& scenes, const Options& options) {
  std::vector<const rules::LabelledScene*> all, mostly, half;
  std::vector<rules::LabelledScene> rest;
  for (const rules::LabelledScene& scene : scenes) {
    all.push_back(&scene);
    if (labelled_share(scene) >= kMostly) mostly.push_back(&scene);
  }
  Fit out;
  out.rows = learn_rows(knowledge, all, options, mostly.size() == all.size());
  out.notes = out.rows.notes;
  if (mostly.size() < all.size()) {
    out.notes.push_back(fmt::format("priors stay: {} of {} scans are labelled only in part, so that shares of classes mean nothing",
                                    all.size() - mostly.size(), all.size()));
  }
  out.with_rows = kb::with_rows(knowledge, out.rows);
  out.knowledge = out.with_rows;
  if (!options.weights) return out;
  if (static_cast<int>(mostly.size()) < options.scans_for_weights) {
    out.notes.push_back(fmt::format("weights stay: {} scans are labelled by {:.0f} % or more, {} are needed", mostly.size(), 100 * kMostly,
                                    options.scans_for_weights));
    return out;
  }
  for (std::size_t i = 0; i < mostly.size(); ++i) {
    if (i % 2 == 0) half.push_back(mostly[i]);
    else rest.push_back(*mostly[i]);
  }
  const kb::Knowledge strange = kb::with_rows(knowledge, learn_rows(knowledge, half, options, true));
  out.weights = rules::learn_weights(strange, rest, {.rounds = 3});
  out.knowledge = rules::with_weights(out.with_rows, *out.weights);
  return out;
}

}  // namespace scenelore::learning
