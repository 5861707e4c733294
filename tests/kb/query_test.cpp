// SQL from users: what it may do, and what the tables refuse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

#include "rooms.hpp"
#include "scenelore/kb/error.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ask;
using testing::error_of;
using testing::TemporaryFolder;

class Query : public ::testing::Test {
 protected:
  // What a person does with sqlite3: foreign keys are off there unless switched on.
  void shell(const std::string& sql, bool foreign_keys = false) {
    Database database(folder_ / "kb.gpkg", OpenMode::read_write);
    if (!foreign_keys) database.execute("PRAGMA foreign_keys = OFF");
    database.execute(sql);
  }
  std::string knowledge_error() {
    return error_of([&] { (void)base_.knowledge(); });
  }
  TemporaryFolder folder_;
  KnowledgeBase base_ = KnowledgeBase::create(folder_ / "kb.gpkg");
};

TEST_F(Query, GivesNamesTypesAndTextAsTheShellPrintsIt) {
  std::vector<std::string> names;
  std::vector<QueryRow> rows;
  base_.query("SELECT 1 AS one, 0.1 + 0.2 AS sum, 2.0, 'x', NULL, x'00ff', 9e999;  ", [&](const auto& header) { names = header; },
              [&](const QueryRow& row) { rows.push_back(row); });
  EXPECT_EQ(names[0], "one");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_THAT(rows[0].values, ElementsAre("1", "0.3", "2.0", "x", std::nullopt, "00ff", "Inf"));
  EXPECT_THAT(rows[0].types, ElementsAre(ValueType::integer, ValueType::real, ValueType::real, ValueType::text, ValueType::null,
                                         ValueType::blob, ValueType::real));
}

TEST_F(Query, RefusesWhateverWritesAndSaysWhat) {
  const std::vector<std::pair<std::string, std::string>> attempts = {
      {"DELETE FROM truth", "DELETE FROM truth"},          {"INSERT INTO truth VALUES (1, 'table')", "INSERT INTO truth"},
      {"UPDATE setting SET value = 1", "UPDATE setting"},  {"DROP TABLE truth", "schema"},
      {"CREATE TABLE mine (x)", "schema"},                 {"CREATE TEMP VIEW mine AS SELECT 1", "schema"},
      {"ATTACH 'other.db' AS other", "ATTACH"},            {"PRAGMA journal_mode = WAL", "PRAGMA journal_mode"},
      {"PRAGMA user_version = 3", "PRAGMA user_version"},  {"PRAGMA writable_schema = 1", "PRAGMA writable_schema"},
      {"SELECT load_extension('x')", "load_extension"},    {"VACUUM", "refused"},
      {"BEGIN", "transaction"},                            {"WITH a AS (SELECT 1) DELETE FROM truth", "DELETE FROM truth"},
      {"UPDATE sqlite_master SET sql = ''", "sqlite_master"}, {"REINDEX", "refused"},
      {"VACUUM INTO 'copy.db'", "refused"}};
  for (const auto& [sql, reason] : attempts) {
    EXPECT_THAT(error_of([&, &text = sql] { ask(base_, text); }), AllOf(HasSubstr("kb.gpkg"), HasSubstr(reason))) << sql;
  }
  EXPECT_THAT(error_of([&] { ask(base_, "SELECT 1; DELETE FROM truth"); }), HasSubstr("one SQL statement at a time"));
  EXPECT_THAT(error_of([&] { ask(base_, "SELEC 1"); }), HasSubstr("syntax error"));
  EXPECT_THAT(ask(base_, "SELECT count(*) FROM object_class"), ElementsAre("14"));
}

TEST_F(Query, AllowsTableValuedFunctionsAndReadingPragmas) {
  EXPECT_THAT(ask(base_, "SELECT value FROM json_each('[1, 2]')"), ElementsAre("1", "2"));
  EXPECT_THAT(ask(base_, "SELECT count(*) FROM pragma_table_info('truth')"), ElementsAre("2"));
  EXPECT_THAT(ask(base_, "PRAGMA integrity_check"), ElementsAre("ok"));
  EXPECT_THAT(ask(base_, "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n LIMIT 3) SELECT sum(i) FROM n"), ElementsAre("6"));
}

TEST_F(Query, StopsAtItsLimitsAndTheBaseStaysUsable) {
  const std::string endless = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT count(*) FROM n";
  const auto run = [&](const QueryLimits& limits) {
    return error_of([&] { base_.query(endless, [](const auto&) {}, [](const auto&) {}, limits); });
  };
  EXPECT_THAT(run({.seconds = 0.05}), HasSubstr("longer than the limit"));
  const std::atomic<bool> interrupt = true;
  EXPECT_THAT(run({.interrupt = &interrupt}), HasSubstr("interrupted"));
  EXPECT_EQ(base_.knowledge().classes.size(), 14U);
}

TEST_F(Query, PlainInsertsOfAPersonAddAClass) {
  shell("INSERT INTO object_class (id, name, prior) VALUES (20, 'sofa', 0.01);"
        "INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('sofa', 'height', 0.42, 0.05), ('sofa', 'length', 0.6, 0.2);"
        "INSERT INTO class_constraint (name, class, quantifier, relation, other_class, weight) VALUES ('sofa_level', 'sofa', 'every', 'parallel', 'floor', 2);"
        "UPDATE setting SET value = 'mean' WHERE key = 'combination';", true);
  const Knowledge k = base_.knowledge();
  EXPECT_EQ(k.classes.back().name, "sofa");
  EXPECT_EQ(k.constraints.back().name, "sofa_level");
  EXPECT_EQ(k.setting("combination", ""), "mean");
}

TEST_F(Query, ChecksOfTheTablesRefuseNonsense) {
  for (const char* const sql : {
           "UPDATE class_feature SET sigma = 0", "UPDATE object_class SET prior = 0", "UPDATE object_class SET color = 'red'",
           "UPDATE feature SET weight = -1", "UPDATE feature SET low = 0 WHERE scale = 'log'", "UPDATE feature SET scale = 'cubic'",
           "UPDATE object_class SET fallback = 1", "INSERT INTO object_class (name) VALUES ('table')",
           "INSERT INTO class_density (class, feature, low, high, density) VALUES ('table', 'height', 1, 1, 0.5)",
           "INSERT INTO class_density (class, feature, low, high, density) VALUES ('table', 'height', 0, 1, -0.5)",
           "UPDATE class_constraint SET weight = 0", "UPDATE class_constraint SET quantifier = 'most'",
           "UPDATE class_constraint SET count = -1 WHERE count IS NOT NULL", "UPDATE class_constraint SET count = 2 WHERE quantifier = 'some'",
           "UPDATE class_constraint SET relation = NULL WHERE quantifier = 'some'", "UPDATE class_constraint SET enabled = 2",
           "UPDATE setting SET value = 'sum' WHERE key = 'combination'", "UPDATE setting SET value = '3' WHERE key = 'floor_threshold'",
           "INSERT INTO truth VALUES (99, 'table')", "INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('tabel', 'height', 1, 1)"}) {
    EXPECT_THAT(error_of([&, sql] { shell(sql, true); }), HasSubstr("constraint")) << sql;
  }
}

TEST_F(Query, RowsThatNoForeignKeyCheckedAreFoundAndNamed) {
  shell("INSERT INTO class_constraint (id, name, class, quantifier, relation, other_class) VALUES (12345, 'screen_over_tables', 'flat_scren', 'some', 'above', 'table')");
  EXPECT_THAT(knowledge_error(), AllOf(HasSubstr("kb.gpkg"), HasSubstr("class_constraint row 12345 'screen_over_tables': class 'flat_scren' "
                                                                        "does not exist; did you mean 'flat_screen'?")));
  shell("DELETE FROM class_constraint WHERE id = 12345; INSERT INTO class_feature (class, feature, mean, sigma) VALUES ('table', 'heigt', 1, 1)");
  EXPECT_THAT(knowledge_error(), HasSubstr("class_feature row ('table', 'heigt'): feature 'heigt' does not exist; did you mean 'height'?"));
  shell("DELETE FROM class_feature WHERE feature = 'heigt'; PRAGMA ignore_check_constraints = 1; UPDATE class_feature SET sigma = 0 WHERE class = 'wall' AND feature = 'height'");
  EXPECT_THAT(knowledge_error(), HasSubstr("class_feature row ('wall', 'height'): sigma must be above 0"));
  shell("UPDATE class_feature SET sigma = 1 WHERE sigma = 0; UPDATE object_class SET fallback = 0");
  EXPECT_THAT(knowledge_error(), HasSubstr("exactly one class must have fallback = 1"));
}

TEST_F(Query, OverlappingBinsAreRefused) {
  shell("DELETE FROM class_density; INSERT INTO class_density (class, feature, low, high, density) VALUES ('table', 'height', 0, 1, 0.5), ('table', 'height', 0.9, 2, 0.5)");
  EXPECT_THAT(knowledge_error(), AllOf(HasSubstr("class_density row ('table', 'height', low 0.9"), HasSubstr("overlaps")));
}

TEST_F(Query, KindsThatCannotBeAreNamed) {
  shell("INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES ('table', 99, 'height', 1, 1)");
  EXPECT_THAT(knowledge_error(), AllOf(HasSubstr("kind_feature row ('table', 99, 'height')"), HasSubstr("no such row in class_kind")));
  shell("DELETE FROM kind_feature WHERE kind = 99; DELETE FROM class_kind WHERE class = 'table'");
  const Knowledge read = base_.knowledge();
  for (const ClassKind& kind : read.kinds) EXPECT_NE(kind.object_class, "table");  // what the kinds said of features went with them, foreign keys or not
  shell("INSERT INTO class_kind (class, kind, share) VALUES ('table', 1, 0.7), ('table', 2, 0.4)");
  EXPECT_THAT(knowledge_error(), AllOf(HasSubstr("class_kind row ('table', 2)"), HasSubstr("add up to more than 1")));
  shell("UPDATE class_kind SET share = 0.3 WHERE class = 'table' AND kind = 2; INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES ('table', 1, 'heigt', 1, 1)");
  EXPECT_THAT(knowledge_error(), HasSubstr("kind_feature row ('table', 1, 'heigt'): feature 'heigt' does not exist; did you mean 'height'?"));
  shell("DELETE FROM kind_feature WHERE class = 'table'; INSERT INTO kind_feature (class, kind, feature, mean, sigma) VALUES ('table', 1, 'height', 1, 1)");
  shell("PRAGMA ignore_check_constraints = 1; UPDATE kind_feature SET sigma = 0 WHERE class = 'table'");
  EXPECT_THAT(knowledge_error(), HasSubstr("kind_feature row ('table', 1, 'height'): sigma must be above 0"));
}

TEST_F(Query, AWrongSettingIsNamed) {
  shell("PRAGMA ignore_check_constraints = 1; UPDATE setting SET value = 'lots' WHERE key = 'outlier_share'");
  EXPECT_THAT(knowledge_error(), HasSubstr("setting row 'outlier_share': 'lots' must be a number from 0.0 to 0.5"));
}

TEST_F(Query, KnowledgePacksMayChangeKnowledgeOnlyAndAllOrNothing) {
  const std::string before = base_.knowledge_hash();
  EXPECT_THAT(error_of([&] { base_.apply_knowledge("DELETE FROM class_feature; DELETE FROM scan;", "kitchen.sql"); }),
              AllOf(HasSubstr("kitchen.sql"), HasSubstr("DELETE FROM scan is refused")));
  EXPECT_THAT(error_of([&] { base_.apply_knowledge("UPDATE object_class SET fallback = 0;", "kitchen.sql"); }),
              AllOf(HasSubstr("kitchen.sql"), HasSubstr("fallback")));
  EXPECT_THAT(error_of([&] { base_.apply_knowledge("UPDATE object_class SET prior = 0.5; COMMIT;", "kitchen.sql"); }), HasSubstr("transaction"));
  EXPECT_EQ(base_.knowledge_hash(), before);
  base_.apply_knowledge("INSERT INTO object_class (id, name) VALUES (30, 'sink'); -- a comment at the end", "kitchen.sql");
  EXPECT_EQ(base_.knowledge().class_index("sink"), 14);
}

TEST_F(Query, TheHashFollowsContentAndNothingElse) {
  const std::string before = base_.knowledge_hash();
  EXPECT_EQ(before, KnowledgeBase::create(folder_ / "again.gpkg").knowledge_hash());
  const testing::Room room = testing::room();
  base_.store_scan(room.scan, room.planes, room.plane_of_point);
  EXPECT_EQ(base_.knowledge_hash(), before);
  shell("UPDATE class_feature SET sigma = sigma + 1e-12 WHERE class = 'wall' AND feature = 'height'");
  EXPECT_NE(base_.knowledge_hash(), before);
}

}  // namespace
}  // namespace scenelore::kb
