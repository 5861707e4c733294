#include "export/floor_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <regex>

#include "export/label_layout.hpp"
#include "export/svg.hpp"
#include "made_up_rooms.hpp"

namespace scenelore::exports {
namespace {

/// What is wrong with a document as XML, as far as our writer could get it wrong: tags that do not match, quotes,
/// entities, stray characters. Empty when nothing is.
std::string xml_fault(const std::string& text) {
  std::vector<std::string> open;
  std::size_t at = 0;
  const std::regex entity("&(amp|lt|gt|quot|#39);"), tag("<(/?)([a-zA-Z]+)((?: [a-zA-Z0-9:-]+=\"[^\"<]*\")*)(/?)>");
  while (at < text.size()) {
    if (text[at] == '<') {
      std::smatch match;
      const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(text.size(), text.find('>', at) + 1));
      const std::string piece(text.begin() + static_cast<std::ptrdiff_t>(at), end);
      if (!std::regex_match(piece, match, tag)) return "tag " + piece;
      if (match[1].length() > 0) {
        if (open.empty() || open.back() != match[2]) return "closing " + piece;
        open.pop_back();
      } else if (match[4].length() == 0) {
        open.push_back(match[2]);
      }
      at += piece.size();
    } else if (text[at] == '&') {
      if (!std::regex_search(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), entity,
                             std::regex_constants::match_continuous))
        return "entity";
      ++at;
    } else if (text[at] == '>') {
      return "stray >";
    } else {
      ++at;
    }
  }
  return open.empty() ? "" : "open " + open.back();
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST(FloorPlanSvg, IsWellFormedAndTheSameEveryTime) {
  for (const double turned : {0.0, 17.0, 90.0, 211.0}) {
    const std::string svg = floor_plan_svg(office(turned));
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_EQ(svg, floor_plan_svg(office(turned)));
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("-0 "), std::string::npos);
  }
}

TEST(FloorPlanSvg, WritesAllLengthsWithOneDecimalAtMost) {
  std::string svg = floor_plan_svg(office(17));
  svg = std::regex_replace(svg, std::regex("<title>[^<]*</title>|(opacity|width)=\"[0-9.]*\""), "");
  const std::regex too_precise("[0-9]\\.[0-9]{2}");
  std::smatch match;
  EXPECT_FALSE(std::regex_search(svg, match, too_precise))
      << match.prefix().str().substr(match.prefix().length() > 60 ? match.prefix().length() - 60 : 0);
}

TEST(FloorPlanSvg, EscapesNamesThatAreNoXml) {
  FloorPlan plan = office();
  plan.title = "<b>\"A\" & 'B'</b> \x01 \xff Büro";
  plan.items[0].class_name = "</svg><script>";
  plan.items[5].color = "\"/><script>";
  const std::string svg = floor_plan_svg(plan);
  EXPECT_EQ(xml_fault(svg), "");
  EXPECT_NE(svg.find("&lt;b&gt;&quot;A&quot; &amp; &#39;B&#39;&lt;/b&gt; ? ? Büro"), std::string::npos);
  EXPECT_EQ(svg.find("<script>"), std::string::npos);
}

TEST(FloorPlanSvg, LeavesCeilingsOutAndSaysSo) {
  const std::string svg = floor_plan_svg(office());
  EXPECT_NE(svg.find(">ceiling (not drawn)<"), std::string::npos);
  EXPECT_EQ(svg.find("ceiling 2"), std::string::npos);
}

TEST(FloorPlanSvg, DrawsFromTheBottomUp) {
  RoomMaker room;
  room.flat("upper", "#ff0000", 0, 0, 1, 1, 1.2)
      .flat("lower", "#00ff00", 0, 0, 1, 1, 0.4)
      .flat("floor", "#0000ff", 0, 0, 4, 4, 0);
  room.flat("middle", "#ffff00", 0, 0, 1, 1, 0.8).steep("wall", "#888888", 2, 2, -2, 2, 0, 2.5);
  const std::string svg = floor_plan_svg(room.plan);
  const auto drawn = [&](const std::string& name) { return svg.find("<title>" + name); };
  EXPECT_LT(drawn("floor 3"), drawn("wall 5"));
  EXPECT_LT(drawn("wall 5"), drawn("lower 2"));
  EXPECT_LT(drawn("lower 2"), drawn("middle 4"));
  EXPECT_LT(drawn("middle 4"), drawn("upper 1"));
}

TEST(FloorPlanSvg, NamesAndCountsTheObjects) {
  const std::string svg = floor_plan_svg(office());
  for (const char* name :
       {">table 11<", ">table 16<", ">table 21<", ">door 7<", ">flat screen 12<", ">keyboard 13<", ">wall 3<"}) {
    EXPECT_EQ(count(svg, name), 1U) << name;
  }
  EXPECT_EQ(count(svg, ">shelf 27–31<"), 1U) << "boards over one another share a name";
  EXPECT_NE(svg.find(">3</text>"), std::string::npos) << "three tables in the legend";
  EXPECT_NE(svg.find(">5</text>"), std::string::npos) << "five shelves in the legend";
}

TEST(FloorPlanSvg, PalesWhatIsUncertain) {
  const auto fill = [](double probability) {
    RoomMaker room;
    const std::string svg = floor_plan_svg(room.flat("table", "#800000", 0, 0, 1, 1, 0.7, probability).plan);
    std::smatch match;
    std::regex_search(svg, match, std::regex("fill=\"#([0-9a-f]{6})\" fill-opacity=\"0.92\""));
    return parse_color("#" + match[1].str()).g;
  };
  EXPECT_LT(fill(1.0), fill(0.6));
  EXPECT_LT(fill(0.6), fill(0.1));
}

TEST(FloorPlanSvg, SurvivesPlansThatHoldNothingToDraw) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  FloorPlan plan;
  EXPECT_NE(floor_plan_svg(plan).find("no planes to draw"), std::string::npos);
  plan.items = {{.hull = {}, .class_name = "a"},
                {.hull = {{{0, 0, 0}, {1, 0, 0}}, {}}, .class_name = "two corners"},
                {.hull = {{{0, 0, 0}, {1, 0, 0}, {nan, 1, 0}}, {}}, .class_name = "not finite"},
                {.hull = {{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}}, {}}, .class_name = "a point"}};
  EXPECT_EQ(xml_fault(floor_plan_svg(plan)), "");
  EXPECT_NE(floor_plan_svg(plan).find("no planes to draw"), std::string::npos);
  plan.items.push_back({.hull = {{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}, {}},
                        .class_name = "a pole",
                        .probability = nan,
                        .tilt_deg = 90,
                        .height = nan});
  EXPECT_EQ(xml_fault(floor_plan_svg(plan)), "");
}

TEST(FloorPlanSvg, FitsScansOfAnySize) {
  for (const double size : {0.3, 5.0, 400.0, 8000.0}) {
    RoomMaker room;
    const std::string svg = floor_plan_svg(room.flat("floor", "#c8b48c", size, -size, size, size / 2, 0).plan);
    std::smatch match;
    ASSERT_TRUE(std::regex_search(svg, match, std::regex("viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\"")));
    EXPECT_LT(std::stod(match[1]), 1400) << size;
    EXPECT_LT(std::stod(match[2]), 1000) << size;
    EXPECT_LT(svg.size(), 60000U) << size << ": the grid stays a grid";
  }
}

TEST(Footprint, MeasuresARectangleWithAHole) {
  perception::Polygon hull;
  hull.outer = {{0, 0, 1}, {4, 0, 1}, {4, 2, 1}, {0, 2, 1}};
  hull.holes = {{{1, 0.5, 1}, {1, 1.5, 1}, {2, 1.5, 1}, {2, 0.5, 1}}};
  const auto print = footprint(hull, 3);
  ASSERT_TRUE(print);
  EXPECT_FALSE(print->strip);
  EXPECT_DOUBLE_EQ(print->area, 7);
  EXPECT_NEAR(print->box.half.x(), 2, 1e-12);
  EXPECT_NEAR(print->box.half.y(), 1, 1e-12);
  EXPECT_TRUE(contains(print->rings, {0.5, 1}));
  EXPECT_FALSE(contains(print->rings, {1.5, 1}));
  EXPECT_FALSE(contains(print->rings, {5, 1}));
}

TEST(Footprint, MakesAStripOfAWallAndKnowsItsBack) {
  const FloorPlan plan = office(30);
  const FloorPlanItem& wall = plan.items[2];  // along the room's x axis at y = 0, seen from inside the room
  const auto print = footprint(wall.hull, wall.tilt_deg);
  ASSERT_TRUE(print);
  EXPECT_TRUE(print->strip);
  EXPECT_NEAR(print->box.half.x(), 3.6, 1e-9);
  EXPECT_NEAR(print->box.half.y(), 0, 1e-9);
  const Eigen::Vector2d outwards(std::sin(30 * 3.14159265358979323846 / 180),
                                 -std::cos(30 * 3.14159265358979323846 / 180));
  EXPECT_GT(print->behind.dot(outwards), 0.999);
}

TEST(Footprint, DropsCornersThatNobodyWouldSee) {
  perception::Polygon hull;
  for (int i = 0; i < 1000; ++i) hull.outer.emplace_back(std::cos(i * 0.0062831853), std::sin(i * 0.0062831853), 0);
  const auto print = footprint(hull, 0);
  ASSERT_TRUE(print);
  EXPECT_LT(print->rings[0].size(), 40U);
  EXPECT_NEAR(print->area, 3.14159, 0.0838)
      << "an inscribed polygon with arrows of 2 cm lacks two thirds of that along its circumference";
}

TEST(OrientedBox, OverlapsAgreeWithSampledPoints) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) / 9007199254740992.0;
  };
  const auto box = [&] {
    const double angle = uniform(0, 6.3);
    return OrientedBox{
        {uniform(-2, 2), uniform(-2, 2)}, {std::cos(angle), std::sin(angle)}, {uniform(0.2, 1.5), uniform(0.2, 1.0)}};
  };
  int together = 0, apart = 0;
  for (int round = 0; round < 400; ++round) {
    const OrientedBox a = box(), b = box();
    bool shared = false;  // some point of a, on a fine grid, lies well within b
    for (int i = -50; i <= 50 && !shared; ++i) {
      for (int j = -50; j <= 50 && !shared; ++j) {
        const Eigen::Vector2d p = a.center + a.axis * a.half.x() * i / 50.0 +
                                  Eigen::Vector2d(-a.axis.y(), a.axis.x()) * a.half.y() * j / 50.0;
        const Eigen::Vector2d d = p - b.center;
        shared = std::abs(d.dot(b.axis)) < b.half.x() - 1e-9 &&
                 std::abs(d.dot(Eigen::Vector2d(-b.axis.y(), b.axis.x()))) < b.half.y() - 1e-9;
      }
    }
    if (shared) {
      EXPECT_TRUE(overlap(a, b));
      EXPECT_TRUE(overlap(b, a));
      ++together;
    } else if (!overlap(a, b)) {
      ++apart;
    }
  }
  EXPECT_GT(together, 50);
  EXPECT_GT(apart, 50);
}

TEST(PlaceLabels, NeverPutsANameOverANameOrOffThePage) {
  std::mt19937_64 random(11);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) / 9007199254740992.0;
  };
  std::size_t with_room = 0;
  for (int round = 0; round < 20; ++round) {
    std::vector<LabelWish> wishes;
    for (int i = 0; i < 60; ++i) {
      LabelWish wish;
      wish.text = "object " + std::to_string(i);
      const double angle = uniform(0, 6.3);
      wish.shape.strip = i % 3 == 0;
      wish.shape.box = {
          {uniform(50, 750), uniform(50, 550)}, {std::cos(angle), std::sin(angle)}, {uniform(5, 90), uniform(3, 40)}};
      wish.shape.behind = {-wish.shape.box.axis.y(), wish.shape.box.axis.x()};
      wish.thickness = 6;
      if (!wish.shape.strip)
        wish.shape.rings = {
            {wish.shape.box.corner(0), wish.shape.box.corner(1), wish.shape.box.corner(2), wish.shape.box.corner(3)}};
      wishes.push_back(wish);
    }
    const auto placed = place_labels(wishes, 11, {}, {{0, 0}, {800, 600}});
    ASSERT_EQ(placed.size(), wishes.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
      if (!placed[i]) continue;
      ++with_room;
      for (int corner = 0; corner < 4; ++corner) {
        const Eigen::Vector2d p = placed[i]->box.corner(corner);
        EXPECT_TRUE(p.x() >= 0 && p.y() >= 0 && p.x() <= 800 && p.y() <= 600);
      }
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(placed[j] && overlap(placed[i]->box, placed[j]->box));
    }
  }
  EXPECT_GT(with_room, 20U * 50U);
}

TEST(PlaceLabels, PutsANameIntoWhatIsLargeEnough) {
  LabelWish wish;
  wish.text = "table 1";
  wish.shape.box = {{100, 100}, {1, 0}, {60, 30}};
  wish.shape.rings = {
      {wish.shape.box.corner(0), wish.shape.box.corner(1), wish.shape.box.corner(2), wish.shape.box.corner(3)}};
  const auto placed = place_labels({wish}, 11, {}, {{0, 0}, {200, 200}});
  ASSERT_TRUE(placed[0]);
  EXPECT_LT((placed[0]->box.center - Eigen::Vector2d(100, 100)).norm(), 1e-9);
  EXPECT_FALSE(placed[0]->beside);
}

}  // namespace
}  // namespace scenelore::exports
