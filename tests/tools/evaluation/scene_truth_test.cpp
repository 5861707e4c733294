#include "evaluation/scene_truth.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "evaluation/error.hpp"
#include "temporary_folder.hpp"

namespace scenelore::evaluation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

kb::Knowledge knowledge() {
  kb::Knowledge out;
  out.classes = {{.id = 0, .name = "unknown", .fallback = true}, {.id = 4, .name = "table"}, {.id = 7, .name = "chair_seat"}};
  return out;
}

perception::PointTable table(const std::vector<std::int32_t>& label, const std::vector<std::int32_t>& instance) {
  perception::PointTable out;
  out.rows = label.size();
  out.set_column("label", label);
  if (!instance.empty()) out.set_column("instance", instance);
  return out;
}

template <typename Make>
std::string error_of(Make make) {
  try {
    (void)make();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SceneTruth, OfTheSimulatorTakesLabelsAsClassIds) {
  const SceneTruth truth = truth_of_table(table({4, 4, 0, 0, 4}, {1, 1, 0, 2, 3}), {.path = "room.ply"}, knowledge());
  EXPECT_THAT(truth.object_of_point, ElementsAre(0, 0, kNothing, 1, 2));
  EXPECT_EQ(truth.objects[1].object_class(), "unknown");
  EXPECT_EQ(truth.objects[2].instance, 3);
  EXPECT_EQ(truth.objects[0].points, 2u);
  EXPECT_TRUE(truth.faces);
}

TEST(SceneTruth, OfAnotherCollectionGoesThroughTheMap) {
  const ClassMap map{{"desk", {"table"}}, {"chair", {"chair_seat"}}, {"thing", {}}};
  const TruthFile file{.path = "real.ply", .map = &map, .names = {{5, "desk"}, {6, "chair"}, {9, "thing"}}};
  const SceneTruth truth = truth_of_table(table({5, 6, 0, 9, 6}, {1, 2, 4, 3, 0}), file, knowledge());
  EXPECT_THAT(truth.object_of_point, ElementsAre(0, 1, kNotKnown, kNotKnown, kNotKnown));
  EXPECT_FALSE(truth.faces);
}

TEST(SceneTruth, WithoutInstancesTakesALabelAsOneObject) {
  const SceneTruth truth = truth_of_table(table({4, 7, 4}, {}), {.path = "room.ply"}, knowledge());
  EXPECT_THAT(truth.object_of_point, ElementsAre(0, 1, 0));
}

TEST(SceneTruth, SaysWhatIsMissing) {
  const ClassMap map{{"desk", {"table"}}};
  const TruthFile file{.path = "real.ply", .map = &map, .names = {{5, "desk"}, {6, "chair"}}};
  EXPECT_THAT(error_of([&] { return truth_of_table(table({3}, {1}), {.path = "room.ply"}, knowledge()); }), HasSubstr("label 3 is no id"));
  EXPECT_THAT(error_of([&] { return truth_of_table(table({8}, {1}), file, knowledge()); }), HasSubstr("label 8 has no name"));
  EXPECT_THAT(error_of([&] { return truth_of_table(table({6}, {1}), file, knowledge()); }), HasSubstr("no line for label 'chair'"));
  EXPECT_THROW((void)truth_of_table(table({0, 0}, {0, 1}), file, knowledge()), NoTruth);
  perception::PointTable none;
  EXPECT_THROW((void)truth_of_table(none, file, knowledge()), NoTruth);
}

TEST(SceneTruth, SeesWhichObjectsAreFlatWhereNobodyTells) {
  perception::PointTable points;
  std::vector<float> x, y, z;
  std::vector<std::int32_t> label, instance;
  for (int i = 0; i < 400; ++i) {  // a slanted plane, then a cylinder of 20 cm
    const float u = static_cast<float>(i % 20) / 20, v = static_cast<float>(i / 20) / 20;
    const bool flat = i < 200;
    x.push_back(flat ? u : 0.2f * std::cos(6.28f * u)), y.push_back(flat ? v : 0.2f * std::sin(6.28f * u)), z.push_back(flat ? u + v : v);
    label.push_back(4), instance.push_back(flat ? 1 : 2);
  }
  points.rows = x.size();
  points.set_column("x", x), points.set_column("y", y), points.set_column("z", z);
  points.set_column("label", label), points.set_column("instance", instance);
  const SceneTruth truth = truth_of_table(points, {.path = "room.ply"}, knowledge());
  EXPECT_TRUE(truth.objects[0].planar);
  EXPECT_FALSE(truth.objects[1].planar);
}

TEST(SceneTruth, BelievesTheSimulatorsFileAboutFlatness) {
  test::TemporaryFolder folder;
  test::write_file(folder / "room.truth.json", R"({"objects": [{"instance": 1, "planar": false}, {"instance": 2, "planar": true}]})");
  const SceneTruth truth = truth_of_table(table({4, 4}, {1, 2}), {.path = folder / "room.ply"}, knowledge());
  EXPECT_FALSE(truth.objects[0].planar);
  EXPECT_TRUE(truth.objects[1].planar);
  test::write_file(folder / "room.truth.json", "{}");
  EXPECT_THROW((void)truth_of_table(table({4}, {1}), {.path = folder / "room.ply"}, knowledge()), Error);
}

TEST(SceneTruth, OfRowsKnowsOnlyTheirPlanes) {
  const SceneTruth truth = truth_of_rows({{12, "table"}, {15, "unknown"}}, {12, 12, 13, -1, 15});
  EXPECT_THAT(truth.object_of_point, ElementsAre(0, 0, kNotKnown, kNotKnown, 1));
  EXPECT_EQ(truth.objects[0].points, 2u);
}

}  // namespace
}  // namespace scenelore::evaluation
