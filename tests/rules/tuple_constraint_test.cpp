// Constraints written in Lua, over several planes at once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conjunctions.hpp"
#include "scenelore/engine/checker.hpp"
#include "scenelore/rules/conflict.hpp"
#include "scenelore/rules/error.hpp"
#include "scenelore/rules/isolated.hpp"
#include "temporary_folder.hpp"
#include "tiny.hpp"

namespace scenelore::rules {
namespace {

/// Three planes in a stack cost when they are lamp, table, wall from the top, next to one another.
const char* const kStack =
    "return constraint { api = 1, name = 'stack', summary = 'no lamp on a table on a wall', classes = { 'lamp', 'table', 'wall' },\n"
    "  quantifier = 'no', weight = 3, within = 2,\n"
    "  applies = function(a, b, c) return a.z > b.z and b.z > c.z end,\n"
    "  degree = function(a, b, c) return a.z - c.z < 1.1 and 1 or 0.25 end }";

/// A lamp needs a table and a wall below it, all within 1.1 m; half of the plane order decides how well that holds.
const char* const kNeeds =
    "return constraint { api = 1, name = 'needs', summary = 'a lamp is above a table that is above a wall',\n"
    "  classes = { 'lamp', 'table', 'wall' }, quantifier = 'some', weight = WEIGHT, within = 2,\n"
    "  applies = function(a, b, c) return a.z > b.z and b.z > c.z end,\n"
    "  degree = function(a, b, c) return b.z - c.z < 0.6 and 1 or a.z - c.z < 1.6 and 0.75 or 0.25 end }";

RuleSet rules_with(const std::string& text) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "rule.lua", text);
  return RuleSet::load({folder.path()});
}

std::string needs(const std::string& weight) {
  std::string text = kNeeds;
  return text.replace(text.find("WEIGHT"), 6, weight);
}

/// All labellings of a scene by number, with classes unknown, table, lamp, wall.
class Worlds {
 public:
  Worlds(const Scene& scene, const std::vector<std::vector<double>>& evidence) : scene_(scene), evidence_(evidence), label_(scene.planes.size()) {}

  /// Visits each with its cost by evidence.
  template <typename Visit>
  void for_each(Visit visit) {
    for (int code = 0, all = static_cast<int>(std::pow(4, planes())); code < all; ++code) {
      double cost = 0;
      for (std::size_t i = 0, rest = static_cast<std::size_t>(code); i < label_.size(); ++i, rest /= 4) {
        label_[i] = static_cast<int>(rest % 4);
        cost -= std::log(evidence_[i][rest % 4]);
      }
      visit(cost);
    }
  }
  [[nodiscard]] int planes() const { return static_cast<int>(label_.size()); }
  [[nodiscard]] double z(int i) const { return scene_.planes[static_cast<std::size_t>(i)].height; }
  [[nodiscard]] bool is(int i, int c) const { return label_[static_cast<std::size_t>(i)] == c; }
  [[nodiscard]] int label(int i) const { return label_[static_cast<std::size_t>(i)]; }

 private:
  const Scene& scene_;
  const std::vector<std::vector<double>>& evidence_;
  std::vector<int> label_;
};

/// What kStack costs by its definition.
double stack_cost(const Worlds& w, double weight) {
  double cost = 0;
  for (int a = 0; a < w.planes(); ++a) {
    for (int b = 0; b < w.planes(); ++b) {
      for (int c = 0; c < w.planes(); ++c) {
        if (w.z(a) > w.z(b) && w.z(b) > w.z(c) && w.is(a, 2) && w.is(b, 1) && w.is(c, 3)) cost += weight * (w.z(a) - w.z(c) < 1.1 ? 1 : 0.25);
      }
    }
  }
  return cost;
}

/// What kNeeds costs by its definition; hard (infinite weight): a degree of one half will do.
double needs_cost(const Worlds& w, double weight) {
  double cost = 0;
  for (int a = 0; a < w.planes(); ++a) {
    if (!w.is(a, 2)) continue;
    double best = 0;
    for (int b = 0; b < w.planes(); ++b) {
      for (int c = 0; c < w.planes(); ++c) {
        if (w.z(a) <= w.z(b) || w.z(b) <= w.z(c) || !w.is(b, 1) || !w.is(c, 3)) continue;
        best = std::max(best, w.z(b) - w.z(c) < 0.6 ? 1 : w.z(a) - w.z(c) < 1.6 ? 0.75 : 0.25);
      }
    }
    cost += std::isinf(weight) ? (best >= 0.5 ? 0 : weight) : weight * (1 - best);
  }
  return cost;
}

Facts facts_of(RuleSet& rules, const Scene& scene, const kb::Knowledge& knowledge) {
  Facts facts;
  facts.constraints = rules.constraints(scene, knowledge);
  return facts;
}

TEST(TupleConstraint, CostsWhatItsDefinitionSays) {
  RuleSet rules = rules_with(kStack);
  const kb::Knowledge plain = tiny::knowledge({"table", "lamp", "wall"});
  std::mt19937 random(3);
  for (int round = 0; round < 25; ++round) {
    const Scene scene = tiny::scene(5);
    const auto evidence = tiny::evidence(random, 5, 4);
    const Facts facts = facts_of(rules, scene, plain);
    ASSERT_EQ(facts.constraints.size(), 1U);
    double best = INFINITY;
    Worlds worlds(scene, evidence);
    worlds.for_each([&](double cost) { best = std::min(best, cost + stack_cost(worlds, 3)); });
    const kb::Inference found = label(with_tuple_constraints(plain, facts), scene, evidence, facts, {});
    EXPECT_NEAR(found.run.cost, best, 1e-9);
    EXPECT_EQ(found.run.outcome, "proved");
  }
}

TEST(TupleConstraint, OfKindSomeCostsWhatItsDefinitionSaysInEveryWorld) {
  std::mt19937 random(4);
  for (const auto& [text, weight] : {std::pair{"2.5", 2.5}, std::pair{"'hard'", double{INFINITY}}}) {
    RuleSet rules = rules_with(needs(text));
    const kb::Knowledge plain = tiny::knowledge({"table", "lamp", "wall"});
    const Scene scene = tiny::scene(5);
    const auto evidence = tiny::evidence(random, 5, 4);
    const Facts facts = facts_of(rules, scene, plain);
    const LabellingProblem compiled = compile(with_tuple_constraints(plain, facts), scene, evidence, facts, {});
    ASSERT_FALSE(compiled.conjunctions.empty());
    Worlds worlds(scene, evidence);
    worlds.for_each([&](double cost) {
      std::vector<int> assignment(scene.planes.size());
      for (int i = 0; i < worlds.planes(); ++i) {
        const auto variable = static_cast<std::size_t>(compiled.variable_of_plane[static_cast<std::size_t>(i)]);
        assignment[variable] = compiled.label_of_class[variable][static_cast<std::size_t>(worlds.label(i))];
      }
      settle(compiled, assignment);
      const engine::Check check = engine::check(compiled.problem, assignment);
      const double wanted = cost + needs_cost(worlds, weight);
      ASSERT_EQ(check.valid, std::isfinite(wanted));
      if (check.valid) {
        ASSERT_NEAR(check.cost, wanted, 1e-9);
      }
    });
  }
}

TEST(TupleConstraint, OfKindSomeGivesTheBestWorldWithMarginsProbabilitiesAndAlternatives) {
  RuleSet rules = rules_with(needs("2.5"));
  const kb::Knowledge plain = tiny::knowledge({"table", "lamp", "wall"});
  std::mt19937 random(5);
  for (int round = 0; round < 15; ++round) {
    const Scene scene = tiny::scene(5);
    const auto evidence = tiny::evidence(random, 5, 4);
    const Facts facts = facts_of(rules, scene, plain);
    const kb::Inference found = label(with_tuple_constraints(plain, facts), scene, evidence, facts, {});
    ASSERT_EQ(found.run.outcome, "proved");
    std::map<std::vector<int>, double> cost_of;
    Worlds worlds(scene, evidence);
    worlds.for_each([&](double cost) {
      std::vector<int> labels;
      for (int i = 0; i < worlds.planes(); ++i) labels.push_back(worlds.label(i));
      cost_of[labels] = cost + needs_cost(worlds, 2.5);
    });
    std::vector<int> best;
    for (const kb::Label& l : found.labels) best.push_back(plain.class_index(l.object_class));
    double least = INFINITY, mass = 0;
    for (const auto& [labels, cost] : cost_of) {
      least = std::min(least, cost);
      mass += std::exp(-cost);
    }
    EXPECT_NEAR(found.run.cost, least, 1e-9);
    EXPECT_NEAR(cost_of.at(best), least, 1e-9);
    for (std::size_t i = 0; i < found.labels.size(); ++i) {
      double other = INFINITY, same = 0;
      for (const auto& [labels, cost] : cost_of) {
        if (labels[i] == best[i]) same += std::exp(-cost);
        if (labels[i] != best[i]) other = std::min(other, cost);
      }
      EXPECT_NEAR(found.labels[i].margin, std::min(other - least, 3.0), 1e-6);
      EXPECT_NEAR(found.labels[i].probability, same / mass, 1e-6);
    }
    // The alternatives are the next worlds, each once.
    std::vector<double> sorted;
    for (const auto& [labels, cost] : cost_of) sorted.push_back(cost);
    std::sort(sorted.begin(), sorted.end());
    for (int rank = 2; rank <= 4; ++rank) {
      std::vector<int> labels = best;
      for (const kb::Alternative& a : found.alternatives) {
        if (a.rank == rank) labels[static_cast<std::size_t>(a.plane - 10)] = plain.class_index(a.object_class);
      }
      EXPECT_NEAR(cost_of.at(labels), sorted[static_cast<std::size_t>(rank - 1)], 1e-9) << "rank " << rank;
    }
  }
}

TEST(TupleConstraint, OfKindSomeKnowsWhatOneChangedLabelCosts) {
  RuleSet rules = rules_with(needs("2.5"));
  const kb::Knowledge plain = tiny::knowledge({"table", "lamp", "wall"});
  std::mt19937 random(6);
  const Scene scene = tiny::scene(4);
  const auto evidence = tiny::evidence(random, 4, 4);
  const Facts facts = facts_of(rules, scene, plain);
  const LabellingProblem compiled = compile(with_tuple_constraints(plain, facts), scene, evidence, facts, {});
  for (int code = 0; code < 256; ++code) {
    std::vector<int> assignment;
    for (int i = 0, rest = code; i < 4; ++i, rest /= 4) assignment.push_back(rest % 4);
    settle(compiled, assignment);
    const double now = engine::check(compiled.problem, assignment).cost;
    const auto flips = label_flip_costs(compiled, assignment);
    ASSERT_EQ(flips.size(), 4U);
    for (std::size_t v = 0; v < 4; ++v) {
      for (int l = 0; l < 4; ++l) {
        std::vector<int> other = assignment;
        other[v] = l;
        settle(compiled, other);
        EXPECT_NEAR(flips[v][static_cast<std::size_t>(l)], engine::check(compiled.problem, other).cost - now, 1e-9);
      }
    }
  }
}

TEST(TupleConstraint, OfKindSomeIsExplained) {
  RuleSet rules = rules_with(needs("2.5"));
  const kb::Knowledge plain = tiny::knowledge({"table", "lamp", "wall"});
  const Scene scene = tiny::scene(3);
  const Facts facts = facts_of(rules, scene, plain);
  const std::vector<std::vector<double>> even(3, {0.25, 0.25, 0.25, 0.25});
  const auto sentences = [&](const std::vector<std::pair<kb::PlaneId, std::string>>& truth, const char* kind) {
    std::vector<std::string> out;
    for (const kb::Reason& reason : label(with_tuple_constraints(plain, facts), scene, even, facts, truth).reasons) {
      if (reason.kind == kind && reason.constraint_name == "needs") out.push_back(reason.sentence);
    }
    return out;
  };
  EXPECT_THAT(sentences({{10, "wall"}, {11, "table"}, {12, "lamp"}}, "support"),
              ::testing::ElementsAre("lamp 12 relies on it (degree 1): 'a lamp is above a table that is above a wall'",
                                     "lamp 12 relies on it (degree 1): 'a lamp is above a table that is above a wall'",
                                     "thanks to table 11 and wall 10 (degree 1): 'a lamp is above a table that is above a wall'; "
                                     "without them 2.5 more"));
  EXPECT_THAT(sentences({{10, "wall"}, {11, "wall"}, {12, "lamp"}}, "violation"),
              ::testing::ElementsAre("pays 2.5 for 'a lamp is above a table that is above a wall': there is no table and wall for "
                                     "which it holds"));
}

TEST(TupleConstraint, OfKindSomeCanContradictWhatIsCertain) {
  RuleSet rules = rules_with(needs("'hard'"));
  const kb::Knowledge plain = tiny::knowledge({"table", "lamp", "wall"});
  const Scene scene = tiny::scene(3);
  const Facts facts = facts_of(rules, scene, plain);
  const std::vector<std::vector<double>> even(3, {0.25, 0.25, 0.25, 0.25});
  const kb::Knowledge knowledge = with_tuple_constraints(plain, facts);
  const Contradiction found = find_contradiction(knowledge, scene, even, facts, {{11, "wall"}, {12, "lamp"}}, {});
  ASSERT_EQ(found.parts.size(), 3U);
  EXPECT_EQ(found.parts[0].constraint, "needs");
  EXPECT_EQ(found.parts[1].planes, std::vector<kb::PlaneId>{11});
  EXPECT_EQ(found.parts[2].planes, std::vector<kb::PlaneId>{12});
  EXPECT_TRUE(find_contradiction(knowledge, scene, even, facts, {{12, "lamp"}}, {}).parts.empty());
}

TEST(TupleConstraint, IsNamedInReasonsAndGivesWayToTruth) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "stack.lua", kStack);
  RuleSet rules = RuleSet::load({folder.path()});
  const kb::Knowledge plain = tiny::knowledge({"table", "lamp", "wall"});
  const Scene scene = tiny::scene(3);
  Facts facts;
  facts.constraints = rules.constraints(scene, plain);
  EXPECT_EQ(facts.constraints[0].tuples.size(), 1U);
  const std::vector<std::vector<double>> even(3, {0.25, 0.25, 0.25, 0.25});
  const kb::Inference found = label(with_tuple_constraints(plain, facts), scene, even, facts, {{10, "wall"}, {11, "table"}, {12, "lamp"}});
  bool told = false;
  for (const kb::Reason& reason : found.reasons) told = told || (reason.kind == "violation" && reason.constraint_name == "stack");
  EXPECT_TRUE(told);
}

TEST(TupleConstraint, IsCheckedWhenLoaded) {
  const auto error_of = [](const std::string& fields) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "c.lua", "return constraint { api = 1, name = 'c', summary = 's', within = 1, degree = function() return 1 end,\n" + fields + " }");
    try {
      RuleSet rules = RuleSet::load({folder.path()});
      (void)rules.constraints(tiny::scene(3), tiny::knowledge({"table", "lamp"}));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const std::string good = "classes = { 'lamp', 'table' }, quantifier = 'no', weight = 1";
  EXPECT_EQ(error_of(good), "no error");
  EXPECT_NE(error_of("classes = { 'lamp' }, quantifier = 'no', weight = 1").find("two to four planes"), std::string::npos);
  EXPECT_NE(error_of("classes = { 'lamp', 'table' }, quantifier = 'any', weight = 1").find("'no', 'every' or 'some'"), std::string::npos);
  EXPECT_NE(error_of("classes = { 'lamp', 'table' }, quantifier = 'no', weight = -1").find("nats above 0"), std::string::npos);
  EXPECT_NE(error_of("classes = { 'lamp', 'tabel' }, quantifier = 'no', weight = 1").find("did you mean 'table'"), std::string::npos);
  EXPECT_NE(error_of(good + ", wieght = 2").find("did you mean 'weight'"), std::string::npos);
}

TEST(TupleConstraint, IsLookedAtByRulesCheck) {
  const auto findings = [](const std::string& classes, const std::string& degree, const std::string& row) {
    const test::TemporaryFolder folder;
    test::write_file(folder / "c.lua", "return constraint { api = 1, name = 'c', summary = 's', within = 1, quantifier = 'some', weight = 1,\n"
                                       "classes = { " + classes + " }, degree = function(a, b) return " + degree + " end }");
    RuleSet rules = RuleSet::load({folder.path()});
    kb::Knowledge knowledge = tiny::knowledge({"table", "lamp"});
    knowledge.constraints = {tiny::row(1, "lamp", kb::Quantifier::at_most, std::nullopt, std::nullopt, 1, 2)};
    knowledge.constraints[0].name = row;
    std::string out;
    for (const Finding& finding : check(knowledge, rules)) out += finding.text + "\n";
    return out;
  };
  EXPECT_EQ(findings("'lamp', 'table'", "1", "r"), "");
  EXPECT_NE(findings("'lamp', 'tabel'", "1", "r").find("there is no class 'tabel'; did you mean 'table'"), std::string::npos);
  EXPECT_NE(findings("'lamp', 'table'", "1", "c").find("the name is taken by class_constraint row 1"), std::string::npos);
  EXPECT_NE(findings("'lamp', 'unknown'", "1", "r").find("never matters"), std::string::npos);
  EXPECT_NE(findings("'lamp', 'table'", "0", "r").find("says nothing about any planes"), std::string::npos);
  EXPECT_NE(findings("'lamp', 'table'", "a.nothing", "r").find("a plane has no 'nothing'"), std::string::npos);
}

TEST(TupleConstraint, ComesBackFromAnIsolatedProcess) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "stack.lua", kStack);
  const kb::Knowledge plain = tiny::knowledge({"table", "lamp", "wall"});
  Scene scene = tiny::scene(4);
  const RuleAnswers there = answer_isolated({folder.path()}, {}, plain, scene, {});
  RuleSet rules = RuleSet::load({folder.path()});
  const std::vector<TupleConstraint> here = rules.constraints(scene, plain);
  ASSERT_EQ(there.facts.constraints.size(), 1U);
  ASSERT_EQ(there.facts.constraints[0].tuples.size(), here[0].tuples.size());
  for (std::size_t i = 0; i < here[0].tuples.size(); ++i) {
    EXPECT_EQ(there.facts.constraints[0].tuples[i].planes, here[0].tuples[i].planes);
    EXPECT_EQ(there.facts.constraints[0].tuples[i].degree, here[0].tuples[i].degree);
  }
  EXPECT_EQ(there.facts.constraints[0].weight, 3);
}

}  // namespace
}  // namespace scenelore::rules
