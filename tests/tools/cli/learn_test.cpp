// Learning as a user does it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "command_line.hpp"

namespace scenelore::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string kRows = "SELECT (SELECT group_concat(name || prior) FROM (SELECT name, prior FROM object_class ORDER BY name)), "
                          "(SELECT group_concat(name || weight) FROM (SELECT name, weight FROM feature ORDER BY name)), "
                          "(SELECT group_concat(class || feature || mean || sigma) FROM (SELECT * FROM class_feature ORDER BY class, feature)), "
                          "(SELECT group_concat(class || feature || low || density) FROM (SELECT * FROM class_density ORDER BY class, feature, low))";

using Learn = CommandLine;

TEST_F(Learn, WritesRowsAndTakesThemBack) {
  make_labelled();
  edit("office.gpkg", "INSERT INTO truth (plane_id, class) SELECT plane_id, class FROM label");
  const std::string before = ask("office.gpkg", kRows);
  const Finished dry = scenelore({"learn", "@office.gpkg", "--dry-run", "--force"});
  ASSERT_EQ(dry.code, 0) << dry.err;
  EXPECT_THAT(dry.out, HasSubstr("nothing was written"));
  EXPECT_EQ(ask("office.gpkg", kRows), before);

  const Finished learned = scenelore({"learn", "@office.gpkg", "--json", "--force"});
  ASSERT_EQ(learned.code, 0) << learned.err;
  const json out = json::parse(learned.out);
  EXPECT_EQ(out["written"], true);
  EXPECT_GE(out["planes"], 20);
  EXPECT_GT(out["after"]["planes"], 10);
  EXPECT_NE(ask("office.gpkg", kRows), before);
  ASSERT_EQ(scenelore({"label", "@office.gpkg"}).code, 0);
  EXPECT_THAT(ask("office.gpkg", "SELECT what FROM knowledge_undo"), HasSubstr("learned from"));

  const Finished undone = scenelore({"learn", "@office.gpkg", "--undo"});
  ASSERT_EQ(undone.code, 0) << undone.err;
  EXPECT_EQ(ask("office.gpkg", kRows), before);
  EXPECT_EQ(scenelore({"learn", "@office.gpkg", "--undo"}).code, 1);  // nothing left
}

TEST_F(Learn, WritesNothingThatTellsHeldBackPlanesWorseAndSaysSo) {
  make_labelled();
  edit("office.gpkg", "INSERT INTO truth (plane_id, class) SELECT plane_id, class FROM label");
  const std::string before = ask("office.gpkg", kRows);
  // A single scan without what was known before.
  const Finished learned = scenelore({"learn", "@office.gpkg", "--strength", "0", "--no-weights"});
  EXPECT_EQ(learned.code, 1);
  EXPECT_THAT(learned.err, HasSubstr("not written: held-back planes are told worse than before; --force"));
  EXPECT_THAT(learned.out, HasSubstr("nothing was written"));
  EXPECT_THAT(learned.out, testing::Not(HasSubstr("uses the new rows")));
  EXPECT_EQ(ask("office.gpkg", kRows), before);
}

TEST_F(Learn, UndoLeavesWhatWasAddedSinceAlone) {
  make_labelled();
  edit("office.gpkg", "INSERT INTO truth (plane_id, class) SELECT plane_id, class FROM label");
  ASSERT_EQ(scenelore({"learn", "@office.gpkg", "--force", "--no-weights"}).code, 0);
  edit("office.gpkg", "INSERT INTO object_class (id, name, prior) VALUES (30, 'lamp', 0.01);"
                      "INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('lamp', 'height', 2.2, 0.2);"
                      "DELETE FROM class_constraint WHERE class = 'whiteboard' OR other_class = 'whiteboard';"
                      "DELETE FROM class_feature WHERE class = 'whiteboard'; DELETE FROM class_density WHERE class = 'whiteboard';"
                      "DELETE FROM evidence WHERE class = 'whiteboard'; DELETE FROM label WHERE class = 'whiteboard';"
                      "DELETE FROM truth WHERE class = 'whiteboard'; DELETE FROM object_class WHERE name = 'whiteboard'");
  const Finished undone = scenelore({"learn", "@office.gpkg", "--undo"});
  ASSERT_EQ(undone.code, 0) << undone.err;
  EXPECT_EQ(ask("office.gpkg", "SELECT count(*) FROM class_feature WHERE class = 'lamp'"), "1\n");
  EXPECT_EQ(ask("office.gpkg", "SELECT count(*) FROM class_feature WHERE class = 'whiteboard'"), "0\n");
}

TEST_F(Learn, RefusesTooLittle) {
  make_labelled();
  const Finished none = scenelore({"learn", "@office.gpkg"});
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.err, HasSubstr("0 planes are labelled, 20 are needed"));
}

}  // namespace
}  // namespace scenelore::test
