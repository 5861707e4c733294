// Costs inside the search are whole numbers, so that sums are exact in any order and "proved" means proved.
#pragma once

#include <cstdint>

namespace scenelore::engine {

using Cost = std::int64_t;

/// "Forbidden". Finite costs of one problem add up to less than kTop / 16 (see scale.hpp), so whatever is shifted to
/// and fro, a number from kTop / 2 on is a forbidden one and a smaller number is not.
inline constexpr Cost kTop = Cost{1} << 60;

constexpr bool is_forbidden(Cost cost) { return cost >= kTop / 2; }

}  // namespace scenelore::engine
