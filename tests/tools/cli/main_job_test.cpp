// The main job as a user does it: run, ask, explain, correct, export.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "command_line.hpp"
#include "scenelore/perception/point_table.hpp"

namespace scenelore::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

using MainJob = CommandLine;

TEST_F(MainJob, LeavesALabelForEveryPlane) {
  make_labelled();
  EXPECT_EQ(ask("office.gpkg", "SELECT count(*) FROM plane WHERE id NOT IN (SELECT plane_id FROM label)"), "0\n");
  EXPECT_EQ(ask("office.gpkg", "SELECT outcome FROM run"), "proved\n");
  EXPECT_NE(ask("office.gpkg", "SELECT count(*) FROM label WHERE class = 'floor'"), "0\n");
  EXPECT_EQ(ask("office.gpkg", "SELECT count(*) FROM label WHERE plane_id NOT IN (SELECT plane_id FROM reason)"), "0\n");
}

TEST_F(MainJob, GivesTheSameLabelsTwiceAndWithAnyNumberOfThreads) {
  make_scan();
  const std::string everything = "SELECT plane_id, class, probability, margin, runner_up FROM label ORDER BY plane_id";
  ASSERT_EQ(scenelore({"run", "@office.ply", "--kb", "@a.gpkg"}).code, 0);
  ASSERT_EQ(scenelore({"run", "@office.ply", "--kb", "@b.gpkg", "--threads", "1"}).code, 0);
  const std::string a = ask("a.gpkg", everything);
  EXPECT_FALSE(a.empty());
  EXPECT_EQ(a, ask("b.gpkg", everything));
  ASSERT_EQ(scenelore({"run", "@office.ply", "--kb", "@a.gpkg"}).code, 0);
  EXPECT_EQ(a, ask("a.gpkg", everything));
}

TEST_F(MainJob, WritesTheLabelledCloudWithAllTheInputsProperties) {
  make_scan();
  ASSERT_EQ(scenelore({"run", "@office.ply", "--labelled", "@labelled.ply"}).code, 0);
  const auto in = perception::read_points(folder_ / "office.ply");
  const auto out = perception::read_points(folder_ / "labelled.ply");
  ASSERT_EQ(in.rows, out.rows);
  for (const perception::Column& column : in.columns) {
    const perception::Column* copy = out.find(column.name);
    ASSERT_TRUE(copy) << column.name;
    EXPECT_EQ(copy->type, column.type) << column.name;
    for (std::size_t i = 0; i < in.rows; ++i) ASSERT_EQ(in.value(column, i), out.value(*copy, i)) << column.name << " " << i;
  }
  const perception::Column* plane = out.find("scalar_plane");
  const perception::Column* label = out.find("scalar_label");
  const perception::Column* probability = out.find("scalar_probability");
  ASSERT_TRUE(plane && label && probability && out.find("red") && out.find("green") && out.find("blue"));
  std::size_t on_planes = 0;
  for (std::size_t i = 0; i < out.rows; ++i) {
    ASSERT_EQ(out.value(*plane, i) < 0, out.value(*label, i) < 0);
    ASSERT_EQ(out.value(*plane, i) < 0, out.value(*probability, i) == 0);
    on_planes += out.value(*plane, i) >= 0;
  }
  EXPECT_GT(on_planes, in.rows / 2);
}

TEST_F(MainJob, TellsWhereTheSensorStoodAndKeepsItInLabelledCopies) {
  ASSERT_EQ(scenelore({"simulate", "@office.ply", "--seed", "3", "--points", "40000", "--poses", "2"}).code, 0);
  ASSERT_EQ(scenelore({"run", "@office.ply", "--labelled", "@labelled.ply"}).code, 0);
  const json before = json::parse(scenelore({"info", "@office.ply", "--json"}).out);
  const json after = json::parse(scenelore({"info", "@labelled.ply", "--json"}).out);
  ASSERT_EQ(before.at("sensors").size(), 2U);
  EXPECT_EQ(before.at("sensors"), after.at("sensors"));
  EXPECT_EQ(before.at("sensors").at(0).at("points").get<int>() + before.at("sensors").at(1).at("points").get<int>(), before.at("points").get<int>());
  EXPECT_TRUE(before.at("viewpoint").is_null());
  EXPECT_THAT(scenelore({"info", "@office.ply"}).out, testing::ContainsRegex("sensor at .* points\nsensor at .* points\n"));
  make_scan();
  EXPECT_THAT(scenelore({"info", "@office.ply"}).out, HasSubstr("\nsensor at 0.000 0.000 1."));
}

TEST_F(MainJob, PrintsJsonWithAReasonForEachLabel) {
  make_scan();
  const Finished finished = scenelore({"run", "@office.ply", "--json"});
  ASSERT_EQ(finished.code, 0) << finished.err;
  const json report = json::parse(finished.out).at(0);
  EXPECT_EQ(report.at("outcome"), "proved");
  ASSERT_FALSE(report.at("planes").empty());
  for (const json& plane : report.at("planes")) {
    EXPECT_GT(plane.at("probability").get<double>(), 0);
    EXPECT_LE(plane.at("probability").get<double>(), 1);
    ASSERT_FALSE(plane.at("reasons").empty());
    EXPECT_FALSE(plane.at("reasons").at(0).at("sentence").get<std::string>().empty());
  }
}

TEST_F(MainJob, ObeysATruthRowAtTheNextLabel) {
  make_labelled();
  const std::string plane = ask("office.gpkg", "SELECT plane_id FROM label WHERE class = 'wall' ORDER BY plane_id LIMIT 1");
  ASSERT_FALSE(plane.empty());
  edit("office.gpkg", "INSERT INTO truth (plane_id, class) VALUES (" + plane + ", 'whiteboard')");
  const Finished finished = scenelore({"label", "@office.gpkg"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  EXPECT_EQ(ask("office.gpkg", "SELECT class FROM label WHERE plane_id = " + plane), "whiteboard\n");
  EXPECT_THAT(finished.out, HasSubstr("was wall, is whiteboard"));
}

TEST_F(MainJob, ExplainsALabelAndWhatAnotherOneWouldTake) {
  make_labelled();
  const std::string floor = ask("office.gpkg", "SELECT plane_id FROM label WHERE class = 'floor' ORDER BY plane_id LIMIT 1");
  const std::string plane = floor.substr(0, floor.find('\n'));
  const Finished why = scenelore({"why", "@office.gpkg", plane});
  ASSERT_EQ(why.code, 0) << why.err;
  EXPECT_THAT(why.out, HasSubstr("is a floor"));
  const Finished why_not = scenelore({"why", "@office.gpkg", plane, "keyboard", "--json"});
  ASSERT_EQ(why_not.code, 0) << why_not.err;
  EXPECT_GT(json::parse(why_not.out).at("extra_cost").get<double>(), 0);
  EXPECT_EQ(scenelore({"why", "@office.gpkg", "999999"}).code, 4);
  EXPECT_EQ(scenelore({"why", "@office.gpkg", plane, "keybord"}).code, 4);
}

TEST_F(MainJob, ExportsEveryFormat) {
  make_labelled();
  for (const char* name : {"@out.ply", "@out.pcd", "@out.csv", "@out.json", "@out.svg"}) {
    const Finished finished = scenelore({"export", "@office.gpkg", "office", name});
    EXPECT_EQ(finished.code, 0) << name << finished.err;
  }
  const auto ply = perception::read_points(folder_ / "out.ply"), pcd = perception::read_points(folder_ / "out.pcd");
  EXPECT_EQ(ply.rows, pcd.rows);
  EXPECT_TRUE(pcd.find("scalar_label"));
  const json planes = json::parse(read_file(folder_ / "out.json"));
  EXPECT_EQ(std::to_string(planes.at("planes").size()) + "\n", ask("office.gpkg", "SELECT count(*) FROM plane"));
  EXPECT_THAT(read_file(folder_ / "out.svg"), testing::AllOf(HasSubstr("<svg"), HasSubstr("</svg>")));
  EXPECT_EQ(scenelore({"export", "@office.gpkg", "office", "@out.docx"}).code, 2);
  EXPECT_EQ(scenelore({"export", "@office.gpkg", "kitchen", "@out.svg"}).code, 4);
  write_file(folder_ / "office.ply", "changed");
  EXPECT_EQ(scenelore({"export", "@office.gpkg", "office", "@again.ply"}).code, 3);
}

TEST_F(MainJob, AnswersTheQuestionWhichScreensStandOnWhichTables) {
  make_labelled();
  const Finished finished = scenelore({"query", "@office.gpkg",
                                       "SELECT a, b FROM labelled_relation WHERE relation = 'above' AND a_class = 'flat_screen' AND "
                                       "b_class = 'table'", "--json"});
  ASSERT_EQ(finished.code, 0) << finished.err;
  EXPECT_TRUE(json::parse(finished.out).is_array());
}

TEST_F(MainJob, SegmentsAndLabelsInTwoSteps) {
  make_scan();
  ASSERT_EQ(scenelore({"segment", "@office.ply", "--kb", "@two.gpkg"}).code, 0);
  EXPECT_EQ(ask("two.gpkg", "SELECT count(*) FROM label"), "0\n");
  ASSERT_EQ(scenelore({"label", "@two.gpkg", "--scan", "office"}).code, 0);
  ASSERT_EQ(scenelore({"run", "@office.ply", "--kb", "@one.gpkg"}).code, 0);
  const std::string labels = "SELECT plane_id, class, probability FROM label ORDER BY plane_id";
  EXPECT_EQ(ask("one.gpkg", labels), ask("two.gpkg", labels));
  EXPECT_EQ(scenelore({"label", "@two.gpkg", "--scan", "kitchen"}).code, 4);
}

TEST_F(MainJob, HasNothingToSayAboutTheKnowledgeThatItCameWith) {
  make_labelled();
  const Finished again = scenelore({"label", "@office.gpkg"});
  EXPECT_EQ(again.code, 0);
  EXPECT_EQ(again.err, "");
}

TEST_F(MainJob, TakesAClassByRowsAlone) {
  make_labelled();
  const std::string plane = ask("office.gpkg", "SELECT plane FROM labelled_plane WHERE class = 'unknown' ORDER BY area_m2 DESC LIMIT 1");
  ASSERT_FALSE(plane.empty());
  edit("office.gpkg",
       "INSERT INTO object_class (id, name, prior, description, color) VALUES (60, 'crate', 0.1, 'what this one looks like', '#aa00aa');"
       "INSERT INTO class_feature (class, feature, mean, sigma) "
       "SELECT 'crate', 'height', height, 0.02 FROM plane WHERE id = " + plane +
       " UNION ALL SELECT 'crate', 'z_max', z_max, 0.02 FROM plane WHERE id = " + plane +
       " UNION ALL SELECT 'crate', 'tilt_deg', tilt_deg, 1 FROM plane WHERE id = " + plane +
       " UNION ALL SELECT 'crate', 'width', ln(width), 0.05 FROM plane WHERE id = " + plane +
       " UNION ALL SELECT 'crate', 'area_m2', ln(area_m2), 0.05 FROM plane WHERE id = " + plane);
  const Finished finished = scenelore({"label", "@office.gpkg"});
  ASSERT_EQ(finished.code, 0) << finished.err;
  EXPECT_THAT(finished.out, HasSubstr("was unknown, is crate"));
  EXPECT_EQ(ask("office.gpkg", "SELECT class FROM label WHERE plane_id = " + plane), "crate\n");
}

TEST_F(MainJob, TellsUsageErrorsApart) {
  EXPECT_EQ(scenelore({}).code, 2);
  EXPECT_EQ(scenelore({"runn"}).code, 2);
  EXPECT_EQ(scenelore({"run"}).code, 2);
  EXPECT_EQ(scenelore({"run", "@office.ply", "--min-points", "1"}).code, 2);
  EXPECT_EQ(scenelore({"run", "@office.ply", "--up", "sideways"}).code, 2);
  EXPECT_EQ(scenelore({"simulate", "@x.ply", "--sensor", "sonar"}).code, 2);
}

TEST_F(MainJob, HasHelpWithAnExampleForEachCommand) {
  for (const std::string command : {"run", "segment", "label", "query", "why", "export", "info", "simulate"}) {
    const Finished finished = scenelore({command, "--help"});
    EXPECT_EQ(finished.code, 0);
    EXPECT_THAT(finished.out, HasSubstr("scenelore " + command)) << command;
  }
  EXPECT_THAT(scenelore({"kb", "init", "--help"}).out, HasSubstr("scenelore kb init"));
  EXPECT_THAT(scenelore({"rules", "check", "--help"}).out, HasSubstr("scenelore rules check"));
}

TEST_F(MainJob, IsDocumentedByItsOwnTables) {
  EXPECT_EQ(scenelore({"--documentation"}).out, read_file(std::filesystem::path(SCENELORE_SOURCE_DIR) / "docs/cli.md"));
}

}  // namespace
}  // namespace scenelore::test
