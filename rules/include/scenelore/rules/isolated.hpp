// Rules from strangers in a process of their own: what they answer comes back through a pipe, and should one ever get out of
// its sandbox, it is in a process that can write no file, start no program and use up only so much.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenelore/rules/rule_set.hpp"
#include "scenelore/rules/testing.hpp"

namespace scenelore::rules {

/// All that labelling needs of rules, for one scene.
struct RuleAnswers {
  std::vector<kb::Feature> features;  ///< of Lua feature files, those that the knowledge lacks
  kb::FeatureTable table;             ///< the scene's features with theirs
  Facts facts;                        ///< of the relations that enabled rows use
  std::string hash;                   ///< RuleSet::hash
};

/// In this process. Throws Error as RuleSet and used_relations do. The result does not depend on `threads`.
[[nodiscard]] RuleAnswers answer(RuleSet& rules, const kb::Knowledge& knowledge, Scene& scene,
                                 const KnownAnswers& known, int threads = 2);

/// rlimits of the child, on top of the budgets of the sandbox.
struct Isolation {
  unsigned cpu_seconds = 120;
  std::size_t memory_bytes = std::size_t{2} << 30;  ///< of address space, the program's own included
};

/// The same in a child process, which also loads the rules. No file can grow in it (RLIMIT_FSIZE 0), it can start no other
/// process or thread (RLIMIT_NPROC 0, unless root asks) and gain no rights (no_new_privs). Throws Error with the child's own message,
/// or with what ended it. Geometry and answers to keep do not come back. What does is checked: facts about planes that are not there, or with degrees outside (0, 1],
/// are errors later on.
[[nodiscard]] RuleAnswers answer_isolated(const std::vector<std::filesystem::path>& directories, const Budget& budget,
                                          const kb::Knowledge& knowledge, const Scene& scene,
                                          const KnownAnswers& known, const Isolation& limits = {});

/// run_rule_tests in such a process; the planes that expectations asked about are left out.
[[nodiscard]] std::vector<RuleTestFile> run_rule_tests_isolated(const std::vector<std::filesystem::path>& directories,
                                                                const Budget& budget, const Isolation& limits = {});

}  // namespace scenelore::rules
