#include "kept_answers.hpp"

#include <utility>

namespace scenelore::rules {

const kb::StoredAnswer* kept_answer(KeptAnswers* kept, const std::string& rule, const RuleSource& source, const SceneDigest& scene) {
  if (kept == nullptr) return nullptr;
  const auto found = kept->before.find(rule);
  if (found == kept->before.end() || found->second.inputs_sha256 != fact_inputs(source, {}, scene.with(found->second.features))) return nullptr;
  return &(kept->now[rule] = found->second);
}

void keep(KeptAnswers* kept, const std::string& rule, const RuleFile& file, const SceneDigest& scene, std::string answers) {
  if (kept == nullptr) return;
  const std::string features = file.features_read();
  kept->now[rule] = {features, fact_inputs(file.source(), {}, scene.with(features)), std::move(answers)};
}

}  // namespace scenelore::rules
