// A first good assignment, before there is any bound: descent from the cheapest labels, one variable at a time.
#pragma once

#include <vector>

#include "budget.hpp"
#include "scenelore/engine/problem.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {

/// Prepared once for a problem; each call of `from` is a descent of its own.
class LocalSearch {
 public:
  explicit LocalSearch(const Problem& problem);

  /// The cheapest labels that the assumptions leave, or `start` as far as they leave it.
  std::vector<int> begin(const Assumptions& assumptions, const std::vector<int>& start = {});
  /// Changes one label at a time for the better until there is none; labels that the last begin() ruled out stay out.
  /// Broken hard constraints count as dearer than everything else, so that the result may break some. Ends early when time
  /// runs out, but not before the fourth look at each variable.
  void descend(std::vector<int>& assignment, Budget& budget);

 private:
  /// Cost of each label of v, everything else as it is.
  void weigh(int v, const std::vector<int>& assignment);
  void weigh(int v, const Requirement& requirement, double weight, const std::vector<int>& assignment);
  void weigh(int v, const Cardinality& cardinality, double weight, const std::vector<int>& assignment);
  void weigh(int v, const PairTable& pair, double weight, const std::vector<int>& assignment);

  /// A conflict seen from one of its variables; most constraints are conflicts.
  struct OneConflict {
    int mine = 0;
    Literal other{};
    double price = 0;
  };

  const Problem& problem_;
  std::vector<std::size_t> first_;           ///< of each variable in constraints_
  std::vector<std::size_t> first_conflict_;  ///< of each variable in conflicts_
  std::vector<int> constraints_;             ///< all but conflicts
  std::vector<OneConflict> conflicts_;
  std::vector<std::vector<char>> allowed_;
  std::vector<double> price_;
  double broken_ = 1;  ///< stands for an infinite cost
};

}  // namespace scenelore::engine
