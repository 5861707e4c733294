// Constraints written in Lua, over several planes at once.
#include <gtest/gtest.h>

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

/// Cheapest labelling by trying all of them: evidence, and what the definition of the constraint says.
double cheapest(const Scene& scene, const std::vector<std::vector<double>>& evidence, double weight) {
  const int planes = static_cast<int>(scene.planes.size()), classes = 4;
  double best = 1e300;
  std::vector<int> label(static_cast<std::size_t>(planes));
  const auto z = [&](int i) { return scene.planes[static_cast<std::size_t>(i)].height; };
  const auto is = [&](int i, int c) { return label[static_cast<std::size_t>(i)] == c; };
  for (int code = 0, all = static_cast<int>(std::pow(classes, planes)); code < all; ++code) {
    double cost = 0;
    for (int i = 0, rest = code; i < planes; ++i, rest /= classes) {
      label[static_cast<std::size_t>(i)] = rest % classes;
      cost -= std::log(evidence[static_cast<std::size_t>(i)][static_cast<std::size_t>(rest % classes)]);
    }
    for (int a = 0; a < planes; ++a) {
      for (int b = 0; b < planes; ++b) {
        for (int c = 0; c < planes; ++c) {
          if (z(a) > z(b) && z(b) > z(c) && is(a, 2) && is(b, 1) && is(c, 3)) cost += weight * (z(a) - z(c) < 1.1 ? 1 : 0.25);
        }
      }
    }
    best = std::min(best, cost);
  }
  return best;
}

TEST(TupleConstraint, CostsWhatItsDefinitionSays) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "stack.lua", kStack);
  RuleSet rules = RuleSet::load({folder.path()});
  const kb::Knowledge plain = tiny::knowledge({"table", "lamp", "wall"});
  std::mt19937 random(3);
  for (int round = 0; round < 25; ++round) {
    const Scene scene = tiny::scene(5);
    const auto evidence = tiny::evidence(random, 5, 4);
    Facts facts;
    facts.constraints = rules.constraints(scene, plain);
    ASSERT_EQ(facts.constraints.size(), 1U);
    const kb::Inference found = label(with_tuple_constraints(plain, facts), scene, evidence, facts, {});
    EXPECT_NEAR(found.run.cost, cheapest(scene, evidence, 3), 1e-9);
    EXPECT_EQ(found.run.outcome, "proved");
  }
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
  EXPECT_NE(error_of("classes = { 'lamp', 'table' }, quantifier = 'some', weight = 1").find("'no' or 'every'"), std::string::npos);
  EXPECT_NE(error_of("classes = { 'lamp', 'table' }, quantifier = 'no', weight = -1").find("nats above 0"), std::string::npos);
  EXPECT_NE(error_of("classes = { 'lamp', 'tabel' }, quantifier = 'no', weight = 1").find("did you mean 'table'"), std::string::npos);
  EXPECT_NE(error_of(good + ", wieght = 2").find("did you mean 'weight'"), std::string::npos);
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
