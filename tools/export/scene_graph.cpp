#include "export/scene_graph.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace scenelore::exports {

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

}  // namespace scenelore::exports
