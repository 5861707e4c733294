#include "export/svg.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

namespace scenelore::exports {
namespace {

/// Length of the UTF-8 character at the front, 0 when there is none or XML 1.0 has no such character.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return lead >= 0x20 || lead == '\t' || lead == '\n' || lead == '\r' ? 1 : 0;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
  unsigned code = lead & (0x7fU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return 0;
    code = code << 6U | (byte(i) & 0x3fU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool forbidden = (code >= 0xd800 && code <= 0xdfff) || code == 0xfffe || code == 0xffff || code > 0x10ffff;
  return overlong || forbidden ? 0 : length;
}

}  // namespace

std::string number(double value) {
  std::string text = fmt::format("{:.1f}", value);
  if (text == "-0.0") return "0";
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

std::string escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    switch (length == 0 ? '\0' : text[0]) {
      case '\0':
        out += '?';
        break;
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

double text_width_em(std::string_view text) {
  double width = 0;
  for (const char c : text) {
    if ((static_cast<unsigned char>(c) & 0xc0U) == 0x80U) continue;  // a later byte of one character
    if (std::string_view("ijlI.,:;|!'()[] tfr").find(c) != std::string_view::npos)
      width += 0.36;
    else if (std::string_view("mwMW@%").find(c) != std::string_view::npos)
      width += 0.92;
    else
      width += std::isupper(static_cast<unsigned char>(c)) != 0 ? 0.72 : 0.61;
  }
  return width;
}

Color parse_color(std::string_view text) {
  const auto digit = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
  };
  double parts[3] = {};
  bool valid = text.size() == 7 && text[0] == '#';
  for (std::size_t i = 0; valid && i < 3; ++i) {
    const int high = digit(text[1 + 2 * i]), low = digit(text[2 + 2 * i]);
    valid = high >= 0 && low >= 0;
    parts[i] = 16 * high + low;
  }
  return valid ? Color{parts[0], parts[1], parts[2]} : Color{158, 158, 158};
}

Color mixed(const Color& a, const Color& b, double share_of_b) {
  const auto mix = [&](double u, double v) { return u + (v - u) * share_of_b; };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

std::string hex(const Color& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", std::lround(color.r), std::lround(color.g), std::lround(color.b));
}

std::string rect(double x, double y, double width, double height, const std::string& style) {
  return "<rect x=\"" + number(x) + "\" y=\"" + number(y) + "\" width=\"" + number(width) + "\" height=\"" +
         number(height) + "\"" + style + "/>\n";
}

std::string line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const std::string& style,
                 const std::string& content) {
  return "<line x1=\"" + number(a.x()) + "\" y1=\"" + number(a.y()) + "\" x2=\"" + number(b.x()) + "\" y2=\"" +
         number(b.y()) + "\"" + style + ">" + content + "</line>\n";
}

std::string text(double x, double y, double size, const std::string& style, const std::string& content) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" font-size=\"" + number(size) + "\"" + style + ">" +
         escaped(content) + "</text>\n";
}

std::string path(const std::vector<std::vector<Eigen::Vector2d>>& rings) {
  std::string out;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      out += (i == 0 ? "M" : "L") + number(ring[i].x()) + " " + number(ring[i].y());
    out += "Z";
  }
  return out;
}

}  // namespace scenelore::exports
