#include "scenelore/kb/learn.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "rooms.hpp"
#include "scenelore/kb/error.hpp"

namespace scenelore::kb {
namespace {

using ::testing::HasSubstr;
using testing::error_of;
using testing::TemporaryFolder;

Knowledge knowledge() {
  Knowledge k;
  k.classes = {{0, "unknown", 0.5, "", "#000000", true}, {1, "table", 0.3, "", "#000000", false}, {2, "shelf", 0.2, "", "#000000", false}};
  k.features = {{"height", "m", Scale::linear, -0.5, 4, 1, ""}, {"length", "m", Scale::log, 0.03, 30, 1, ""},
                {"tilt_deg", "deg", Scale::linear, 0, 90, 1, ""}, {"x", "m", Scale::linear, -20, 20, 0, ""}};
  return k;
}

// Tables about 0.73 m high and 1.5 m long; shelves level or upright.
LabelledPlanes draws(std::size_t tables, std::size_t shelves, unsigned seed = 3) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  LabelledPlanes planes{{{"height", "length", "tilt_deg", "x"}, {}}, {}};
  for (std::size_t i = 0; i < tables; ++i) {
    planes.features.values.push_back({0.73 + 0.03 * normal(random), std::exp(0.4 + 0.2 * normal(random)), std::abs(normal(random)), 0});
    planes.classes.push_back("table");
  }
  for (std::size_t i = 0; i < shelves; ++i) {
    const double tilt = std::abs(normal(random));
    planes.features.values.push_back({1 + 0.5 * normal(random), 0.9, i % 2 == 0 ? tilt : 90 - tilt, 0});
    planes.classes.push_back("shelf");
  }
  return planes;
}

const LearnedClass& of(const LearnedRows& rows, const std::string& name) {
  for (const LearnedClass& c : rows.classes) {
    if (c.object_class == name) return c;
  }
  throw Error("no " + name);
}

double mass(const LearnedClass& learned, const std::string& feature, bool log) {
  double sum = 0;
  for (const ClassDensity& bin : learned.densities) {
    if (bin.feature == feature) sum += bin.density * (log ? std::log(bin.high / bin.low) : bin.high - bin.low);
  }
  return sum;
}

double density_at(const LearnedClass& learned, const std::string& feature, double value) {
  for (const ClassDensity& bin : learned.densities) {
    if (bin.feature == feature && bin.low <= value && value < bin.high) return bin.density;
  }
  return 0;
}

TEST(Learn, FindsTheGaussianThatTheDrawsCameFrom) {
  const LearnedRows rows = learn(knowledge(), draws(2000, 0));
  const LearnedClass& table = of(rows, "table");
  ASSERT_EQ(table.gaussians.size(), 3U);  // not x, whose weight is 0
  EXPECT_NEAR(table.gaussians[0].mean, 0.73, 0.003);
  EXPECT_NEAR(table.gaussians[0].sigma, 0.03, 0.003);
  EXPECT_NEAR(table.gaussians[1].mean, 0.4, 0.02);
  EXPECT_NEAR(table.gaussians[1].sigma, 0.2, 0.02);
}

TEST(Learn, FitsHistogramsThatIntegrateToOneAndFollowTheTrueDensity) {
  const LearnedRows rows = learn(knowledge(), draws(2000, 2000), {.most_kinds = 0});
  const LearnedClass &table = of(rows, "table"), &shelf = of(rows, "shelf");
  EXPECT_NEAR(mass(table, "height", false), 1, 1e-9);
  EXPECT_NEAR(mass(table, "length", true), 1, 1e-9);
  EXPECT_NEAR(mass(shelf, "tilt_deg", false), 1, 1e-9);
  const double peak = 1 / (0.03 * std::sqrt(2 * M_PI));
  EXPECT_NEAR(density_at(table, "height", 0.73), peak, 0.2 * peak);
  EXPECT_GT(density_at(shelf, "tilt_deg", 0.2), 0.2);
  EXPECT_GT(density_at(shelf, "tilt_deg", 89.8), 0.2);
  EXPECT_LT(density_at(shelf, "tilt_deg", 45), 0.01);  // where the Gaussian of both heaps would have its middle
}

TEST(Learn, IsLedAstrayNeitherByOutliersNorByTheOrderOfPlanes) {
  LabelledPlanes planes = draws(200, 0);
  planes.features.values[0][0] = 40;
  planes.features.values[1][0] = -40;
  const ClassFeature fit = of(learn(knowledge(), planes), "table").gaussians[0];
  EXPECT_NEAR(fit.mean, 0.73, 0.01);
  EXPECT_LT(fit.sigma, 0.06);
  std::reverse(planes.features.values.begin(), planes.features.values.end());
  EXPECT_NEAR(of(learn(knowledge(), planes), "table").gaussians[0].sigma, fit.sigma, 1e-12);
}

TEST(Learn, ShrinksSmallSamplesTowardsTheGaussian) {
  LearnOptions strong;
  strong.gaussian_strength = 1e6;
  const LabelledPlanes planes = draws(0, 20);
  const double loose = density_at(of(learn(knowledge(), planes), "shelf"), "tilt_deg", 45);
  const double shrunk = density_at(of(learn(knowledge(), planes, strong), "shelf"), "tilt_deg", 45);
  EXPECT_GT(shrunk, 1.5 * loose);
}

TEST(Learn, KeepsTheRowsOfClassesWithTooFewExamples) {
  const LearnedRows rows = learn(knowledge(), draws(100, 5));
  EXPECT_TRUE(of(rows, "shelf").gaussians.empty());
  EXPECT_TRUE(of(rows, "shelf").densities.empty());
  ASSERT_EQ(rows.notes.size(), 2U);
  EXPECT_THAT(rows.notes[1], HasSubstr("'shelf' keeps its rows: 5 examples"));
  EXPECT_TRUE(learn(knowledge(), {}).classes[1].gaussians.empty());
}

TEST(Learn, MovesPriorsFromThePresentOnesToTheSharesSeen) {
  const LearnedRows rows = learn(knowledge(), draws(60, 30));
  EXPECT_NEAR(of(rows, "table").prior, (60 + 30 * 0.3) / 120, 1e-12);
  EXPECT_NEAR(of(rows, "unknown").prior, 30 * 0.5 / 120, 1e-12);
}

TEST(Learn, RefusesAClassThatDoesNotExist) {
  LabelledPlanes planes = draws(1, 0);
  planes.classes[0] = "tabel";
  EXPECT_THAT(error_of([&] { (void)learn(knowledge(), planes); }), HasSubstr("'tabel' does not exist; did you mean 'table'?"));
}

TEST(Learn, WritesSqlThatTheKnowledgeBaseTakesAndThatClassifies) {
  const TemporaryFolder folder;
  KnowledgeBase base = KnowledgeBase::create(folder / "office.gpkg");
  base.apply_knowledge("UPDATE feature SET weight = 0.5", "weights");  // what is learned counts, not what the pack weighs
  const LearnedRows rows = learn(base.knowledge(), draws(100, 100));
  const std::string sql = to_sql(rows);
  EXPECT_EQ(sql, to_sql(learn(base.knowledge(), draws(100, 100))));
  base.apply_knowledge(sql, "learned");
  base.apply_knowledge(sql, "learned");  // again: replaces, never doubles
  const Knowledge k = base.knowledge();
  const auto p = preclassify(k, {{"height", "length", "tilt_deg"}, {{0.73, 1.5, 1}, {1.8, 0.9, 89.5}}});
  EXPECT_GT(p[0][static_cast<std::size_t>(k.class_index("table"))], 0.9);
  EXPECT_GT(p[1][static_cast<std::size_t>(k.class_index("shelf"))], 0.5);
}

}  // namespace
}  // namespace scenelore::kb
