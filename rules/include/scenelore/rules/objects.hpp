// Things of several surfaces, from labelled planes and the relations between them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scenelore/kb/inference.hpp"
#include "scenelore/kb/knowledge.hpp"
#include "scenelore/rules/rule_set.hpp"
#include "scenelore/rules/scene.hpp"

namespace scenelore::rules {

/// One object an anchor, with the parts that are its own: each plane is a part of at most one object of a composite, each object has
/// at most `most` of a part, and the degrees of the relations add up to the most that is possible (equal sums: lower plane
/// ids first). Only relations that hold (hold_degree) count. Parts of the anchor's own class are what hangs together with it: the
/// largest plane of the group is the anchor. Objects that lack a part of which some are needed are left out. By composite, then
/// the anchor's place in the scene.
[[nodiscard]] std::vector<kb::Object> group_objects(const kb::Knowledge& knowledge, const Scene& scene, const std::vector<kb::Label>& labels,
                                                    const std::vector<kb::RelationFact>& facts);

}  // namespace scenelore::rules
