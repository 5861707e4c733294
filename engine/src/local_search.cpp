#include "local_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scope.hpp"

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

double finite_part(double cost) { return std::isfinite(cost) ? cost : 0; }

}  // namespace

LocalSearch::LocalSearch(const Problem& problem)
    : problem_(problem), first_(problem.variables().size() + 1, 0), first_conflict_(first_) {
  const auto& constraints = problem.constraints();
  for (const Variable& variable : problem.variables())
    for (const double cost : variable.costs) broken_ += finite_part(cost);
  for (const Constraint& constraint : constraints) {
    broken_ += finite_part(constraint.weight);
    if (const auto* conflict = std::get_if<Conflict>(&constraint.body)) {
      ++first_conflict_[index(conflict->a.variable) + 1];
      ++first_conflict_[index(conflict->b.variable) + 1];
    } else {
      for_each_variable(constraint, [&](int v) { ++first_[index(v) + 1]; });
    }
  }
  for (std::size_t v = 1; v < first_.size(); ++v) {
    first_[v] += first_[v - 1];
    first_conflict_[v] += first_conflict_[v - 1];
  }
  constraints_.resize(first_.back());
  conflicts_.resize(first_conflict_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  std::vector<std::size_t> next_conflict(first_conflict_.begin(), first_conflict_.end() - 1);
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    if (const auto* conflict = std::get_if<Conflict>(&constraints[c].body)) {
      const double weight = std::min(constraints[c].weight, broken_);
      const bool apart = conflict->a.variable != conflict->b.variable;
      const auto add = [&](const Literal& mine, const Literal& other, double price) {
        conflicts_[next_conflict[index(mine.variable)]++] = {mine.label, other, price};
      };
      add(conflict->a, conflict->b, apart || conflict->a == conflict->b ? weight : 0);
      add(conflict->b, conflict->a, apart ? weight : 0);  // one that is with itself is told once
      continue;
    }
    for_each_variable(constraints[c], [&](int v) {
      std::size_t& place = next[index(v)];
      if (place == first_[index(v)] || constraints_[place - 1] != static_cast<int>(c))
        constraints_[place++] = static_cast<int>(c);
    });
  }
  for (std::size_t v = 0; v < next.size(); ++v)  // a constraint may name a variable twice
    std::fill(constraints_.begin() + static_cast<std::ptrdiff_t>(next[v]),
              constraints_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]), -1);
}

std::vector<int> LocalSearch::begin(const Assumptions& assumptions, const std::vector<int>& start) {
  const auto& variables = problem_.variables();
  allowed_.clear();
  for (const Variable& variable : variables) {
    auto& row = allowed_.emplace_back();
    for (const double cost : variable.costs) row.push_back(std::isfinite(cost) ? 1 : 0);
  }
  for (const Literal& literal : assumptions.fixed)
    for (std::size_t l = 0; l < allowed_[index(literal.variable)].size(); ++l)
      if (l != index(literal.label)) allowed_[index(literal.variable)][l] = 0;
  for (const Literal& literal : assumptions.forbidden) allowed_[index(literal.variable)][index(literal.label)] = 0;
  std::vector<int> assignment;
  for (std::size_t v = 0; v < variables.size(); ++v) {
    const auto& costs = variables[v].costs;
    int best = 0;
    for (std::size_t l = 0; l < costs.size(); ++l)
      if (allowed_[v][l] != 0 && (allowed_[v][index(best)] == 0 || costs[l] < costs[index(best)]))
        best = static_cast<int>(l);
    if (!start.empty() && allowed_[v][index(start[v])] != 0) best = start[v];
    assignment.push_back(best);
  }
  return assignment;
}

void LocalSearch::descend(std::vector<int>& assignment, Budget& budget) {
  constexpr int kLeastSweeps = 4;  // these come first, so that there is something to keep
  constexpr int kMostSweeps = 100;
  bool changed = true;
  for (int sweep = 0; changed && sweep < kMostSweeps; ++sweep) {
    if (sweep >= kLeastSweeps && budget.out_of_time()) return;
    changed = false;
    for (std::size_t v = 0; v < assignment.size(); ++v) {
      if (std::count(allowed_[v].begin(), allowed_[v].end(), 1) < 2) continue;
      weigh(static_cast<int>(v), assignment);
      int& label = assignment[v];
      const int before = label;
      for (std::size_t l = 0; l < price_.size(); ++l)
        if (allowed_[v][l] != 0 && price_[l] < price_[index(label)] - 1e-9) label = static_cast<int>(l);
      changed = changed || label != before;
    }
  }
}

void LocalSearch::weigh(int v, const std::vector<int>& assignment) {
  price_ = problem_.variables()[index(v)].costs;
  for (std::size_t i = first_conflict_[index(v)]; i < first_conflict_[index(v) + 1]; ++i) {
    const OneConflict& conflict = conflicts_[i];
    // One with itself has a price whenever it is looked at.
    if (conflict.other.variable == v || assignment[index(conflict.other.variable)] == conflict.other.label)
      price_[index(conflict.mine)] += conflict.price;
  }
  for (std::size_t i = first_[index(v)]; i < first_[index(v) + 1] && constraints_[i] >= 0; ++i) {
    const Constraint& constraint = problem_.constraints()[index(constraints_[i])];
    const double weight = std::min(constraint.weight, broken_);
    if (const auto* requirement = std::get_if<Requirement>(&constraint.body))
      weigh(v, *requirement, weight, assignment);
    else if (const auto* cardinality = std::get_if<Cardinality>(&constraint.body))
      weigh(v, *cardinality, weight, assignment);
    else
      weigh(v, std::get<PairTable>(constraint.body), weight, assignment);
  }
}

void LocalSearch::weigh(int v, const Requirement& requirement, double weight, const std::vector<int>& assignment) {
  const Literal& owner = requirement.literal;
  const bool is_owner = owner.variable == v;
  if (!is_owner && assignment[index(owner.variable)] != owner.label) return;
  double least = weight;  // of the supports at other variables
  for (const Support& support : requirement.supports) {
    const Literal& literal = support.literal;
    if (literal == owner)
      least = std::min(least, support.cost);
    else if (literal.variable != v && literal.variable != owner.variable &&
             assignment[index(literal.variable)] == literal.label)
      least = std::min(least, support.cost);
  }
  if (is_owner) {
    price_[index(owner.label)] += least;
    return;
  }
  for (double& price : price_) price += least;
  for (std::size_t l = 0; l < price_.size(); ++l) {
    double with = least;
    for (const Support& support : requirement.supports)
      if (support.literal == Literal{v, static_cast<int>(l)}) with = std::min(with, support.cost);
    price_[l] -= least - with;
  }
}

void LocalSearch::weigh(int v, const Cardinality& cardinality, double weight, const std::vector<int>& assignment) {
  const auto& condition = cardinality.condition;
  if (condition && condition->variable != v && assignment[index(condition->variable)] != condition->label) return;
  int others = 0;
  std::vector<char> counts(price_.size(), 0);
  for (std::size_t i = 0; i < cardinality.literals.size(); ++i) {
    const Literal& literal = cardinality.literals[i];
    if (literal.variable == v)
      counts[index(literal.label)] = 1;
    else if (assignment[index(literal.variable)] == literal.label &&
             std::find(cardinality.literals.begin(), cardinality.literals.begin() + static_cast<std::ptrdiff_t>(i),
                       literal) == cardinality.literals.begin() + static_cast<std::ptrdiff_t>(i))
      ++others;  // a literal that is listed twice counts once
  }
  for (std::size_t l = 0; l < price_.size(); ++l) {
    if (condition && condition->variable == v && condition->label != static_cast<int>(l)) continue;
    const int count = others + counts[l];
    price_[l] += weight * std::max({0, cardinality.low - count, count - cardinality.high});
  }
}

void LocalSearch::weigh(int v, const PairTable& pair, double weight, const std::vector<int>& assignment) {
  const std::vector<double>& costs = problem_.table(pair.table);
  const int columns = problem_.table_size(pair.table).second;
  const bool is_a = pair.a == v;
  const int other = assignment[index(is_a ? pair.b : pair.a)];
  for (std::size_t l = 0; l < price_.size(); ++l) {
    const double entry = costs[index(is_a ? static_cast<int>(l) * columns + other : other * columns) + (is_a ? 0 : l)];
    if (entry > 0) price_[l] += std::isfinite(entry) ? weight * entry : broken_;
  }
}

}  // namespace scenelore::engine
