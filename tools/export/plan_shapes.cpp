#include "export/plan_shapes.hpp"

#include <algorithm>
#include <cmath>

namespace scenelore::exports {
namespace {

constexpr double kPanelWidth = 920, kPanelHeight = 700;  // pixels, at most
constexpr double kLargestScale = 240;                    // pixels a metre: a single desk must not fill the page

Kind kind_of(const FloorPlanItem& item, const Footprint& print) {
  if (item.class_name == "floor" && !print.strip) return Kind::floor;
  if (item.class_name == "wall" && print.strip) return Kind::wall;
  if (print.strip) return Kind::strip;
  return item.height > kOverhead ? Kind::overhead : Kind::flat;
}

}  // namespace

std::vector<Shape> shapes_of(const FloorPlan& plan) {
  std::vector<Shape> shapes;
  for (const FloorPlanItem& item : plan.items) {
    if (item.class_name == "ceiling") continue;
    if (auto print = footprint(item.hull, item.tilt_deg)) {
      const Kind kind = kind_of(item, *print);
      shapes.push_back({&item, std::move(*print), kind});
    }
  }
  const auto rank = [](const Shape& s) { return s.kind == Kind::floor ? 0 : s.kind == Kind::wall ? 1 : 2; };
  const auto height = [](const Shape& s) { return std::isfinite(s.item->height) ? s.item->height : 0.0; };
  std::stable_sort(shapes.begin(), shapes.end(), [&](const Shape& a, const Shape& b) {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    if (height(a) != height(b)) return height(a) < height(b);
    return a.item->id < b.item->id;
  });
  return shapes;
}

std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

Page page_for(const std::vector<Shape>& shapes) {
  Page page;
  if (shapes.empty()) return page;
  page.low = shapes[0].print.box.center, page.high = page.low;
  for (const Shape& shape : shapes) {
    for (int i = 0; i < 4; ++i) {
      page.low = page.low.cwiseMin(shape.print.box.corner(i));
      page.high = page.high.cwiseMax(shape.print.box.corner(i));
    }
  }
  const double border = std::max(kBorder, 0.04 * (page.high - page.low).maxCoeff());
  page.low.array() -= border, page.high.array() += border;
  const Eigen::Vector2d size = page.high - page.low;
  page.scale = std::min({kPanelWidth / size.x(), kPanelHeight / size.y(), kLargestScale});
  return page;
}

Footprint on_page(const Footprint& print, const Page& page) {
  Footprint out = print;
  for (Ring2& ring : out.rings) {
    for (Eigen::Vector2d& p : ring) p = page.to(p);
  }
  out.box.center = page.to(print.box.center);
  out.box.axis.y() = -print.box.axis.y();
  out.box.half *= page.scale;
  out.behind.y() = -print.behind.y();
  return out;
}

double round_step(double pixels, const Page& page) {
  double step = std::pow(10.0, std::floor(std::log10(pixels / page.scale)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    if (factor * step * page.scale >= pixels) return factor * step;
  }
  return 10 * step;
}

}  // namespace scenelore::exports
