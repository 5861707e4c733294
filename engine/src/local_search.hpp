// A first good assignment, before there is any bound: descent from the cheapest labels, one variable at a time.
#pragma once

#include <compare>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "budget.hpp"
#include "outline.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {

/// Prepared once for a problem; each call of `begin` and `descend` is a descent of its own.
class LocalSearch {
 public:
  explicit LocalSearch(const Outline& outline);

  /// The cheapest labels that the assumptions leave, or `start` as far as they leave it.
  std::vector<int> begin(const Assumptions& assumptions, const std::vector<int>& start = {});
  /// Changes one label at a time for the better until there is none; labels that the last begin() ruled out stay out.
  /// Broken hard constraints count as dearer than everything else, so that the result may break some. Ends early when time
  /// runs out, but not before the fourth look at each variable.
  void descend(std::vector<int>& assignment, Budget& budget);
  /// Labels that may change from now on, in place of what begin() left: `allowed` by literal of the outline.
  void allow(std::vector<char> allowed) { allowed_ = std::move(allowed); }
  /// Simulated annealing (Kirkpatrick, Gelatt, Vecchi, Science 1983), by heat bath and variable by variable, and down again from
  /// the best that was met; no worse than before. The same random numbers each time.
  void anneal(std::vector<int>& assignment, std::uint64_t sweeps, Budget& budget);

 private:
  struct Price {
    int broken = 0;  ///< hard constraints
    Cost cost = 0;
    auto operator<=>(const Price&) const = default;
    void add(Cost more, int sign = 1) {
      if (is_forbidden(more))
        broken += sign;
      else
        cost += sign * more;
    }
  };
  /// A need, seen from a label that meets it.
  struct Use {
    int need;
    Cost cost;
  };

  std::size_t held(int v) const {
    const auto at = static_cast<std::size_t>(v);
    return static_cast<std::size_t>(outline_.first_label[at] + labels_[at]);
  }
  bool holds(int literal) const { return static_cast<int>(held(outline_.variable(literal))) == literal; }
  double mean_step();
  int drawn(int v, double temperature, double broken);
  void start(const std::vector<int>& assignment);
  void hold(int v, int label);
  void change(int v, int label);
  /// To the best label of v, if there is a better one. Returns whether.
  bool improve(int v);
  void go_down(int most_sweeps, int least_sweeps, Budget& budget);
  /// Adds (or takes back) what the conflicts and pairs of a label that holds cost other labels.
  void charge(std::size_t literal, int sign);
  /// prices_ of v's labels, everything else as it is.
  void weigh(int v);
  void weigh_needs(int v);
  void weigh_counts(int v);
  void find_members();
  Cost least_prop(std::size_t need, int without);
  /// A literal of v begins or ends to hold.
  void join(int v, std::size_t literal);
  void leave(int v, std::size_t literal);

  const Outline& outline_;
  std::vector<std::size_t> first_use_;  ///< by literal, in uses_
  std::vector<Use> uses_;
  std::vector<std::vector<int>> counts_, pairs_;  ///< by variable
  std::vector<std::size_t> first_member_;         ///< by variable, in members_
  std::vector<char> members_;                     ///< whether a label is counted: by count of the variable, then by label
  std::vector<char> allowed_;                     ///< by literal
  std::vector<int> open_;                         ///< variables with two labels or more that are allowed
  std::vector<Price> charged_;                    ///< by literal: its own cost, and conflicts and pairs with labels that hold
  std::vector<Price> prices_;                     ///< by label of the variable at hand
  std::vector<int> labels_;                       ///< what charged_ is about, and the next two
  /// The cheapest prop of a need that holds, and the cheapest of other variables than its; at most the weight.
  struct Met {
    bool known = false;
    int variable = -1;
    Cost best = 0, second = 0;
  };
  std::vector<Met> met_;    ///< by need
  std::vector<int> held_;   ///< by count: literals that hold
  std::mt19937_64 random_;  ///< the same sequence for each problem
  Price total_{};                                 ///< since start(): how much dearer than at first
  std::vector<double> shares_;                    ///< of labels, see drawn()
};

}  // namespace scenelore::engine
