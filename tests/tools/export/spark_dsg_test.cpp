#include "export/spark_dsg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "scenelore/kb/error.hpp"
#include "spark_dsg_reader.hpp"

namespace scenelore::exports {
namespace {

using nlohmann::json;
using test::SparkDsgReader;
using test::SparkGraph;
using test::SparkNode;

constexpr std::uint64_t id(std::int64_t plane) { return std::uint64_t{'O'} << 56 | static_cast<std::uint64_t>(plane); }

/// A rectangle of sizes x and y along its own axes, its centroid off its middle as that of an unevenly scanned one.
perception::Plane rectangle(const Eigen::Vector3d& centroid, const Eigen::Quaterniond& orientation, double x, double y) {
  perception::Plane plane{.centroid = centroid, .normal = orientation * Eigen::Vector3d::UnitZ(), .orientation = orientation};
  for (const auto& [u, v] : {std::pair{-0.4, -0.5}, {0.6, -0.5}, {0.6, 0.5}, {-0.4, 0.5}}) {
    plane.hull.outer.push_back(centroid + orientation * Eigen::Vector3d(u * x, v * y, 0));
  }
  return plane;
}

Eigen::Quaterniond turned(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()));
}

GraphNode node(kb::PlaneId plane, int class_id, const std::string& name, perception::Plane shape) {
  return {.plane = plane, .object_class = name, .class_id = class_id, .color = "#ff9800", .probability = 0.75, .shape = std::move(shape)};
}

SceneGraph room() {
  const Eigen::Quaterniond flat = Eigen::Quaterniond::Identity(), steep = turned(90, {1, 0.3, 0});
  return {.scan = "room",
          .classes = {{.id = 0, .name = "unknown", .fallback = true}, {.id = 1, .name = "floor"}, {.id = 300, .name = "table"}},
          .nodes = {node(1, 1, "floor", rectangle({0, 0, 0}, flat, 4, 5)), node(2, 300, "table", rectangle({1, 2, 0.75}, flat, 1, 2)),
                    node(3, -1, "", rectangle({2, 0, 1}, steep, 4, 2))},
          .edges = {{"above", 2, 1, 0.5}, {"below", 1, 2, 0.25}, {"parallel", 2, 1, 0.875}, {"touches", 3, 1, 1}}};
}

SparkGraph loaded(const SceneGraph& graph) { return SparkDsgReader::read(json::parse(to_spark_dsg(graph))); }

TEST(SparkDsg, HoldsPlanesAsObjects) {
  const SparkGraph graph = loaded(room());
  ASSERT_EQ(graph.nodes.size(), 3U);
  const SparkNode& table = graph.nodes.at(id(2));
  EXPECT_EQ(table.name, "table");
  EXPECT_EQ(table.label, 300U);
  EXPECT_EQ(table.label_weights, (std::map<std::uint32_t, float>{{300, 0.75F}}));
  EXPECT_EQ(graph.class_names.at(table.label), "table");
  EXPECT_EQ(table.position, Eigen::Vector3d(1, 2, 0.75));
  EXPECT_EQ(table.color, (std::array<std::uint8_t, 4>{0xff, 0x98, 0, 255}));
  EXPECT_EQ(graph.scan, "room");
}

TEST(SparkDsg, LeavesAPlaneWithoutALabelWithoutALabel) {
  const SparkNode& plane = loaded(room()).nodes.at(id(3));
  EXPECT_EQ(plane.label, std::numeric_limits<std::uint32_t>::max());                         // NO_SEMANTIC_LABEL of 1.1
  EXPECT_EQ(static_cast<std::uint8_t>(plane.label), std::numeric_limits<std::uint8_t>::max());  // and of 1.0
  EXPECT_TRUE(plane.name.empty());
  EXPECT_TRUE(plane.label_weights.empty());
}

TEST(SparkDsg, HasOneEdgeAPairAndEveryFactInTheMetadata) {
  SceneGraph made = room();
  made.edges.push_back({"odd", 2, 2, 1});  // an edge to itself would have the file refused
  const SparkGraph graph = loaded(made);
  EXPECT_EQ(graph.weights, (std::map<std::pair<std::uint64_t, std::uint64_t>, double>{{{id(1), id(2)}, 0.875}, {{id(1), id(3)}, 1.0}}));
  ASSERT_EQ(graph.facts.size(), made.edges.size());
  for (std::size_t i = 0; i < made.edges.size(); ++i) {
    const kb::RelationFact& fact = made.edges[i];
    EXPECT_EQ(graph.facts[i], (json{{"relation", fact.relation}, {"a", id(fact.a)}, {"b", id(fact.b)}, {"degree", fact.degree}}));
  }
}

TEST(SparkDsg, BoxesLieAroundTheOutlineHoweverItStands) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1), angle(0, 360), size(0.05, 6);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Quaterniond q = turned(angle(random), {any(random), any(random), any(random)});
    const double x = size(random), y = size(random);
    SceneGraph graph{.scan = "one", .nodes = {node(7, 1, "floor", rectangle({any(random), any(random), any(random)}, q, x, y))}};
    const SparkNode plane = loaded(graph).nodes.at(id(7));
    EXPECT_LT((plane.box.dimensions - Eigen::Vector3d(std::max(x, y), std::min(x, y), 0.01).cast<float>()).norm(), 1e-4F);
    const Eigen::Vector3d longer = x > y ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    EXPECT_NEAR(std::abs((plane.rotation * Eigen::Vector3d::UnitX()).dot(q * longer)), 1, 1e-9);
    EXPECT_NEAR((plane.rotation * Eigen::Vector3d::UnitZ()).dot(q * Eigen::Vector3d::UnitZ()), 1, 1e-9);
    EXPECT_LT((plane.rotation.cast<float>().toRotationMatrix() - plane.box.rotation).norm(), 1e-5F);
    EXPECT_TRUE(plane.box.contains(plane.position.cast<float>()));
    for (const Eigen::Vector3d& corner : graph.nodes[0].shape.hull.outer) {
      const Eigen::Vector3d middle = plane.box.centre.cast<double>();
      EXPECT_TRUE(plane.box.contains((middle + (corner - middle) * 0.999).cast<float>()));
      EXPECT_FALSE(plane.box.contains((middle + (corner - middle) * 1.001).cast<float>()));
    }
    EXPECT_FALSE(plane.box.contains((plane.position + q * Eigen::Vector3d(0, 0, 0.006)).cast<float>()));
  }
}

TEST(SparkDsg, BoxesFollowTheOutlineNotThePlanesOwnAxes) {
  const Eigen::Quaterniond q = turned(70, {1, 2, 3});
  perception::Plane plane = rectangle({0, 0, 0}, q, 3, 3);
  plane.orientation = q * turned(45, {0, 0, 1});  // the points of a square spread alike every way
  const SparkNode square = loaded({.scan = "one", .nodes = {node(1, 1, "wall", plane)}}).nodes.at(id(1));
  EXPECT_LT((square.box.dimensions - Eigen::Vector3f(3, 3, 0.01F)).norm(), 1e-5F);
}

TEST(SparkDsg, AnOutlineWithoutAreaHasAValidBoxAsWell) {
  const Eigen::Quaterniond flat = Eigen::Quaterniond::Identity();
  perception::Plane point{.centroid = {1, 2, 3}};
  const SparkGraph graph = loaded({.scan = "thin", .nodes = {node(1, 1, "floor", point), node(2, 1, "floor", rectangle({0, 0, 0}, flat, 3, 0))}});
  EXPECT_LT((graph.nodes.at(id(1)).box.dimensions - Eigen::Vector3f::Constant(0.01F)).norm(), 1e-6F);
  EXPECT_EQ(graph.nodes.at(id(1)).box.centre, Eigen::Vector3f(1, 2, 3));
  EXPECT_LT((graph.nodes.at(id(2)).box.dimensions - Eigen::Vector3f(3, 0.01F, 0.01F)).norm(), 1e-6F);
  EXPECT_TRUE(graph.nodes.at(id(1)).box.valid() && graph.nodes.at(id(2)).box.valid());
}

TEST(SparkDsg, OfAnEmptyScanIsAnEmptyGraph) {
  const SparkGraph graph = loaded({.scan = "nothing"});
  EXPECT_TRUE(graph.nodes.empty() && graph.weights.empty() && graph.facts.empty());
}

TEST(SparkDsg, CarriesTwoThousandPlanes) {
  SceneGraph made{.scan = "building"};
  for (int i = 1; i <= 2000; ++i) {
    made.nodes.push_back(node(i, 1, "floor", rectangle({i * 1.0, 0, 0}, Eigen::Quaterniond::Identity(), 1, 1)));
    for (int j = std::max(1, i - 5); j < i; ++j) made.edges.push_back({"near", i, j, 1.0 / (i - j)});
  }
  const SparkGraph graph = loaded(made);
  EXPECT_EQ(graph.nodes.size(), 2000U);
  EXPECT_EQ(graph.weights.size(), made.edges.size());
}

TEST(SparkDsg, NumbersNodesUpToTheLetter) {
  const std::int64_t last = (std::int64_t{1} << 56) - 1;
  SceneGraph graph{.scan = "far", .nodes = {node(last, 1, "floor", {})}};
  EXPECT_TRUE(loaded(graph).nodes.contains(id(last)));
  for (const std::int64_t outside : {last + 1, std::int64_t{-1}}) {
    graph.nodes[0].plane = outside;
    try {
      (void)to_spark_dsg(graph);
      ADD_FAILURE() << outside;
    } catch (const kb::Error& error) {
      const std::string text = error.what();
      for (const std::string& part : {std::string("'far'"), "plane " + std::to_string(outside), std::string("--json")}) {
        EXPECT_NE(text.find(part), text.npos) << text;
      }
    }
  }
}

TEST(SparkDsg, NamesMayHoldAnything) {
  SceneGraph graph = room();
  graph.nodes[0].object_class = "\"a\\b\"\n\xff";  // not UTF-8
  EXPECT_EQ(loaded(graph).nodes.at(id(1)).name, "\"a\\b\"\n\xef\xbf\xbd");
}

/// The reader is only as good as what it refuses: each of these files has a loader that throws or reads something else.
TEST(SparkDsgReader, RefusesWhatALoaderRefuses) {
  const json good = json::parse(to_spark_dsg(room()));
  const std::pair<const char*, json> changes[] = {
      {"/SPARK_DSG_header/version/patch", 1},
      {"/SPARK_DSG_header/version/minor", 0},
      {"/SPARK_DSG_header/project_name", "hydra"},
      {"/layer_ids", json::array()},
      {"/layer_keys/0/layer", 7},
      {"/layer_names/OBJECTS", 2},
      {"/nodes/0/layer", 6},
      {"/nodes/0/partition", 1},
      {"/nodes/0/timestamp", 12},
      {"/nodes/0/id", id(2)},
      {"/nodes/0/attributes/type", "PlaneNodeAttributes"},
      {"/nodes/0/attributes/semantic_label", -1},
      {"/nodes/0/attributes/color/r", 256},
      {"/nodes/0/attributes/position/2", nullptr},
      {"/nodes/0/attributes/bounding_box/type", "box"},
      {"/nodes/0/attributes/world_R_object/w", nullptr},
      {"/nodes/0/attributes/semantic_feature/data", {1.5}},
      {"/edges/0/source", id(9)},
      {"/edges/0/source", good.at("edges")[0].at("target")},
      {"/edges/1", good.at("edges")[0]},
      {"/edges/0/info/type", "SpatialEdgeAttributes"},
      {"/metadata/labelspaces/_l2p0", json::object({{"1", "floor"}})},
      {"/metadata/scenelore/relations/0/a", id(9)},
  };
  EXPECT_NO_THROW(SparkDsgReader::read(good));
  for (const auto& [where, value] : changes) {
    json bad = good;
    bad[json::json_pointer(where)] = value;
    EXPECT_ANY_THROW(SparkDsgReader::read(bad)) << where << " " << value;
  }
}

}  // namespace
}  // namespace scenelore::exports
