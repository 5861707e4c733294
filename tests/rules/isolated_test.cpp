// The same answers from a process that can do no harm.
#include "scenelore/rules/isolated.hpp"

#include <gtest/gtest.h>

#include "scenelore/rules/error.hpp"
#include "temporary_folder.hpp"
#include "tiny.hpp"

namespace scenelore::rules {
namespace {

kb::Knowledge stacked() {
  kb::Knowledge knowledge = tiny::knowledge({"table", "lamp"});
  knowledge.constraints = {tiny::row(1, "lamp", kb::Quantifier::some, "above", "table", 2.0),
                           tiny::row(2, "lamp", kb::Quantifier::no, "near", "lamp", 1.0)};
  return knowledge;
}

std::string error_of(const std::string& body, const Budget& budget, const Isolation& limits) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "near.lua", "return relation { name = 'near', extends = 'near', degree = function(a, b)\n" + body + "\nend }");
  try {
    (void)answer_isolated({folder.path()}, budget, stacked(), tiny::scene(3), {}, limits);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(IsolatedRules, AnswerAsTheyDoInThisProcess) {
  const kb::Knowledge knowledge = stacked();
  const Scene scene = tiny::scene(5);
  const test::TemporaryFolder folder;
  test::write_file(folder / "near.lua", "return relation { name = 'near', extends = 'near', full = 0.6 }");
  const RuleAnswers there = answer_isolated({folder.path()}, {}, knowledge, scene, {});
  Scene own = scene;
  RuleSet rules = RuleSet::load({folder.path()});
  const RuleAnswers here = answer(rules, knowledge, own, {});
  EXPECT_EQ(there.hash, here.hash);
  EXPECT_EQ(there.table.names, here.table.names);
  EXPECT_EQ(there.features.size(), here.features.size());
  ASSERT_EQ(there.facts.facts.size(), here.facts.facts.size());
  for (std::size_t i = 0; i < here.facts.facts.size(); ++i) {
    const kb::RelationFact &f = here.facts.facts[i], &g = there.facts.facts[i];
    EXPECT_EQ(std::tie(f.relation, f.a, f.b, f.degree), std::tie(g.relation, g.a, g.b, g.degree));
  }
  EXPECT_EQ(there.facts.asked.at("near").inputs_sha256, here.facts.asked.at("near").inputs_sha256);
  EXPECT_EQ(there.facts.reach.at("above").within_plan, here.facts.reach.at("above").within_plan);
}

TEST(IsolatedRules, HandOnTheErrorOfARuleWithItsPlace) {
  EXPECT_NE(error_of("return a.nothing", {}, {}).find("near.lua:2: a plane has no 'nothing'"), std::string::npos);
}

TEST(IsolatedRules, AreStoppedByTheProcessLimitsWhereTheSandboxWouldLetThemRun) {
  Budget wide;
  wide.instructions = std::int64_t{1} << 60;
  wide.time = wide.total = std::chrono::hours(1);
  EXPECT_NE(error_of("while true do end", wide, {.cpu_seconds = 1}).find("processor time"), std::string::npos);
}

TEST(IsolatedRules, CannotUseMoreMemoryThanTheProcessMay) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the address sanitizer needs more address space than any limit";
#endif
  Budget wide;
  wide.memory_bytes = std::size_t{1} << 40;
  const std::string error = error_of("local t = {} while true do t[#t + 1] = { 1, 2, 3 } end", wide, {.memory_bytes = std::size_t{256} << 20});
  EXPECT_NE(error, "no error");
  EXPECT_NE(error.find("near.lua"), std::string::npos) << error;
}

TEST(IsolatedRules, RunTheirTestsAsInThisProcess) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "near.lua", "return relation { name = 'near', extends = 'near' }");
  test::write_file(folder / "near_test.lua", "case('good', function() end)\ncase('bad', function() error('so it is', 0) end)");
  EXPECT_EQ(as_text(run_rule_tests_isolated({folder.path()}, {})), as_text(run_rule_tests({folder.path()})));
  Budget wide;
  wide.instructions = std::int64_t{1} << 60;
  wide.time = wide.total = std::chrono::hours(1);
  test::write_file(folder / "near_test.lua", "case('endless', function() while true do end end)");
  EXPECT_THROW((void)run_rule_tests_isolated({folder.path()}, wide, {.cpu_seconds = 1}), Error);
}

}  // namespace
}  // namespace scenelore::rules
