// What a person who writes rules does at the shell.
#include <gmock/gmock.h>

#include <signal.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "../export/spark_dsg_reader.hpp"
#include "command_line.hpp"

namespace scenelore::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class RuleAuthor : public CommandLine {};

TEST_F(RuleAuthor, StartsARuleThatIsInOrder) {
  const std::string folder = "@rules";
  Finished made = scenelore({"rules", "new", "leans_on", "--in", folder});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(scenelore({"rules", "new", "further", "--in", folder, "--extends", "near"}).code, 0);
  for (const char* file : {"leans_on.lua", "leans_on_test.lua", "further.lua", ".luarc.json", ".luacheckrc", ".scenelore/meta.lua"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / "rules" / file)) << file;
  }
  const Finished tested = scenelore({"rules", "test", folder});
  EXPECT_EQ(tested.code, 0) << tested.out;
  EXPECT_THAT(tested.out, HasSubstr("all good"));
  EXPECT_EQ(scenelore({"rules", "new", "leans_on", "--in", folder}).code, 2);  // never overwritten
  EXPECT_EQ(scenelore({"rules", "new", "1st", "--in", folder}).code, 2);
  const Finished unknown = scenelore({"rules", "new", "x", "--in", folder, "--extends", "abov"});
  EXPECT_EQ(unknown.code, 4);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean 'above'"));
}

TEST_F(RuleAuthor, IsToldWhichTestFails) {
  write_file(folder_ / "rules/odd.lua", "return relation { name = 'odd', extends = 'near' }");
  write_file(folder_ / "rules/odd_test.lua",
             "case('far is near', function()\n  expect.holds(flat { x = 0, y = 0, z = 0, length = 1, width = 1 },\n"
             "    flat { x = 9, y = 0, z = 0, length = 1, width = 1 })\nend)");
  const Finished text = scenelore({"rules", "test", "@rules"}), tap = scenelore({"rules", "test", "@rules", "--tap"});
  EXPECT_EQ(text.code, 1);
  EXPECT_THAT(text.out, AllOf(HasSubstr("FAILED"), HasSubstr("odd_test.lua:2"), HasSubstr("far is near")));
  EXPECT_EQ(tap.code, 1);
  EXPECT_THAT(tap.out, AllOf(HasSubstr("TAP version 13\n1..1\n"), HasSubstr("not ok 1 - odd: far is near")));
  const json out = json::parse(scenelore({"rules", "test", "@rules", "--json"}).out);
  EXPECT_FALSE(out.at(0).at("passed"));
}

TEST_F(RuleAuthor, SetsTheBudget) {
  make_labelled();
  write_file(folder_ / "rules/near.lua",
             "return relation { name = 'near', extends = 'near', degree = function() local n = 0\n"
             "  for i = 1, 50000 do n = n + i end return 1 end }");
  const Finished small = scenelore({"label", "@office.gpkg", "--rule-instructions", "20000"});
  EXPECT_EQ(small.code, 4);
  EXPECT_THAT(small.err, AllOf(HasSubstr("near.lua"), HasSubstr("20000 instructions")));
  EXPECT_EQ(scenelore({"label", "@office.gpkg"}).code, 0);
}

TEST_F(RuleAuthor, ReadsWhatARelationMeans) {
  const Finished one = scenelore({"rules", "doc", "above"});
  EXPECT_EQ(one.code, 0);
  EXPECT_THAT(one.out, AllOf(HasSubstr("above: a lies over b"), HasSubstr("tolerance reach = 0.25"), Not(HasSubstr("touching"))));
  const Finished unknown = scenelore({"rules", "doc", "abov"});
  EXPECT_EQ(unknown.code, 4);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean 'above'"));
  EXPECT_THAT(scenelore({"rules", "doc", "--format", "meta"}).out, HasSubstr("---@meta"));
  EXPECT_TRUE(json::accept(scenelore({"rules", "doc", "--format", "luarc"}).out));
}

TEST_F(RuleAuthor, SeesWhatRulesCostAndDecide) {
  make_labelled();
  const Finished finished = scenelore({"rules", "profile", "@office.gpkg", "--json"});
  ASSERT_EQ(finished.code, 0) << finished.err;
  const json out = json::parse(finished.out);
  EXPECT_GT(out.at("relations").size(), 5U);
  EXPECT_GT(out.at("relations").at(0).at("asked"), 0);
  EXPECT_GT(out.at("constraints").size(), 20U);
  EXPECT_THAT(scenelore({"rules", "profile", "@office.gpkg"}).out, HasSubstr("never decided anything in these scans"));
}

TEST_F(RuleAuthor, ExportsRelationsInThreeFormats) {
  make_labelled();
  const json plain = json::parse(scenelore({"relations", "@office.gpkg", "--json"}).out);
  const std::string stored = ask("office.gpkg", "SELECT count(*) FROM relation_fact");
  EXPECT_EQ(plain.at("relations").size(), std::stoul(stored));
  EXPECT_EQ(plain.at("planes").size(), std::stoul(ask("office.gpkg", "SELECT count(*) FROM plane")));

  const std::string graphml = scenelore({"relations", "@office.gpkg", "--graphml"}).out;
  const auto count = [](const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != text.npos; ++at) ++n;
    return n;
  };
  EXPECT_EQ(count(graphml, "<edge "), std::stoul(stored));
  EXPECT_EQ(count(graphml, "<node "), plain.at("planes").size());

  const SparkGraph graph = SparkDsgReader::read(json::parse(scenelore({"relations", "@office.gpkg", "--dsg"}).out));
  EXPECT_EQ(graph.scan, "office");
  EXPECT_EQ(graph.nodes.size(), plain.at("planes").size());
  EXPECT_EQ(graph.facts.size(), plain.at("relations").size());
  EXPECT_EQ(graph.weights.size(), std::stoul(ask("office.gpkg", "SELECT count(DISTINCT min(a, b) || ' ' || max(a, b)) FROM relation_fact")));
  EXPECT_EQ(graph.class_names.size(), std::stoul(ask("office.gpkg", "SELECT count(*) FROM object_class")));
  for (const json& plane : plain.at("planes")) {
    const SparkNode& node = graph.nodes.at(plane.at("plane").get<std::uint64_t>() | std::uint64_t{'O'} << 56);
    const auto v = [&](const char* field) { return Eigen::Vector3d(plane.at(field)[0], plane.at(field)[1], plane.at(field)[2]); };
    EXPECT_EQ(node.name, plane.at("class"));
    EXPECT_EQ(graph.class_names.at(node.label), node.name);
    EXPECT_EQ(node.position, v("centroid"));
    EXPECT_NEAR(std::abs((node.rotation * Eigen::Vector3d::UnitZ()).dot(v("normal"))), 1, 1e-9);
    EXPECT_TRUE(node.box.contains(node.position.cast<float>()));
  }
  EXPECT_EQ(scenelore({"relations", "@office.gpkg", "--json", "--dsg"}).code, 2);
}

TEST_F(RuleAuthor, LearnsWhatContradicts) {
  make_labelled();
  EXPECT_EQ(scenelore({"conflict", "@office.gpkg"}).code, 0);
  edit("office.gpkg",
       "INSERT INTO class_constraint (name, class, quantifier, count) VALUES ('no_doors', 'door', 'at_most', 0);"
       "INSERT INTO truth VALUES (1, 'door')");
  const Finished finished = scenelore({"conflict", "@office.gpkg", "--json"});
  EXPECT_EQ(finished.code, 1) << finished.err;
  const json out = json::parse(finished.out).at(0);
  EXPECT_EQ(out.at("cannot_hold_together").size(), 2U);
  EXPECT_THAT(scenelore({"conflict", "@office.gpkg"}).out, AllOf(HasSubstr("'no_doors'"), HasSubstr("plane 1 is door because a truth row")));
}

TEST_F(RuleAuthor, AsksWhyInNumbers) {
  make_labelled();
  const std::string table = ask("office.gpkg", "SELECT min(plane) FROM labelled_plane WHERE class = 'table'");
  const json out = json::parse(scenelore({"why", "@office.gpkg", std::to_string(std::stoi(table)), "--json"}).out);
  EXPECT_GT(out.at("features").size(), 5U);
  for (const json& feature : out.at("features")) {
    EXPECT_TRUE(feature.at("value").is_number());
    EXPECT_TRUE(feature.at("contribution").is_number());
  }
  // The reason table holds the same: one row a feature, with the numbers.
  EXPECT_EQ(ask("office.gpkg", "SELECT count(*) FROM reason WHERE kind = 'feature' AND value IS NOT NULL AND against IS NOT NULL AND plane_id = " + table),
            std::to_string(out.at("features").size()) + "\n");
  for (const json& reason : out.at("reasons")) EXPECT_FALSE(reason.at("sentence").get<std::string>().empty());
  EXPECT_EQ(ask("office.gpkg", "SELECT count(*) FROM label WHERE plane_id NOT IN (SELECT plane_id FROM reason WHERE kind = 'evidence')"), "0\n");
  const json not_floor = json::parse(scenelore({"why", "@office.gpkg", std::to_string(std::stoi(table)), "floor", "--json"}).out);
  EXPECT_TRUE(not_floor.at("possible"));
  EXPECT_FALSE(not_floor.at("violated").empty());
  EXPECT_GT(not_floor.at("violated").at(0).at("amount"), 0);
  // Which features speak against it, strongest first.
  ASSERT_EQ(not_floor.at("features").size(), out.at("features").size());
  EXPECT_EQ(not_floor.at("features").at(0).at("against"), "table");
  EXPECT_LT(not_floor.at("features").at(0).at("contribution"), 0);
  for (std::size_t i = 1; i < not_floor.at("features").size(); ++i) {
    EXPECT_LE(std::abs(not_floor.at("features").at(i).at("contribution").get<double>()),
              std::abs(not_floor.at("features").at(i - 1).at("contribution").get<double>()));
  }
}

TEST_F(RuleAuthor, IsToldWhatElseACorrectionChanged) {
  make_labelled();
  const int table = std::stoi(ask("office.gpkg", "SELECT plane FROM labelled_plane WHERE class = 'table' ORDER BY area_m2 DESC LIMIT 1"));
  edit("office.gpkg", "UPDATE labelled_plane SET class = 'cabinet' WHERE plane = " + std::to_string(table));
  const Finished once = scenelore({"label", "@office.gpkg"}), again = scenelore({"label", "@office.gpkg"});
  EXPECT_EQ(once.code, 0);
  EXPECT_THAT(once.out, HasSubstr("corrected by a person: plane " + std::to_string(table) + " is cabinet"));
  EXPECT_THAT(again.out, AllOf(Not(HasSubstr("corrected")), HasSubstr("no label changed")));
}

TEST_F(RuleAuthor, GetsTheSameLabelsWithoutReasons) {
  make_labelled();
  const std::string labels = ask("office.gpkg", "SELECT * FROM label ORDER BY plane_id");
  EXPECT_EQ(scenelore({"label", "@office.gpkg", "--no-reasons"}).code, 0);
  EXPECT_EQ(ask("office.gpkg", "SELECT * FROM label ORDER BY plane_id"), labels);
  EXPECT_EQ(ask("office.gpkg", "SELECT count(*) FROM reason"), "0\n");
}

TEST_F(RuleAuthor, RunsRulesFromStrangersInAProcessOfTheirOwn) {
  make_labelled();
  const std::string labels = ask("office.gpkg", "SELECT * FROM label ORDER BY plane_id");
  write_file(folder_ / "rules/near.lua", "return relation { name = 'near', extends = 'near' }");
  const Finished isolated = scenelore({"label", "@office.gpkg", "--isolate"});
  EXPECT_EQ(isolated.code, 0) << isolated.err;
  EXPECT_EQ(ask("office.gpkg", "SELECT * FROM label ORDER BY plane_id"), labels);
  write_file(folder_ / "rules/near.lua", "return relation { name = 'near', extends = 'near', degree = function() return a end }");
  const Finished broken = scenelore({"label", "@office.gpkg", "--isolate"});
  EXPECT_EQ(broken.code, 4);
  EXPECT_THAT(broken.err, AllOf(HasSubstr("near.lua:1"), HasSubstr("'a' is not declared")));
  EXPECT_EQ(ask("office.gpkg", "SELECT * FROM label ORDER BY plane_id"), labels);
}

TEST_F(RuleAuthor, WatchesFilesAndRows) {
  make_labelled();
  std::filesystem::create_directory(folder_ / "rules");
  const pid_t child = start(full({"watch", "@office.gpkg", "--rules", "@rules", "--for", "60", "--every", "50"}), folder_);
  const auto wait_for = [&](const std::string& text) {
    for (int i = 0; i < 400; ++i) {
      if (read_file(folder_ / "stdout").find(text) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  };
  EXPECT_TRUE(wait_for("no label changed"));
  edit("office.gpkg", "INSERT INTO truth SELECT min(plane), 'shelf' FROM labelled_plane WHERE class = 'table'");
  EXPECT_TRUE(wait_for("was table, is shelf: "));
  write_file(folder_ / "rules/near.lua", "return relation {\n  name = 'near', extends = 'near',\n  degree = function(a)\n    return a.nothing\n  end }");
  EXPECT_TRUE(wait_for("near.lua:4: a plane has no 'nothing'"));
  EXPECT_TRUE(wait_for("the labels stay as they were"));
  kill(child, SIGINT);
  EXPECT_EQ(finish(child, folder_).code, 0);
}

TEST_F(RuleAuthor, WatchesRulesFromStrangersInAProcessOfTheirOwn) {
  make_labelled();
  std::filesystem::create_directory(folder_ / "rules");
  write_file(folder_ / "rules/near.lua", "return relation { name = 'near', extends = 'near' }");
  write_file(folder_ / "rules/near_test.lua", "case('a bad day', function() error('not today', 0) end)");
  EXPECT_THAT(scenelore({"watch", "@office.gpkg", "--isolate", "--for", "0"}).out,
              AllOf(HasSubstr("a bad day: not today"), HasSubstr("the labels stay as they were")));
  write_file(folder_ / "rules/near_test.lua", "case('a good day', function() end)");
  EXPECT_THAT(scenelore({"watch", "@office.gpkg", "--isolate", "--for", "0"}).out, HasSubstr("no label changed"));
  write_file(folder_ / "rules/near.lua", "return relation { name = 'near', extends = 'near', degree = function(a)\n return a.nothing end }");
  EXPECT_THAT(scenelore({"watch", "@office.gpkg", "--isolate", "--for", "0"}).out,
              AllOf(HasSubstr("near.lua:2: a plane has no 'nothing'"), HasSubstr("  near.lua:2: in "), HasSubstr("the labels stay as they were")));
}

}  // namespace
}  // namespace scenelore::test
