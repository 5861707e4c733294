// "Did you mean": the known word nearest to a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scenelore::rules {

/// Number of letters to insert, remove, replace or swap with a neighbour (Damerau–Levenshtein, optimal string alignment).
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The word of `known` nearest to `word`, the first of equals; empty when none is near (a third of its letters, at least 2).
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& known);

/// "; did you mean 'x'?" or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace scenelore::rules
