#include "learning/learning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "learning/cross_validation.hpp"
#include "learning/fit.hpp"
#include "learning/platt.hpp"

namespace scenelore::learning {

namespace {

std::vector<Suspect> suspects_of(const std::vector<Judged>& judged, const std::vector<LabelledScan>& scans, const Options& options) {
  std::vector<const Judged*> doubtful;
  for (const Judged& j : judged) {
    if (j.truth_evidence < options.suspicious && j.best_evidence > 0.5 && j.by_world != j.truth) doubtful.push_back(&j);
  }
  std::stable_sort(doubtful.begin(), doubtful.end(), [](const Judged* a, const Judged* b) { return a->truth_evidence < b->truth_evidence; });
  doubtful.resize(std::min(doubtful.size(), static_cast<std::size_t>(options.most_suspects * static_cast<double>(judged.size()))));
  std::vector<Suspect> out;
  for (const Judged* j : doubtful) {
    out.push_back({scans[j->scene].scan, scans[j->scene].planes.scene.ids[j->plane], j->truth, j->by_evidence, j->truth_evidence});
  }
  return out;
}

/// Why there is too little to learn from.
std::optional<std::string> too_little(const std::vector<rules::LabelledScene>& scenes, const Options& options, int& planes) {
  std::map<std::string, int> count;
  for (const rules::LabelledScene& scene : scenes) {
    for (const std::string& name : scene.classes) {
      if (!name.empty()) ++count[name], ++planes;
    }
  }
  if (planes < options.fewest_planes) {
    return fmt::format("{} planes are labelled, {} are needed: add rows to the table truth, or correct labels in a GIS", planes, options.fewest_planes);
  }
  const bool enough = std::any_of(count.begin(), count.end(), [&](const auto& entry) { return entry.second >= options.min_examples; });
  if (!enough) return fmt::format("no class has {} labelled planes", options.min_examples);
  return std::nullopt;
}

}  // namespace

std::vector<LabelledScan> labelled_scans(const kb::KnowledgeBase& base, const std::vector<kb::Scan>& scans, rules::RuleSet& rules) {
  std::vector<LabelledScan> out;
  for (const kb::Scan& scan : scans) {
    if (base.truth(scan.id).empty()) continue;
    pipeline::Situation situation = pipeline::assess(base, scan, rules);
    LabelledScan& labelled = out.emplace_back();
    labelled.scan = scan.name;
    labelled.planes.classes.resize(situation.scene.ids.size());
    for (const auto& [plane, name] : situation.truth) {
      const auto found = std::find(situation.scene.ids.begin(), situation.scene.ids.end(), plane);
      if (found != situation.scene.ids.end()) labelled.planes.classes[static_cast<std::size_t>(found - situation.scene.ids.begin())] = name;
    }
    labelled.planes.scene = std::move(situation.scene);
    labelled.planes.facts = std::move(situation.facts);
  }
  return out;
}

bool Learned::harmful() const { return after.accuracy < before.accuracy - 0.02 && after.log_likelihood < before.log_likelihood; }

Learned learn(const kb::Knowledge& knowledge, const std::vector<LabelledScan>& scans, const Options& options) {
  Learned out{.scans = static_cast<int>(scans.size())};
  std::vector<rules::LabelledScene> scenes;
  for (const LabelledScan& scan : scans) scenes.push_back(scan.planes);
  out.refusal = too_little(scenes, options, out.planes);
  if (out.refusal) return out;

  const std::string& fallback = knowledge.classes[static_cast<std::size_t>(knowledge.fallback_index())].name;
  kb::Knowledge unscaled = knowledge;  // the scale is fitted to what the model itself says
  unscaled.settings.erase("probability_slope");
  unscaled.settings.erase("probability_offset");
  std::vector<Judged> held = cross_validate(unscaled, scenes, options);
  out.suspects = suspects_of(held, scans, options);
  std::vector<Judged> present = judge(knowledge, scenes, options);
  for (const Suspect& suspect : out.suspects) {
    for (std::size_t s = 0; s < scans.size(); ++s) {
      for (std::size_t p = 0; p < scenes[s].classes.size(); ++p) {
        if (scans[s].scan != suspect.scan || scenes[s].scene.ids[p] != suspect.plane) continue;
        scenes[s].classes[p].clear();
        for (auto* list : {&held, &present}) std::erase_if(*list, [&](const Judged& j) { return j.scene == s && j.plane == p; });
      }
    }
  }
  std::vector<evaluation::Claim> claims;
  for (const Judged& j : held) claims.push_back({j.world_probability, j.by_world == j.truth});
  out.scale = fit_scale(claims);
  for (Judged& j : held) j.world_probability = out.scale(j.world_probability);
  out.before = effect_of(present, fallback);
  out.after = effect_of(held, fallback);

  Fit fitted = fit(knowledge, scenes, options);
  out.notes = std::move(fitted.notes);
  out.sql = kb::to_sql(fitted.rows);
  if (fitted.weights) out.sql += rules::to_sql(fitted.with_rows, *fitted.weights);
  const auto setting = [&](const char* key, double value, const char* meaning) {
    const std::string text = fmt::format("{:.3f}", value);
    out.sql += fmt::format("INSERT INTO setting (key, value, description) VALUES ('{}', '{}', '{}')\n  ON CONFLICT (key) DO UPDATE SET value = excluded.value;\n",
                           key, text, meaning);
    fitted.knowledge.settings[key] = text;
  };
  setting("probability_slope", out.scale.slope, "logit of a told probability per logit of the model''s");
  setting("probability_offset", out.scale.offset, "what is added to it");
  out.rows = std::move(fitted.rows);
  out.weights = std::move(fitted.weights);
  out.knowledge = std::move(fitted.knowledge);
  return out;
}

}  // namespace scenelore::learning
