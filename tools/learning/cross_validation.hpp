// What a fit makes of planes that it has not seen.
#pragma once

#include "learning/fit.hpp"

namespace scenelore::learning {

/// One labelled plane, judged.
struct Judged {
  std::size_t scene = 0, plane = 0;
  std::string truth, by_evidence, by_world;
  double truth_evidence = 0;    ///< P(truth | Φ)
  double best_evidence = 0;     ///< of by_evidence
  double world_probability = 0; ///< adjusted, of by_world
};

/// All labelled planes by a knowledge as it is, no truth being told.
[[nodiscard]] std::vector<Judged> judge(const kb::Knowledge& knowledge, const std::vector<rules::LabelledScene>& scenes, const Options& options);

/// The same, each plane by a fit to the other folds. In the order of scenes and planes.
[[nodiscard]] std::vector<Judged> cross_validate(const kb::Knowledge& knowledge, const std::vector<rules::LabelledScene>& scenes,
                                                 const Options& options);

[[nodiscard]] Effect effect_of(const std::vector<Judged>& judged, const std::string& fallback);

}  // namespace scenelore::learning
