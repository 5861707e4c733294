#include "export/rule_picture.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "export/svg.hpp"

namespace scenelore::exports {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kView = 150, kGap = 16, kPanelWidth = 2 * kView + 3 * kGap, kCaption = 54, kPanelHeight = kView + kCaption + kGap;
constexpr const char* kAccent = "#1f77b4";

/// The outlines of both planes as one view sees them, fitted into a square.
class View {
 public:
  View(const rules::Asked& asked, const Vector3d& right, const Vector3d& up) : right_(right), up_(up) {
    for (const perception::Plane* plane : {&asked.a, &asked.b}) {
      for (const Vector3d& corner : plane->hull.outer) box_.extend(flat(corner));
    }
    const Vector2d size = box_.sizes();
    scale_ = (kView - 16) / std::max({size.x(), size.y(), 0.1});
  }

  [[nodiscard]] std::string draw(const perception::Plane& plane, const Vector2d& corner, const std::string& style) const {
    std::vector<Vector2d> ring;
    for (const Vector3d& point : plane.hull.outer) {
      const Vector2d from_middle = scale_ * (flat(point) - box_.center());
      ring.emplace_back(corner.x() + kView / 2 + from_middle.x(), corner.y() + kView / 2 - from_middle.y());
    }
    return fmt::format("<path d=\"{}\"{}/>\n", path({ring}), style);
  }

 private:
  [[nodiscard]] Vector2d flat(const Vector3d& point) const { return {right_.dot(point), up_.dot(point)}; }

  Vector3d right_, up_;
  Eigen::AlignedBox2d box_;
  double scale_ = 1;
};

/// The side from which the two planes lie further apart, so that neither hides the other.
Vector3d side_axis(const rules::Asked& asked) {
  Eigen::AlignedBox3d box;
  for (const perception::Plane* plane : {&asked.a, &asked.b}) {
    for (const Vector3d& corner : plane->hull.outer) box.extend(corner);
  }
  const Vector3d apart = (asked.a.centroid - asked.b.centroid).cwiseAbs();
  if (apart.y() > apart.x() + 0.01) return Vector3d::UnitY();
  return box.sizes().x() >= box.sizes().y() || apart.x() > apart.y() + 0.01 ? Vector3d::UnitX() : Vector3d::UnitY();
}

/// A sentence on lines of at most so many characters.
std::vector<std::string> lines_of(const std::string& sentence, std::size_t most) {
  std::vector<std::string> lines{""};
  for (std::size_t at = 0; at < sentence.size();) {
    const std::size_t end = std::min(sentence.find(' ', at), sentence.size());
    const std::string word = sentence.substr(at, end - at);
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > most) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    at = end + 1;
  }
  return lines;
}

std::string panel(const rules::RuleTestCase& test, double x, double y) {
  const rules::Asked& asked = test.asked.front();
  std::string out;
  const std::string of_a = fmt::format(" fill=\"{0}\" fill-opacity=\"0.35\" stroke=\"{0}\" stroke-width=\"2.5\" stroke-linejoin=\"round\"", kAccent);
  const std::string of_b = " fill=\"#777\" fill-opacity=\"0.2\" stroke=\"#777\" stroke-width=\"2.5\" stroke-linejoin=\"round\"";
  const View views[] = {View(asked, Vector3d::UnitX(), Vector3d::UnitY()), View(asked, side_axis(asked), Vector3d::UnitZ())};
  for (int i = 0; i < 2; ++i) {
    const Vector2d corner(x + kGap + i * (kView + kGap), y);
    out += rect(corner.x(), corner.y(), kView, kView, " fill=\"#fafafa\" stroke=\"#ddd\"");
    out += views[i].draw(asked.b, corner, of_b);
    out += views[i].draw(asked.a, corner, of_a);
    out += text(corner.x() + 5, corner.y() + 13, 10, " fill=\"#999\"", i == 0 ? "from above" : "from the side");
  }
  double line_y = y + kView + 16;
  for (const std::string& line : lines_of(test.name, 54)) {
    out += text(x + kGap, line_y, 12, " fill=\"#26323d\"", line);
    line_y += 15;
  }
  return out + text(x + kGap, line_y, 12, fmt::format(" fill=\"{}\"", kAccent), fmt::format("degree {:.2g}", asked.degree));
}

}  // namespace

std::string rule_picture(const rules::RuleTestFile& tests) {
  std::vector<const rules::RuleTestCase*> cases;
  for (const rules::RuleTestCase& test : tests.cases) {
    if (test.failure.empty() && !test.asked.empty()) cases.push_back(&test);
  }
  if (cases.empty()) return {};
  const std::size_t rows = (cases.size() + 1) / 2;
  const double width = 2 * kPanelWidth, height = 34 + static_cast<double>(rows) * kPanelHeight;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\">\n",
      number(width), number(height));
  out += rect(0, 0, width, height, " fill=\"#ffffff\"");
  out += text(kGap, 22, 15, " fill=\"#26323d\" font-weight=\"bold\"", tests.rule);
  out += text(kGap + 200, 22, 12, fmt::format(" fill=\"{}\"", kAccent), "a");
  out += text(kGap + 220, 22, 12, " fill=\"#777\"", "b");
  for (std::size_t i = 0; i < cases.size(); ++i) {
    out += panel(*cases[i], static_cast<double>(i % 2) * kPanelWidth, 34 + static_cast<double>(i / 2) * kPanelHeight);
  }
  return out + "</svg>\n";
}

}  // namespace scenelore::exports
