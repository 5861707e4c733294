#include "formats.hpp"

#include <algorithm>
#include <charconv>

namespace scenelore::perception {

std::string text_hint(std::string_view body) {
  const std::string_view start = body.substr(0, 256);
  const bool printable = std::all_of(start.begin(), start.end(),
                                     [](char c) { return (c >= 0x20 && c < 0x7f) || (c >= '\t' && c <= '\r'); });
  return start.size() >= 32 && printable ? "; its points look like text, but the header says binary" : "";
}

std::string shortest(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::replace(text.begin(), text.end(), '\r', ' ');
  return text;
}

bool is_packed(const PointTable& table) {
  std::size_t offset = 0;
  for (const Column& column : table.columns) {
    if (column.offset != offset) return false;
    offset += size_of(column.type);
  }
  return offset == table.stride;
}

}  // namespace scenelore::perception
