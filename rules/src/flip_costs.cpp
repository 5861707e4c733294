#include "flip_costs.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace scenelore::rules {

namespace {

using engine::Literal;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Flips {
 public:
  Flips(const engine::Problem& problem, const std::vector<int>& assignment) : problem_(problem), now_(assignment) {
    for (const engine::Variable& variable : problem.variables()) delta.emplace_back(variable.costs.size(), 0.0);
  }

  void add_variables() {
    for (std::size_t v = 0; v < now_.size(); ++v) {
      const std::vector<double>& costs = problem_.variables()[v].costs;
      for (std::size_t l = 0; l < costs.size(); ++l) delta[v][l] += costs[l] - costs[at(now_[v])];
    }
  }

  void add(const engine::ConstraintView& constraint) {
    if (const auto* conflict = constraint.as<engine::Conflict>()) return add(*conflict, constraint.weight);  // most of them
    constraint.visit([&](const auto& body) { add(body, constraint.weight); });
  }

  std::vector<std::vector<double>> delta;

 private:
  [[nodiscard]] bool holds(Literal l) const { return now_[at(l.variable)] == l.label; }
  void change(Literal to, double cost) { delta[at(to.variable)][at(to.label)] += cost; }
  /// Every label but the present one of a variable costs so much more.
  void leave(int variable, double cost) {
    if (cost == 0) return;
    for (int l = 0; l < static_cast<int>(delta[at(variable)].size()); ++l) {
      if (l != now_[at(variable)]) change({variable, l}, cost);
    }
  }

  void add(const engine::Conflict& body, double weight) {
    const bool a = holds(body.a), b = holds(body.b);
    if (a && b) {
      leave(body.a.variable, -weight);
      leave(body.b.variable, -weight);
    } else if (a) {
      change(body.b, weight);
    } else if (b) {
      change(body.a, weight);
    }
  }

  void add(const engine::PairTable& body, double weight) {
    const std::vector<double>& table = problem_.table(body.table);
    const int labels_b = static_cast<int>(delta[at(body.b)].size());
    const auto cost = [&](int a, int b) {
      const double entry = table[at(a * labels_b + b)];
      return entry == 0 ? 0 : entry == kInfinite || weight == kInfinite ? kInfinite : entry * weight;
    };
    const int a = now_[at(body.a)], b = now_[at(body.b)];
    const double present = cost(a, b);
    for (int l = 0; l < static_cast<int>(delta[at(body.a)].size()); ++l) change({body.a, l}, cost(l, b) - present);
    for (int l = 0; l < labels_b; ++l) change({body.b, l}, cost(a, l) - present);
  }

  void add(const engine::Requirement& body, double weight) {
    double best = weight, second = weight;  // of the supports that hold; of those at other planes than the best
    int best_variable = -1;
    for (const engine::Support& support : body.supports) {
      if (!holds(support.literal) || (best_variable >= 0 && support.cost >= best)) continue;
      best = support.cost;
      best_variable = support.literal.variable;
    }
    for (const engine::Support& support : body.supports) {
      if (holds(support.literal) && support.literal.variable != best_variable) second = std::min(second, support.cost);
    }
    if (!holds(body.literal)) return change(body.literal, best);
    leave(body.literal.variable, -best);
    // Cost after the change of a variable: without it as a support, or with what its new label supports.
    std::map<Literal, double> after;
    if (best_variable >= 0) {
      for (int l = 0; l < static_cast<int>(delta[at(best_variable)].size()); ++l) after[{best_variable, l}] = second;
    }
    for (const engine::Support& support : body.supports) {
      const auto entry = after.try_emplace(support.literal, best).first;
      entry->second = std::min(entry->second, support.cost);
    }
    for (const auto& [literal, cost] : after) {
      if (!holds(literal) && cost != best) change(literal, cost - best);
    }
  }

  void add(const engine::Cardinality& body, double weight) {
    const auto cost = [&](int count) {
      const int off = std::max({body.low - count, count - body.high, 0});
      return off == 0 ? 0.0 : off * weight;
    };
    const std::set<Literal> literals(body.literals.begin(), body.literals.end());
    const int count = static_cast<int>(std::count_if(literals.begin(), literals.end(), [&](Literal l) { return holds(l); }));
    if (body.condition) {
      if (!holds(*body.condition)) return change(*body.condition, cost(count));
      leave(body.condition->variable, -cost(count));
    }
    std::set<int> counted;  // variables that count now
    for (const Literal& l : literals) {
      if (holds(l)) counted.insert(l.variable);
    }
    const double present = cost(count);
    for (const int variable : counted) {
      for (int l = 0; l < static_cast<int>(delta[at(variable)].size()); ++l) {
        if (!literals.contains({variable, l})) change({variable, l}, cost(count - 1) - present);
      }
    }
    for (const Literal& l : literals) {
      if (!counted.contains(l.variable)) change(l, cost(count + 1) - present);
    }
  }

  const engine::Problem& problem_;
  const std::vector<int>& now_;
};

}  // namespace

std::vector<std::vector<double>> flip_costs(const engine::Problem& problem, const std::vector<int>& assignment) {
  Flips flips(problem, assignment);
  flips.add_variables();
  for (const engine::ConstraintView constraint : problem.constraints()) flips.add(constraint);
  return std::move(flips.delta);
}

std::vector<std::vector<double>> flip_costs(const engine::Problem& problem, const std::vector<int>& assignment,
                                            std::span<const int> constraints) {
  Flips flips(problem, assignment);
  for (const int index : constraints) flips.add(problem.constraints()[at(index)]);
  return std::move(flips.delta);
}

}  // namespace scenelore::rules
