// Counts of segmentation by hand, on the five cases of Hoover et al. 1996.
#include "evaluation/segmentation_score.hpp"

#include <gtest/gtest.h>

#include "scenes.hpp"

namespace scenelore::evaluation {
namespace {

TEST(SegmentationScore, TellsTheFiveCasesApart) {
  const MadeScene s = scene({"wall", "wall", "wall", "wall", "wall"}, {{90, 0, 0}, {10, 0, -1},              // found, 90 %
                                                                       {50, 1, 1}, {45, 1, 2}, {5, 1, -1},    // in two pieces
                                                                       {100, 2, 3}, {90, 3, 3}, {10, 3, -1},  // two as one
                                                                       {60, 4, -1},                           // missed
                                                                       {80, kNothing, 4}});                   // nothing there
  const SegmentationScore t = score_segmentation(s.truth, s.plane_of_point, 0.8);
  EXPECT_EQ(t.planes, 5);
  EXPECT_EQ(t.faces, 5);
  EXPECT_EQ(t.correct, 1);
  EXPECT_EQ(t.over, 1);
  EXPECT_EQ(t.under, 2);
  EXPECT_EQ(t.missed, 1);
  EXPECT_EQ(t.noise, 1);
  EXPECT_EQ(t.right, 1);  // of the joined plane, intersection over union with the first face is 100 / 190
  EXPECT_EQ(t.found, 1);
  const SegmentationScore half = score_segmentation(s.truth, s.plane_of_point, 0.5);
  EXPECT_EQ(half.right, 3);
  EXPECT_EQ(half.found, 3);  // 90/100, 50/100, 100/190
  EXPECT_DOUBLE_EQ(half.precision(), 0.6);
  EXPECT_DOUBLE_EQ(half.recall(), 0.6);
}

TEST(SegmentationScore, LeavesOutPointsThatNobodyKnowsAndThingsThatAreNotFlat) {
  MadeScene s = scene({"wall", "unknown", "wall"}, {{80, 0, 0}, {70, kNotKnown, 0}, {100, 1, 1}, {40, kNotKnown, 2}, {30, 2, 2}});
  s.truth.objects[1].planar = false;
  const SegmentationScore t = score_segmentation(s.truth, s.plane_of_point, 0.8);
  EXPECT_EQ(t.planes, 2);  // plane 2 is mostly not known
  EXPECT_EQ(t.faces, 1);   // object 2 has too few points
  EXPECT_EQ(t.found, 1);
  EXPECT_EQ(t.correct, 1);
  EXPECT_EQ(t.noise, 1);  // a plane through a plant
}

TEST(SegmentationScore, GivesEachRegionOneVerdict) {
  // A face found well and a splinter of it: over-segmented by the letter, but the good plane agrees better alone.
  const MadeScene s = scene({"wall"}, {{95, 0, 0}, {5, 0, 1}});
  const SegmentationScore t = score_segmentation(s.truth, s.plane_of_point, 0.8);
  EXPECT_EQ(t.correct + t.over + t.under + t.missed, 1);
  EXPECT_EQ(t.over, 1);  // (1.00 + 1.00) / 2 against (1.00 + 0.95) / 2
  EXPECT_EQ(t.noise, 0);
}

TEST(SegmentationScore, IsZeroOfNothing) {
  const SegmentationScore t = score_segmentation({}, {}, 0.5);
  EXPECT_EQ(t.precision(), 0);
  EXPECT_EQ(t.recall(), 0);
}

}  // namespace
}  // namespace scenelore::evaluation
