#pragma once

#include <string>
#include <vector>

namespace scenelore::kb {

/// "; did you mean 'flat_screen'?" for the nearest of `known` by edit distance, or nothing when none is near.
[[nodiscard]] std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

}  // namespace scenelore::kb
