#pragma once

#include "learning/learning.hpp"

namespace scenelore::learning {

/// One fit to the classes that are not "".
struct Fit {
  kb::LearnedRows rows;
  std::optional<rules::LearnedWeights> weights;
  kb::Knowledge with_rows, knowledge;  ///< before and after the weights
  std::vector<std::string> notes;
};
[[nodiscard]] Fit fit(const kb::Knowledge& knowledge, const std::vector<rules::LabelledScene>& scenes, const Options& options);

/// Share of the planes that have a class.
[[nodiscard]] double labelled_share(const rules::LabelledScene& scene);

}  // namespace scenelore::learning
