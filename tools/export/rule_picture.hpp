// What a relation means, drawn from the planes of its own tests.
#pragma once

#include <string>

#include "scenelore/rules/testing.hpp"

namespace scenelore::exports {

/// An SVG with a panel a test case: the two planes of its first expectation from above and from the side, the sentence, and
/// the degree found. a is coloured, b grey. Empty for a file without such cases (features, broken files).
[[nodiscard]] std::string rule_picture(const rules::RuleTestFile& tests);

}  // namespace scenelore::exports
