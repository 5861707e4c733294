// Asks Lua features for their values.
#include "scenelore/rules/rule_set.hpp"

#include <algorithm>
#include <utility>

#include "byte_stream.hpp"
#include "deadline.hpp"
#include "kept_answers.hpp"
#include "loaded_rules.hpp"
#include "scenelore/rules/error.hpp"
#include "shown_scene.hpp"

namespace scenelore::rules {

namespace {

/// Appends a column that was kept; false where there is none for so many planes.
bool append_kept(const kb::StoredAnswer* kept, kb::FeatureTable& table) {
  if (kept == nullptr || kept->answers.size() != table.values.size() * sizeof(double)) return false;
  Reader column(kept->answers);
  for (std::vector<double>& row : table.values) row.push_back(column.number<double>());
  return true;
}

/// Appends what a file that has been shown the scene answers, and returns it as bytes to keep.
std::string append_asked(RuleFile& file, const Budget& budget, kb::FeatureTable& table) {
  const Deadline deadline(file, budget);
  Writer column;
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    deadline.check(static_cast<std::int64_t>(i));
    table.values[i].push_back(file.value(static_cast<int>(i)));
    column.number(table.values[i].back());
  }
  return std::move(column.bytes);
}

}  // namespace

void RuleSet::compute_features(const Scene& scene, kb::FeatureTable& table, KeptAnswers* kept) const {
  PairGeometry geometry(scene.planes);
  ShownScene shown(scene);
  const SceneDigest digest = loaded_->digest_of(scene);  // `table` is often the scene's own: a feature may look at those before it
  table.values.resize(scene.planes.size(), std::vector<double>(table.names.size()));
  for (auto& [name, entry] : loaded_->features()) {
    if (std::find(table.names.begin(), table.names.end(), name) != table.names.end()) {
      throw Error(entry.source.shown + ": the feature '" + name + "' exists already; choose another name");
    }
    const std::string rule = "feature " + name;
    if (append_kept(kept_answer(kept, rule, entry.source, digest), table)) {
      table.names.push_back(name);
      continue;
    }
    RuleFile& file = loaded_->file(entry);
    table.names.push_back(name);
    shown.show_to(file, geometry);
    keep(kept, rule, file, digest, append_asked(file, loaded_->budget(), table));
  }
}

}  // namespace scenelore::rules
