// The cheapest relaxation: the same problem with each hard constraint at a price that outweighs all that can be paid.
#include <algorithm>
#include <cmath>

#include "scenelore/engine/checker.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {
namespace {

double largest(const std::vector<double>& costs) {
  double most = 0;
  for (const double cost : costs)
    if (std::isfinite(cost)) most = std::max(most, cost);
  return most;
}

/// More than all finite costs together.
double more_than_all(const Problem& problem) {
  double sum = 1;
  for (const Variable& variable : problem.variables()) sum += largest(variable.costs);
  for (const ConstraintView constraint : problem.constraints()) {
    const double weight = std::isfinite(constraint.weight) ? constraint.weight : 0;
    if (const auto* pair = constraint.as<PairTable>())
      sum += weight * largest(problem.table(pair->table));
    else if (const auto* cardinality = constraint.as<Cardinality>())
      sum += weight * static_cast<double>(cardinality->literals.size() + static_cast<std::size_t>(std::max(cardinality->low, 0)));
    else
      sum += weight;
    if (const auto* requirement = constraint.as<Requirement>(); requirement != nullptr && weight == 0)
      for (const Support& support : requirement->supports) sum += std::isfinite(support.cost) ? support.cost : 0;
  }
  return sum;
}

/// The allowed part of a table, and what it forbids as a table of 0 and 1.
void add_table(Problem& relaxed, const Problem& problem, const ConstraintView& constraint, const PairTable& pair, double price) {
  const auto [rows, columns] = problem.table_size(pair.table);
  std::vector<double> allowed = problem.table(pair.table), forbidden;
  for (double& cost : allowed) {
    forbidden.push_back(std::isinf(cost) || (constraint.weight == kHard && cost > 0) ? 1 : 0);
    if (forbidden.back() > 0) cost = 0;
  }
  if (constraint.weight != kHard)
    relaxed.add(constraint.name, constraint.weight, -1, PairTable{pair.a, pair.b, relaxed.add_table(rows, columns, allowed)});
  relaxed.add(constraint.name, price, -1, PairTable{pair.a, pair.b, relaxed.add_table(rows, columns, forbidden)});
}

}  // namespace

Relaxation cheapest_relaxation(const Problem& problem, const SolverOptions& options) {
  const double price = more_than_all(problem);
  Problem relaxed;
  for (const Variable& variable : problem.variables()) relaxed.add_variable(variable.name, variable.labels, variable.costs);
  for (const ConstraintView constraint : problem.constraints()) {
    if (const auto* pair = constraint.as<PairTable>()) {
      add_table(relaxed, problem, constraint, *pair, price);
      continue;
    }
    auto body = Constraint(constraint).body;
    if (auto* requirement = std::get_if<Requirement>(&body))
      std::erase_if(requirement->supports, [](const Support& support) { return std::isinf(support.cost); });
    relaxed.add(constraint.name, std::min(constraint.weight, price), -1, std::move(body));
  }
  Relaxation result{Solver(relaxed, options).solve(), {}};
  Solution& solution = result.solution;
  if (solution.assignment.empty()) return result;
  Check real = check(problem, solution.assignment);
  double cost = 0;
  for (std::size_t v = 0; v < solution.assignment.size(); ++v)
    cost += problem.variables()[v].costs[static_cast<std::size_t>(solution.assignment[v])];
  for (const Violation& violation : real.violations) {
    if (std::isinf(violation.amount))
      result.constraints.push_back(violation.constraint);
    else
      cost += violation.amount;
  }
  solution.lower_bound = solution.outcome == Outcome::proved ? cost : 0;
  solution.cost = cost;
  solution.violations = std::move(real.violations);
  return result;
}

}  // namespace scenelore::engine
