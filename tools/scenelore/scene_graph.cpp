#include "scene_graph.hpp"

#include <fmt/core.h>

#include <charconv>
#include <map>
#include <nlohmann/json.hpp>

namespace scenelore::tools {

namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json vector(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') out += "&amp;";
    else if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '"') out += "&quot;";
    else if (static_cast<unsigned char>(c) >= 0x20) out += c;
  }
  return out;
}

/// Spark-DSG's node ids: a letter in the highest byte, a number below.
std::uint64_t symbol(kb::PlaneId plane) { return (std::uint64_t{'O'} << 56) | static_cast<std::uint64_t>(plane); }

Json color(const std::string& text) {
  const auto channel = [&](std::size_t at) {
    int value = 158;
    if (text.size() == 7) std::from_chars(text.data() + at, text.data() + at + 2, value, 16);
    return value;
  };
  return {{"r", channel(1)}, {"g", channel(3)}, {"b", channel(5)}, {"a", 255}};
}

Json bounding_box(const perception::Plane& plane) {
  Eigen::AlignedBox3d box(plane.centroid, plane.centroid);
  for (const Eigen::Vector3d& corner : plane.hull.outer) box.extend(corner);
  return {{"type", "AABB"},
          {"dimensions", vector(box.sizes())},
          {"world_P_center", vector(box.center())},
          {"world_R_center", {{"w", 1.0}, {"x", 0.0}, {"y", 0.0}, {"z", 0.0}}}};
}

}  // namespace

std::string to_json(const SceneGraph& graph) {
  Json nodes = Json::array(), edges = Json::array();
  for (const GraphNode& n : graph.nodes) {
    nodes.push_back({{"plane", n.plane},
                     {"class", n.object_class.empty() ? Json(nullptr) : Json(n.object_class)},
                     {"probability", n.probability},
                     {"centroid", vector(n.shape.centroid)},
                     {"normal", vector(n.shape.normal)},
                     {"length", n.shape.length},
                     {"width", n.shape.width},
                     {"area_m2", n.shape.area_m2}});
  }
  for (const kb::RelationFact& e : graph.edges) {
    edges.push_back({{"relation", e.relation}, {"a", e.a}, {"b", e.b}, {"degree", e.degree}});
  }
  return dump({{"scan", graph.scan}, {"planes", std::move(nodes)}, {"relations", std::move(edges)}});
}

std::string to_graphml(const SceneGraph& graph) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
      "  <key id=\"class\" for=\"node\" attr.name=\"class\" attr.type=\"string\"/>\n"
      "  <key id=\"probability\" for=\"node\" attr.name=\"probability\" attr.type=\"double\"/>\n";
  for (const char* name : {"x", "y", "z", "length", "width", "area_m2"}) {
    out += fmt::format("  <key id=\"{0}\" for=\"node\" attr.name=\"{0}\" attr.type=\"double\"/>\n", name);
  }
  out +=
      "  <key id=\"relation\" for=\"edge\" attr.name=\"relation\" attr.type=\"string\"/>\n"
      "  <key id=\"degree\" for=\"edge\" attr.name=\"degree\" attr.type=\"double\"/>\n";
  out += fmt::format("  <graph id=\"{}\" edgedefault=\"directed\">\n", escaped(graph.scan));
  for (const GraphNode& n : graph.nodes) {
    out += fmt::format("    <node id=\"p{}\"><data key=\"class\">{}</data><data key=\"probability\">{}</data>", n.plane,
                       escaped(n.object_class), n.probability);
    const std::pair<const char*, double> values[] = {{"x", n.shape.centroid.x()}, {"y", n.shape.centroid.y()},
                                                     {"z", n.shape.centroid.z()}, {"length", n.shape.length},
                                                     {"width", n.shape.width},    {"area_m2", n.shape.area_m2}};
    for (const auto& [key, value] : values) out += fmt::format("<data key=\"{}\">{}</data>", key, value);
    out += "</node>\n";
  }
  std::size_t id = 0;
  for (const kb::RelationFact& e : graph.edges) {
    out += fmt::format(
        "    <edge id=\"e{}\" source=\"p{}\" target=\"p{}\"><data key=\"relation\">{}</data><data key=\"degree\">{}</data></edge>\n",
        id++, e.a, e.b, escaped(e.relation), e.degree);
  }
  return out + "  </graph>\n</graphml>\n";
}

std::string to_spark_dsg(const SceneGraph& graph) {
  Json nodes = Json::array(), edges = Json::array();
  for (const GraphNode& n : graph.nodes) {
    const Eigen::Quaterniond& q = n.shape.orientation;
    nodes.push_back({{"id", symbol(n.plane)},
                     {"layer", 2},
                     {"attributes",
                      {{"type", "ObjectNodeAttributes"},
                       {"position", vector(n.shape.centroid)},
                       {"last_update_time_ns", 0},
                       {"is_active", false},
                       {"is_predicted", false},
                       {"name", n.object_class},
                       {"color", color(n.color)},
                       {"bounding_box", bounding_box(n.shape)},
                       {"semantic_label", n.class_id < 0 || n.class_id > 255 ? 255 : n.class_id},
                       {"semantic_feature", {{"rows", 0}, {"cols", 0}, {"data", Json::array()}}},
                       {"mesh_connections", Json::array()},
                       {"registered", false},
                       {"world_R_object", {{"w", q.w()}, {"x", q.x()}, {"y", q.y()}, {"z", q.z()}}}}}});
  }
  std::map<std::pair<kb::PlaneId, kb::PlaneId>, std::vector<const kb::RelationFact*>> pairs;
  for (const kb::RelationFact& e : graph.edges) pairs[std::minmax(e.a, e.b)].push_back(&e);
  for (const auto& [pair, facts] : pairs) {
    double weight = 0;
    Json relations = Json::array();
    for (const kb::RelationFact* fact : facts) {
      weight = std::max(weight, fact->degree);
      relations.push_back({{"relation", fact->relation}, {"a", symbol(fact->a)}, {"b", symbol(fact->b)}, {"degree", fact->degree}});
    }
    edges.push_back({{"source", symbol(pair.first)},
                     {"target", symbol(pair.second)},
                     {"info", {{"type", "EdgeAttributes"}, {"weighted", true}, {"weight", weight}, {"relations", std::move(relations)}}}});
  }
  return dump({{"SPARK_DSG_header", {{"project_name", "main"}, {"version", {{"major", 1}, {"minor", 0}, {"patch", 5}}}}},
               {"directed", false},
               {"multigraph", false},
               {"layer_ids", {2, 3, 4, 5}},
               {"mesh_layer_id", 1},
               {"nodes", std::move(nodes)},
               {"edges", std::move(edges)}});
}

}  // namespace scenelore::tools
