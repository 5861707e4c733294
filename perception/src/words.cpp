#include "words.hpp"

#include <charconv>

namespace scenelore::perception {

std::string count_of(long long count, const std::string& noun) { return std::to_string(count) + " " + noun + (count == 1 ? "" : "s"); }

std::string fixed(double value, int decimals) {
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals);
  return end.ec == std::errc() ? std::string(text, end.ptr) : std::to_string(value);
}

}  // namespace scenelore::perception
