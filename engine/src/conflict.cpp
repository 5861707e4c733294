// Which hard constraints cannot hold together: QuickXplain (Junker, AAAI 2004) over satisfaction searches.
#include <algorithm>

#include "implementation.hpp"

namespace scenelore::engine {
namespace {

class ConflictFinder {
 public:
  ConflictFinder(const Problem& problem, const Scale& scale, const Limits& limits)
      : problem_(problem), scale_(scale), budget_(limits) {
    for (std::size_t c = 0; c < problem.constraints().size(); ++c)
      if (may_forbid(problem, problem.constraints()[c])) hard_.push_back(static_cast<int>(c));
  }

  std::vector<int> find() {
    if (satisfiable(hard_)) return {};
    if (!satisfiable({})) return {};  // the domains alone: no constraint is to blame
    std::vector<int> core = explain({}, false, hard_);
    std::sort(core.begin(), core.end());
    return core;
  }
  bool limit_struck() { return budget_.exhausted(); }

 private:
  static bool may_forbid(const Problem& problem, const ConstraintView& constraint) {
    if (constraint.weight == kHard) return true;
    const auto* pair = constraint.as<PairTable>();
    if (pair == nullptr) return false;
    const auto& costs = problem.table(pair->table);
    return std::find(costs.begin(), costs.end(), kHard) != costs.end();
  }

  /// When a limit strikes: true, so that nothing is left out without proof.
  bool satisfiable(const std::vector<int>& constraints) {
    if (budget_.exhausted()) return true;
    std::vector<char> use(problem_.constraints().size() + 1, 0);
    for (const int c : constraints) use[static_cast<std::size_t>(c)] = 1;
    Decomposition parts = decompose(Outline(problem_, scale_, use), Bound::paper);
    if (parts.broken >= 0) return false;
    const Search::Report silent;
    for (Component& component : parts.components) {
      if (!component.feasible) return false;
      bool found = false;
      const bool complete = Search(component.network, budget_, silent).enumerate({}, kTop / 2, [&](const auto&, Cost) {
        found = true;
        return Cost{0};
      });
      if (!found && complete) return false;
    }
    return true;
  }

  /// A minimal subset of `candidates` that is unsatisfiable together with `background`, which alone is satisfiable
  /// unless `grown` says that it has been added to since that was known.
  std::vector<int> explain(const std::vector<int>& background, bool grown, const std::vector<int>& candidates) {
    if (grown && !satisfiable(background)) return {};
    if (candidates.size() == 1) return candidates;
    const auto middle = candidates.begin() + static_cast<std::ptrdiff_t>(candidates.size() / 2);
    const std::vector<int> first(candidates.begin(), middle), second(middle, candidates.end());
    std::vector<int> core = explain(join(background, first), true, second);
    const std::vector<int> rest = explain(join(background, core), !core.empty(), first);
    core.insert(core.end(), rest.begin(), rest.end());
    return core;
  }

  static std::vector<int> join(std::vector<int> a, const std::vector<int>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  const Problem& problem_;
  const Scale& scale_;
  Budget budget_;
  std::vector<int> hard_;
};

}  // namespace

std::vector<int> Solver::Implementation::conflict(bool& minimal) const {
  ConflictFinder finder(problem, scale, options.limits);
  std::vector<int> core = finder.find();
  minimal = !finder.limit_struck();
  return core;
}

}  // namespace scenelore::engine
