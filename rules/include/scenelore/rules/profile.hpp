// What each relation and each row of constraints costs, and whether it ever decides anything.
#pragma once

#include <string>
#include <vector>

#include "scenelore/rules/labelling.hpp"

namespace scenelore::rules {

struct RowProfile {
  std::string constraint;
  std::string relation;          ///< empty = none
  int constraints = 0;           ///< places of the scene where it could matter: constraints of the engine's problem
  int broken = 0;                ///< of these, broken in the best labelling
  double paid = 0;               ///< nats, by those
  std::int64_t pruned = 0;       ///< nodes of the search that it ended
  int decided = 0;               ///< planes whose label would be another one without this row
};

struct Profile {
  std::vector<RelationCount> relations;  ///< by name: pairs asked, held, milliseconds
  std::vector<RowProfile> rows;          ///< enabled ones, by id
};

/// Asks every relation that rows use or that comes from a user's folder, labels, and labels again without each row.
[[nodiscard]] Profile profile(const kb::Knowledge& knowledge, const Scene& scene,
                              const std::vector<std::vector<double>>& evidence, RuleSet& rules,
                              const std::vector<std::pair<kb::PlaneId, std::string>>& truth,
                              const LabellingOptions& options = {});

}  // namespace scenelore::rules
