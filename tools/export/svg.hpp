// The little that writing SVG needs: numbers, escaping, colours, polygons.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace scenelore::exports {

/// One decimal, never "-0.0": a tenth of a pixel.
[[nodiscard]] std::string number(double value);

/// For text and for attributes in double quotes; bytes that are no UTF-8 or no XML character become '?'.
[[nodiscard]] std::string escaped(std::string_view text);

/// Number of characters (code points) and their likely width in units of the font size, in a usual sans-serif font.
[[nodiscard]] double text_width_em(std::string_view text);

struct Color {
  double r = 0, g = 0, b = 0;  ///< 0..255
};

/// Of "#rrggbb"; a middle grey for anything else.
[[nodiscard]] Color parse_color(std::string_view text);
[[nodiscard]] Color mixed(const Color& a, const Color& b, double share_of_b);
[[nodiscard]] std::string hex(const Color& color);

/// The d attribute of closed rings.
[[nodiscard]] std::string path(const std::vector<std::vector<Eigen::Vector2d>>& rings);

}  // namespace scenelore::exports
