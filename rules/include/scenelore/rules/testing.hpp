// Tests of rules, written in Lua: a file above_test.lua beside above.lua, run in the sandbox of the rule itself.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenelore/rules/rule_set.hpp"

namespace scenelore::rules {

/// A question that an expectation asked of a relation.
struct Asked {
  perception::Plane a, b;
  double degree = 0;
};

struct RuleTestCase {
  std::string name;     ///< the sentence given to case()
  std::string failure;  ///< empty = passed; else file:line and what was found
  std::vector<Asked> asked;
};

struct RuleTestFile {
  std::string file;
  std::string rule;     ///< relation or feature it is about
  std::string failure;  ///< why the file could not be run at all; empty = it was
  std::vector<RuleTestCase> cases;

  [[nodiscard]] bool passed() const;
};

/// Runs the tests of the built-in rules, or, when folders are given, those in the folders; by file name. A broken rule or
/// test file is a failure in its entry, never an exception; a folder that cannot be read throws Error.
[[nodiscard]] std::vector<RuleTestFile> run_rule_tests(const std::vector<std::filesystem::path>& directories = {},
                                                       Budget budget = {});

/// Readable text, or TAP version 13.
[[nodiscard]] std::string as_text(const std::vector<RuleTestFile>& files);
[[nodiscard]] std::string as_tap(const std::vector<RuleTestFile>& files);

}  // namespace scenelore::rules
