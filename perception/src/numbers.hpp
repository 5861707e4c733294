// Numbers in text: strict (the whole token, nothing else), independent of the locale, exact.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "scenelore/perception/point_table.hpp"

namespace scenelore::perception {

/// The whole token as a number; also nan, inf, and a leading '+'. Nothing for anything else. What is too large for a
/// double is nothing, too; what is too small is 0.
[[nodiscard]] std::optional<double> parse_double(std::string_view token);

/// A whole number of at most 18 digits, not negative: a count.
[[nodiscard]] std::optional<std::size_t> parse_count(std::string_view token);

/// Writes the token as a scalar of this type. False when it is no number of the type: not a number at all, a fraction
/// for a whole type, or out of its range. "255.0" is a whole number.
[[nodiscard]] bool parse_scalar(std::string_view token, ScalarType type, std::byte* to);

}  // namespace scenelore::perception
