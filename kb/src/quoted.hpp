#pragma once

#include <string>

namespace scenelore::kb {

/// A text as SQL writes it.
[[nodiscard]] inline std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

}  // namespace scenelore::kb
