// Scoring as a user does it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "scenelore/perception/point_table.hpp"

namespace scenelore::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

using Eval = CommandLine;

TEST_F(Eval, ScoresASimulatedRoomAgainstItsOwnTruth) {
  make_labelled();
  const Finished scored = scenelore({"eval", "@office.gpkg", "--truth", "@office.ply", "--json", "--html", "@page.html"});
  ASSERT_EQ(scored.code, 0) << scored.err;
  const json out = json::parse(scored.out);
  EXPECT_EQ(out["scans"], 1);
  EXPECT_GT(out["after"]["points"]["floor"]["iou"], 0.8);
  EXPECT_GT(out["after"]["point_accuracy"], 0.6);
  const json objects = json::parse(read_file(folder_ / "office.truth.json"))["objects"];
  int tables = 0;
  for (const json& object : objects) tables += object["class"] == "table" && object["points"] > 0;
  EXPECT_EQ(out["after"]["objects"]["table"]["real"], tables);
  EXPECT_THAT(read_file(folder_ / "page.html"), HasSubstr("<svg"));
  const Finished text = scenelore({"eval", "@office.gpkg", "--truth", "@office.ply", "--class", "table"});
  EXPECT_THAT(text.out, HasSubstr("all of these"));
}

TEST_F(Eval, DoesNotTellTheEngineTheRowsItIsScoredBy) {
  make_labelled();
  edit("office.gpkg", "INSERT INTO truth (plane_id, class) SELECT plane_id, 'keyboard' FROM label WHERE class = 'floor' LIMIT 1");
  ASSERT_EQ(scenelore({"label", "@office.gpkg"}).code, 0);  // now it is stored as a keyboard
  const Finished scored = scenelore({"eval", "@office.gpkg", "--truth", "rows", "--json"});
  ASSERT_EQ(scored.code, 0) << scored.err;
  const json out = json::parse(scored.out);
  EXPECT_EQ(out["known_planes"], 1);
  EXPECT_EQ(out["after"]["objects"]["keyboard"]["false_negative"], 1);
  EXPECT_EQ(out["after"]["objects"]["floor"]["false_positive"], 1);
}

TEST_F(Eval, ReadsAnotherCollectionThroughAClassMap) {
  make_labelled();
  write_file(folder_ / "truth/labels.txt", "0 none\n1 ground\n2 rest\n");
  write_file(folder_ / "map.txt", "ground = floor\nrest = -\n");
  perception::PointTable points = perception::read_points(folder_ / "office.ply");
  std::vector<std::int32_t> label;
  const perception::Column* column = points.find("label");
  for (std::size_t i = 0; i < points.rows; ++i) label.push_back(points.value(*column, i) == 1 ? 1 : 2);
  points.set_column("label", label);
  perception::write_points(folder_ / "truth/office.ply", points);
  const Finished scored = scenelore({"eval", "@office.gpkg", "--truth", "@truth", "--class-map", "@map.txt", "--json"});
  ASSERT_EQ(scored.code, 0) << scored.err;
  const json out = json::parse(scored.out);
  EXPECT_GT(out["after"]["points"]["floor"]["accuracy"], 0.8);
  EXPECT_FALSE(out["after"]["points"].contains("wall") && out["after"]["points"]["wall"]["points"] > 0);

  write_file(folder_ / "map.txt", "ground = flor\nrest = -\n");
  const Finished typo = scenelore({"eval", "@office.gpkg", "--truth", "@truth", "--class-map", "@map.txt"});
  EXPECT_EQ(typo.code, 3);
  EXPECT_THAT(typo.err, HasSubstr("did you mean 'floor'"));
  write_file(folder_ / "map.txt", "ground = floor\n");
  EXPECT_THAT(scenelore({"eval", "@office.gpkg", "--truth", "@truth", "--class-map", "@map.txt"}).err, HasSubstr("no line for label 'rest'"));
}

TEST_F(Eval, RefusesATruthThatDoesNotFit) {
  make_labelled();
  ASSERT_EQ(scenelore({"simulate", "@other.ply", "--seed", "4", "--points", "40000"}).code, 0);
  const Finished other = scenelore({"eval", "@office.gpkg", "--truth", "@other.ply"});
  EXPECT_EQ(other.code, 3);
  EXPECT_THAT(other.err, HasSubstr("point by point"));
  EXPECT_EQ(scenelore({"eval", "@office.gpkg", "--truth", "@nowhere.ply"}).code, 3);
  EXPECT_EQ(scenelore({"eval", "@office.gpkg"}).code, 2);
  const Finished rows = scenelore({"eval", "@office.gpkg", "--truth", "rows"});
  EXPECT_EQ(rows.code, 3);
  EXPECT_THAT(rows.err, HasSubstr("no truth"));
  EXPECT_EQ(scenelore({"eval", "@office.gpkg", "--truth", "@office.ply", "--class", "tabel"}).code, 4);
  edit("office.gpkg", "DELETE FROM label");
  const Finished unlabelled = scenelore({"eval", "@office.gpkg", "--truth", "@office.ply"});
  EXPECT_EQ(unlabelled.code, 4);
  EXPECT_THAT(unlabelled.err, HasSubstr("label it first"));
}

}  // namespace
}  // namespace scenelore::test
