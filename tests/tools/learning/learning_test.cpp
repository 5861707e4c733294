// Learning from worlds whose densities are known.
#include "learning/learning.hpp"

#include <gmock/gmock.h>

#include <map>
#include <random>

#include "learning/cross_validation.hpp"
#include "learning/platt.hpp"

namespace scenelore::learning {
namespace {

/// Three classes that differ in one feature, at 0, 4 and 8 (sigma 1), whatever the rows of the knowledge say.
struct Made {
  std::vector<LabelledScan> scans;
  std::map<kb::PlaneId, std::string> truth;
};

const std::vector<std::string> kNames{"unknown", "low", "middle", "high"};

kb::Knowledge knowledge() {
  kb::Knowledge out;
  for (const std::string& name : kNames) {
    out.classes.push_back({.id = static_cast<int>(out.classes.size()), .name = name, .prior = 0.25, .fallback = name == "unknown"});
  }
  out.features = {{.name = "size", .scale = kb::Scale::linear, .low = -10, .high = 20, .weight = 1}};
  out.class_features = {{"low", "size", 1, 3}, {"middle", "size", 2, 3}, {"high", "size", 3, 3}};
  return out;
}

Made made(int scans, int planes_a_scan, double wrong, unsigned seed = 7) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise;
  std::uniform_real_distribution<double> uniform;
  Made out;
  kb::PlaneId id = 0;
  for (int s = 0; s < scans; ++s) {
    LabelledScan& scan = out.scans.emplace_back();
    scan.scan = "scan " + std::to_string(s);
    scan.planes.scene.features.names = {"size"};
    for (int p = 0; p < planes_a_scan; ++p) {
      const int c = 1 + p % 3;
      scan.planes.scene.planes.emplace_back();
      scan.planes.scene.ids.push_back(++id);
      scan.planes.scene.features.values.push_back({4.0 * (c - 1) + noise(random)});
      out.truth[id] = kNames[static_cast<std::size_t>(c)];
      const bool flip = uniform(random) < wrong;
      scan.planes.classes.push_back(kNames[static_cast<std::size_t>(flip ? 1 + (c % 3) : c)]);
    }
  }
  return out;
}

kb::ClassFeature gaussian(const Learned& learned, const std::string& name) {
  for (const kb::ClassFeature& row : learned.knowledge.class_features) {
    if (row.object_class == name) return row;
  }
  return {};
}

/// Share of fresh planes whose class has the highest evidence.
double accuracy(const kb::Knowledge& knowledge) {
  const Made fresh = made(1, 3000, 0, 99);
  const auto evidence = kb::preclassify(knowledge, fresh.scans[0].planes.scene.features);
  double right = 0;
  for (std::size_t p = 0; p < evidence.size(); ++p) {
    const auto best = std::max_element(evidence[p].begin(), evidence[p].end()) - evidence[p].begin();
    right += kNames[static_cast<std::size_t>(best)] == fresh.scans[0].planes.classes[p];
  }
  return right / static_cast<double>(evidence.size());
}

TEST(Learn, FindsTheDensitiesOfTheWorldAndTellsTheEffect) {
  const kb::Knowledge before = knowledge();
  const Learned learned = learn(before, made(6, 60, 0).scans);
  ASSERT_FALSE(learned.refusal);
  EXPECT_EQ(learned.planes, 360);
  EXPECT_NEAR(gaussian(learned, "low").mean, 0, 0.3);
  EXPECT_NEAR(gaussian(learned, "high").mean, (120 * 8 + 12 * 3) / 132.0, 0.3);
  EXPECT_LT(gaussian(learned, "middle").sigma, 1.7);  // 3 before
  EXPECT_GT(accuracy(learned.knowledge), accuracy(before) + 0.15);
  EXPECT_GT(learned.after.accuracy, learned.before.accuracy + 0.15);
  EXPECT_NEAR(learned.after.accuracy, accuracy(learned.knowledge), 0.05);  // the forecast comes true
  EXPECT_GT(learned.after.log_likelihood, learned.before.log_likelihood);
  EXPECT_FALSE(learned.harmful());
}

TEST(Learn, HardlyMindsFiveWrongLabelsOfAHundredAndNamesThem) {
  const Made clean = made(6, 60, 0), soiled = made(6, 60, 0.05);
  const Learned right = learn(knowledge(), clean.scans), robust = learn(knowledge(), soiled.scans);
  EXPECT_GT(accuracy(robust.knowledge), accuracy(right.knowledge) - 0.01);
  EXPECT_NEAR(gaussian(robust, "low").mean, gaussian(right, "low").mean, 0.25);
  int wrong = 0, caught = 0, accused = 0;  // a right label far out looks wrong, too
  for (const LabelledScan& scan : soiled.scans) {
    for (std::size_t p = 0; p < scan.planes.classes.size(); ++p) wrong += scan.planes.classes[p] != soiled.truth.at(scan.planes.scene.ids[p]);
  }
  ASSERT_GT(wrong, 8);
  for (const Suspect& suspect : robust.suspects) ++(suspect.labelled != soiled.truth.at(suspect.plane) ? caught : accused);
  EXPECT_GT(2 * caught, wrong);
  EXPECT_LT(accused, caught);
}

TEST(Learn, HoldsOnToThePresentRowsWhileExamplesAreFew) {
  const Learned few = learn(knowledge(), made(1, 21, 0).scans), many = learn(knowledge(), made(4, 300, 0).scans);
  const double from_few = gaussian(few, "high").mean, from_many = gaussian(many, "high").mean;
  EXPECT_GT(from_few, 3.5);  // 7 examples at 8 against 12 pretended ones at 3
  EXPECT_LT(from_few, 6);
  EXPECT_NEAR(from_many, 8, 0.3);
}

TEST(Learn, RefusesTooLittleAndSaysHowMuchIsMissing) {
  const Learned none = learn(knowledge(), std::vector<LabelledScan>{});
  ASSERT_TRUE(none.refusal);
  EXPECT_THAT(*none.refusal, testing::HasSubstr("0 planes are labelled, 20 are needed"));
  const Learned little = learn(knowledge(), made(1, 12, 0).scans);
  EXPECT_TRUE(little.refusal);
  const Learned scattered = learn(knowledge(), made(1, 30, 0).scans, {.min_examples = 11});
  ASSERT_TRUE(scattered.refusal);
  EXPECT_THAT(*scattered.refusal, testing::HasSubstr("no class has 11"));
}

TEST(Learn, KeepsPriorsWhenOnlySomePlanesAreLabelled) {
  Made some = made(1, 120, 0);
  for (std::size_t p = 0; p < 120; p += 3) some.scans[0].planes.classes[p].clear();  // none of class low
  const Learned learned = learn(knowledge(), some.scans);
  for (const kb::ObjectClass& c : learned.knowledge.classes) EXPECT_DOUBLE_EQ(c.prior, 0.25) << c.name;
  EXPECT_EQ(gaussian(learned, "low").mean, 1);
}

TEST(Learn, DoesNotDependOnThreads) {
  const Made world = made(5, 60, 0.03);
  Options one, four;
  one.threads = 1, four.threads = 4;
  EXPECT_EQ(learn(knowledge(), world.scans, one).sql, learn(knowledge(), world.scans, four).sql);
}

TEST(Learn, IsHarmfulWhenHeldBackPlanesAreToldWorse) {
  Learned learned;
  learned.before = {.accuracy = 0.8, .log_likelihood = -0.5};
  learned.after = {.accuracy = 0.7, .log_likelihood = -0.6};
  EXPECT_TRUE(learned.harmful());
  learned.after.accuracy = 0.79;
  EXPECT_FALSE(learned.harmful());
}

TEST(FitScale, FindsHowOverconfidentClaimsAre) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.02, 0.98), chance;
  const kb::ProbabilityScale truth{0.5, 0.3};
  std::vector<evaluation::Claim> claims;
  for (int i = 0; i < 20'000; ++i) {
    const double told = uniform(random);
    claims.push_back({told, chance(random) < truth(told)});
  }
  const kb::ProbabilityScale fitted = fit_scale(claims);
  EXPECT_NEAR(fitted.slope, 0.5, 0.03);
  EXPECT_NEAR(fitted.offset, 0.3, 0.05);
  EXPECT_EQ(fit_scale({}).slope, 1);
  EXPECT_EQ(fit_scale({}).offset, 0);
  EXPECT_EQ(truth(1), 1);
  EXPECT_EQ(truth(0), 0);
  EXPECT_NEAR(kb::ProbabilityScale{}(0.37), 0.37, 0);
}

TEST(Effect, IsCountedByHand) {
  const std::vector<Judged> judged{{0, 0, "low", "low", "low", 0.8, 0.8, 0.9}, {0, 1, "low", "high", "low", 0.2, 0.7, 0.6},
                                   {0, 2, "high", "high", "low", 0.5, 0.5, 0.6}, {0, 3, "unknown", "low", "unknown", 0.1, 0.9, 1}};
  const Effect effect = effect_of(judged, "unknown");
  EXPECT_DOUBLE_EQ(effect.evidence_accuracy, 0.5);
  EXPECT_DOUBLE_EQ(effect.accuracy, 0.75);
  EXPECT_DOUBLE_EQ(effect.macro_f1, (0.8 + 0) / 2);
  EXPECT_DOUBLE_EQ(effect.log_likelihood, (std::log(0.8) + std::log(0.2) + std::log(0.5) + std::log(0.1)) / 4);
}

}  // namespace
}  // namespace scenelore::learning
