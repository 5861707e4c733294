// The scene graph as Spark-DSG, the library under Hydra, loads it: DynamicSceneGraph.load("office.json").
#pragma once

#include <string>

#include "export/scene_graph.hpp"

namespace scenelore::exports {

/// JSON in one line, with what every loader from 1.0.3 on asks for (but 1.1.0, whose layer names are of another type): file
/// version 1.1.4; layers by id, by key and by name.
///
/// - A plane is an object node, layer 2, partition 0, id 'O' and the plane's number: name = class, position = centroid, box
///   and rotation = the smallest rectangle around the outline (x along its longer side, z = normal), at least 1 cm each way
///   since a box without volume is invalid there. `semantic_label` = the class's id (4294967295 without a label, which early
///   1.0 reads as its own 255; it also keeps the lower byte alone of ids above 255), `label_weights` = the label's probability.
/// - Loaders take one undirected edge a pair: its weight is the highest degree of the pair's facts.
/// - `metadata` (from 1.1 on): `labelspaces` with the name of every class, and `scenelore` with the scan's name and every fact
///   as {relation, a, b, degree}, a and b the ids of nodes.
///
/// Throws kb::Error for a plane whose id has no room beside the letter: below 0, or 2^56 and above.
[[nodiscard]] std::string to_spark_dsg(const SceneGraph& graph);

}  // namespace scenelore::exports
