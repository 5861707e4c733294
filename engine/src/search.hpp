// Hybrid best-first search over one network: Allouche, de Givry, Katsirelos, Schiex, Zytnicki, "Anytime hybrid
// best-first search with tree decomposition for weighted CSP", CP 2015. An open list of nodes ordered by lower bound
// gives the best bound at any time; each node that is taken from it is explored depth first for a limited number of
// backtracks, which gives good assignments early; what is left of that burst goes back to the list.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "budget.hpp"
#include "cost.hpp"
#include "network.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {

/// A branch: the variable has the label, or has not.
struct Decision {
  int variable, label;
  bool equal;
};

struct SearchResult {
  Cost cost = kTop;             ///< of `assignment`; the limit given when there is none cheaper
  Cost lower_bound = 0;         ///< no assignment is cheaper than this; equal to cost when complete
  std::vector<int> assignment;  ///< empty: none found below the limit
  bool complete = false;
};

/// Looks for an assignment below the limit without a proof, with so many sweeps over the variables; nothing when there is none.
using Polish = std::function<std::optional<std::vector<int>>(Cost limit, std::uint64_t sweeps)>;

/// Called with each complete assignment that is found below the limit; returns the new limit.
using Accept = std::function<Cost(const std::vector<int>& assignment, Cost cost)>;

class Search {
 public:
  /// `network` is at its root, propagated; it is left as it was. `variable_of` and `scale` are for the observer.
  struct Report {
    Observer* observer = nullptr;
    std::function<Literal(int variable, int label)> literal;
    std::function<double(Cost)> real;
  };
  Search(Network& network, Budget& budget, const Report& report)
      : network_(network), budget_(budget), report_(report) {}

  /// Labels to try first when costs are equal, one a variable.
  void prefer(const std::vector<int>& assignment) { preferred_ = assignment; }
  /// Depth first by variables and labels in ascending order, so that assignments are met in lexicographic order.
  void search_in_order() { in_order_ = true; }
  /// From time to time, and in proportion to the work done, run() asks this for a better assignment.
  void polish_with(Polish polish) { polish_ = std::move(polish); }
  /// run() finishes nodes without branches where small tables do, unless this is false.
  void eliminate(bool on) { eliminates_ = on; }
  /// A long run() strikes labels at the root that are in no assignment of least cost. There must be no assumptions.
  void dominate(bool on) { dominates_ = on; }
  /// Depth first in one go, each branch told to `log`, which the network has too.
  void log_to(ProofLog& log) { log_ = &log; }
  /// Least cost assignment below `limit` under `assumptions`.
  SearchResult run(const std::vector<Decision>& assumptions, Cost limit);
  /// Shows every assignment below the falling limit to `accept`. Returns whether the search is complete.
  bool enumerate(const std::vector<Decision>& assumptions, Cost limit, const Accept& accept);

 private:
  struct Open {
    Cost bound;
    std::uint64_t number;
    std::vector<Decision> path;
    bool operator<(const Open& other) const {  // for a max-heap: the greatest is taken first
      if (bound != other.bound) return bound > other.bound;
      return number > other.number;
    }
  };
  struct Frame {
    Decision decision;
    Cost bound;
    std::size_t path;  ///< length of the path at this node
  };

  bool stopped();
  bool tighten_root();
  void burst(const Open& open);
  bool enter(const std::vector<Decision>& path);
  bool apply(const Decision& decision);
  bool leaf(Cost& cost);
  void round();
  void polish();
  bool finish();
  Decision first_in_order() const;
  int branching_variable() const;
  Cost clearance(int v) const;
  Decision choose();
  void learn_from_failure(const Decision& decision, int depth);
  void hand_back(std::size_t base_path);

  Network& network_;
  Budget& budget_;
  const Report& report_;
  Accept accept_;
  Polish polish_;
  std::uint64_t nodes_before_ = 0, next_polish_ = 0;
  Cost limit_ = kTop / 2;
  std::priority_queue<Open> open_;
  std::uint64_t number_ = 0;
  std::vector<Frame> frames_;
  std::vector<Decision> path_;
  std::vector<int> preferred_;
  std::vector<double> weight_;
  double weight_step_ = 1;
  std::vector<int> assignment_;
  std::uint64_t burst_backtracks_ = 0, burst_limit_ = 1;
  int last_failed_ = -1;
  ProofLog* log_ = nullptr;
  bool in_order_ = false;
  bool eliminates_ = true;
  bool dominates_ = false;
  bool tightened_ = false;
  bool rounding_ = false;
};

}  // namespace scenelore::engine
