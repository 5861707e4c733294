// Contradictions, and what rows decide.
#include "scenelore/rules/conflict.hpp"

#include <gtest/gtest.h>

#include "scenelore/rules/profile.hpp"
#include "tiny.hpp"

namespace scenelore::rules {
namespace {

using kb::Quantifier;
using Truth = std::vector<std::pair<kb::PlaneId, std::string>>;

const std::vector<std::vector<double>> kEven(3, {0.2, 0.4, 0.4});

TEST(Contradiction, IsNotThereWhenEverythingCanHold) {
  kb::Knowledge knowledge = tiny::knowledge({"table", "lamp"});
  knowledge.constraints = {tiny::row(1, "lamp", Quantifier::at_most, std::nullopt, std::nullopt, std::nullopt, 1)};
  const Contradiction found = find_contradiction(knowledge, tiny::scene(3), kEven, {}, {{10, "lamp"}});
  EXPECT_TRUE(found.parts.empty());
  EXPECT_TRUE(found.relaxation.empty());
}

TEST(Contradiction, NamesAMinimalSetOfRowsAndTruth) {
  kb::Knowledge knowledge = tiny::knowledge({"table", "lamp"});
  knowledge.constraints = {tiny::row(1, "lamp", Quantifier::at_most, std::nullopt, std::nullopt, std::nullopt, 1),
                           tiny::row(2, "lamp", Quantifier::no, std::nullopt, "table", 1.0),  // soft: no part of it
                           tiny::row(3, "table", Quantifier::at_most, std::nullopt, std::nullopt, std::nullopt, 2)};
  const Truth truth{{10, "lamp"}, {11, "lamp"}, {12, "table"}};
  const Contradiction found = find_contradiction(knowledge, tiny::scene(3), kEven, {}, truth);
  std::vector<std::string> rows;
  std::vector<kb::PlaneId> planes;
  for (const ConflictPart& part : found.parts) {
    if (part.constraint.empty()) planes.push_back(part.planes.at(0));
    else rows.push_back(part.constraint);
  }
  EXPECT_EQ(rows, std::vector<std::string>{"row_1"});
  EXPECT_EQ(planes, (std::vector<kb::PlaneId>{10, 11}));  // the table has no part in it
  // Minimal: without any one of the parts there is no contradiction.
  EXPECT_TRUE(find_contradiction(knowledge, tiny::scene(3), kEven, {}, {{10, "lamp"}, {12, "table"}}).parts.empty());
  EXPECT_TRUE(find_contradiction(knowledge, tiny::scene(3), kEven, {}, {{11, "lamp"}, {12, "table"}}).parts.empty());
}

TEST(Contradiction, TellsTheCheapestWayOut) {
  // Two rows that cannot both be met by the lamp at 10: it needs a table above or below, and there is to be none.
  kb::Knowledge knowledge = tiny::knowledge({"table", "lamp"});
  knowledge.constraints = {tiny::row(1, "lamp", Quantifier::some, "near", "table", std::nullopt),
                           tiny::row(2, "lamp", Quantifier::no, "near", "table", std::nullopt)};
  Facts facts;
  facts.facts = {{"near", 10, 11, 1}, {"near", 11, 10, 1}};
  const Contradiction found = find_contradiction(knowledge, tiny::scene(3), kEven, facts, {{10, "lamp"}});
  EXPECT_EQ(found.parts.size(), 3U);  // both rows and the truth
  ASSERT_EQ(found.relaxation.size(), 1U);
  EXPECT_TRUE(found.relaxation[0].constraint == "row_1" || found.relaxation[0].constraint == "row_2");
  EXPECT_EQ(found.relaxation[0].planes.at(0), 10);
}

TEST(Profile, TellsWhichRowsDecideSomething) {
  kb::Knowledge knowledge = tiny::knowledge({"table", "lamp"});
  knowledge.constraints = {tiny::row(1, "lamp", Quantifier::some, "above", "table", 5.0),
                           tiny::row(2, "table", Quantifier::at_most, std::nullopt, std::nullopt, 1.0, 3)};
  const std::vector<std::vector<double>> evidence{{0.5, 0.1, 0.4}, {0.1, 0.1, 0.8}};
  RuleSet rules = RuleSet::load();
  const Profile found = profile(knowledge, tiny::scene(2), evidence, rules, {});
  ASSERT_EQ(found.relations.size(), 1U);
  EXPECT_EQ(found.relations[0].relation, "above");
  EXPECT_EQ(found.relations[0].asked, 2);
  ASSERT_EQ(found.rows.size(), 2U);
  EXPECT_EQ(found.rows[0].constraints, 2);
  EXPECT_GT(found.rows[0].decided, 0);  // no table below: the upper plane is a lamp only without the row
  EXPECT_EQ(found.rows[1].constraints, 0);  // two planes can never be too many
  EXPECT_EQ(found.rows[1].decided, 0);
}

TEST(Reasons, NeverChangeTheAnswer) {
  std::mt19937 random(5);
  kb::Knowledge knowledge = tiny::knowledge({"table", "lamp", "wall"});
  knowledge.constraints = {tiny::row(1, "lamp", Quantifier::some, "above", "table", 2.0),
                           tiny::row(2, "wall", Quantifier::no, "near", "lamp", 1.5)};
  RuleSet rules = RuleSet::load();
  for (int round = 0; round < 20; ++round) {
    const Scene scene = tiny::scene(6);
    const auto evidence = tiny::evidence(random, 6, 4);
    const Facts facts = rules.relate(scene, {"above", "near"});
    const kb::Inference with = label(knowledge, scene, evidence, facts, {});
    const kb::Inference without = label(knowledge, scene, evidence, facts, {}, {.reasons = false});
    EXPECT_FALSE(with.reasons.empty());
    EXPECT_TRUE(without.reasons.empty());
    ASSERT_EQ(with.labels.size(), without.labels.size());
    for (std::size_t i = 0; i < with.labels.size(); ++i) {
      EXPECT_EQ(std::tie(with.labels[i].object_class, with.labels[i].probability, with.labels[i].margin, with.labels[i].runner_up),
                std::tie(without.labels[i].object_class, without.labels[i].probability, without.labels[i].margin, without.labels[i].runner_up));
    }
  }
}

}  // namespace
}  // namespace scenelore::rules
