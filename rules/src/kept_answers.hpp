// Answers of Lua features and constraints that are carried over from one run to the next.
#pragma once

#include <string>

#include "fact_inputs.hpp"

namespace scenelore::rules {

/// The answers of the run before to a rule, if it was the same rule about the same planes; they are kept on. Else nullptr.
[[nodiscard]] const kb::StoredAnswer* kept_answer(KeptAnswers* kept, const std::string& rule, const RuleSource& source,
                                                  const SceneDigest& scene);

/// Keeps what a file answered, beside what that depends on.
void keep(KeptAnswers* kept, const std::string& rule, const RuleFile& file, const SceneDigest& scene, std::string answers);

}  // namespace scenelore::rules
