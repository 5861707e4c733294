// Where rule files come from: compiled in, and folders of the user's.
#pragma once

#include <filesystem>
#include <vector>

#include "rule_file.hpp"

namespace scenelore::rules {

/// Relations and features that come with Scenelore, in name order; without their tests.
[[nodiscard]] std::vector<RuleSource> built_in_sources();
[[nodiscard]] bool is_built_in(const RuleSource& source);

/// All *.lua below a folder, in name order, without *_test.lua unless wanted. Throws Error when the folder or a file
/// cannot be read.
[[nodiscard]] std::vector<RuleSource> sources_below(const std::filesystem::path& directory, bool with_tests = false);

[[nodiscard]] bool is_test_name(std::string_view name);
/// The whole file. Throws Error naming it.
[[nodiscard]] std::string read_text(const std::filesystem::path& path);

}  // namespace scenelore::rules
