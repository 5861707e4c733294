// Calibration by hand.
#include "evaluation/calibration.hpp"

#include <gtest/gtest.h>

namespace scenelore::evaluation {
namespace {

Calibration of(std::initializer_list<Claim> claims) {
  Calibration out;
  for (const Claim& claim : claims) out.add(claim);
  return out;
}

TEST(Calibration, MeasuresErrorAndBrierScore) {
  const Calibration c = of({{0.95, true}, {0.95, false}, {0.65, true}});
  EXPECT_DOUBLE_EQ(c.ece(), (std::abs(1 - 1.9) + std::abs(1 - 0.65)) / 3);
  EXPECT_DOUBLE_EQ(c.brier(), (0.05 * 0.05 + 0.95 * 0.95 + 0.35 * 0.35) / 3);
  EXPECT_DOUBLE_EQ(c.accuracy(), 2.0 / 3);
  EXPECT_DOUBLE_EQ(c.confidence(), 2.55 / 3);
}

TEST(Calibration, IsZeroWhereEveryBinKeepsItsWord) {
  const Calibration c = of({{0.75, true}, {0.75, true}, {0.75, true}, {0.75, false}, {1, true}});
  EXPECT_DOUBLE_EQ(c.ece(), 0);
  EXPECT_GT(c.brier(), 0);
}

TEST(Calibration, PutsABorderIntoTheLowerBinAndTheEndsIntoTheOuterOnes) {
  const Calibration c = of({{0, false}, {0.5, true}, {0.51, true}, {1, true}});
  EXPECT_EQ(c.bins[0].claims, 1);
  EXPECT_EQ(c.bins[4].claims, 1);
  EXPECT_EQ(c.bins[5].claims, 1);
  EXPECT_EQ(c.bins[9].claims, 1);
}

TEST(Calibration, AddsUpAsIfAllWereOne) {
  Calibration a = of({{0.9, true}, {0.2, false}});
  a += of({{0.9, false}});
  const Calibration all = of({{0.9, true}, {0.2, false}, {0.9, false}});
  EXPECT_DOUBLE_EQ(a.ece(), all.ece());
  EXPECT_DOUBLE_EQ(a.brier(), all.brier());
  EXPECT_EQ(Calibration().ece(), 0);
}

}  // namespace
}  // namespace scenelore::evaluation
