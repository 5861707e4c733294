// What is really there, per point and per object, whoever says so: the simulator, a person's labelled cloud, truth rows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/class_map.hpp"
#include "scenelore/kb/knowledge.hpp"
#include "scenelore/kb/knowledge_base.hpp"
#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/point_table.hpp"

namespace scenelore::evaluation {

/// A thing, or a face of one, that a label can be right about.
struct TruthObject {
  int instance = 0;                  ///< number in the truth's own file
  std::vector<std::string> classes;  ///< right ones, at least one; the object counts for the first
  bool planar = true;                ///< a face that segmentation should find as one plane
  std::size_t points = 0;
  [[nodiscard]] const std::string& object_class() const { return classes.front(); }
};

/// Points of no object: nobody knows what is there (not judged), or certainly nothing (a mixed pixel).
inline constexpr std::int32_t kNotKnown = -1, kNothing = -2;

struct SceneTruth {
  std::vector<TruthObject> objects;
  std::vector<std::int32_t> object_of_point;  ///< index into `objects`, kNotKnown or kNothing
  /// Objects are single faces: a second plane on one is a mistake. Else (a chair as a whole) further planes are not judged.
  bool faces = true;
};

/// How a labelled cloud is to be read.
struct TruthFile {
  std::filesystem::path path;
  const ClassMap* map = nullptr;              ///< without one, labels are ids of object_class
  std::map<int, std::string> names;           ///< of the label ids, for `map`
};

/// From the columns `label` (or `scalar_label`) and `instance` (optional: else one object a label) of a labelled cloud.
/// With a map, label 0 is not judged. Without one the cloud is the simulator's or labelled in its manner: instance 0 is
/// nothing; which faces are planar is read from NAME.truth.json beside NAME.ply when it is there. Where nobody tells, an
/// object is planar when 90 % of its points lie within 3 cm of its best plane.
/// Throws NoTruth without a column of labels or any label that is judged, Error for a label without a name, a name that the map
/// lacks and an id without a class.
[[nodiscard]] SceneTruth read_truth(const TruthFile& file, const kb::Knowledge& knowledge);
[[nodiscard]] SceneTruth truth_of_table(const perception::PointTable& points, const TruthFile& file, const kb::Knowledge& knowledge);

/// Each plane with a truth row is an object of its own; nothing is known of the others.
[[nodiscard]] SceneTruth truth_of_rows(const std::vector<std::pair<kb::PlaneId, std::string>>& rows,
                                       const std::vector<std::int64_t>& plane_id_of_point);

}  // namespace scenelore::evaluation
