// Numbers in sentences.
#pragma once

#include <string>

namespace scenelore::perception {

/// "1 level plane", "3 level planes".
[[nodiscard]] std::string count_of(long long count, const std::string& noun);

/// Fixed-point with so many decimals, whatever the locale.
[[nodiscard]] std::string fixed(double value, int decimals);

}  // namespace scenelore::perception
