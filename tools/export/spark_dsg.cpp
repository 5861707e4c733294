#include "export/spark_dsg.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "scenelore/kb/error.hpp"
#include "scenelore/perception/hull.hpp"

namespace scenelore::exports {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kObjects = 2;  // the layer of objects, as Hydra numbers its layers
constexpr double kThinnest = 0.01;    // metres
constexpr auto kNoLabel = std::numeric_limits<std::uint32_t>::max();

Json vector(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json quaternion(const Eigen::Quaterniond& q) { return {{"w", q.w()}, {"x", q.x()}, {"y", q.y()}, {"z", q.z()}}; }

/// Spark-DSG's node ids: a letter in the highest byte, a number below.
std::uint64_t symbol(const SceneGraph& graph, kb::PlaneId plane) {
  constexpr std::int64_t last = (std::int64_t{1} << 56) - 1;
  if (plane < 0 || plane > last) {
    throw kb::Error(fmt::format("scan '{}', plane {}: the nodes of Spark-DSG are numbered 0 to {}; renumber the plane, or use --json", graph.scan,
                                plane, last));
  }
  return (std::uint64_t{'O'} << 56) | static_cast<std::uint64_t>(plane);
}

Json color(const std::string& text) {
  const auto channel = [&](std::size_t at) {
    int value = 158;
    if (text.size() == 7) std::from_chars(text.data() + at, text.data() + at + 2, value, 16);
    return value;
  };
  return {{"r", channel(1)}, {"g", channel(3)}, {"b", channel(5)}, {"a", 255}};
}

struct Box {
  Eigen::Vector3d center, size;
  Eigen::Quaterniond rotation;  // x along the longer side, z = normal
};

/// The smallest rectangle around the outline. A box along the room's x and y would fill half the room for a wall that stands
/// askew, and the plane's own axes follow its points: they may run along the diagonal of a square.
Box box_around(const perception::Plane& plane) {
  const Eigen::Quaterniond& q = plane.orientation;
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector3d& corner : plane.hull.outer) corners.emplace_back((q.conjugate() * (corner - plane.centroid)).head<2>());
  const perception::Rectangle rectangle = perception::minimum_rectangle(corners);
  const Eigen::AngleAxisd turn(std::atan2(rectangle.along.y(), rectangle.along.x()), Eigen::Vector3d::UnitZ());
  return {plane.centroid + q * Eigen::Vector3d(rectangle.center.x(), rectangle.center.y(), 0),
          Eigen::Vector3d(rectangle.length, rectangle.width, 0).cwiseMax(kThinnest), q * turn};
}

Json bounding_box(const Box& box) {
  return {{"type", "OBB"},
          {"dimensions", vector(box.size)},
          {"world_P_center", vector(box.center)},
          {"world_R_center", quaternion(box.rotation)}};
}

Json attributes(const GraphNode& node) {
  const bool labelled = node.class_id >= 0;
  const Box box = box_around(node.shape);
  return {{"type", "ObjectNodeAttributes"},
          {"position", vector(node.shape.centroid)},
          {"last_update_time_ns", 0},
          {"is_active", false},
          {"is_predicted", false},
          {"name", node.object_class},
          {"color", color(node.color)},
          {"bounding_box", bounding_box(box)},
          {"semantic_label", labelled ? static_cast<std::uint32_t>(node.class_id) : kNoLabel},
          {"label_weights", labelled ? Json::array({Json::array({node.class_id, node.probability})}) : Json::array()},
          {"semantic_feature", {{"rows", 0}, {"cols", 0}, {"data", Json::array()}}},
          {"mesh_connections", Json::array()},
          {"registered", true},  // the rotation counts only then
          {"world_R_object", quaternion(box.rotation)}};
}

Json node_list(const SceneGraph& graph) {
  Json nodes = Json::array();
  for (const GraphNode& node : graph.nodes) {
    nodes.push_back({{"id", symbol(graph, node.plane)}, {"layer", kObjects}, {"partition", 0}, {"attributes", attributes(node)}});
  }
  return nodes;
}

/// A second edge of a pair, or one from a node to itself, has the whole file refused.
Json edge_list(const SceneGraph& graph) {
  std::map<std::pair<std::uint64_t, std::uint64_t>, double> weights;
  for (const kb::RelationFact& fact : graph.edges) {
    if (fact.a == fact.b) continue;
    double& weight = weights[std::minmax({symbol(graph, fact.a), symbol(graph, fact.b)})];
    weight = std::max(weight, fact.degree);
  }
  Json edges = Json::array();
  for (const auto& [pair, weight] : weights) {
    edges.push_back({{"source", pair.first},
                     {"target", pair.second},
                     {"info", {{"type", "EdgeAttributes"}, {"weighted", true}, {"weight", weight}}}});
  }
  return edges;
}

/// What the loader keeps word for word; `_l2p0` is where Spark-DSG looks for the class names of layer 2, partition 0.
Json metadata(const SceneGraph& graph) {
  Json names = Json::array(), facts = Json::array();
  for (const kb::ObjectClass& object_class : graph.classes) names.push_back(Json::array({object_class.id, object_class.name}));
  for (const kb::RelationFact& fact : graph.edges) {
    facts.push_back({{"relation", fact.relation}, {"a", symbol(graph, fact.a)}, {"b", symbol(graph, fact.b)}, {"degree", fact.degree}});
  }
  return {{"labelspaces", {{"_l2p0", std::move(names)}}}, {"scenelore", {{"scan", graph.scan}, {"relations", std::move(facts)}}}};
}

}  // namespace

std::string to_spark_dsg(const SceneGraph& graph) {
  const std::pair<const char*, std::int64_t> layers[] = {{"OBJECTS", kObjects}, {"PLACES", 3}, {"ROOMS", 4}, {"BUILDINGS", 5}};
  Json ids = Json::array(), keys = Json::array(), names = Json::object();
  for (const auto& [name, id] : layers) {
    ids.push_back(id);
    keys.push_back({{"layer", id}, {"partition", 0}});
    names[name] = keys.back();
  }
  const Json file = {{"SPARK_DSG_header", {{"project_name", "main"}, {"version", {{"major", 1}, {"minor", 1}, {"patch", 4}}}}},
                     {"directed", false},
                     {"multigraph", false},
                     {"layer_ids", std::move(ids)},
                     {"layer_keys", std::move(keys)},
                     {"layer_names", std::move(names)},
                     {"mesh_layer_id", 1},
                     {"metadata", metadata(graph)},
                     {"nodes", node_list(graph)},
                     {"edges", edge_list(graph)}};
  return file.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace scenelore::exports
