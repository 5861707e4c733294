// New classes: by packs, and by INSERT statements alone.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "command_line.hpp"

namespace scenelore::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class Packs : public CommandLine {
 protected:
  /// A room of this kind as "@room.ply", labelled in "@room.gpkg" with the pack added, scored.
  json scored(const std::string& room, const std::string& seed) {
    EXPECT_EQ(scenelore({"simulate", "@room.ply", "--room", room, "--seed", seed, "--points", "150000"}).code, 0);
    EXPECT_EQ(scenelore({"kb", "init", "@room.gpkg"}).code, 0);
    EXPECT_EQ(scenelore({"kb", "add", room, "@room.gpkg"}).code, 0);
    const Finished run = scenelore({"run", "@room.ply"});
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.err, Not(HasSubstr("has no effect"))) << "a pack's own rows are nobody's mistake";
    const Finished out = scenelore({"eval", "@room.gpkg", "--truth", "@room.ply", "--json"});
    EXPECT_EQ(out.code, 0) << out.err;
    return json::parse(out.out)["after"]["objects"];
  }
};

// Rooms of seeds that no row of the packs was chosen on (those are 1 to 6).
TEST_F(Packs, OfHomesFindSofasWithTheirBacks) {
  const json objects = scored("home", "12");
  EXPECT_GE(objects["sofa"]["true_positive"], 1);
  EXPECT_EQ(objects["sofa"]["false_positive"], 0);
  EXPECT_GE(objects["sofa_back"]["true_positive"], 1);
  EXPECT_NE(ask("room.gpkg", "SELECT count(*) FROM labelled_object WHERE composite = 'sofa' AND part = 'back'"), "0\n");
}

TEST_F(Packs, OfKitchensFindTheCounter) {
  const json objects = scored("kitchen", "11");
  EXPECT_EQ(objects["counter"]["true_positive"], 1);
  EXPECT_EQ(objects["counter"]["false_positive"], 0);
}

TEST_F(Packs, AreAddedOnceAndWholeOrNotAtAll) {
  ASSERT_EQ(scenelore({"kb", "init", "@lab.gpkg"}).code, 0);
  ASSERT_EQ(scenelore({"kb", "add", "home", "@lab.gpkg"}).code, 0);
  const std::string rows = "SELECT (SELECT count(*) FROM object_class), (SELECT count(*) FROM class_feature), (SELECT count(*) FROM composite_part)";
  const std::string before = ask("lab.gpkg", rows);
  const Finished again = scenelore({"kb", "add", "home", "@lab.gpkg"});
  EXPECT_EQ(again.code, 4);
  EXPECT_THAT(again.err, HasSubstr("there already"));
  write_file(folder_ / "mine.sql", "INSERT INTO object_class (id, name) VALUES (60, 'lamp'); INSERT INTO class_feature (class, feature, mean, sigma) "
                                   "VALUES ('lamp', 'height', 2, -1);");
  EXPECT_EQ(scenelore({"kb", "add", "@mine.sql", "@lab.gpkg"}).code, 4);
  EXPECT_EQ(ask("lab.gpkg", rows), before);
  EXPECT_THAT(scenelore({"kb", "add", "garage", "@lab.gpkg"}).err, HasSubstr("home, kitchen"));
  write_file(folder_ / "mine.sql", "INSERT INTO object_class (id, name) VALUES (60, 'lamp')");
  EXPECT_EQ(scenelore({"kb", "add", "@mine.sql", "@lab.gpkg"}).code, 0);
}

class NewClass : public Packs, public testing::WithParamInterface<const char*> {};

TEST_P(NewClass, NeedsNothingButRows) {
  ASSERT_EQ(scenelore({"simulate", "@room.ply", "--room", "home", "--seed", GetParam(), "--points", "150000"}).code, 0);
  ASSERT_EQ(scenelore({"run", "@room.ply"}).code, 0);
  EXPECT_EQ(ask("room.gpkg", "SELECT count(*) FROM label WHERE class IN ('sofa', 'radiator')"), "0\n");
  edit("room.gpkg",
       "INSERT INTO object_class (id, name, prior) VALUES (40, 'sofa', 0.02), (43, 'radiator', 0.02);"
       "INSERT INTO class_feature (class, feature, mean, sigma) VALUES "
       "('sofa', 'tilt_deg', 1, 3), ('sofa', 'height', 0.43, 0.05), ('sofa', 'z_min', 0.42, 0.05), ('sofa', 'z_max', 0.44, 0.05), "
       "('sofa', 'spread_length', 0.41, 0.25), ('sofa', 'aspect', 0.83, 0.3), "
       "('radiator', 'tilt_deg', 89, 2), ('radiator', 'height', 0.42, 0.08), ('radiator', 'z_min', 0.14, 0.06), ('radiator', 'z_max', 0.7, 0.12), "
       "('radiator', 'spread_length', 0.1, 0.45), ('radiator', 'spread_width', -0.69, 0.25), ('radiator', 'aspect', 0.74, 0.4), "
       "('radiator', 'rectangularity', 0.82, 0.15);"
       "INSERT INTO class_constraint (name, class, quantifier, relation, other_class, weight, message) VALUES "
       "('radiator_at_wall', 'radiator', 'some', 'near', 'wall', 2.0, 'a radiator hangs near a wall')");
  ASSERT_EQ(scenelore({"label", "@room.gpkg"}).code, 0);
  // Held against the truth, in which labels 40 and 43 are the same classes.
  write_file(folder_ / "truth/labels.txt", "0 none\n1 floor\n2 ceiling\n3 wall\n4 table\n5 flat_screen\n6 keyboard\n7 chair_seat\n8 chair_back\n9 door\n"
                                           "10 window\n11 whiteboard\n12 shelf\n13 cabinet\n40 sofa\n41 sofa_back\n42 bed\n43 radiator\n");
  std::string map = "sofa_back = unknown\nbed = unknown\nnone = -\n";
  for (const char* same : {"floor", "ceiling", "wall", "table", "flat_screen", "keyboard", "chair_seat", "chair_back", "door", "window", "whiteboard", "shelf",
                           "cabinet", "sofa", "radiator"}) {
    map += std::string(same) + " = " + same + "\n";
  }
  write_file(folder_ / "map.txt", map);
  std::filesystem::rename(folder_ / "room.ply", folder_ / "truth/room.ply");
  const Finished out = scenelore({"eval", "@room.gpkg", "--truth", "@truth", "--class-map", "@map.txt", "--json"});
  ASSERT_EQ(out.code, 0) << out.err;
  const json objects = json::parse(out.out)["after"]["objects"];
  for (const char* name : {"sofa", "radiator"}) {
    EXPECT_GE(objects[name]["true_positive"], 1) << name;
    EXPECT_EQ(objects[name]["false_positive"], 0) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Rooms, NewClass, testing::Values("5", "6", "9"));

}  // namespace
}  // namespace scenelore::test
