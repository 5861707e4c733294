#include "tree_solver.hpp"

#include <algorithm>
#include <limits>

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

struct CostTable {
  std::vector<int> scope;   ///< ascending
  std::vector<Cost> costs;  ///< the last variable runs fastest
};

class TreeSolver {
 public:
  TreeSolver(const Residual& residual, std::size_t most) : residual_(residual), most_(static_cast<double>(most)) {}

  std::optional<TreeSolution> solve() {
    if (!plan() || !add_functions()) return std::nullopt;
    constant_ = residual_.constant;
    for (Step& step : steps_) eliminate(step);
    TreeSolution solution{constant_, std::vector<int>(residual_.variables.size(), 0)};
    for (std::size_t s = steps_.size(); s-- > 0;) {
      std::size_t place = 0;
      for (const int v : steps_[s].scope) place = place * size(v) + index(solution.labels[index(v)]);
      solution.labels[index(steps_[s].variable)] = steps_[s].best[place];
    }
    return solution;
  }

 private:
  struct Step {
    int variable;
    std::vector<int> scope;  ///< the variables that are left and meet it, ascending
    std::vector<int> best{}; ///< its label for each of their tuples
  };

  std::size_t size(int v) const { return residual_.variables[index(v)].labels.size(); }
  double size(const std::vector<int>& scope) const {
    double product = 1;
    for (const int v : scope) product *= static_cast<double>(size(v));
    return product;
  }

  static std::vector<int> scope_of(const Residual::Need& need) {
    std::vector<int> scope{need.x};
    for (const auto& support : need.supports) scope.push_back(support.variable);
    return sorted(std::move(scope));
  }
  static std::vector<int> scope_of(const Residual::Count& count) {
    std::vector<int> scope;
    if (count.x >= 0) scope.push_back(count.x);
    for (const auto& member : count.members) scope.push_back(member.first);
    return sorted(std::move(scope));
  }
  static std::vector<int> sorted(std::vector<int> scope) {
    std::sort(scope.begin(), scope.end());
    scope.erase(std::unique(scope.begin(), scope.end()), scope.end());
    return scope;
  }

  /// The order of elimination, as long as all tables together have room.
  bool plan() {
    const std::size_t count = residual_.variables.size();
    std::vector<std::vector<int>> neighbours(count);
    const auto join = [&](const std::vector<int>& scope) {
      for (const int a : scope)
        for (const int b : scope)
          if (a != b) neighbours[index(a)].push_back(b);
    };
    for (const auto& pair : residual_.pairs) join({pair.x, pair.y});
    for (const auto& need : residual_.needs) join(scope_of(need));
    for (const auto& of : residual_.counts) join(scope_of(of));
    for (auto& own : neighbours) own = sorted(std::move(own));
    std::vector<char> gone(count, 0);
    double room = most_;
    for (std::size_t step = 0; step < count; ++step) {
      int best = -1;
      double least = 0;
      for (std::size_t v = 0; v < count; ++v) {
        if (gone[v] != 0) continue;
        const double entries = size(neighbours[v]) * static_cast<double>(residual_.variables[v].labels.size());
        if (best < 0 || entries < least) best = static_cast<int>(v), least = entries;
      }
      if ((room -= least) < 0) return false;
      gone[index(best)] = 1;
      const std::vector<int> scope = neighbours[index(best)];
      for (const int v : scope) {
        auto& own = neighbours[index(v)];
        own.insert(own.end(), scope.begin(), scope.end());
        own = sorted(std::move(own));
        std::erase_if(own, [&](int other) { return other == best || other == v; });
      }
      steps_.push_back({best, scope});
    }
    return true;
  }

  /// Visits all tuples of a scope, the last variable running fastest.
  void for_each(const std::vector<int>& scope, const auto& visit) const {
    std::vector<int> tuple(scope.size(), 0);
    for (;;) {
      visit(tuple);
      std::size_t i = scope.size();
      while (i-- > 0) {
        if (++tuple[i] < static_cast<int>(size(scope[i]))) break;
        tuple[i] = 0;
      }
      if (i == std::numeric_limits<std::size_t>::max()) return;
    }
  }

  /// Writes a function out: `cost_of` gets a way to ask for the label of a variable of the scope. False: too large.
  bool tabulate(const std::vector<int>& scope, const auto& cost_of) {
    if (size(scope) > most_) return false;
    CostTable table{scope, {}};
    for_each(scope, [&](const std::vector<int>& tuple) {
      table.costs.push_back(cost_of([&](int v) {
        return tuple[index(static_cast<int>(std::lower_bound(scope.begin(), scope.end(), v) - scope.begin()))];
      }));
    });
    tables_.push_back(std::move(table));
    return true;
  }

  bool add_functions() {
    for (const auto& pair : residual_.pairs) tables_.push_back({{pair.x, pair.y}, pair.costs});
    for (const auto& need : residual_.needs) {
      const auto cost_of = [&](const auto& label) {
        if (label(need.x) != need.label) return Cost{0};
        Cost cost = need.weight;
        for (const auto& support : need.supports)
          if (label(support.variable) == support.label) cost = std::min(cost, support.cost);
        return cost;
      };
      if (!tabulate(scope_of(need), cost_of)) return false;
    }
    for (const auto& of : residual_.counts) {
      const auto cost_of = [&](const auto& label) {
        int held = 0;
        for (const auto& [v, counts] : of.members) held += counts[index(label(v))];
        return of.x >= 0 && label(of.x) != of.label ? 0 : of.violation(held);
      };
      if (!tabulate(scope_of(of), cost_of)) return false;
    }
    return true;
  }

  void eliminate(Step& step) {
    std::vector<CostTable> inputs;
    std::erase_if(tables_, [&](CostTable& table) {
      if (!std::binary_search(table.scope.begin(), table.scope.end(), step.variable)) return false;
      inputs.push_back(std::move(table));
      return true;
    });
    std::vector<std::vector<std::size_t>> strides;  // of each input: of the scope, and last of the variable itself
    for (const CostTable& table : inputs) {
      auto& of = strides.emplace_back(step.scope.size() + 1, 0);
      std::size_t stride = 1;
      for (std::size_t i = table.scope.size(); i-- > 0;) {
        const int v = table.scope[i];
        const bool own = v == step.variable;
        of[own ? step.scope.size() : static_cast<std::size_t>(std::lower_bound(step.scope.begin(), step.scope.end(), v) - step.scope.begin())] = stride;
        stride *= size(v);
      }
    }
    CostTable result{step.scope, {}};
    const auto& own = residual_.variables[index(step.variable)].costs;
    for_each(step.scope, [&](const std::vector<int>& tuple) {
      sums_.assign(own.begin(), own.end());
      for (std::size_t t = 0; t < inputs.size(); ++t) {
        std::size_t place = 0;
        for (std::size_t i = 0; i < tuple.size(); ++i) place += strides[t][i] * index(tuple[i]);
        for (Cost& sum : sums_) {
          sum = std::min(sum + inputs[t].costs[place], kTop);
          place += strides[t].back();
        }
      }
      const auto least = std::min_element(sums_.begin(), sums_.end());
      result.costs.push_back(*least);
      step.best.push_back(static_cast<int>(least - sums_.begin()));
    });
    if (step.scope.empty())
      constant_ = std::min(constant_ + result.costs[0], kTop);
    else
      tables_.push_back(std::move(result));
  }

  const Residual& residual_;
  double most_;
  Cost constant_ = 0;
  std::vector<CostTable> tables_{};
  std::vector<Step> steps_{};
  std::vector<Cost> sums_{};
};

}  // namespace

std::optional<TreeSolution> solve_by_elimination(const Residual& residual, std::size_t most) {
  return TreeSolver(residual, most).solve();
}

}  // namespace scenelore::engine
