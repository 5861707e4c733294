// The snippets of docs/rules.md, as a newcomer would type them.
#include <gtest/gtest.h>

#include <map>

#include "scenelore/rules/rule_set.hpp"
#include "scenelore/rules/testing.hpp"
#include "temporary_folder.hpp"

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
