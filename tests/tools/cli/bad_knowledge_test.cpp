// Knowledge bases that are broken or odd.
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command_line.hpp"

namespace scenelore::test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;

class BadKnowledge : public CommandLine {
 protected:
  void SetUp() override { ASSERT_EQ(scenelore({"kb", "init", "@kb.gpkg"}).code, 0); }
};

TEST_F(BadKnowledge, IsNeverOverwrittenByKbInit) {
  const std::string before = read_file(folder_ / "kb.gpkg");
  const Finished finished = scenelore({"kb", "init", "@kb.gpkg"});
  EXPECT_EQ(finished.code, 4);
  EXPECT_THAT(finished.err, HasSubstr("kb.gpkg"));
  EXPECT_EQ(read_file(folder_ / "kb.gpkg"), before);
}

TEST_F(BadKnowledge, OfANewerVersionIsRefusedAndLeftAlone) {
  edit("kb.gpkg", "UPDATE scenelore_meta SET schema_version = 99, oldest_reader = 99");
  const std::string before = read_file(folder_ / "kb.gpkg");
  const Finished finished = scenelore({"label", "@kb.gpkg"});
  EXPECT_EQ(finished.code, 4);
  EXPECT_THAT(finished.err, AllOf(HasSubstr("kb.gpkg"), HasSubstr("newer"), HasSubstr("99")));
  EXPECT_EQ(read_file(folder_ / "kb.gpkg"), before);
}

TEST_F(BadKnowledge, ThatIsNoDatabaseIsRefused) {
  write_file(folder_ / "kb.gpkg", std::string(5000, 'x'));
  const Finished finished = scenelore({"query", "@kb.gpkg", "SELECT 1"});
  EXPECT_EQ(finished.code, 4);
  EXPECT_THAT(finished.err, HasSubstr("kb.gpkg"));
}

TEST_F(BadKnowledge, ThatIsMissingIsRefusedAndNotMade) {
  const Finished finished = scenelore({"query", "@none.gpkg", "SELECT 1"});
  EXPECT_EQ(finished.code, 4);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none.gpkg"));
}

TEST_F(BadKnowledge, ThatIsReadOnlyCanBeAskedButNotWritten) {
  make_labelled();
  chmod((folder_ / "office.gpkg").c_str(), 0444);
  chmod(folder_.path().c_str(), 0555);
  // Root may write read-only files, so it asks in the name of somebody else (nobody, 65534), who needs a program to start
  // where he may go.
  const bool root = geteuid() == 0;
  if (root) std::filesystem::copy_file(SCENELORE_BINARY, folder_ / "scenelore");
  const auto as_user = [&](std::vector<std::string> arguments) {
    std::vector<std::string> command = full(std::move(arguments));
    if (!root) return run(command, folder_);
    command[0] = (folder_ / "scenelore").string();
    command.insert(command.begin(), {"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"});
    return run(command, folder_);
  };
  const Finished asked = as_user({"query", "@office.gpkg", "SELECT count(*) > 0 AS some FROM label", "--csv"});
  const Finished labelled = as_user({"label", "@office.gpkg"});
  chmod(folder_.path().c_str(), 0755);
  EXPECT_EQ(asked.code, 0) << asked.err;
  EXPECT_EQ(labelled.code, 4);
  EXPECT_THAT(labelled.err, AllOf(HasSubstr("office.gpkg"), HasSubstr("read-only")));
}

TEST_F(BadKnowledge, CannotBeWrittenByAQuery) {
  for (const char* sql : {"DELETE FROM object_class", "UPDATE setting SET value = 'mean'", "DROP TABLE plane", "ATTACH 'x' AS y",
                          "PRAGMA user_version = 7", "VACUUM INTO 'copy.db'"}) {
    const Finished finished = scenelore({"query", "@kb.gpkg", sql});
    EXPECT_EQ(finished.code, 4) << sql;
  }
  EXPECT_EQ(ask("kb.gpkg", "SELECT count(*) FROM object_class WHERE name = 'floor'"), "1\n");
}

TEST_F(BadKnowledge, WithAClassWithoutFeaturesStillLabels) {
  make_labelled();
  const std::string before = ask("office.gpkg", "SELECT plane_id, class FROM label ORDER BY plane_id");
  edit("office.gpkg", "INSERT INTO object_class (id, name, prior, description, color, fallback) VALUES (50, 'mystery', 0.01, '', '#000000', 0)");
  const Finished finished = scenelore({"label", "@office.gpkg"});
  EXPECT_EQ(finished.code, 0) << finished.err;
  EXPECT_EQ(ask("office.gpkg", "SELECT plane_id, class FROM label ORDER BY plane_id"), before);
}

TEST_F(BadKnowledge, WithSigmaZeroIsRefusedBySqlAlready) {
  EXPECT_THROW(edit("kb.gpkg", "UPDATE class_feature SET sigma = 0"), std::runtime_error);
}

TEST_F(BadKnowledge, WithSigmaZeroForcedInNamesTheRow) {
  make_labelled();
  edit("office.gpkg", "PRAGMA ignore_check_constraints = 1; UPDATE class_feature SET sigma = 0 WHERE class = 'table' AND feature = 'height'");
  const Finished finished = scenelore({"label", "@office.gpkg"});
  EXPECT_EQ(finished.code, 4);
  EXPECT_THAT(finished.err, AllOf(HasSubstr("class_feature"), HasSubstr("table"), HasSubstr("height"), HasSubstr("sigma")));
}

TEST_F(BadKnowledge, NamingAnUnknownRelationSaysWhichOneWasMeant) {
  make_labelled();
  const std::string before = ask("office.gpkg", "SELECT plane_id, class FROM label ORDER BY plane_id");
  edit("office.gpkg", "INSERT INTO class_constraint (name, class, quantifier, relation, other_class, weight, message, enabled) "
                      "VALUES ('odd', 'table', 'some', 'abvoe', 'floor', 1.0, 'x', 1)");
  for (const std::string command : {"label", "rules check"}) {
    const Finished finished = command == "label" ? scenelore({"label", "@office.gpkg"}) : scenelore({"rules", "check", "@office.gpkg"});
    EXPECT_EQ(finished.code, 4) << command;
    EXPECT_THAT(finished.err + finished.out, AllOf(HasSubstr("odd"), HasSubstr("abvoe"), HasSubstr("above"))) << command;
  }
  EXPECT_EQ(ask("office.gpkg", "SELECT plane_id, class FROM label ORDER BY plane_id"), before);
}

TEST_F(BadKnowledge, NamingAnUnknownClassSaysWhichOneWasMeant) {
  make_labelled();
  edit("office.gpkg", "PRAGMA foreign_keys = 0; INSERT INTO class_constraint (name, class, quantifier, relation, other_class, weight, "
                      "message, enabled) VALUES ('odd', 'flat_scren', 'some', 'above', 'table', 1.0, 'x', 1)");
  const Finished finished = scenelore({"label", "@office.gpkg"});
  EXPECT_EQ(finished.code, 4);
  EXPECT_THAT(finished.err, AllOf(HasSubstr("odd"), HasSubstr("flat_scren"), HasSubstr("flat_screen")));
}

}  // namespace
}  // namespace scenelore::test
