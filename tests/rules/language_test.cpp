// The files for editors and luacheck say what the sandbox really offers.
#include <gtest/gtest.h>

#include <regex>

#include "scenelore/rules/error.hpp"
#include "scenelore/rules/language.hpp"
#include "scenelore/rules/testing.hpp"
#include "temporary_folder.hpp"

namespace scenelore::rules {
namespace {

/// What a rule file finds in a table, as "name name …": told by an error, the only way out.
std::string keys_seen(const std::string& table) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "r.lua", "local names = ''\nfor key in pairs(" + table + ") do names = names .. key .. ' ' end\nerror(names)");
  try {
    (void)RuleSet::load({folder.path()});
  } catch (const Error& error) {
    const std::string text = error.what();
    return text.substr(text.find("r.lua:3: ") + 9);
  }
  return "";
}

TEST(RuleLanguage, TellsLuacheckEverythingThatASandboxOffers) {
  const std::string text = language_luacheckrc();
  std::size_t found = 0;
  for (const char* table : {"_G", "math", "string", "table", "utf8", "geometry"}) {
    const std::string keys = keys_seen(table);
    const std::regex word("\\S+");
    for (std::sregex_iterator key(keys.begin(), keys.end(), word), end; key != end; ++key) {
      EXPECT_TRUE(text.find('"' + key->str() + '"') != text.npos || text.find("  " + key->str() + " = {") != text.npos) << table << "." << key->str();
      ++found;
    }
  }
  EXPECT_GT(found, 60U);
}

TEST(RuleLanguage, TellsLuacheckNothingThatASandboxLacks) {
  const std::string all = keys_seen("_G") + " " + keys_seen("math") + " " + keys_seen("string") + " " + keys_seen("table") + " " +
                          keys_seen("utf8") + " " + keys_seen("geometry") + " flat upright case between holds fails value ";
  const std::string text = language_luacheckrc(), globals = text.substr(text.find("read_globals"));
  const std::regex quoted("\"([A-Za-z_]\\w*)\"");
  for (std::sregex_iterator word(globals.begin(), globals.end(), quoted), end; word != end; ++word) {
    const std::string name = (*word)[1];
    EXPECT_TRUE(name == "lua54" || (" " + all).find(" " + name + " ") != all.npos) << name;
  }
}

TEST(RuleLanguage, IsWhatTheRepositorysOwnLuacheckrcSays) {
  EXPECT_EQ(test::read_file(SCENELORE_SOURCE_DIR "/.luacheckrc"), language_luacheckrc())
      << "scenelore rules doc --format luacheckrc > .luacheckrc";
}

TEST(RuleLanguage, NamesEachFieldAndFunctionForEditors) {
  const std::string meta = language_meta();
  EXPECT_EQ(meta.rfind("---@meta\n", 0), 0U);
  for (const char* part : {"---@field tilt_deg number degrees", "---@param high number?\n---@return number\nfunction geometry.gap(a, b, low, high) end",
                           "function geometry.footprint_overlap(a, b, reach, low, high) end", "function falloff(value, full, none) end",
                           "function expect.holds(a, b) end"}) {
    EXPECT_NE(meta.find(part), meta.npos) << part;
  }
}

TEST(NewRules, AreInOrderAndPassTheirTests) {
  const test::TemporaryFolder folder;
  const auto write = [&](const std::string& name, const NewRule& made) {
    test::write_file(folder / (name + ".lua"), made.rule);
    test::write_file(folder / (name + "_test.lua"), made.test);
  };
  write("fresh", new_relation("fresh"));
  write("wider", new_variant("wider", "above"));
  write("ratio", new_feature("ratio"));
  const std::vector<RuleTestFile> tests = run_rule_tests({folder.path()});
  EXPECT_EQ(tests.size(), 3U);
  for (const RuleTestFile& file : tests) EXPECT_TRUE(file.passed()) << as_text(tests);
  const RuleSet rules = RuleSet::load({folder.path()});
  EXPECT_NE(describe(rules.relations()[0], rules.text("above")).find("a lies over b"), std::string::npos);
  EXPECT_THROW((void)new_variant("x", "abov"), Error);
}

TEST(RuleFolders, LeaveOutWhatEditorsKeepInHiddenFolders) {
  const test::TemporaryFolder folder;
  test::write_file(folder / ".scenelore/meta.lua", language_meta());
  EXPECT_NO_THROW((void)RuleSet::load({folder.path()}));
}

TEST(RuleErrors, TellTheCallsThatLedThere) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "r.lua",
                   "local function deep(p)\n  local x = p.nothing\n  return x\nend\nlocal x = deep({}) + 1\nreturn relation {}");
  try {
    (void)RuleSet::load({folder.path()});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.traceback()), "  r.lua:5: in the function declared there\n");
  }
}

}  // namespace
}  // namespace scenelore::rules
