// Learned weights against closed forms and against scenes of which it is known what should weigh.
#include "scenelore/rules/learn_weights.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "log_linear.hpp"
#include "scenelore/rules/error.hpp"
#include "tiny.hpp"

namespace scenelore::rules {
namespace {

using kb::Quantifier;

TEST(LogLinear, FindsTheLogOdds) {
  // One parameter that speaks for class 1 in every example: its best value is ln(share / (1 - share)).
  std::vector<Example> examples;
  for (int i = 0; i < 100; ++i) examples.push_back({.of_class = {{0.0}, {1.0}}, .truth = i < 80 ? 1 : 0});
  std::vector<double> parameters{0};
  const double reached = fit_log_linear(examples, {.start = {0}, .low = {0}, .high = {0}, .free = 0, .frees = 1}, parameters);
  EXPECT_NEAR(parameters[0], std::log(4.0), 0.02);
  EXPECT_NEAR(reached, 0.8 * std::log(0.8) + 0.2 * std::log(0.2), 1e-4);
}

TEST(LogLinear, KeepsToItsBoundsAndToWhereItStarted) {
  std::vector<Example> examples;
  for (int i = 0; i < 100; ++i) examples.push_back({.of_class = {{0.0}, {1.0}}, .truth = i < 80 ? 1 : 0});
  std::vector<double> bounded{0}, held{0};
  fit_log_linear(examples, {.start = {0}, .low = {0}, .high = {0.5}, .free = 1}, bounded);
  EXPECT_DOUBLE_EQ(bounded[0], 0.5);
  fit_log_linear(examples, {.start = {0}, .strength = 1e6, .low = {0}, .high = {9}, .free = 1}, held);
  EXPECT_NEAR(held[0], 0, 1e-3);
}

TEST(LogLinear, LearnsNothingFromNothing) {
  std::vector<double> parameters{0.7};
  EXPECT_EQ(fit_log_linear({}, {.start = {0}, .low = {0}, .high = {9}}, parameters), 0);
  EXPECT_EQ(parameters[0], 0.7);
}

/// Pairs of planes: a "cup" always on a "plate" (relation on), and "unknown" ones that are on nothing. The features tell
/// plates, but not cups from unknown. A second row asks that cups be far from plates, which never holds.
std::vector<LabelledScene> cups() {
  std::vector<LabelledScene> out;
  for (int i = 0; i < 20; ++i) {
    LabelledScene scene{.scene = tiny::scene(3), .facts = {}, .classes = {"plate", "cup", "unknown"}};
    scene.scene.features = {.names = {"size"}, .values = {{0.9}, {0.2}, {0.2}}};
    scene.facts.facts = {{.relation = "on", .a = 11, .b = 10, .degree = 1}};
    out.push_back(scene);
  }
  return out;
}

kb::Knowledge crockery() {
  kb::Knowledge out = tiny::knowledge({"plate", "cup"});
  out.features.push_back({.name = "size", .low = 0, .high = 1, .weight = 1});
  out.class_features = {{"unknown", "size", 0.2, 0.1}, {"plate", "size", 0.9, 0.1}, {"cup", "size", 0.2, 0.1}};
  out.constraints = {tiny::row(1, "cup", Quantifier::some, "on", "plate", 0.5),
                     tiny::row(2, "cup", Quantifier::some, "far", "plate", 0.5)};
  return out;
}

TEST(LearnWeights, RaisesARowThatTellsClassesApartAndDropsOneThatNeverHolds) {
  const auto scenes = cups();
  const LearnedWeights learned = learn_weights(crockery(), scenes);
  EXPECT_GT(learned.constraints[0], 1.5);
  EXPECT_LT(learned.constraints[1], learned.constraints[0] / 3);
  EXPECT_GT(learned.log_likelihood.back(), learned.log_likelihood.front() - 1e-9);

  const kb::Knowledge better = with_weights(crockery(), learned);
  const auto evidence = kb::preclassify(better, scenes[0].scene.features);
  const kb::Inference answer = label(better, scenes[0].scene, evidence, scenes[0].facts, {});
  EXPECT_EQ(answer.labels[1].object_class, "cup");
  EXPECT_EQ(answer.labels[2].object_class, "unknown");
}

TEST(LearnWeights, LeavesHardAndDisabledRowsAlone) {
  kb::Knowledge knowledge = crockery();
  knowledge.constraints[0].weight = std::nullopt;
  knowledge.constraints[1].enabled = false;
  const kb::Knowledge after = with_weights(knowledge, learn_weights(knowledge, cups()));
  EXPECT_FALSE(after.constraints[0].weight.has_value());
  EXPECT_EQ(after.constraints[1].weight, knowledge.constraints[1].weight);
}

TEST(LearnWeights, LetsNoFeatureWeighMoreThanIsAllowed) {
  EXPECT_GT(learn_weights(crockery(), cups()).features[0], 0.3) << "or the bound below would bind nothing";
  const LearnedWeights bounded = learn_weights(crockery(), cups(), {.most_of_feature = 0.3});
  EXPECT_LE(bounded.features[0], 0.3);
  EXPECT_GT(bounded.constraints[0], 0.5) << "rows have a bound of their own";
}

TEST(LearnWeights, TellsWhatDoesNotFit) {
  auto scenes = cups();
  scenes[3].classes.pop_back();
  EXPECT_THROW((void)learn_weights(crockery(), scenes), Error);
  scenes = cups();
  scenes[3].classes[0] = "saucer";
  EXPECT_THROW((void)learn_weights(crockery(), scenes), Error);
}

TEST(LearnWeights, WritesOneStatementAWeightThatChanged) {
  const kb::Knowledge knowledge = crockery();
  LearnedWeights same{.features = {1}, .priors = {1, 1, 1}, .constraints = {0.5, 0.5}};
  EXPECT_EQ(to_sql(knowledge, same), "");
  same.constraints[1] = 2;
  EXPECT_EQ(to_sql(knowledge, same), "UPDATE class_constraint SET weight = 2 WHERE name = 'row_2';\n");
}

}  // namespace
}  // namespace scenelore::rules
