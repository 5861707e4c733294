// Table 1, points and confusion of scenes small enough for counting by hand.
#include "evaluation/evaluation.hpp"

#include <gtest/gtest.h>

#include "evaluation/error.hpp"
#include "scenes.hpp"

namespace scenelore::evaluation {
namespace {

Answer answer(std::vector<std::string> classes) {
  Answer out{std::move(classes), {}};
  out.probabilities.assign(out.classes.size(), 0.75);
  return out;
}

TEST(PlaneTruth, NeedsMoreThanHalfOfThePoints) {
  const MadeScene s = scene({"table", "wall"}, {{50, 0, 0}, {50, 1, 0}, {51, 0, 1}, {49, 1, 1}, {51, 1, 2}, {49, kNotKnown, 2}, {50, 1, 3}, {50, kNotKnown, 3}});
  const auto planes = plane_truth(s.truth, s.plane_of_point, 4, "unknown");
  EXPECT_EQ(planes[0].object, -1);
  EXPECT_EQ(planes[0].object_class, "unknown");
  EXPECT_TRUE(planes[0].known);
  EXPECT_EQ(planes[1].object, 0);
  EXPECT_DOUBLE_EQ(planes[1].purity, 0.51);
  EXPECT_DOUBLE_EQ(planes[1].coverage, 51.0 / 101);
  EXPECT_EQ(planes[2].object_class, "wall");
  EXPECT_FALSE(planes[3].known);
  EXPECT_THROW((void)plane_truth(s.truth, std::vector<std::int32_t>(3, 0), 1, "unknown"), Error);
}

TEST(ClassScore, CountsAnObjectOnceAndASecondPlaneOnItAsFalse) {
  // Two tables; planes 0 and 1 on the first, 2 on a wall, nothing on the second table.
  const MadeScene s = scene({"table", "table", "wall"}, {{60, 0, 0}, {40, 0, 1}, {70, 1, -1}, {90, 2, 2}});
  const auto planes = plane_truth(s.truth, s.plane_of_point, 3, "unknown");
  ClassScore score = score_class(s.truth, planes, {"table", "table", "table"}, "table");
  EXPECT_EQ(score.real, 2);
  EXPECT_EQ(score.true_positive, 1);
  EXPECT_EQ(score.false_positive, 2);
  EXPECT_EQ(score.false_negative(), 1);
  EXPECT_DOUBLE_EQ(precision(score), 1.0 / 3);
  EXPECT_DOUBLE_EQ(recall(score), 0.5);
  EXPECT_DOUBLE_EQ(f1(score), 0.4);
  EXPECT_EQ(f1(ClassScore{}), 0);
}

TEST(ClassScore, TakesAnyPartOfAThingThatIsLabelledAsAWhole) {
  MadeScene s = scene({"chair_seat"}, {{60, 0, 0}, {40, 0, 1}, {50, kNotKnown, 2}});
  s.truth.objects[0].classes = {"chair_seat", "chair_back"};
  s.truth.faces = false;
  const auto planes = plane_truth(s.truth, s.plane_of_point, 3, "unknown");
  const std::vector<std::string> labels{"chair_back", "chair_seat", "chair_seat"};
  const ClassScore seat = score_class(s.truth, planes, labels, "chair_seat");
  EXPECT_EQ(seat.real, 1);
  EXPECT_EQ(seat.true_positive, 1);
  EXPECT_EQ(seat.false_positive, 0);  // the third plane is on something nobody knows
  const ClassScore back = score_class(s.truth, planes, labels, "chair_back");
  EXPECT_EQ(back.real + back.detected(), 0);
}

TEST(Evaluation, CountsPointsAndPlanes) {
  const MadeScene s = scene({"table", "wall", "unknown"}, {{80, 0, 0}, {20, 0, -1}, {60, 1, 1}, {40, 1, 0}, {30, 2, -1}, {10, kNothing, 1}});
  const LabelledScan scan{s.plane_of_point, answer({"wall", "wall"}), answer({"table", "wall"})};
  const Evaluation e = evaluate(scan, s.truth, "unknown");
  EXPECT_EQ(e.known_points, 230u);
  EXPECT_EQ(e.points, 240u);
  const auto points = point_scores(e.after.points);
  EXPECT_DOUBLE_EQ(points.at("table").iou(), 80.0 / (100 + 120 - 80));
  EXPECT_DOUBLE_EQ(points.at("table").accuracy(), 0.8);
  EXPECT_DOUBLE_EQ(points.at("table").precision(), 80.0 / 120);
  EXPECT_DOUBLE_EQ(points.at("wall").iou(), 0.6);
  EXPECT_DOUBLE_EQ(points.at("unknown").accuracy(), 1);  // points on no plane are nothing the knowledge knows
  EXPECT_DOUBLE_EQ(overall_accuracy(e.after.points), (80.0 + 60 + 30) / 230);
  EXPECT_EQ(e.after.planes.at({"table", "table"}), 1u);
  EXPECT_EQ(e.before.planes.at({"table", "wall"}), 1u);
  EXPECT_EQ(total(e.before.objects).true_positive, 1);
  EXPECT_EQ(total(e.after.objects).true_positive, 2);
  EXPECT_EQ(total(e.after.objects, {"table"}).real, 1);
  EXPECT_DOUBLE_EQ(e.after.calibration.ece(), 0.25);
}

TEST(Evaluation, AddsUpOverScenes) {
  const MadeScene s = scene({"table"}, {{80, 0, 0}});
  const LabelledScan right{s.plane_of_point, answer({"table"}), answer({"table"})}, wrong{s.plane_of_point, answer({"wall"}), answer({"wall"})};
  Evaluation e = evaluate(right, s.truth, "unknown");
  e += evaluate(wrong, s.truth, "unknown");
  EXPECT_EQ(e.scans, 2);
  EXPECT_EQ(e.after.objects.at("table").real, 2);
  EXPECT_EQ(e.after.objects.at("wall").false_positive, 1);
  EXPECT_DOUBLE_EQ(overall_accuracy(e.after.points), 0.5);
  EXPECT_EQ(e.segmentation[1].found, 2);
}

}  // namespace
}  // namespace scenelore::evaluation
