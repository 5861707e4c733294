// Each shipped relation has a picture in docs/, drawn from the planes of its own tests.
#include "export/rule_picture.hpp"

#include <gtest/gtest.h>

#include "temporary_folder.hpp"

namespace scenelore::exports {
namespace {

TEST(RulePicture, OfEachBuiltInRelationIsTheOneInTheDocs) {
  const std::string folder = SCENELORE_SOURCE_DIR "/docs/";
  const std::string page = test::read_file(folder + "rules.md");
  int relations = 0;
  for (const rules::RuleTestFile& tests : rules::run_rule_tests()) {
    const std::string picture = rule_picture(tests);
    if (tests.file.find("/features/") != std::string::npos) {
      EXPECT_EQ(picture, "") << tests.file;
      continue;
    }
    ++relations;
    EXPECT_EQ(test::read_file(folder + "images/rules/" + tests.rule + ".svg"), picture)
        << "scenelore rules doc " << tests.rule << " --format svg > docs/images/rules/" << tests.rule << ".svg";
    EXPECT_NE(page.find("images/rules/" + tests.rule + ".svg"), page.npos) << tests.rule;
  }
  EXPECT_EQ(relations, 15);
}

TEST(RulePicture, ShowsBothPlanesAndTheDegree) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "far.lua", "return relation { name = 'far', extends = 'near' }");
  test::write_file(folder / "far_test.lua",
                   "case('a < b & so on', function()\n  expect.between(0, 1, flat { x = 0, y = 0, z = 0, length = 1, width = 1 },\n"
                   "    flat { x = 0, y = 0, z = 0.65, length = 1, width = 1 })\nend)");
  const std::string picture = rule_picture(rules::run_rule_tests({folder.path()}).at(0));
  EXPECT_NE(picture.find("a &lt; b &amp; so on"), picture.npos);
  EXPECT_NE(picture.find("degree 0.5"), picture.npos);  // 0.65 m lies midway between 0.3 and 1
  std::size_t outlines = 0;
  for (std::size_t at = 0; (at = picture.find("<path ", at)) != picture.npos; ++at) ++outlines;
  EXPECT_EQ(outlines, 4U);  // two planes in two views
}

}  // namespace
}  // namespace scenelore::exports
