// Rows and truth that cannot all hold, and what is cheapest to give up.
#pragma once

#include <string>
#include <vector>

#include "scenelore/rules/labelling.hpp"

namespace scenelore::rules {

/// One row at one place of the scene, or one plane whose class is certain.
struct ConflictPart {
  std::string constraint;           ///< name of the row; empty = a truth row
  std::vector<kb::PlaneId> planes;  ///< that the row speaks about here; empty = the whole scene
  std::string sentence;
};

/// `parts` cannot hold together, and without any one of them the others can. `relaxation` is what the best labelling
/// breaks instead, at kBrokenRow a piece. Both empty: no contradiction.
struct Contradiction {
  std::vector<ConflictPart> parts, relaxation;
};

/// Throws Error for what compile refuses. Unclear when the search ends at a limit: then `parts` is empty.
[[nodiscard]] Contradiction find_contradiction(const kb::Knowledge& knowledge, const Scene& scene,
                                               const std::vector<std::vector<double>>& evidence, const Facts& facts,
                                               const std::vector<std::pair<kb::PlaneId, std::string>>& truth,
                                               const LabellingOptions& options = {});

}  // namespace scenelore::rules
