// Planes, their labels and the relations between them as a graph, in three formats.
#pragma once

#include <string>
#include <vector>

#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::tools {

struct GraphNode {
  kb::PlaneId plane = 0;
  std::string object_class;  ///< empty = not labelled
  int class_id = -1;
  std::string color;         ///< #rrggbb
  double probability = 0;
  perception::Plane shape;   ///< in the upright frame
};

struct SceneGraph {
  std::string scan;
  std::vector<GraphNode> nodes;         ///< by plane
  std::vector<kb::RelationFact> edges;  ///< by relation, a, b
};

[[nodiscard]] std::string to_json(const SceneGraph& graph);
/// http://graphml.graphdrawing.org: directed, one edge a fact; what networkx, yEd and Gephi read.
[[nodiscard]] std::string to_graphml(const SceneGraph& graph);
/// What Spark-DSG's DynamicSceneGraph.load reads (file version 1.0.5): the planes as object nodes of layer 2. Its graph has
/// one undirected edge a pair of nodes: its weight is the highest degree, `relations` lists all that hold.
[[nodiscard]] std::string to_spark_dsg(const SceneGraph& graph);

}  // namespace scenelore::tools
