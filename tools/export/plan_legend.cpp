#include "export/plan_legend.hpp"

#include <map>

#include "export/svg.hpp"

namespace scenelore::exports {
namespace {

constexpr double kHead = 28, kLine = 25;  // pixels

int rank(const std::string& name) {
  if (name == "floor") return 0;
  if (name == "wall") return 1;
  if (name == "unknown") return 3;
  return name == "ceiling" ? 4 : 2;
}

/// A flat example is worth more than a strip: it shows the colour.
bool better_example(const Shape* known, const Shape& shape) {
  return known == nullptr || (known->print.strip && !shape.print.strip);
}

std::string swatch(double x, double y, const std::string& name, const Color& color, const Shape* example) {
  const Kind kind = example == nullptr ? Kind::overhead : example->kind;
  if (kind == Kind::wall || kind == Kind::strip) {
    const Color fill = kind == Kind::wall ? wall_color(color) : color;
    return rect(x, y + 5, 24, 6.5, " fill=\"" + hex(fill) + "\" stroke=\"" + hex(mixed(fill, kInk, 0.5)) + "\"");
  }
  const bool hollow = example == nullptr, unknown = name == "unknown";
  const Color fill = unknown ? kWhite : kind == Kind::floor ? floor_color(color) : mixed(color, kWhite, 0.12);
  const std::string edge = hex(mixed(color, kInk, kind == Kind::floor ? 0.1 : 0.45));
  std::string out = rect(x, y + 0.5, 24, 15,
                         " rx=\"2\" fill=\"" + (hollow ? "none" : hex(fill)) + "\" stroke=\"" + edge + "\"" +
                             (hollow ? " stroke-dasharray=\"3 2\"" : ""));
  if (unknown && !hollow) out += rect(x, y + 0.5, 24, 15, " rx=\"2\" fill=\"url(#hatch)\"");
  return out;
}

}  // namespace

Legend::Legend(const FloorPlan& plan, const std::vector<Shape>& shapes) {
  std::map<std::pair<int, std::string>, Entry> sorted;
  for (const FloorPlanItem& item : plan.items) {
    Entry& entry = sorted[{rank(item.class_name), item.class_name}];
    entry.name = item.class_name;
    entry.color = item.color;
    ++entry.count;
  }
  for (const Shape& shape : shapes) {
    Entry& entry = sorted[{rank(shape.item->class_name), shape.item->class_name}];
    if (better_example(entry.example, shape)) entry.example = &shape;
  }
  for (const auto& [key, entry] : sorted) entries_.push_back(entry);
}

double Legend::height() const { return kHead + kLine * static_cast<double>(entries_.size()); }

std::string Legend::draw(double left, double top, double width) const {
  std::string out = text(left, top + 14, 12, " font-weight=\"700\" letter-spacing=\"0.8\" fill=\"#6b7780\"", "CLASSES");
  double y = top + kHead;
  for (const Entry& entry : entries_) {
    const bool drawn = entry.example != nullptr;
    out += swatch(left, y, entry.name, parse_color(entry.color), entry.example);
    out += text(left + 34, y + 12.5, 13, drawn ? " fill=\"#26323d\"" : " fill=\"#98a2aa\"",
                spoken(entry.name) + (drawn ? "" : " (not drawn)"));
    out += text(left + width, y + 12.5, 13, " text-anchor=\"end\" fill=\"#6b7780\"", std::to_string(entry.count));
    y += kLine;
  }
  return out;
}

}  // namespace scenelore::exports
