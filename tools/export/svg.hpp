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

inline const Color kInk{38, 50, 61}, kWhite{255, 255, 255}, kBlack{0, 0, 0};

/// The shades in which a class colour stands for a floor (a background) and for a wall (cut masonry).
[[nodiscard]] inline Color floor_color(const Color& color) { return mixed(color, kWhite, 0.82); }
[[nodiscard]] inline Color wall_color(const Color& color) { return mixed(color, kInk, 0.45); }

// Elements, each on a line; `style` are further attributes, with a blank before each.
[[nodiscard]] std::string rect(double x, double y, double width, double height, const std::string& style);
[[nodiscard]] std::string line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const std::string& style,
                               const std::string& content = {});
[[nodiscard]] std::string text(double x, double y, double size, const std::string& style, const std::string& content);

/// The d attribute of closed rings.
[[nodiscard]] std::string path(const std::vector<std::vector<Eigen::Vector2d>>& rings);

}  // namespace scenelore::exports
