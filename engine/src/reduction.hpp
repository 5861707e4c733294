// The part of a component that matters near its optimum. With the optimum known, a label that is in no world cheaper
// than the optimum plus a reach is told apart by propagation with that upper bound; without these labels most functions
// depend on nothing any more, and what is left falls into small parts. Every world below the cutoff is a world of the
// reduction at the same cost, so that answers about such worlds are exact.
#pragma once

#include <vector>

#include "component.hpp"

namespace scenelore::engine {

struct Reduction {
  Cost cutoff = 0;                         ///< worlds cheaper than this are all in it
  Cost constant = 0;                       ///< least cost of everything outside the parts
  std::vector<int> settled;                ///< the label of each variable that is in no part
  std::vector<int> part_of;                ///< of each variable, −1 = none
  std::vector<int> index_in;               ///< its place in that part
  std::vector<std::vector<int>> label_in;  ///< of each label of a variable in a part its number there, −1 = gone
  std::vector<Component> parts;            ///< variables and labels are those of the reduced component
};

/// `component` has a proved optimum cheaper than `cutoff`.
Reduction reduce(Component& component, Cost cutoff);

}  // namespace scenelore::engine
