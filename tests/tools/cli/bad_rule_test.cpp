// Rule files that are broken or hostile: an error that names file and line; the labels from before stay.
#include <gmock/gmock.h>

#include "command_line.hpp"

namespace scenelore::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class BadRule : public CommandLine {
 protected:
  void SetUp() override {
    make_labelled();
    before_ = ask("office.gpkg", "SELECT plane_id, class, probability FROM label ORDER BY plane_id");
  }

  /// Labels with a relation file `odd.lua` of this text that a constraint row uses.
  Finished label_with(const std::string& lua) {
    write_file(folder_ / "rules/odd.lua", lua);
    edit("office.gpkg", "INSERT INTO class_constraint (name, class, quantifier, relation, other_class, weight, message, enabled) "
                        "VALUES ('odd_row', 'table', 'some', 'odd', 'floor', 1.0, 'x', 1)");
    const Finished finished = scenelore({"label", "@office.gpkg"});
    EXPECT_EQ(ask("office.gpkg", "SELECT plane_id, class, probability FROM label ORDER BY plane_id"), before_);
    return finished;
  }

  std::string before_;
};

TEST_F(BadRule, WithASyntaxErrorIsNamedWithItsLine) {
  const Finished finished = label_with("return relation {\n  api = 1,\n  name = \"odd\" summary\n}\n");
  EXPECT_EQ(finished.code, 4);
  EXPECT_THAT(finished.err, HasSubstr("odd.lua:3"));
}

TEST_F(BadRule, ThatThrowsIsNamedWithItsLine) {
  const Finished finished = label_with(
      "return relation {\n  api = 1, name = \"odd\", summary = \"throws\", within = 5,\n"
      "  degree = function(a, b)\n    return a.height + nil\n  end,\n}\n");
  EXPECT_EQ(finished.code, 4);
  EXPECT_THAT(finished.err, HasSubstr("odd.lua:4"));
}

TEST_F(BadRule, ThatLoopsForEverIsStopped) {
  const Finished finished = label_with(
      "return relation {\n  api = 1, name = \"odd\", summary = \"loops\", within = 5,\n"
      "  degree = function(a, b)\n    while true do end\n  end,\n}\n");
  EXPECT_EQ(finished.code, 4);
  EXPECT_THAT(finished.err, HasSubstr("odd.lua:4"));
}

TEST_F(BadRule, WithAnUnknownFieldIsAskedWhetherAnotherWasMeant) {
  const Finished finished = label_with(
      "return relation {\n  api = 1, name = \"odd\", summary = \"misspelt\", withn = 5,\n  degree = function(a, b) return 1 end,\n}\n");
  EXPECT_EQ(finished.code, 4);
  EXPECT_THAT(finished.err, AllOf(HasSubstr("odd.lua"), HasSubstr("withn"), HasSubstr("within")));
}

}  // namespace
}  // namespace scenelore::test
