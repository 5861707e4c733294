// The tests beside the shipped rules, run in the real sandbox; and what a failing one looks like.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scenelore/rules/testing.hpp"
#include "temporary_folder.hpp"

namespace scenelore::rules {
namespace {

TEST(ShippedRules, PassTheTestsBesideThem) {
  const std::vector<RuleTestFile> files = run_rule_tests();
  EXPECT_EQ(files.size(), 18U);
  for (const RuleTestFile& file : files) EXPECT_TRUE(file.passed()) << as_text({file});
}

TEST(ShippedRules, AllHaveTests) {
  std::size_t rules = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SCENELORE_SOURCE_DIR "/rules")) {
    const std::string name = entry.path().string();
    if (!name.ends_with(".lua") || name.ends_with("_test.lua") || name.find("/rules/lua/") != name.npos) continue;
    ++rules;
    EXPECT_TRUE(std::filesystem::exists(name.substr(0, name.size() - 4) + "_test.lua")) << name;
  }
  EXPECT_EQ(rules, 18U);
}

TEST(RuleTests, SayWhatFailedAndWhere) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "high.lua", "return relation { api = 1, name = 'high', summary = 's', degree = function(a) return a.z > 1 end }\n");
  test::write_file(folder / "high_test.lua", "case('two metres is high', function() expect.holds(flat { x = 0, y = 0, z = 2, length = 1, width = 1 }, "
               "flat { x = 0, y = 0, z = 0, length = 1, width = 1 }) end)\n"
               "case('so is one', function()\n"
               "  local a = flat { x = 0, y = 0, z = 1, length = 1, width = 1 }\n"
               "  expect.holds(a, a)\n"
               "end)\n"
               "case('a typo', function() flat { x = 0, y = 0, z = 1, lenght = 1, width = 1 } end)\n");
  test::write_file(folder / "lonely_test.lua", "case('nothing', function() end)\n");
  const std::vector<RuleTestFile> files = run_rule_tests({folder.path()});
  ASSERT_EQ(files.size(), 2U);
  const std::string file = (folder / "high_test.lua").string();
  ASSERT_EQ(files[0].cases.size(), 3U);
  EXPECT_EQ(files[0].cases[0].failure, "");
  EXPECT_EQ(files[0].cases[1].failure, file + ":4: got 0, expected that it holds (0.9 or more)");
  EXPECT_EQ(files[0].cases[2].failure,
            file + ":6: a plane has no field 'lenght'; it has x, y, z, length, width, facing, lean, turn, rmse");
  EXPECT_EQ(files[1].failure, (folder / "lonely_test.lua").string() + ": there is no " + (folder / "lonely.lua").string() + " beside it to test");
  EXPECT_EQ(as_tap({files[0]}).substr(0, 81),
            "TAP version 13\n1..3\nok 1 - high: two metres is high\nnot ok 2 - high: so is one\n# ");
}

}  // namespace
}  // namespace scenelore::rules
