// Reads a file as strictly as the strictest of Spark-DSG's loaders, from 1.0.3 to 1.1.7, at each place.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace scenelore::test {

struct SparkBox {
  Eigen::Vector3f dimensions, centre;  // the loaders keep floats
  Eigen::Matrix3f rotation;

  bool valid() const { return dimensions.prod() > 0; }
  bool contains(const Eigen::Vector3f& point) const {
    return valid() && ((rotation.transpose() * (point - centre)).cwiseAbs() - dimensions / 2).maxCoeff() <= 0;
  }
};

struct SparkNode {
  std::string name;
  std::uint32_t label = 0;
  std::map<std::uint32_t, float> label_weights;
  Eigen::Vector3d position;
  Eigen::Quaterniond rotation;
  SparkBox box;
  std::array<std::uint8_t, 4> color{};  // red, green, blue, opacity
};

struct SparkGraph {
  std::map<std::uint64_t, SparkNode> nodes;
  std::map<std::pair<std::uint64_t, std::uint64_t>, double> weights;  // of edges; the smaller id first
  std::map<std::uint32_t, std::string> class_names;
  nlohmann::json facts;
  std::string scan;
};

/// One read; any deviation throws std::runtime_error or nlohmann::json::exception, where a loader would throw or misread.
class SparkDsgReader {
 public:
  static SparkGraph read(const nlohmann::json& file) {
    SparkDsgReader reader;
    reader.header(file);
    reader.layers(file);
    for (const Json& node : file.at("nodes")) reader.node(node);
    for (const Json& edge : file.at("edges")) reader.edge(edge);
    reader.metadata(file.at("metadata"));
    return std::move(reader.graph_);
  }

 private:
  using Json = nlohmann::json;

  static void require(bool held, const std::string& what) {
    if (!held) throw std::runtime_error(what);
  }

  /// nlohmann's get<> cuts larger numbers off without a word.
  template <typename T>
  static T whole(const Json& value) {
    const bool natural = value.is_number_unsigned() || (value.is_number_integer() && value.get<std::int64_t>() >= 0);
    require(natural, "not a whole number from 0: " + value.dump());
    require(value.get<std::uint64_t>() <= std::numeric_limits<T>::max(), "too large: " + value.dump());
    return value.get<T>();
  }

  /// null would be not-a-number in a position, and refused in a quaternion.
  static double real(const Json& value) {
    require(value.is_number(), "not a number: " + value.dump());
    return value.get<double>();
  }

  static Eigen::Vector3d vector(const Json& value) {
    require(value.is_array() && value.size() == 3, "not a vector: " + value.dump());
    return {real(value[0]), real(value[1]), real(value[2])};
  }

  static Eigen::Quaterniond quaternion(const Json& value) {
    const Eigen::Quaterniond q(real(value.at("w")), real(value.at("x")), real(value.at("y")), real(value.at("z")));
    require(std::abs(q.norm() - 1) < 1e-6, "not a rotation: " + value.dump());
    return q;
  }

  /// Before 1.1: layer_ids. 1.1.1: layer_names with keys, a partition for every node. From 1.1.7 on older files than 1.1.2 are refused.
  /// What a file of 1.1.7 holds besides (features as plain lists) is not in ours.
  void header(const Json& file) {
    const Json& header = file.at("SPARK_DSG_header");
    require(header.at("project_name").get<std::string>() == "main", "another project");
    const Json& version = header.at("version");
    const auto part = [&](const char* name) { return whole<std::uint8_t>(version.at(name)); };
    const auto number = part("major") * 10000 + part("minor") * 100 + part("patch");
    require(number >= 10102, "File version is too old to load");
    require(number >= 10104 && number <= 10106, "label weights since 1.1.4, features as a matrix until 1.1.6");
    require(!file.at("directed").get<bool>() && !file.at("multigraph").get<bool>(), "not an undirected graph");
  }

  void layers(const Json& file) {
    for (const Json& id : file.at("layer_ids")) layers_.insert({whole<std::int64_t>(id), 0});
    std::set<Key> keys, named;
    for (const Json& one : file.at("layer_keys")) keys.insert(key(one));
    for (const auto& [name, one] : file.at("layer_names").items()) named.insert(key(one));
    require(!layers_.empty() && keys == layers_ && named == layers_, "layers by id, key and name are the same");
    require(key(file.at("layer_names").at("OBJECTS")) == Key{2, 0}, "objects are layer 2");
    require(whole<std::int64_t>(file.at("mesh_layer_id")) == 1, "some of 1.0 read it");
  }

  void node(const Json& record) {
    const auto id = whole<std::uint64_t>(record.at("id"));
    require(id >> 56 == 'O', "Hydra's objects start with O");
    require(layers_.contains({whole<std::int64_t>(record.at("layer")), whole<std::uint32_t>(record.at("partition"))}), "a layer that is not there");
    require(!record.contains("timestamp"), "would put the node into a layer of agents");
    require(graph_.nodes.emplace(id, attributes(record.at("attributes"))).second, "failed to add: the id is there already");
  }

  static SparkNode attributes(const Json& record) {
    require(record.at("type") == "ObjectNodeAttributes", "chooses the class that is made");
    (void)whole<std::uint64_t>(record.at("last_update_time_ns"));
    require(!record.at("is_active").get<bool>() && !record.at("is_predicted").get<bool>(), "neither in an active window nor predicted");
    require(record.at("mesh_connections").get<std::vector<std::uint64_t>>().empty(), "there is no mesh");
    require(record.at("registered").get<bool>(), "world_R_object is valid only then");
    const Json& feature = record.at("semantic_feature");
    require(feature.at("data").size() == whole<std::uint32_t>(feature.at("rows")) * whole<std::uint32_t>(feature.at("cols")), "cannot decode matrix");
    SparkNode node{.name = record.at("name").get<std::string>(),
                   .label = whole<std::uint32_t>(record.at("semantic_label")),
                   .label_weights = record.at("label_weights").get<std::map<std::uint32_t, float>>(),
                   .position = vector(record.at("position")),
                   .rotation = quaternion(record.at("world_R_object")),
                   .box = box(record.at("bounding_box"))};
    const char* channels[] = {"r", "g", "b", "a"};
    for (std::size_t i = 0; i < 4; ++i) node.color[i] = whole<std::uint8_t>(record.at("color").at(channels[i]));
    return node;
  }

  static SparkBox box(const Json& record) {
    require(record.at("type") == "OBB", "any other type would not be turned");  // an unknown one is read as INVALID
    return {vector(record.at("dimensions")).cast<float>(), vector(record.at("world_P_center")).cast<float>(),
            quaternion(record.at("world_R_center")).cast<float>().toRotationMatrix()};
  }

  void edge(const Json& record) {
    const auto source = whole<std::uint64_t>(record.at("source")), target = whole<std::uint64_t>(record.at("target"));
    require(source != target, "failed to add: a self-edge");
    require(graph_.nodes.contains(source) && graph_.nodes.contains(target), "failed to add: no such node");
    const Json& info = record.at("info");
    require(info.at("type") == "EdgeAttributes" && info.at("weighted").get<bool>(), "the weight counts only then");
    require(graph_.weights.emplace(std::minmax({source, target}), real(info.at("weight"))).second, "failed to add: the pair has an edge");
  }

  void metadata(const Json& record) {
    graph_.class_names = record.at("labelspaces").at("_l2p0").get<std::map<std::uint32_t, std::string>>();
    graph_.scan = record.at("scenelore").at("scan").get<std::string>();
    graph_.facts = record.at("scenelore").at("relations");
    for (const Json& fact : graph_.facts) {
      for (const char* end : {"a", "b"}) require(graph_.nodes.contains(whole<std::uint64_t>(fact.at(end))), "a fact about no node");
    }
  }

  using Key = std::pair<std::int64_t, std::uint32_t>;
  static Key key(const Json& record) { return {whole<std::int64_t>(record.at("layer")), whole<std::uint32_t>(record.at("partition"))}; }

  std::set<Key> layers_;
  SparkGraph graph_;
};

}  // namespace scenelore::test
