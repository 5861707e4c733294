// The rule language as files for editors and checkers, written from the table that registers the host's functions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenelore/rules/rule_set.hpp"

namespace scenelore::rules {

/// Everything that rule files see, for lua-language-server: a file that starts with `---@meta`.
[[nodiscard]] std::string language_meta();
/// `.luarc.json` of a folder of rules; the meta file lies in its folder `.scenelore`.
[[nodiscard]] std::string language_luarc();
/// `.luacheckrc` of a folder of rules.
[[nodiscard]] std::string language_luacheckrc();

/// A relation or feature and its test, as a start: both in order, and the test passes.
struct NewRule {
  std::string rule, test;
};
[[nodiscard]] NewRule new_relation(const std::string& name);
/// All fields of a built-in relation, with its tolerances to be changed. Throws Error for a relation that is not there.
[[nodiscard]] NewRule new_variant(const std::string& name, const std::string& extends);
[[nodiscard]] NewRule new_feature(const std::string& name);

/// Text about one rule: summary, sketch (the comment before `return`), reach, tolerances.
[[nodiscard]] std::string describe(const RelationInfo& relation, const std::string& text);
/// The comment lines that a rule file starts with, without their dashes.
[[nodiscard]] std::string head_comment(const std::string& text);

}  // namespace scenelore::rules
