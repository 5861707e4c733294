#include "scenelore/engine/checker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace scenelore::engine {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What each kind of constraint adds to the cost of one assignment, read word by word from problem.hpp.
struct Price {
  const Problem& problem;
  const std::vector<int>& assignment;
  double weight;

  bool holds(const Literal& literal) const {
    return assignment[static_cast<std::size_t>(literal.variable)] == literal.label;
  }

  double operator()(const Conflict& conflict) const { return holds(conflict.a) && holds(conflict.b) ? weight : 0; }

  double operator()(const Requirement& requirement) const {
    if (!holds(requirement.literal)) return 0;
    double least = weight;
    for (const Support& support : requirement.supports)
      if (holds(support.literal)) least = std::min(least, support.cost);
    return least;
  }

  double operator()(const Cardinality& cardinality) const {
    if (cardinality.condition && !holds(*cardinality.condition)) return 0;
    std::vector<Literal> held;  // a literal that is listed twice counts once
    for (const Literal& literal : cardinality.literals)
      if (holds(literal)) held.push_back(literal);
    std::sort(held.begin(), held.end());
    const int count = static_cast<int>(std::unique(held.begin(), held.end()) - held.begin());
    const double off =
        std::max({0.0, static_cast<double>(cardinality.low) - count, count - static_cast<double>(cardinality.high)});
    return off > 0 ? weight * off : 0;
  }

  double operator()(const PairTable& pair) const {
    const auto columns = static_cast<std::size_t>(problem.table_size(pair.table).second);
    const auto row = static_cast<std::size_t>(assignment[static_cast<std::size_t>(pair.a)]);
    const auto column = static_cast<std::size_t>(assignment[static_cast<std::size_t>(pair.b)]);
    const double entry = problem.table(pair.table)[row * columns + column];
    if (!(entry > 0)) return 0;
    return std::isinf(entry) || std::isinf(weight) ? kInfinity : entry * weight;
  }
};

bool labels_exist(const Problem& problem, const std::vector<int>& assignment) {
  const auto& variables = problem.variables();
  if (assignment.size() != variables.size()) return false;
  for (std::size_t v = 0; v < variables.size(); ++v)
    if (assignment[v] < 0 || assignment[v] >= static_cast<int>(variables[v].labels.size())) return false;
  return true;
}

}  // namespace

Check check(const Problem& problem, const std::vector<int>& assignment, const std::vector<int>& constraints) {
  Check result;
  result.cost = kInfinity;
  if (!labels_exist(problem, assignment)) return result;
  double cost = 0;
  for (std::size_t v = 0; v < assignment.size(); ++v)
    cost += problem.variables()[v].costs[static_cast<std::size_t>(assignment[v])];
  for (const int c : constraints) {
    const ConstraintView constraint = problem.constraints()[static_cast<std::size_t>(c)];
    const double amount = constraint.visit(Price{problem, assignment, constraint.weight});
    if (!(amount > 0)) continue;
    result.violations.push_back({c, amount});
    cost += amount;
  }
  result.valid = std::isfinite(cost);
  result.cost = cost;
  return result;
}

Check check(const Problem& problem, const std::vector<int>& assignment) {
  std::vector<int> all(problem.constraints().size());
  std::iota(all.begin(), all.end(), 0);
  return check(problem, assignment, all);
}

}  // namespace scenelore::engine
