// Kinds of classes: evidence of mixtures against closed forms, and kinds learned from classes that are several things.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "rooms.hpp"
#include "scenelore/kb/error.hpp"
#include "scenelore/kb/learn.hpp"
#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::kb {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;

double normal(double x, double mean, double sigma) {
  return std::exp(-0.5 * std::pow((x - mean) / sigma, 2)) / (sigma * std::sqrt(2 * std::numbers::pi));
}

// Class a has two kinds, which differ in height and size together; the second has no row for size.
Knowledge two_kinds() {
  Knowledge k;
  k.classes = {{0, "unknown", 1, "", "#000000", true}, {1, "a", 1, "", "#000000", false}};
  k.features = {{"height", "m", Scale::linear, 0, 4, 0.8, ""}, {"size", "m", Scale::log, 0.1, 10, 0.5, ""}};
  k.class_features = {{"a", "height", 1, 0.6}, {"a", "size", 0, 0.4}};
  k.kinds = {{"a", 1, 0.5, "low", {{"height", 0.4, 0.1}, {"size", 0.7, 0.2}}}, {"a", 2, 0.3, "high", {{"height", 1.6, 0.2}}}};
  return k;
}

double expected(double height, double size) {
  const double ln = std::log(size), own_size = std::pow(normal(ln, 0, 0.4), 0.5);
  return 0.2 * std::pow(normal(height, 1, 0.6), 0.8) * own_size +
         0.5 * std::pow(normal(height, 0.4, 0.1), 0.8) * std::pow(normal(ln, 0.7, 0.2), 0.5) +
         0.3 * std::pow(normal(height, 1.6, 0.2), 0.8) * own_size;
}

TEST(Kinds, AreMixedInTheirSharesAndTheRestIsTheClassItself) {
  const Knowledge k = two_kinds();
  for (const auto& [height, size] : {std::pair(0.4, 2.0), std::pair(1.5, 1.0), std::pair(1.0, 0.5), std::pair(3.0, 5.0)}) {
    const double a = expected(height, size), unknown = std::pow(0.25, 0.8) * std::pow(1 / std::log(100.0), 0.5);
    EXPECT_NEAR(preclassify(k, {{"height", "size"}, {{height, size}}})[0][1], a / (a + unknown), 1e-9) << height << " " << size;
  }
}

TEST(Kinds, LeaveOutWhatIsNotKnownOfAPlane) {
  const Knowledge k = two_kinds();
  const double a = 0.2 * std::pow(normal(1.5, 1, 0.6), 0.8) + 0.5 * std::pow(normal(1.5, 0.4, 0.1), 0.8) + 0.3 * std::pow(normal(1.5, 1.6, 0.2), 0.8);
  const auto p = preclassify(k, {{"height", "size"}, {{1.5, std::numeric_limits<double>::quiet_NaN()}}})[0];
  EXPECT_NEAR(p[1], a / (a + std::pow(0.25, 0.8)), 1e-9);
  EXPECT_NEAR(preclassify(k, {{}, {{}}})[0][1], 0.5, 1e-9);  // nothing known: the prior
}

TEST(Kinds, MixOddValuesInAsClassesDo) {
  Knowledge k = two_kinds();
  k.kinds = {{"a", 1, 1, "", {{"height", 0.4, 0.1}}}};
  Knowledge plain = two_kinds();
  plain.kinds.clear();
  plain.class_features[0] = {"a", "height", 0.4, 0.1};
  for (Knowledge* both : {&k, &plain}) both->settings["outlier_share"] = "0.1";
  for (const double height : {0.4, 0.55, 0.9, 3.0}) {
    for (const double error : {0.0, 0.05, 0.3}) {
      const FeatureTable table{{"height"}, {{height}}, {{"height", {error}}}};
      EXPECT_NEAR(preclassify(k, table)[0][1], preclassify(plain, table)[0][1], 1e-9) << height << " " << error;
    }
  }
}

TEST(Kinds, HaveContributionsThatAddUpToTheEvidence) {
  const Knowledge k = two_kinds();
  const FeatureTable table{{"size", "height"}, {{1.9, 0.5}}};
  double sum = 0;
  const std::vector<Contribution> terms = contributions(k, table, 0, 1);
  for (const Contribution& term : terms) sum += term.weight * term.log_likelihood;
  EXPECT_NEAR(sum, std::log(expected(0.5, 1.9)), 1e-9);
  EXPECT_EQ(terms[0].mean, 0.4);  // of the kind that it looks like
  EXPECT_EQ(terms.back().feature, kKindTerm);
  EXPECT_EQ(terms.back().value, 1);
  EXPECT_EQ(contributions(k, table, 0, 0).back().log_likelihood, 0);  // a class without kinds: so that terms can be compared one by one
}

TEST(Kinds, HaveContributionsThatAddUpWithOddValuesErrorsAndFeaturesOfOneWeight) {
  Knowledge k = two_kinds();
  k.settings["outlier_share"] = "0.1";
  k.features.push_back({"width", "m", Scale::linear, 0, 4, 0.8, ""});
  k.kinds[0].features.push_back({"width", 1, 0.2});
  k.class_features.push_back({"a", "width", 1, 0.5});
  const FeatureTable table{{"size", "height", "width"}, {{1.9, 0.5, 1.3}}, {{"height", {0.1}}}};
  double logs[2] = {0, 0};
  for (const std::size_t c : {0U, 1U}) {
    for (const Contribution& term : contributions(k, table, 0, c)) logs[c] += term.weight * term.log_likelihood;
  }
  EXPECT_NEAR(preclassify(k, table)[0][1], 1 / (1 + std::exp(logs[0] - logs[1])), 1e-12);
}

TEST(Kinds, GiveTheSameBytesWithAnyNumberOfThreadsAndNeighbours) {
  Knowledge k = two_kinds();
  k.settings["outlier_share"] = "0.05";
  FeatureTable all{{"height", "size"}, {}, {{"height", {}}}};
  for (int i = 0; i < 100; ++i) {
    all.values.push_back({0.04 * i, i % 7 == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.1 + 0.05 * i});
    all.errors["height"].push_back(0.03 * (i % 5));
  }
  const auto one = preclassify(k, all, 1);
  for (const int threads : {2, 3, 64}) EXPECT_EQ(preclassify(k, all, threads), one) << threads;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const FeatureTable alone{all.names, {all.values[i]}, {{"height", {all.errors["height"][i]}}}};
    EXPECT_EQ(preclassify(k, alone)[0], one[i]) << i;
  }
}

TEST(Kinds, ThatAreTooFarAwayToMatterLeaveFiniteEvidence) {
  Knowledge k = two_kinds();
  k.settings["outlier_share"] = "0.1";
  k.classes.push_back({2, "b", 1, "", "#000000", false});
  k.class_features.push_back({"b", "height", 3.9, 0.6});
  k.kinds[0].features[0].sigma = k.kinds[1].features[0].sigma = 1e-3;  // thousands of deviations
  for (const double error : {0.0, 1e-4}) {
    const FeatureTable table{{"height"}, {{3.9}}, {{"height", {error}}}};
    const double odd = 0.05 * 0.25, sigma = std::hypot(0.6, error), tail = std::hypot(2.4, error);
    const double own = 0.9 * normal(3.9, 1, sigma) + odd + 0.05 * normal(3.9, 1, tail), b = 0.9 * normal(3.9, 3.9, sigma) + odd + 0.05 * normal(3.9, 3.9, tail);
    const double a = 0.2 * std::pow(own, 0.8) + 0.8 * std::pow(odd, 0.8);
    const auto p = preclassify(k, table)[0];
    EXPECT_NEAR(p[1] / p[2], a / std::pow(b, 0.8), 1e-12) << error;
  }
}

// A class of two kinds is the fallback here; the others say nothing, or nothing about size.
Knowledge kinds_of_the_unknown() {
  Knowledge k = two_kinds();
  k.classes = {{0, "a", 0.3, "", "#000000", true}, {1, "mystery", 0.01, "", "#000000", false}, {2, "high", 0.2, "", "#000000", false}};
  k.class_features.push_back({"high", "height", 2, 0.3});
  return k;
}

TEST(Kinds, OfTheFallbackClassSpeakForAClassWithoutRows) {
  const Knowledge k = kinds_of_the_unknown();
  for (const auto& [height, size] : {std::pair(0.4, 2.0), std::pair(1.0, 1.0), std::pair(1.0, 0.5), std::pair(3.0, 5.0)}) {
    const auto p = preclassify(k, {{"height", "size"}, {{height, size}}})[0];
    EXPECT_NEAR(p[1] / p[0], 0.01 / 0.3, 1e-9) << height << " " << size << ": nothing but the prior tells it from the fallback class";
  }
}

// What "high" describes of the two kinds: (7) of newcomers.hpp.
const double kOfLow = std::pow(std::exp(-1.6 * 1.6 / (2 * (0.09 + 0.01))), 0.8), kOfHigh = std::pow(std::exp(-0.4 * 0.4 / (2 * (0.09 + 0.04))), 0.8);

TEST(Kinds, OfTheFallbackClassSpeakForWhatAClassHasNoRowsForAsFarAsItDescribesThem) {
  const Knowledge k = kinds_of_the_unknown();
  const double taken = std::min(1.0, 0.2 / 0.3 / (0.5 * kOfLow + 0.3 * kOfHigh)), weighed = 0.5 * (kOfLow + 0.01) + 0.3 * (kOfHigh + 0.01);
  for (const auto& [height, size] : {std::pair(2.1, 2.0), std::pair(1.5, 0.5)}) {
    const auto p = preclassify(k, {{"height", "size"}, {{height, size}}})[0];
    const double ln = std::log(size), own = std::pow(normal(ln, 0, 0.4), 0.5), small = std::pow(normal(ln, 0.7, 0.2), 0.5);
    const double of_size = 0.8 / weighed * (0.5 * (kOfLow + 0.01) * small + 0.3 * (kOfHigh + 0.01) * own) + 0.2 * own;
    const double unknown = 0.2 * std::pow(normal(height, 1, 0.6), 0.8) * own + 0.5 * (1 - taken * kOfLow) * std::pow(normal(height, 0.4, 0.1), 0.8) * small +
                           0.3 * (1 - taken * kOfHigh) * std::pow(normal(height, 1.6, 0.2), 0.8) * own;
    EXPECT_NEAR(p[2] / p[0], 0.2 * std::pow(normal(height, 2, 0.3), 0.8) * of_size / (0.3 * unknown), 1e-9) << height << " " << size;
  }
}

TEST(Kinds, AreTakenOverByWhatDescribesThemNoFurtherThanItsPriorGoes) {
  Knowledge k = kinds_of_the_unknown();
  k.class_features.back() = {"high", "height", 1.6, 0.2};  // exactly what the second kind is
  const FeatureTable table{{"height"}, {{1.6}}};
  const auto usual = [&](double prior) {
    k.classes[2].prior = prior;
    return std::exp(contributions(k, table, 0, 0).back().log_likelihood);
  };
  EXPECT_GT(usual(1e-9), 0.2) << "hardly anything is taken over";
  EXPECT_LT(usual(0.05), usual(0.01));
  k.classes[2].prior = 0.2;
  EXPECT_GT(preclassify(k, table)[0][2], 0.9) << "what is left of the fallback class is its own rows";
}

TEST(Kinds, CountForNothingInEquationOneOfThePaper) {
  Knowledge k = two_kinds(), plain = two_kinds();
  plain.kinds.clear();
  for (Knowledge* both : {&k, &plain}) both->settings["combination"] = "mean";
  const FeatureTable table{{"height", "size"}, {{0.4, 2.0}}};
  EXPECT_EQ(preclassify(k, table), preclassify(plain, table));
  EXPECT_EQ(contributions(k, table, 0, 1).size(), 2U);
}

Knowledge to_learn() {
  Knowledge k;
  k.classes = {{0, "unknown", 0.4, "", "#000000", true}, {1, "table", 0.3, "", "#000000", false}, {2, "shelf", 0.3, "", "#000000", false}};
  k.features = {{"height", "m", Scale::linear, -0.5, 4, 1, ""}, {"length", "m", Scale::log, 0.03, 30, 1, ""}};
  return k;
}

// Tables are low and short or high and long; shelves low and long or high and short: each feature by itself tells nothing.
LabelledPlanes crossed(int each, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> spread(0, 0.1);
  LabelledPlanes planes{{{"height", "length"}, {}}, {}};
  for (int i = 0; i < 4 * each; ++i) {
    const bool high = i % 2 == 1, is_long = i % 4 >= 2;
    planes.features.values.push_back({(high ? 2 : 1) + spread(random), std::exp((is_long ? 1 : 0) + spread(random))});
    planes.classes.push_back(high == is_long ? "table" : "shelf");
  }
  return planes;
}

double share_right(const Knowledge& k, const LabelledPlanes& planes) {
  const auto p = preclassify(k, planes.features);
  int right = 0;
  for (std::size_t i = 0; i < p.size(); ++i) right += planes.classes[i] == (p[i][1] > p[i][2] ? "table" : "shelf");
  return right / static_cast<double>(p.size());
}

TEST(LearnKinds, TellsClassesApartThatNoSingleFeatureDoes) {
  const LearnedRows rows = learn(to_learn(), crossed(30, 1));
  const Knowledge with = with_rows(to_learn(), rows);
  Knowledge without = with;
  without.kinds.clear();
  const LabelledPlanes fresh = crossed(50, 2);
  EXPECT_LT(share_right(without, fresh), 0.7);
  EXPECT_GT(share_right(with, fresh), 0.98);
  ASSERT_GE(rows.classes[1].kinds.size(), 2U);
  double shares = 0;
  for (const ClassKind& kind : rows.classes[1].kinds) shares += kind.share;
  EXPECT_NEAR(shares, LearnOptions{}.kind_share, 1e-12);
}

// Whole tables are long, their scraps short; unknown things are short at any height.
LabelledPlanes with_scraps(int each, const std::string& class_of_scraps, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> spread(0, 0.1);
  std::uniform_real_distribution<double> anywhere(0, 3);
  LabelledPlanes planes{{{"height", "length"}, {}}, {}};
  const auto add = [&](double height, double length, const std::string& object_class) {
    planes.features.values.push_back({height, length});
    planes.classes.push_back(object_class);
  };
  for (int i = 0; i < each; ++i) {
    add(1 + spread(random), std::exp(1 + spread(random)), "table");
    add(1 + spread(random), std::exp(-1 + 3 * spread(random)), class_of_scraps);
    add(anywhere(random), std::exp(-1 + 3 * spread(random)), "unknown");
  }
  return planes;
}

TEST(LearnKinds, GiveScrapsTheirOwnKindSoThatTheUnknownDoesNotClaimThem) {
  const Knowledge learned = with_rows(to_learn(), learn(to_learn(), with_scraps(60, "table", 1)));
  const Knowledge left_out = with_rows(to_learn(), learn(to_learn(), with_scraps(60, "", 1)));
  const FeatureTable whole_and_scrap{{"height", "length"}, {{1, std::exp(1.0)}, {1, std::exp(-1.0)}}};
  const auto with = preclassify(learned, whole_and_scrap), without = preclassify(left_out, whole_and_scrap);
  EXPECT_GT(with[0][1], 0.95);
  EXPECT_GT(without[0][1], 0.95);
  EXPECT_GT(with[1][1], 0.7);  // among scraps and unknown things of this height most are scraps
  EXPECT_LT(without[1][1], 0.05);  // what nobody taught is claimed by other classes with certainty
}

TEST(LearnKinds, MakesNoKindOfAFewWrongLabels) {
  LabelledPlanes planes = crossed(30, 1);
  for (int i = 0; i < 3; ++i) {
    planes.features.values.push_back({3.9, 0.05});
    planes.classes.push_back("table");
  }
  const LearnedRows rows = learn(to_learn(), planes);
  ASSERT_GE(rows.classes[1].kinds.size(), 2U);
  for (const ClassKind& kind : rows.classes[1].kinds) {
    EXPECT_LT(kind.features[0].mean, 3) << "kind " << kind.number;
    EXPECT_GT(kind.share * 63, 4) << "kind " << kind.number;
  }
}

// A clean scan has free edges of exactly none: one odd sample in thirty must not make a plane something else.
TEST(LearnKinds, AreNoSharperInSharesThanCountingIs) {
  Knowledge k = to_learn();
  k.features[0] = {"edge_free", "1", Scale::linear, 0, 1, 1, ""};
  LabelledPlanes planes = crossed(30, 1);
  planes.features.names[0] = "edge_free";
  for (std::size_t i = 0; i < planes.classes.size(); ++i) planes.features.values[i][0] = planes.classes[i] == "table" || i % 4 != 1 ? 0 : 0.5;
  k.class_features.clear();
  const LearnedRows rows = learn(k, planes);
  ASSERT_GE(rows.classes[1].kinds.size(), 2U);
  for (const ClassKind& kind : rows.classes[1].kinds) {
    EXPECT_GE(kind.features[0].sigma, 0.03 - 1e-12);
    EXPECT_LT(kind.features[1].sigma, 0.3) << "sizes stay as sharp as they are";
  }
}

TEST(LearnKinds, DoesNotDependOnTheOrderOfPlanes) {
  const LabelledPlanes planes = crossed(20, 4);
  LabelledPlanes turned = planes;
  std::reverse(turned.features.values.begin(), turned.features.values.end());
  std::reverse(turned.classes.begin(), turned.classes.end());
  const auto a = learn(to_learn(), planes).classes[1].kinds, b = learn(to_learn(), turned).classes[1].kinds;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].share, b[k].share);
    EXPECT_EQ(a[k].features[1].mean, b[k].features[1].mean);
  }
}

TEST(LearnKinds, TooFewExamplesMakeNone) {
  LabelledPlanes planes = crossed(30, 1);
  planes.features.values.resize(40);
  planes.classes.resize(40);  // twenty tables: less than two kinds of twelve
  EXPECT_TRUE(learn(to_learn(), planes).classes[1].kinds.empty());
}

TEST(LearnKinds, MovesThePresentOnesWhereTheyCount) {
  Knowledge k = to_learn();
  k.kinds = {{"table", 1, 0.6, "by the wall", {{"height", 1.3, 0.2}, {"length", 0, 0.2}}}, {"table", 2, 0.35, "", {{"height", 2.2, 0.2}, {"length", 1, 0.2}}}};
  LearnOptions options;
  options.present_strength = 60;
  const auto kinds = learn(k, crossed(30, 1), options).classes[1].kinds;
  ASSERT_EQ(kinds.size(), 2U);
  EXPECT_EQ(kinds[0].description, "by the wall");
  EXPECT_NEAR(kinds[0].features[0].mean, (30 * 1.0 + 60 * 1.3) / 90, 0.03);  // 30 examples at 1.0 beside what stands for 60 at 1.3
  EXPECT_NEAR(kinds[0].share, 0.95 * (30 + 60 * 0.6) / (60 + 57), 0.02);
}

TEST(KindRows, AreReadAsTheyWereLearnedAndUndone) {
  const TemporaryFolder folder;
  KnowledgeBase base = KnowledgeBase::create(folder / "k.gpkg", "empty");
  base.apply_knowledge("INSERT INTO object_class (id, name, prior) VALUES (1, 'table', 0.3), (2, 'shelf', 0.3)", "classes");
  LabelledPlanes planes = crossed(30, 1);
  const LearnedRows rows = learn(base.knowledge(), planes);
  base.learn_knowledge(to_sql(rows), "learned from a test");
  const Knowledge read = base.knowledge();
  const Knowledge direct = with_rows(base.knowledge(), rows);
  ASSERT_EQ(read.kinds.size(), direct.kinds.size());
  ASSERT_GE(read.kinds.size(), 4U);
  for (std::size_t k = 0; k < read.kinds.size(); ++k) {
    EXPECT_EQ(read.kinds[k].object_class, direct.kinds[k].object_class);
    EXPECT_NEAR(read.kinds[k].share, direct.kinds[k].share, 1e-4);
    ASSERT_EQ(read.kinds[k].features.size(), direct.kinds[k].features.size());
    EXPECT_NEAR(read.kinds[k].features[0].mean, direct.kinds[k].features[0].mean, 1e-3);
  }
  EXPECT_GT(share_right(read, crossed(50, 2)), 0.98);
  EXPECT_EQ(base.undo_knowledge(), "learned from a test");
  EXPECT_TRUE(base.knowledge().kinds.empty());
}

/// Mean of ln P(true class | features).
double mean_log_probability(const Knowledge& k, const LabelledPlanes& planes) {
  const auto p = preclassify(k, planes.features);
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += std::log(p[i][static_cast<std::size_t>(k.class_index(planes.classes[i]))]);
  return sum / static_cast<double>(p.size());
}

/// Features that count a third make densities too vague to tell much.
Knowledge vague() {
  Knowledge k = to_learn();
  for (Feature& feature : k.features) feature.weight = 0.3;
  return k;
}

TEST(Contrast, MakesFreshLabelsLikelier) {
  LearnedRows rows = learn(vague(), with_scraps(60, "table", 1));
  const LabelledPlanes fresh = with_scraps(60, "table", 2);
  const double before = mean_log_probability(with_rows(vague(), rows), fresh);
  contrast(vague(), with_scraps(60, "table", 1), rows);
  EXPECT_GT(mean_log_probability(with_rows(vague(), rows), fresh), before + 0.05);
  double shares = 0, priors = 0;
  for (const ClassKind& kind : rows.classes[1].kinds) shares += kind.share;
  for (const LearnedClass& learned : rows.classes) priors += learned.prior;
  EXPECT_NEAR(shares, LearnOptions{}.kind_share, 1e-9);
  EXPECT_NEAR(priors, 1, 1e-9);
}

// Where the likelihood is highest, classes are expected as often as they occur: the score of ln s_k π_C, (2) of contrast.cpp, is zero.
TEST(Contrast, ExpectsEachClassAsOftenAsItIs) {
  LabelledPlanes planes = with_scraps(60, "table", 1);
  for (std::size_t i = 0; i < planes.classes.size(); i += 6) planes.classes[i] = "shelf";  // half of the whole tables
  LearnedRows rows = learn(vague(), planes);
  for (LearnedClass& learned : rows.classes) learned.prior = 1.0 / 3;
  contrast(vague(), planes, rows, {.passes = 40, .strength = 1e-3});
  const auto p = preclassify(with_rows(vague(), rows), planes.features);
  for (std::size_t c = 0; c < 3; ++c) {
    double expected = 0;
    for (const auto& of_plane : p) expected += of_plane[c];
    const auto real = std::count(planes.classes.begin(), planes.classes.end(), to_learn().classes[c].name);
    EXPECT_NEAR(expected / static_cast<double>(p.size()), static_cast<double>(real) / static_cast<double>(p.size()), 0.02) << "class " << c;
  }
}

// The same with what is at stake as weights.
TEST(Contrast, ExpectsOfEachClassAsMuchAsIsAtStake) {
  LabelledPlanes planes = with_scraps(60, "table", 1);
  for (std::size_t i = 0; i < planes.classes.size(); ++i) {
    if (i % 6 == 0) planes.classes[i] = "shelf";  // half of the whole tables, which matter more
    planes.stakes.push_back(i % 6 == 0 ? 4 : 1);
  }
  LearnedRows rows = learn(vague(), planes);
  for (LearnedClass& learned : rows.classes) learned.prior = 1.0 / 3;
  contrast(vague(), planes, rows, {.passes = 40, .strength = 1e-3});
  const auto p = preclassify(with_rows(vague(), rows), planes.features);
  for (std::size_t c = 0; c < 3; ++c) {
    double expected = 0, real = 0, all = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      expected += planes.stakes[i] * p[i][c], all += planes.stakes[i];
      real += planes.classes[i] == to_learn().classes[c].name ? planes.stakes[i] : 0;
    }
    EXPECT_NEAR(expected / all, real / all, 0.02) << "class " << c;
  }
}

TEST(Contrast, WantsToKnowWhatIsAtStakeOfAllPlanesOrNone) {
  LabelledPlanes planes = crossed(30, 1);
  LearnedRows rows = learn(vague(), planes);
  planes.stakes = {1, 2};
  EXPECT_THROW(contrast(vague(), planes, rows), Error);
}

TEST(MixFits, LooksLikeWhatAllFitsSay) {
  LearnedRows one = learn(vague(), crossed(30, 1)), other = learn(vague(), crossed(40, 3)), third = learn(vague(), crossed(35, 7));
  for (std::size_t c = 0; c < one.classes.size(); ++c) {
    for (LearnedRows* rows : {&other, &third}) {
      rows->classes[c].gaussians = one.classes[c].gaussians;
      rows->classes[c].densities = one.classes[c].densities;
    }
  }
  const LearnedRows all = mix_fits({one, other, third});
  const std::vector<ClassKind>& kinds = all.classes[1].kinds;
  ASSERT_EQ(kinds.size(), one.classes[1].kinds.size() + other.classes[1].kinds.size() + third.classes[1].kinds.size());
  for (std::size_t k = 0; k < kinds.size(); ++k) EXPECT_EQ(kinds[k].number, static_cast<int>(k) + 1);
  EXPECT_EQ(all.classes[1].examples, one.classes[1].examples + other.classes[1].examples + third.classes[1].examples);
  EXPECT_DOUBLE_EQ(all.classes[1].prior, (one.classes[1].prior + other.classes[1].prior + third.classes[1].prior) / 3);
  const LabelledPlanes fresh = crossed(5, 5);
  const auto density = [&](const LearnedRows& rows, std::size_t plane) {
    double log = 0;
    for (const Contribution& term : contributions(with_rows(vague(), rows), fresh.features, plane, 1)) log += term.weight * term.log_likelihood;
    return std::exp(log);
  };
  for (std::size_t i = 0; i < fresh.classes.size(); ++i) {
    const double mean = (density(one, i) + density(other, i) + density(third, i)) / 3;
    EXPECT_NEAR(density(all, i), mean, 1e-9 * mean) << i;
  }
}

TEST(MixFits, LeavesSharesToTheFitsThatHaveKinds) {
  const LearnedRows one = learn(vague(), crossed(30, 1));
  LearnedRows other = one;
  other.classes[1].kinds.clear();
  EXPECT_EQ(mix_fits({one, other}).classes[1].kinds.size(), one.classes[1].kinds.size());
  EXPECT_EQ(mix_fits({one, other}).classes[1].kinds[0].share, one.classes[1].kinds[0].share);
  EXPECT_EQ(mix_fits({other, one}).classes[1].kinds[0].share, one.classes[1].kinds[0].share);
  EXPECT_EQ(mix_fits({one, other, one}).classes[1].kinds[0].share, one.classes[1].kinds[0].share / 2);
}

TEST(Contrast, LeavesKindsWhereTheyHoldOnFirmly) {
  LearnedRows rows = learn(vague(), crossed(30, 1));
  const std::vector<ClassKind> before = rows.classes[1].kinds;
  contrast(vague(), crossed(30, 3), rows, {.strength = 1e9});
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_NEAR(rows.classes[1].kinds[k].share, before[k].share, 0.1 * before[k].share);
    EXPECT_NEAR(rows.classes[1].kinds[k].features[0].mean, before[k].features[0].mean, 0.1 * before[k].features[0].sigma);
  }
}

TEST(Contrast, UsesWhatIsKnownOfAPlaneAndDoesTheSameTwice) {
  LabelledPlanes planes = crossed(30, 1);
  for (std::size_t i = 0; i < planes.classes.size(); i += 3) planes.features.values[i][0] = std::numeric_limits<double>::quiet_NaN();
  LearnedRows rows = learn(vague(), planes), again = rows;
  contrast(vague(), planes, rows);
  contrast(vague(), planes, again);
  EXPECT_EQ(to_sql(rows), to_sql(again));
  for (const ClassKind& kind : rows.classes[1].kinds) {
    EXPECT_TRUE(std::isfinite(kind.share));
    EXPECT_TRUE(std::isfinite(kind.features[0].mean) && kind.features[0].sigma > 0);
  }
}

TEST(Contrast, WantsARowForEachFeatureThatCounts) {
  LearnedRows rows = learn(vague(), crossed(30, 1));
  rows.classes[1].kinds[0].features.pop_back();
  EXPECT_THROW(contrast(vague(), crossed(30, 1), rows), Error);
}

}  // namespace
}  // namespace scenelore::kb
