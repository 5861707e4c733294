// Which constraints can cost anything, given the labels: most conflicts and requirements are about labels that do not hold.
#pragma once

#include <vector>

#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {

class Relevant {
 public:
  explicit Relevant(const Problem& problem);
  /// Ascending. Labels must exist.
  std::vector<int> constraints(const std::vector<int>& assignment) const;

 private:
  struct Entry {
    int constraint;
    Literal too;  ///< the constraint costs nothing unless this literal holds as well
  };
  std::vector<int> first_label_;                 ///< of each variable among all labels
  std::vector<std::vector<Entry>> of_label_;     ///< constraints that cost nothing unless this label holds
  std::vector<int> always_;
};

}  // namespace scenelore::engine
