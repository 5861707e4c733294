// The snippets of docs/rules.md, as a newcomer would type them.
#include <gtest/gtest.h>

#include <map>

#include "scenelore/rules/rule_set.hpp"
#include "scenelore/rules/testing.hpp"
#include "temporary_folder.hpp"
#include "tiny.hpp"

namespace scenelore::rules {
namespace {

/// Text of each ```lua file=NAME block.
std::map<std::string, std::string> snippets(const std::string& text) {
  std::map<std::string, std::string> out;
  const std::string open = "```lua file=";
  for (std::size_t at = 0; (at = text.find(open, at)) != text.npos;) {
    const std::size_t name = at + open.size(), body = text.find('\n', name) + 1, end = text.find("```", body);
    out[text.substr(name, body - 1 - name)] = text.substr(body, end - body);
    at = end;
  }
  return out;
}

TEST(RulesTutorial, RunsAsWritten) {
  const auto files = snippets(test::read_file(SCENELORE_SOURCE_DIR "/docs/rules.md"));
  ASSERT_EQ(files.size(), 5U);
  const test::TemporaryFolder folder;
  for (const auto& [name, text] : files) test::write_file(folder / name, text);
  const RuleSet rules = RuleSet::load({folder.path()});
  std::map<std::string, RelationInfo> relations;
  for (const RelationInfo& relation : rules.relations()) relations[relation.name] = relation;
  EXPECT_EQ(relations.at("hangs_over").summary, "a hangs over b with room in between");
  EXPECT_EQ(relations.at("above").tolerances.at("reach"), 0.4);
  EXPECT_EQ(relations.at("above").tolerances.at("enough"), 0.5);
  EXPECT_EQ(rules.features().back().name, "slenderness");
  const std::vector<RuleTestFile> tests = run_rule_tests({folder.path()});
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_TRUE(tests[0].passed()) << as_text(tests);
  EXPECT_EQ(tests[0].cases.size(), 3U);
}

TEST(RulesReference, HasAConstraintThatTellsTheFrontOfAScreenFromItsBack) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "between.lua", snippets(test::read_file(SCENELORE_SOURCE_DIR "/docs/rules.md")).at("keyboard_between.lua"));
  RuleSet rules = RuleSet::load({folder.path()});
  const Scene scene = make_scene(std::vector<MadePlane>{{.center = {0, 0, 0.74}, .length = 1.6, .width = 0.8},
                                                        {.center = {0, 0.25, 1.0}, .normal = {0, -1, 0}, .length = 0.5, .width = 0.35},
                                                        {.center = {0, -0.05, 0.76}, .length = 0.45, .width = 0.15},
                                                        {.center = {0, 0.33, 0.76}, .length = 0.45, .width = 0.1}});
  const std::vector<TupleConstraint> found = rules.constraints(scene, tiny::knowledge({"keyboard", "flat_screen", "table"}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].quantifier, kb::Quantifier::some);
  ASSERT_EQ(found[0].tuples.size(), 1U) << "only the keyboard before the screen";
  EXPECT_EQ(found[0].tuples[0].planes, (std::vector<kb::PlaneId>{scene.ids[2], scene.ids[1], scene.ids[0]}));
  EXPECT_GT(found[0].tuples[0].degree, 0.9);
}

TEST(RulesReference, NamesEveryBuiltInRelationAndFunction) {
  const std::string text = test::read_file(SCENELORE_SOURCE_DIR "/docs/rules.md");
  for (const RelationInfo& relation : RuleSet::load().relations()) {
    EXPECT_NE(text.find("`" + relation.name + "`"), text.npos) << relation.name;
  }
  for (const char* function : {"angle", "gap", "footprint_overlap", "vertical_gap", "plane_distance", "side", "centroid_distance"}) {
    EXPECT_NE(text.find(std::string("`geometry.") + function + "("), text.npos) << function;
  }
}

}  // namespace
}  // namespace scenelore::rules
