// What a person who writes rules does at the shell.
#include <gmock/gmock.h>

#include <signal.h>

#include <chrono>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

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

/// Reads a file as the loader of Spark-DSG does (graph_json_serialization.cpp, json_conversions.h and node_attributes.cpp of
/// version 1.1, for a file that says 1.0.5): the same fields of the same types, and an exception where that one throws.
class SparkDsgReader {
 public:
  explicit SparkDsgReader(const json& record) {
    const json& header = record.at("SPARK_DSG_header");
    EXPECT_EQ(header.at("project_name").get<std::string>(), "main");
    EXPECT_EQ(header.at("version").at("major").get<std::uint8_t>(), 1);
    EXPECT_EQ(header.at("version").at("minor").get<std::uint8_t>(), 0);  // from 1.1 on: layer_names, and a partition per node
    EXPECT_EQ(header.at("version").at("patch").get<std::uint8_t>(), 5);
    EXPECT_FALSE(record.at("directed").get<bool>() || record.at("multigraph").get<bool>());
    const auto layers = record.at("layer_ids").get<std::vector<std::int64_t>>();
    EXPECT_EQ(record.at("mesh_layer_id").get<std::int64_t>(), 1);  // 1.0 reads it
    for (const json& node : record.at("nodes")) {
      const auto layer = node.at("layer").get<std::int64_t>();
      EXPECT_NE(std::find(layers.begin(), layers.end(), layer), layers.end()) << "a node of a layer that is not there is refused";
      EXPECT_FALSE(node.contains("timestamp")) << "would put the node into a layer of agents";
      EXPECT_TRUE(nodes.emplace(node.at("id").get<std::uint64_t>(), attributes(node.at("attributes"))).second) << "ids are unique";
    }
    for (const json& edge : record.at("edges")) {
      const auto source = edge.at("source").get<std::uint64_t>(), target = edge.at("target").get<std::uint64_t>();
      EXPECT_TRUE(nodes.contains(source) && nodes.contains(target) && source != target);
      EXPECT_TRUE(edges.insert(std::minmax(source, target)).second) << "a second edge of a pair is refused";
      const json& info = edge.at("info");
      EXPECT_EQ(info.at("type").get<std::string>(), "EdgeAttributes");
      EXPECT_TRUE(info.at("weighted").get<bool>());
      EXPECT_TRUE(info.at("weight").get<double>() > 0 && info.at("weight").get<double>() <= 1);
    }
  }
  std::map<std::uint64_t, json> nodes;  // id → attributes
  std::set<std::pair<std::uint64_t, std::uint64_t>> edges;

 private:
  static void vector3(const json& value) {
    EXPECT_EQ(value.size(), 3U);
    for (const json& x : value) EXPECT_TRUE(std::isfinite(x.get<double>()));
  }
  static void quaternion(const json& value) {
    double square = 0;
    for (const char* part : {"w", "x", "y", "z"}) square += std::pow(value.at(part).get<double>(), 2);
    EXPECT_NEAR(square, 1, 1e-6);
  }
  static json attributes(const json& node) {
    EXPECT_EQ(node.at("type").get<std::string>(), "ObjectNodeAttributes");  // chooses the C++ class
    vector3(node.at("position"));
    (void)node.at("last_update_time_ns").get<std::uint64_t>();
    (void)node.at("is_active").get<bool>();
    (void)node.at("is_predicted").get<bool>();  // since 1.0.4
    (void)node.at("name").get<std::string>();
    for (const char* channel : {"r", "g", "b", "a"}) EXPECT_LE(node.at("color").at(channel).get<unsigned>(), 255U);  // since 1.0.3
    const json& box = node.at("bounding_box");
    EXPECT_EQ(box.at("type").get<std::string>(), "AABB");
    vector3(box.at("dimensions"));  // since 1.0.3
    vector3(box.at("world_P_center"));
    quaternion(box.at("world_R_center"));
    EXPECT_LE(node.at("semantic_label").get<unsigned>(), 255U);  // one byte in 1.0
    const json& feature = node.at("semantic_feature");
    EXPECT_EQ(feature.at("data").size(), feature.at("rows").get<unsigned>() * feature.at("cols").get<unsigned>());
    EXPECT_TRUE(node.at("mesh_connections").get<std::vector<std::uint64_t>>().empty());
    (void)node.at("registered").get<bool>();
    quaternion(node.at("world_R_object"));
    return node;
  }
};

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

  const SparkDsgReader reader(json::parse(scenelore({"relations", "@office.gpkg", "--dsg"}).out));
  EXPECT_EQ(reader.nodes.size(), plain.at("planes").size());
  EXPECT_EQ(reader.edges.size(), std::stoul(ask("office.gpkg", "SELECT count(DISTINCT min(a, b) || ' ' || max(a, b)) FROM relation_fact")));
  for (const json& plane : plain.at("planes")) {
    const json& node = reader.nodes.at(plane.at("plane").get<std::uint64_t>() | std::uint64_t{'O'} << 56);
    EXPECT_EQ(node.at("name"), plane.at("class"));
    EXPECT_EQ(node.at("position"), plane.at("centroid"));
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
