#include "evaluation/report.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "scenes.hpp"

namespace scenelore::evaluation {
namespace {

using testing::HasSubstr;
using testing::Not;

Evaluation example() {
  const MadeScene s = scene({"table", "<wall>"}, {{80, 0, 0}, {20, 0, -1}, {60, 1, 1}});
  const LabelledScan scan{s.plane_of_point, {{"table", "table"}, {0.5, 0.4}}, {{"table", "<wall>"}, {0.9, 0.8}}};
  return evaluate(scan, s.truth, "unknown");
}

TEST(Report, AsJsonHasTheMeasuredFigures) {
  const Evaluation e = example();
  const auto json = nlohmann::json::parse(to_json(e, {.title = "a test"}));
  EXPECT_EQ(json["after"]["objects"]["table"]["real"], 1);
  EXPECT_DOUBLE_EQ(json["after"]["all_objects"]["f1"], 1);
  EXPECT_DOUBLE_EQ(json["before"]["all_objects"]["precision"], 0.5);
  EXPECT_DOUBLE_EQ(json["after"]["points"]["table"]["iou"], 0.8);
  EXPECT_DOUBLE_EQ(json["after"]["calibration"]["ece"], e.after.calibration.ece());
  EXPECT_EQ(json["segmentation"][0]["found"], 2);
  EXPECT_EQ(json["segmentation"][1]["threshold"], 0.8);
  EXPECT_FALSE(nlohmann::json::parse(to_json(e, {.title = "a test", .classes = {}, .segmentation = false})).contains("segmentation"));
}

TEST(Report, AsTextListsTheClassesAskedFor) {
  const std::string text = to_text(example(), {.title = "a test", .classes = {"table"}});
  EXPECT_THAT(text, HasSubstr("table              1 |    2    1    1    0  0.500 1.000 0.667 |    1    1    0    0  1.000 1.000 1.000\n"));
  EXPECT_THAT(text, HasSubstr("none\n"));  // no plane is wrong
  EXPECT_THAT(text, Not(HasSubstr("<wall>             1 |")));
}

TEST(Report, AsPageNeedsNothingElse) {
  const std::string page = to_html(example(), {.title = "a <test>"});
  for (const char* outside : {"src=", "href=", "url(", "@import", "http"}) EXPECT_THAT(page, Not(HasSubstr(outside)));
  EXPECT_THAT(page, HasSubstr("prefers-color-scheme: dark"));
  EXPECT_THAT(page, HasSubstr("a &lt;test&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<wall>")));
  for (const char* tag : {"svg", "table", "div", "text", "span", "main"}) {
    const auto count = [&](const std::string& what) {
      std::size_t n = 0;
      for (std::size_t at = page.find(what); at != std::string::npos; at = page.find(what, at + 1)) ++n;
      return n;
    };
    const std::string open = std::string("<") + tag;
    EXPECT_EQ(count(open + " ") + count(open + ">"), count(std::string("</") + tag + ">")) << tag;
  }
}

TEST(Report, OfNothingIsWritten) {
  const ReportOptions options{.title = "nothing"};
  EXPECT_FALSE(to_text({}, options).empty());
  EXPECT_THAT(to_html({}, options), Not(HasSubstr("nan")));
  EXPECT_FALSE(nlohmann::json::parse(to_json({}, options)).empty());
}

}  // namespace
}  // namespace scenelore::evaluation
