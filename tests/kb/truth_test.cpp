// What a person said about planes, and what becomes of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rooms.hpp"
#include "scenelore/kb/error.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using testing::ask;
using testing::error_of;
using testing::TemporaryFolder;

class Truth : public ::testing::Test {
 protected:
  Truth() {
    scan_ = base_.store_scan(room_.scan, room_.planes, room_.plane_of_point);
    base_.store_inference(scan_, testing::inference(base_.planes(scan_)));
  }
  void shell(const std::string& sql) {
    Database database(folder_ / "kb.gpkg", OpenMode::read_write);
    database.execute("PRAGMA foreign_keys = OFF");
    database.execute(sql);
  }
  TemporaryFolder folder_;
  KnowledgeBase base_ = KnowledgeBase::create(folder_ / "kb.gpkg");
  testing::Room room_ = testing::room();
  ScanId scan_ = 0;
};

TEST_F(Truth, KeepsPlanesLabelsAndTruthWhenTheSameScanIsStoredAgain) {
  shell("INSERT INTO truth VALUES (3, 'table')");
  std::vector<std::string> warnings;
  room_.scan.parameters = "{\"again\": true}";
  EXPECT_EQ(base_.store_scan(room_.scan, room_.planes, room_.plane_of_point, &warnings), scan_);
  EXPECT_THAT(base_.truth(scan_), ElementsAre(Pair(3, "table")));
  EXPECT_EQ(base_.labels(scan_).size(), 4U);
  EXPECT_EQ(base_.planes(scan_)[0].id, 1);
  EXPECT_EQ(base_.find_scan("room")->parameters, room_.scan.parameters);
  EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(Truth, MovesToTheNewPlaneThatIsTheSameThing) {
  shell("INSERT INTO truth VALUES (3, 'table'), (4, 'flat_screen')");
  // Another segmentation: wall and floor change places, the table loses a third of its points, the screen is gone.
  std::swap(room_.planes[0], room_.planes[1]);
  room_.planes.pop_back();
  for (std::int32_t& number : room_.plane_of_point) number = number == 0 ? 1 : number == 1 ? 0 : number == 3 ? -1 : number;
  for (std::size_t i = 200; i < 233; ++i) room_.plane_of_point[i] = -1;
  std::vector<std::string> warnings;
  EXPECT_EQ(base_.store_scan(room_.scan, room_.planes, room_.plane_of_point, &warnings), scan_);
  EXPECT_THAT(base_.truth(scan_), ElementsAre(Pair(7, "table")));  // ids 1 to 4 are never used again
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], HasSubstr("plane 4 is 'flat_screen' is lost"));
  EXPECT_TRUE(base_.labels(scan_).empty());
  EXPECT_THAT(ask(base_, "SELECT count(*) FROM evidence"), ElementsAre("0"));
  EXPECT_TRUE(ask(base_, "PRAGMA foreign_key_check").empty());
}

TEST_F(Truth, IsWhatACorrectedLabelBecomes) {
  shell("UPDATE label SET class = 'keyboard', probability = probability WHERE plane_id = 4");
  shell("UPDATE labelled_plane SET class = 'door' WHERE plane = 2");
  shell("UPDATE label SET class = class");
  EXPECT_THAT(base_.truth(scan_), ElementsAre(Pair(2, "door"), Pair(4, "keyboard")));
  EXPECT_THAT(ask(base_, "SELECT plane FROM needs_review"), ElementsAre("1", "3"));
  base_.store_inference(scan_, testing::inference(base_.planes(scan_)));
  EXPECT_EQ(base_.truth(scan_).size(), 2U);
}

TEST_F(Truth, IsLeftAloneWhenAClassIsRenamed) {
  Database(folder_ / "kb.gpkg", OpenMode::read_write).execute("UPDATE object_class SET name = 'desk' WHERE name = 'table'");
  EXPECT_EQ(base_.labels(scan_)[2].object_class, "desk");
  EXPECT_THAT(base_.truth(scan_), IsEmpty());
}

TEST_F(Truth, ThatNamesNothingIsNamed) {
  shell("INSERT INTO truth VALUES (3, 'tabel')");
  EXPECT_THAT(error_of([&] { (void)base_.truth(scan_); }), HasSubstr("truth row 3: class 'tabel' does not exist; did you mean 'table'?"));
  shell("DELETE FROM truth; INSERT INTO truth VALUES (77, 'table')");
  EXPECT_THAT(error_of([&] { (void)base_.truth(scan_); }), HasSubstr("truth row 77: there is no plane"));
}

TEST_F(Truth, ScansThatMakeNoSenseAreRefusedAndNothingChanges) {
  std::vector<std::int32_t> wrong = room_.plane_of_point;
  wrong[0] = 4;
  EXPECT_THAT(error_of([&] { base_.store_scan(room_.scan, room_.planes, wrong); }), HasSubstr("plane number 4 of 4"));
  wrong.pop_back();
  EXPECT_THAT(error_of([&] { base_.store_scan(room_.scan, room_.planes, wrong); }), HasSubstr("has 450 points, but plane numbers for 449"));
  room_.scan.sha256 = "other";
  room_.planes[3].rmse = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(error_of([&] { base_.store_scan(room_.scan, room_.planes, room_.plane_of_point); }), HasSubstr("plane.rmse"));
  EXPECT_EQ(base_.labels(scan_).size(), 4U);
}

TEST_F(Truth, ScansWithoutPlanesOrPointsAreStored) {
  const ScanId empty = base_.store_scan({.name = "empty"}, {}, {});
  EXPECT_NE(empty, scan_);
  EXPECT_TRUE(base_.planes(empty).empty());
  EXPECT_TRUE(base_.plane_of_point(empty).empty());
  base_.store_inference(empty, {.run = {.outcome = "proved"}});
  const ScanId points = base_.store_scan({.name = "points", .point_count = 3}, {}, {-1, -1, -1});
  EXPECT_THAT(base_.plane_of_point(points), ElementsAre(-1, -1, -1));
  EXPECT_EQ(base_.scans().size(), 3U);
}

TEST_F(Truth, FeaturesAreStoredForTheWholeCatalogue) {
  base_.register_features({{"slenderness", "1", Scale::linear, 0, 20, 1, "length / width"}});
  FeatureTable table = built_in_features(*base_.find_scan("room"), base_.planes(scan_));
  table.names.push_back("slenderness");
  table.names.push_back("nonsense");
  for (auto& row : table.values) row.insert(row.end(), {row[1] / row[2], 1.0});
  table.values[0][table.names.size() - 2] = std::numeric_limits<double>::quiet_NaN();
  base_.store_features(1, {1, 2, 3, 4}, table);
  const FeatureTable back = base_.features({3, 1});
  EXPECT_EQ(back.names.size(), 22U);  // of the catalogue those that are known of these planes
  const auto at = [&](const std::string& name) { return static_cast<std::size_t>(std::find(back.names.begin(), back.names.end(), name) - back.names.begin()); };
  EXPECT_NEAR(back.values[0][at("slenderness")], 1.4 / 0.8, 1e-12);
  EXPECT_TRUE(std::isnan(back.values[1][at("slenderness")]));
  EXPECT_NEAR(back.values[0][at("x")], 1 - 2, 1e-12);
  EXPECT_NEAR(back.values[0][at("y")], 1 - 1.5, 1e-12);
  EXPECT_EQ(ask(base_, "SELECT weight FROM feature WHERE name = 'slenderness'"), std::vector<std::string>{"0.0"});
}

}  // namespace
}  // namespace scenelore::kb
