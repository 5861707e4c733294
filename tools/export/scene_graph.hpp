// Planes, their labels and the relations between them as a graph, for other programs. Spark-DSG's format: spark_dsg.hpp.
#pragma once

#include <string>
#include <vector>

#include "scenelore/kb/knowledge_base.hpp"

namespace scenelore::exports {

struct GraphNode {
  kb::PlaneId plane = 0;
  std::string object_class;  ///< empty = not labelled
  int class_id = -1;         ///< of the class's row; -1 = not labelled
  std::string color;         ///< #rrggbb; anything else is grey
  double probability = 0;    ///< of the label, 0..1
  perception::Plane shape;   ///< in the upright frame
};

struct SceneGraph {
  std::string scan;
  std::vector<kb::ObjectClass> classes{};  ///< all that a plane may be
  std::vector<GraphNode> nodes{};          ///< by plane
  std::vector<kb::RelationFact> edges{};   ///< by relation, a, b
};

[[nodiscard]] std::string to_json(const SceneGraph& graph);
/// http://graphml.graphdrawing.org: directed, one edge a fact; what networkx, yEd and Gephi read.
[[nodiscard]] std::string to_graphml(const SceneGraph& graph);

}  // namespace scenelore::exports
