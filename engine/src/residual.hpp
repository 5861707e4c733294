// What is left of a network when only its live labels count: the open variables, and the functions that still depend on
// two or more of them, with the original costs.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "cost.hpp"

namespace scenelore::engine {

class Network;

/// Indices of variables and labels in `pairs`, `requirements` and `counts` are those of `variables` and their `labels`.
struct Residual {
  struct OpenVariable {
    int variable;             ///< of the network
    std::vector<int> labels;  ///< the live ones, ascending; just one when it is the owner of a need
    std::vector<Cost> costs;  ///< theirs, with those of functions that only this variable decides
  };
  struct Pair {
    int x, y;
    std::vector<Cost> costs;  ///< row-major by x
  };
  struct Support {
    int variable, label;
    Cost cost;
  };
  struct Need {
    int x, label;  ///< x may be a variable with one label
    Cost weight;
    std::vector<Support> supports;  ///< each cheaper than the weight; of ascending variables, none of them x
  };
  struct Count {
    int x, label;  ///< −1 = always
    int low, high;
    Cost weight;
    std::vector<std::pair<int, std::vector<char>>> members;  ///< variable, counts for each label
    /// What it costs when so many are held.
    Cost violation(int held) const {
      const int off = std::max({0, low - held, held - high});
      return off == 0 ? 0 : is_forbidden(weight) ? kTop : weight * off;
    }
  };

  Cost constant = 0;  ///< what is decided already
  std::vector<OpenVariable> variables;
  std::vector<Pair> pairs;  ///< at most one for two variables, x < y
  std::vector<Need> needs;
  std::vector<Count> counts;
};

}  // namespace scenelore::engine
