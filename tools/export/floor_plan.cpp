#include "export/floor_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "export/footprint.hpp"
#include "export/label_layout.hpp"
#include "export/plan_legend.hpp"
#include "export/plan_shapes.hpp"
#include "export/svg.hpp"

namespace scenelore::exports {
namespace {

// The page, in pixels.
constexpr double kLegendWidth = 216, kLegendGap = 28, kFooterHeight = 62;
constexpr double kFontSize = 11.5;

// The drawing, in metres.
constexpr double kWallThickness = 0.14, kStripThickness = 0.07;
constexpr double kSmallArea = 0.35;    // m²; smaller things should not be written over
constexpr double kNamedUnknown = 0.5;  // m² (or metres of a strip) from which on an unknown thing is worth a name

std::string metres(double value) { return fmt::format("{:g}", std::abs(value) < 1e-9 ? 0.0 : value); }

class Drawing {
 public:
  explicit Drawing(const FloorPlan& plan)
      : plan_(plan), shapes_(shapes_of(plan)), legend_(plan, shapes_), page_(page_for(shapes_)) {}

  std::string draw() {
    draw_panel();
    draw_floors();
    draw_grid();
    draw_walls();
    for (const Shape& shape : shapes_) draw_thing(shape);
    body_ += "</g>\n";
    draw_frame();
    draw_names();
    draw_title();
    body_ += legend_.draw(legend_left(), page_.top, kLegendWidth);
    draw_footer();
    return header() + body_ + "</svg>\n";
  }

 private:
  // Page -----------------------------------------------------------------------------------------------------------

  [[nodiscard]] double page_width() const { return legend_left() + kLegendWidth + kPageMargin; }
  [[nodiscard]] double page_height() const {
    return std::max(page_.bottom() + kFooterHeight + 14, page_.top + legend_.height() + kPageMargin);
  }

  [[nodiscard]] std::string header() const {
    const std::string w = number(page_width()), h = number(page_height());
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + w + " " + h + "\" width=\"" + w +
           "\" height=\"" + h +
           "\" font-family=\"Inter, 'Segoe UI', 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif\">\n<title>" +
           escaped(plan_.title) +
           "</title>\n<defs>\n"
           "<pattern id=\"hatch\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\" "
           "patternTransform=\"rotate(45)\">"
           "<line x1=\"0\" y1=\"0\" x2=\"0\" y2=\"7\" stroke=\"#8a949e\" stroke-width=\"1.6\" "
           "stroke-opacity=\"0.55\"/></pattern>\n"
           "<clipPath id=\"panel\">" +
           rect(page_.left, page_.top, page_.width(), page_.height(), "") +
           "</clipPath>\n</defs>\n"
           "<rect width=\"100%\" height=\"100%\" fill=\"#fbfcfd\"/>\n";
  }

  void draw_panel() {
    body_ += rect(page_.left, page_.top, page_.width(), page_.height(), " fill=\"#eef1f4\"") +
             "\n<g clip-path=\"url(#panel)\">\n";
  }

  // Shapes ---------------------------------------------------------------------------------------------------------

  void draw_floors() {
    for (const Shape& shape : shapes_) {
      if (shape.kind != Kind::floor) continue;
      const Color tint = floor_color(parse_color(shape.item->color));
      body_ += "<path d=\"" + path(on_page(shape.print, page_).rings) + "\" fill=\"" + hex(tint) +
               "\" fill-rule=\"evenodd\" stroke=\"" + hex(mixed(tint, kBlack, 0.12)) + "\" stroke-linejoin=\"round\">" +
               tip(shape) + "</path>\n";
    }
  }

  void draw_grid() {
    const double step = grid_step();
    std::string thin;
    for (double x = std::ceil(page_.low.x() / step) * step; x <= page_.high.x(); x += step) {
      const double px = page_.to({x, 0}).x();
      thin += "M" + number(px) + " " + number(page_.top) + "V" + number(page_.bottom());
    }
    for (double y = std::ceil(page_.low.y() / step) * step; y <= page_.high.y(); y += step) {
      const double py = page_.to({0, y}).y();
      thin += "M" + number(page_.left) + " " + number(py) + "H" + number(page_.right());
    }
    body_ += "<path d=\"" + thin + "\" stroke=\"#26323d\" stroke-opacity=\"0.09\" fill=\"none\"/>\n";
  }

  [[nodiscard]] double grid_step() const { return std::max(round_step(26, page_), 1.0); }

  [[nodiscard]] double thickness(const Shape& shape) const {
    if (is_unknown(shape)) return 3;
    const double least = shape.kind == Kind::wall ? 7 : 4.5;
    const double drawn =
        shape.kind == Kind::wall ? kWallThickness : std::clamp(2 * shape.print.box.half.y(), kStripThickness, 0.12);
    return std::clamp(drawn * page_.scale, least, 24.0);
  }

  /// A wall lies behind the surface that was seen, any other strip about it.
  [[nodiscard]] Footprint strip_on_page(const Shape& shape) const {
    Footprint print = on_page(shape.print, page_);
    if (shape.kind == Kind::wall) print.box.center += print.behind * thickness(shape) / 2;
    return print;
  }

  /// By how much a wall is drawn longer at its end of that sign, in pixels: round the corner where another wall ends
  /// nearby.
  [[nodiscard]] double corner_length(const Shape& wall, double sign) const {
    constexpr double kNear = 0.35;  // metres
    const auto end = [](const Shape& shape, double side) -> Eigen::Vector2d {
      return shape.print.box.center + side * shape.print.box.half.x() * shape.print.box.axis;
    };
    const bool meets = std::any_of(shapes_.begin(), shapes_.end(), [&](const Shape& other) {
      if (other.kind != Kind::wall || &other == &wall || std::abs(other.print.box.axis.dot(wall.print.box.axis)) > 0.8)
        return false;
      return (end(other, 1) - end(wall, sign)).norm() < kNear || (end(other, -1) - end(wall, sign)).norm() < kNear;
    });
    return meets ? thickness(wall) : 0;
  }

  [[nodiscard]] std::string strip_line(const Shape& shape, double outline, const Color& color) const {
    const OrientedBox box = strip_on_page(shape).box;
    const bool wall = shape.kind == Kind::wall;
    const double before = outline / 2 + (wall ? corner_length(shape, -1) : 0),
                 after = outline / 2 + (wall ? corner_length(shape, 1) : 0);
    const std::string style =
        " stroke=\"" + hex(color) + "\" stroke-width=\"" + number(thickness(shape) + outline) + "\"";
    return line(box.center - box.axis * (box.half.x() + before), box.center + box.axis * (box.half.x() + after), style,
                tip(shape));
  }

  /// All outlines first, then all fillings, so that walls join at the corners.
  void draw_walls() {
    for (const bool outline : {true, false}) {
      for (const Shape& shape : shapes_) {
        if (shape.kind != Kind::wall) continue;
        const Color fill = wall_color(parse_color(shape.item->color));
        body_ += strip_line(shape, outline ? 1.6 : 0, outline ? mixed(fill, kBlack, 0.35) : faded(fill, shape));
      }
    }
  }

  void draw_thing(const Shape& shape) {
    if (shape.kind == Kind::flat) draw_flat(shape);
    if (shape.kind == Kind::overhead) draw_overhead(shape);
    if (shape.kind == Kind::strip) draw_strip(shape);
  }

  void draw_flat(const Shape& shape) {
    const Color color = parse_color(shape.item->color);
    const std::string outline = path(on_page(shape.print, page_).rings);
    const bool unknown = is_unknown(shape);
    body_ += "<path d=\"" + outline + "\" fill=\"" + hex(unknown ? kWhite : faded(mixed(color, kWhite, 0.12), shape)) +
             "\" fill-opacity=\"" + (unknown ? "0.6" : "0.92") + "\" fill-rule=\"evenodd\" stroke=\"" +
             hex(unknown ? color : mixed(color, kInk, 0.45)) + "\" stroke-width=\"" + (unknown ? "0.8" : "1.2") +
             "\" stroke-linejoin=\"round\">" + tip(shape) + "</path>\n";
    if (unknown)
      body_ += "<path d=\"" + outline + "\" fill=\"url(#hatch)\" fill-rule=\"evenodd\" pointer-events=\"none\"/>\n";
  }

  void draw_overhead(const Shape& shape) {
    const Color color = parse_color(shape.item->color);
    body_ += "<path d=\"" + path(on_page(shape.print, page_).rings) + "\" fill=\"" + hex(color) +
             "\" fill-opacity=\"0.05\" fill-rule=\"evenodd\" stroke=\"" + hex(mixed(color, kInk, 0.3)) +
             "\" stroke-width=\"1.2\" stroke-dasharray=\"6 4\" stroke-linejoin=\"round\">" + tip(shape) + "</path>\n";
  }

  void draw_strip(const Shape& shape) {
    const Color color = parse_color(shape.item->color);
    if (is_unknown(shape)) {
      body_ += strip_line(shape, 0, mixed(color, kWhite, 0.35));
      return;
    }
    body_ += strip_line(shape, 2, mixed(color, kInk, 0.6));
    body_ += strip_line(shape, 0, faded(color, shape));
  }

  [[nodiscard]] static bool is_unknown(const Shape& shape) { return shape.item->class_name == "unknown"; }

  /// Paler the less certain the label: at probability 0, two thirds of the way to white.
  [[nodiscard]] static Color faded(const Color& color, const Shape& shape) {
    const double p = std::isfinite(shape.item->probability) ? std::clamp(shape.item->probability, 0.0, 1.0) : 0.0;
    return mixed(color, kWhite, 0.66 * (1 - p));
  }

  /// What a browser shows under the pointer.
  [[nodiscard]] static std::string tip(const Shape& shape) {
    const FloorPlanItem& item = *shape.item;
    return "<title>" +
           escaped(fmt::format("{} {}: {:.0f} %, height {:.2f} m", spoken(item.class_name), item.id,
                               100 * item.probability, item.height)) +
           "</title>";
  }

  // Names ----------------------------------------------------------------------------------------------------------

  /// Small things first, since they have the fewest places; then the unknown, the walls, the floor.
  [[nodiscard]] std::vector<const Shape*> naming_order() const {
    std::vector<const Shape*> order;
    for (const Shape& shape : shapes_) {
      const double size = shape.print.strip ? 2 * shape.print.box.half.x() : shape.print.area;
      if (!is_unknown(shape) || size >= kNamedUnknown) order.push_back(&shape);
    }
    const auto rank = [](const Shape* s) {
      if (s->kind == Kind::floor) return 3;
      if (s->kind == Kind::wall) return 2;
      return is_unknown(*s) ? 1 : 0;
    };
    std::stable_sort(order.begin(), order.end(), [&](const Shape* a, const Shape* b) {
      return rank(a) != rank(b) ? rank(a) < rank(b) : a->print.area < b->print.area;
    });
    return order;
  }

  /// Shapes of one class over one another, like the boards of a shelf, share one name.
  [[nodiscard]] static bool stacked(const Shape& a, const Shape& b) {
    const OrientedBox &u = a.print.box, &v = b.print.box;
    return a.item->class_name == b.item->class_name && a.print.strip == b.print.strip && a.kind != Kind::wall &&
           (u.center - v.center).norm() < 0.15 && std::abs(u.half.x() - v.half.x()) < 0.15 &&
           std::abs(u.half.y() - v.half.y()) < 0.1;
  }

  [[nodiscard]] std::vector<std::vector<const Shape*>> named_groups() const {
    std::vector<std::vector<const Shape*>> groups;
    for (const Shape* shape : naming_order()) {
      const auto known =
          std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return stacked(*group[0], *shape); });
      if (known == groups.end())
        groups.push_back({shape});
      else
        known->push_back(shape);
    }
    return groups;
  }

  /// "table 3", "shelf 3–5", "shelf 3, 7".
  [[nodiscard]] static std::string name_of(const std::vector<const Shape*>& group) {
    std::vector<std::int64_t> ids;
    for (const Shape* shape : group) ids.push_back(shape->item->id);
    std::sort(ids.begin(), ids.end());
    std::string out = spoken(group[0]->item->class_name);
    for (std::size_t i = 0; i < ids.size();) {
      std::size_t last = i;
      while (last + 1 < ids.size() && ids[last + 1] == ids[last] + 1) ++last;
      out += (i == 0 ? " " : ", ") + std::to_string(ids[i]);
      if (last > i) out += (last > i + 1 ? "–" : ", ") + std::to_string(ids[last]);
      i = last + 1;
    }
    return out;
  }

  void draw_names() {
    std::vector<LabelWish> wishes;
    std::vector<Obstacle> obstacles;
    const auto groups = named_groups();
    for (const auto& group : groups) {
      const Shape& shape = *group[0];
      LabelWish wish{name_of(group), shape.print.strip ? strip_on_page(shape) : on_page(shape.print, page_), 0,
                     shape.kind == Kind::floor || is_unknown(shape)};
      if (shape.print.strip) wish.thickness = thickness(shape), wish.shape.box.half.y() = wish.thickness / 2;
      const bool small = shape.print.strip || shape.print.area < kSmallArea;
      if (shape.kind != Kind::floor)
        obstacles.push_back({wish.shape.box, wishes.size(), small && shape.kind != Kind::overhead});
      wishes.push_back(std::move(wish));
    }
    const LabelArea area{{page_.left + 2, page_.top + 2}, {page_.right() - 2, page_.bottom() - 2}};
    const auto placed = place_labels(wishes, kFontSize, obstacles, area);
    body_ += "<g font-size=\"" + number(kFontSize) + "\" text-anchor=\"middle\" fill=\"" + hex(kInk) +
             "\" stroke=\"#ffffff\" stroke-opacity=\"0.8\" stroke-width=\"2.6\" stroke-linejoin=\"round\" "
             "paint-order=\"stroke\">\n";
    for (std::size_t i = 0; i < wishes.size(); ++i) {
      if (placed[i]) draw_name(*groups[i][0], wishes[i], *placed[i]);
    }
    body_ += "</g>\n";
  }

  void draw_name(const Shape& shape, const LabelWish& wish, const PlacedLabel& label) {
    const Eigen::Vector2d center = label.box.center;
    if (label.beside) {
      const Eigen::Vector2d target = wish.shape.box.center;
      const Eigen::Vector2d near(
          std::clamp(target.x(), center.x() - label.box.half.x(), center.x() + label.box.half.x()),
          std::clamp(target.y(), center.y() - label.box.half.y(), center.y() + label.box.half.y()));
      body_ += line(near, target, " stroke=\"" + hex(kInk) + "\" stroke-width=\"0.7\" stroke-opacity=\"0.6\"");
    }
    const double angle = std::atan2(label.box.axis.y(), label.box.axis.x()) * 180 / 3.14159265358979323846;
    const bool quiet = shape.kind == Kind::floor || shape.kind == Kind::wall || is_unknown(shape);
    body_ += "<text x=\"" + number(center.x()) + "\" y=\"" + number(center.y() + kFontSize * 0.36) + "\"";
    if (std::abs(angle) > 0.05)
      body_ += " transform=\"rotate(" + number(angle) + " " + number(center.x()) + " " + number(center.y()) + ")\"";
    body_ += quiet ? " fill=\"#5d6973\">" : " font-weight=\"600\">";
    body_ += escaped(wish.text) + "</text>\n";
  }

  // Around the drawing ---------------------------------------------------------------------------------------------

  void draw_frame() {
    body_ += rect(page_.left, page_.top, page_.width(), page_.height(), " fill=\"none\" stroke=\"#c3cbd3\"");
    const double step = std::max(round_step(48, page_), grid_step());
    body_ += "<g fill=\"#7b8791\">\n";
    for (double x = std::ceil(page_.low.x() / step) * step; x <= page_.high.x(); x += step) {
      body_ += text(page_.to({x, 0}).x(), page_.bottom() + 15, 10, " text-anchor=\"middle\"", metres(x));
    }
    for (double y = std::ceil(page_.low.y() / step) * step; y <= page_.high.y(); y += step) {
      body_ += text(page_.left - 6, page_.to({0, y}).y() + 3.5, 10, " text-anchor=\"end\"", metres(y));
    }
    body_ += "</g>\n";
  }

  void draw_title() {
    const std::string ink = hex(kInk);
    body_ += text(page_.left, kPageMargin + 18, 26, " font-weight=\"700\" fill=\"" + ink + "\"",
                  plan_.title.empty() ? "Floor plan" : plan_.title);
    double floor = 0;
    for (const Shape& shape : shapes_) floor += shape.kind == Kind::floor ? shape.print.area : 0;
    const Eigen::Vector2d size = extent();
    std::string line = fmt::format("{} labelled plane{}", plan_.items.size(), plan_.items.size() == 1 ? "" : "s");
    if (!shapes_.empty()) line += fmt::format(" · {:.1f} m × {:.1f} m", size.x(), size.y());
    if (floor > 0) line += fmt::format(" · {:.1f} m² of floor seen", floor);
    body_ += text(page_.left, kPageMargin + 40, 13, " fill=\"#6b7780\"", line);
  }

  [[nodiscard]] Eigen::Vector2d extent() const {
    const double border = shapes_.empty() ? 0 : (page_.high - page_.low).maxCoeff();
    const double inner = border / 1.08 * 0.04 > kBorder ? border / 1.08 * 0.04 : kBorder;
    return (page_.high - page_.low).array() - 2 * inner;
  }

  [[nodiscard]] double legend_left() const { return page_.right() + kLegendGap; }

  void draw_footer() {
    const double y = page_.bottom() + 36, step = std::max(round_step(60, page_), grid_step());
    for (int i = 0; i < 2; ++i) {
      body_ += rect(
          page_.left + i * step * page_.scale, y, step * page_.scale, 6,
          std::string(" stroke=\"#26323d\" stroke-width=\"0.8\" fill=\"") + (i == 0 ? "#26323d" : "#ffffff") + "\"");
    }
    for (int i = 0; i < 3; ++i) {
      body_ += text(page_.left + i * step * page_.scale, y + 19, 10.5, " text-anchor=\"middle\" fill=\"#26323d\"",
                    metres(i * step) + (i == 2 ? " m" : ""));
    }
    std::string notes = "grid " + metres(grid_step()) + " m · the paler, the less certain";
    if (std::any_of(shapes_.begin(), shapes_.end(), [](const Shape& s) { return s.kind == Kind::overhead; })) {
      notes += " · dashed: above " + metres(kOverhead) + " m";
    }
    body_ += text(legend_left() + kLegendWidth, y + 19, 11, " text-anchor=\"end\" fill=\"#7b8791\"", notes);
    if (shapes_.empty()) {
      body_ += text(page_.left + page_.width() / 2, page_.top + page_.height() / 2, 15,
                    " text-anchor=\"middle\" fill=\"#6b7780\"", "no planes to draw");
    }
  }

  const FloorPlan& plan_;
  std::vector<Shape> shapes_;
  Legend legend_;
  Page page_;
  std::string body_;
};

}  // namespace

std::string floor_plan_svg(const FloorPlan& plan) { return Drawing(plan).draw(); }

}  // namespace scenelore::exports
