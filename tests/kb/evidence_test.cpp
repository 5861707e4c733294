// Pre-classification against closed forms and against a naive reference without logarithms.
#include "scenelore/kb/evidence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::kb {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double normal(double x, double mean, double sigma) {
  return std::exp(-0.5 * std::pow((x - mean) / sigma, 2)) / (sigma * std::sqrt(2 * std::numbers::pi));
}

// Two classes and the unknown one over a linear, a log and a circular feature.
Knowledge small() {
  Knowledge k;
  k.classes = {{0, "unknown", 2, "", "#000000", true}, {1, "a", 1, "", "#000000", false}, {2, "b", 1, "", "#000000", false}};
  k.features = {{"angle", "deg", Scale::circular, 0, 360, 1, ""},
                {"height", "m", Scale::linear, 0, 4, 1, ""},
                {"size", "m", Scale::log, 0.1, 10, 0.5, ""}};
  k.class_features = {{"a", "height", 1, 0.2}, {"b", "height", 2, 0.5}, {"a", "size", std::log(2.0), 0.3}, {"a", "angle", 350, 20}};
  return k;
}

TEST(Preclassify, MultipliesPriorsAndWeightedDensities) {
  const Knowledge k = small();
  const auto p = preclassify(k, {{"height", "size"}, {{1.2, 1.5}}})[0];
  const double log_range = std::log(100.0);
  const double unknown = 0.5 * 0.25 * std::sqrt(1 / log_range);
  const double a = 0.25 * normal(1.2, 1, 0.2) * std::sqrt(normal(std::log(1.5), std::log(2.0), 0.3));
  const double b = 0.25 * normal(1.2, 2, 0.5) * std::sqrt(1 / log_range);
  EXPECT_NEAR(p[0], unknown / (unknown + a + b), 1e-10);
  EXPECT_NEAR(p[1], a / (unknown + a + b), 1e-10);
  EXPECT_NEAR(p[2], b / (unknown + a + b), 1e-10);
}

TEST(Preclassify, AveragesPosteriorsAsInEquationOneOfThePaper) {
  Knowledge k = small();
  k.settings["combination"] = "mean";
  const auto p = preclassify(k, {{"height", "size"}, {{1.2, 1.5}}})[0];
  const double h = 0.25 * normal(1.2, 1, 0.2), sum_h = 0.5 * 0.25 + h + 0.25 * normal(1.2, 2, 0.5);
  const double log_range = std::log(100.0);
  const double s = 0.25 * normal(std::log(1.5), std::log(2.0), 0.3), sum_s = 0.75 / log_range + s;
  EXPECT_NEAR(p[1], (1 * h / sum_h + 0.5 * s / sum_s) / 1.5, 1e-10);
  EXPECT_NEAR(p[0] + p[1] + p[2], 1, 1e-12);
}

TEST(Preclassify, WrapsAnglesAroundTheCircle) {
  const Knowledge k = small();
  const auto p = preclassify(k, {{"angle"}, {{350}, {5}, {335}, {170}}});
  EXPECT_NEAR(p[1][1], p[2][1], 1e-12);  // both 15 degrees off
  const double a = 0.25 * normal(15, 0, 20), rest = 0.75 / 360;
  EXPECT_NEAR(p[1][1], a / (a + rest), 1e-9);
  EXPECT_LT(p[3][1], 1e-12 * 1.01);
}

TEST(Preclassify, GivesThePriorsWhenNothingIsKnown) {
  Knowledge k = small();
  for (const char* combination : {"product", "mean"}) {
    k.settings["combination"] = combination;
    for (const FeatureTable& table : {FeatureTable{{"height"}, {{kNan}}}, FeatureTable{{}, {{}}}, FeatureTable{{"colour"}, {{3}}}}) {
      const auto p = preclassify(k, table)[0];
      EXPECT_NEAR(p[0], 0.5, 1e-12);
      EXPECT_NEAR(p[1], 0.25, 1e-12);
    }
  }
  EXPECT_TRUE(preclassify(k, {}).empty());
}

TEST(Preclassify, SkipsWhatIsNotKnownOfAPlane) {
  const Knowledge k = small();
  EXPECT_EQ(preclassify(k, {{"height", "size"}, {{1.2, kNan}}}), preclassify(k, {{"height"}, {{1.2}}}));
}

TEST(Preclassify, SurvivesValuesFarFromEveryGaussian) {
  Knowledge k = small();
  k.class_features.push_back({"unknown", "height", 0, 1e-3});
  const auto p = preclassify(k, {{"height", "size"}, {{1e6, 1e-9}, {0.5, -3}}});
  for (const auto& row : p) {
    EXPECT_NEAR(std::accumulate(row.begin(), row.end(), 0.0), 1, 1e-12);
    for (const double probability : row) EXPECT_GE(probability, kLeastProbability * 0.99);
  }
}

TEST(Preclassify, LetsAClassWithoutRowsWinOnlyWhatFitsNoOther) {
  Knowledge k = small();
  k.classes.push_back({3, "sofa", 0.1, "", "#000000", false});
  const auto p = preclassify(k, {{"height", "size"}, {{1.0, 2.0}, {3.9, 9.0}}});
  EXPECT_LT(p[0][3], 0.02);
  EXPECT_NEAR(p[1][3] / p[1][0], 0.1 / 2, 1e-9);  // as the fallback, but for its prior
}

TEST(Preclassify, LetsAFeatureWithoutARowSpeakNeitherForNorAgainstAClass) {
  Knowledge k = small();
  k.class_features.push_back({"unknown", "height", 1, 0.1});
  k.classes.push_back({3, "sofa", 0.1, "", "#000000", false});
  k.class_features.push_back({"sofa", "size", std::log(2.0), 0.2});
  const auto at = [&](double height) { return preclassify(k, {{"height", "size"}, {{height, 2.0}}})[0]; };
  EXPECT_NEAR(at(1.0)[3] / at(1.0)[0], at(1.2)[3] / at(1.2)[0], 1e-9);
  EXPECT_GT(at(1.0)[3] / at(1.0)[0], 0.1) << "its size speaks for it";
}

TEST(Preclassify, ReadsHistogramsInsteadOfGaussians) {
  Knowledge k = small();
  k.class_densities = {{"a", "height", 0, 1, 0.2}, {"a", "height", 1, 1.5, 1.2}, {"a", "height", 2, 2.5, 0.4}};
  const FeatureTable table{{"height"}, {{0}, {1}, {1.4}, {1.7}, {2.5}, {2.6}, {-1}}};
  const std::vector<double> expected = {0.2, 1.2, 1.2, 0.25e-6, 0.4, 0.25e-6, 0.25e-6};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Contribution c = contributions(k, table, i, 1)[0];
    EXPECT_NEAR(c.log_likelihood, std::log(expected[i]), 1e-12) << i;
    EXPECT_TRUE(std::isnan(c.mean));
  }
}

/// ∫ density(t) N(x; t, error²) dt over the range of "height", with what errors carry beyond its ends folded back.
double seen_through(double x, double error, const std::function<double(double)>& density) {
  double sum = 0;
  constexpr int kSteps = 400'000;
  constexpr double kLow = 0, kHigh = 4, kStep = (kHigh - kLow) / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const double t = kLow + (i + 0.5) * kStep;
    for (const double image : {x, 2 * kLow - x, 2 * kHigh - x}) sum += density(t) * normal(image, t, error) * kStep;
  }
  return sum;
}

TEST(Preclassify, SeesHistogramsThroughTheErrorOfAValue) {
  Knowledge k = small();
  k.class_densities = {{"a", "height", 0, 1, 0.2}, {"a", "height", 1, 1.5, 1.2}, {"a", "height", 2, 2.5, 0.4}};
  const auto density = [](double t) { return t < 1 ? 0.2 : t < 1.5 ? 1.2 : t >= 2 && t < 2.5 ? 0.4 : 0; };
  for (const double error : {0.02, 0.3, 1.5}) {
    for (const double x : {0.0, 0.1, 0.99, 1.7, 3.1}) {
      const double expected = std::max(seen_through(x, error, density), 0.25e-6);
      const Contribution c = contributions(k, {{"height"}, {{x}}, {{"height", {error}}}}, 0, 1)[0];
      EXPECT_NEAR(std::exp(c.log_likelihood), expected, 1e-5) << x << " with " << error;
      EXPECT_EQ(c.error, error);
    }
  }
}

TEST(Preclassify, WidensGaussiansAndOutliersByTheErrorOfAValue) {
  Knowledge k = small();
  k.settings["outlier_share"] = "0.1";
  const FeatureTable table{{"height"}, {{1.1}, {1.1}}, {{"height", {0, 0.5}}}};
  const double wide = std::hypot(0.2, 0.5), tail = std::hypot(0.8, 0.5);
  EXPECT_NEAR(std::exp(contributions(k, table, 0, 1)[0].log_likelihood), 0.9 * normal(1.1, 1, 0.2) + 0.1 * (0.25 + normal(1.1, 1, 0.8)) / 2, 1e-12);
  EXPECT_NEAR(std::exp(contributions(k, table, 1, 1)[0].log_likelihood), 0.9 * normal(1.1, 1, wide) + 0.1 * (0.25 + normal(1.1, 1, tail)) / 2, 1e-12);
  EXPECT_LT(preclassify(k, table)[1][1], preclassify(k, table)[0][1]) << "a value that is not known well says less";
}

StoredPlane tilted(double tilt_deg, double area_m2) {
  StoredPlane stored;
  stored.plane.tilt_deg = tilt_deg;
  stored.plane.area_m2 = area_m2;
  return stored;
}

TEST(Stray, IsHowFarLargePlanesAreFromLevelOrUpright) {
  std::vector<StoredPlane> planes = {tilted(1, 4), tilted(88, 1), tilted(3, 1), tilted(86, 1), tilted(30, 9), tilted(7, 0.01)};
  EXPECT_NEAR(stray_deg(planes), 3 / 1.2816, 1e-12);  // weights 2, 1, 1, 1: 80 % is at the fourth of five
  std::reverse(planes.begin(), planes.end());
  EXPECT_NEAR(stray_deg(planes), 3 / 1.2816, 1e-12);
  EXPECT_EQ(stray_deg({tilted(1, 4), tilted(88, 1), tilted(3, 1)}), 0.3) << "too few to say";
  EXPECT_EQ(stray_deg(std::vector<StoredPlane>(5, tilted(0.1, 1))), 0.3) << "as true as it can be built";
  EXPECT_EQ(built_in_features({}, planes).errors.at("tilt_deg"), std::vector<double>(6, 3 / 1.2816));
}

TEST(Preclassify, MixesInTheShareOfOutliers) {
  Knowledge k = small();
  k.settings["outlier_share"] = "0.1";
  const Contribution near = contributions(k, {{"height"}, {{1.1}}}, 0, 1)[0];
  EXPECT_NEAR(std::exp(near.log_likelihood), 0.9 * normal(1.1, 1, 0.2) + 0.1 * (0.25 + normal(1.1, 1, 0.8)) / 2, 1e-12);
  const Contribution far = contributions(k, {{"height"}, {{50}}}, 0, 1)[0];
  EXPECT_NEAR(std::exp(far.log_likelihood), 0.1 * 0.25 / 2, 1e-12);
}

TEST(Preclassify, BlamesOddValuesLessWhereTheyAreNearTheUsualOnes) {
  Knowledge k = small();
  k.settings["outlier_share"] = "0.1";
  const auto at = [&](double value) { return contributions(k, {{"height"}, {{value}}}, 0, 1)[0].log_likelihood; };
  EXPECT_GT(at(2), at(2.5) + 0.3);
  EXPECT_GT(at(2.5), at(3) + 0.1);
}

TEST(Preclassify, MixesUniformOutliersIntoAHistogramWithoutGaussian) {
  Knowledge k = small();
  k.settings["outlier_share"] = "0.1";
  k.class_densities = {{"a", "height", 1, 1.5, 1.2}};
  std::erase_if(k.class_features, [](const ClassFeature& row) { return row.object_class == "a" && row.feature == "height"; });
  EXPECT_NEAR(std::exp(contributions(k, {{"height"}, {{1.2}}}, 0, 1)[0].log_likelihood), 0.9 * 1.2 + 0.1 * 0.25, 1e-12);
}

TEST(Preclassify, AgreesWithANaiveReferenceOnRandomKnowledge) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.1, 1);
  for (int round = 0; round < 50; ++round) {
    Knowledge k;
    FeatureTable table;
    std::vector<double> values;
    for (int f = 0; f < 4; ++f) {
      const std::string name(1, static_cast<char>('p' + f));
      k.features.push_back({name, "", f % 2 == 0 ? Scale::linear : Scale::log, 0.05, 3, unit(random), ""});
      table.names.push_back(name);
      values.push_back(unit(random));
    }
    table.values = {values};
    for (int c = 0; c < 5; ++c) {
      k.classes.push_back({c, std::string(1, static_cast<char>('a' + c)), unit(random), "", "", c == 0});
      for (int f = 0; f < 4 && c > 0; ++f) k.class_features.push_back({k.classes.back().name, table.names[static_cast<std::size_t>(f)], unit(random), unit(random)});
    }
    std::vector<double> product(5, 1.0);
    double sum = 0;
    for (std::size_t c = 0; c < 5; ++c) {
      product[c] = k.classes[c].prior;
      for (std::size_t f = 0; f < 4; ++f) {
        const Feature& feature = k.features[f];
        const bool log = feature.scale == Scale::log;
        double density = 1 / (log ? std::log(3 / 0.05) : 2.95);
        if (c > 0) {
          const ClassFeature& g = k.class_features[(c - 1) * 4 + f];
          density = normal(log ? std::log(values[f]) : values[f], g.mean, g.sigma);
        }
        product[c] *= std::pow(density, feature.weight);
      }
      sum += product[c];
    }
    const auto p = preclassify(k, table)[0];
    for (std::size_t c = 0; c < 5; ++c) EXPECT_NEAR(p[c], product[c] / sum, 1e-9);
  }
}

TEST(Contributions, AddUpToTheProduct) {
  const Knowledge k = small();
  const FeatureTable table{{"size", "height", "angle"}, {{1.5, 1.2, 10}}};
  std::vector<double> logs;
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = std::log(k.classes[c].prior / 4);
    for (const Contribution& term : contributions(k, table, 0, c)) sum += term.weight * term.log_likelihood;
    logs.push_back(sum);
  }
  const double z = std::exp(logs[0]) + std::exp(logs[1]) + std::exp(logs[2]);
  const auto p = preclassify(k, table)[0];
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(p[c], std::exp(logs[c]) / z, 1e-10);
  EXPECT_EQ(contributions(k, table, 0, 1)[1].feature, "height");
  EXPECT_EQ(contributions(k, table, 0, 1)[1].mean, 1);
}

}  // namespace
}  // namespace scenelore::kb
