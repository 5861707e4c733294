#include "scenelore/engine/solver.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "implementation.hpp"
#include "scenelore/engine/checker.hpp"
#include "scenelore/engine/error.hpp"

namespace scenelore::engine {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostRemembered = 256;

bool agrees(const std::vector<int>& labels, const std::vector<Decision>& decisions) {
  return std::all_of(decisions.begin(), decisions.end(), [&](const Decision& d) {
    return (labels[static_cast<std::size_t>(d.variable)] == d.label) == d.equal;
  });
}

}  // namespace

Solver::Implementation::Implementation(const Problem& of, SolverOptions with)
    : problem(of), options(with), scale(of), parts(decompose(of, scale, with.bound)) {}

Search::Report Solver::Implementation::report(const Component& component) const {
  if (options.observer == nullptr) return {};
  return {options.observer,
          [&component](int v, int label) {
            return Literal{component.variables[static_cast<std::size_t>(v)], label};
          },
          [this](Cost cost) { return scale.real(cost); }};
}

bool Solver::Implementation::feasible() const {
  return parts.broken < 0 && std::all_of(parts.components.begin(), parts.components.end(),
                                         [](const Component& component) { return component.feasible; });
}

void Solver::Implementation::remember(Component& component, const std::vector<int>& labels, Cost cost) const {
  auto& pool = component.pool;
  for (const auto& known : pool)
    if (known.second == labels) return;
  if (pool.size() < kMostRemembered) {
    pool.emplace_back(cost, labels);
    return;
  }
  const auto dearest = std::max_element(pool.begin(), pool.end());
  if (cost < dearest->first) *dearest = {cost, labels};
}

SearchResult Solver::Implementation::solve(Component& component, const std::vector<Decision>& decisions,
                                           Budget& budget) {
  SearchResult result;
  result.cost = kTop / 2;
  if (!component.feasible) {
    result.complete = true;
    result.lower_bound = kTop;
    return result;
  }
  if (!component.best.empty() && agrees(component.best, decisions))
    return {component.best_cost, component.best_cost, component.best, true};
  std::vector<int> known;
  for (const auto& [cost, labels] : component.pool)
    if (cost < result.cost && agrees(labels, decisions)) result.cost = cost, known = labels;
  const Search::Report events = report(component);
  Search search(component.network, budget, events);
  if (!known.empty())
    search.prefer(known);
  else if (!component.best.empty())
    search.prefer(component.best);
  result = search.run(decisions, result.cost);
  if (result.assignment.empty())
    result.assignment = known;
  else
    remember(component, result.assignment, result.cost);
  if (!component.best.empty()) result.lower_bound = std::max(result.lower_bound, component.best_cost);
  if (result.complete && decisions.empty() && !result.assignment.empty()) {
    component.best = result.assignment;
    component.best_cost = result.cost;
  }
  return result;
}

Solution Solver::Implementation::finish(std::vector<int> assignment, bool complete, Cost lower_bound,
                                        const Budget& budget) const {
  Solution solution;
  solution.nodes = budget.nodes;
  solution.backtracks = budget.backtracks;
  solution.seconds = budget.seconds();
  solution.lower_bound = scale.real(lower_bound);
  if (assignment.empty() && (!complete || lower_bound == kTop)) {
    solution.outcome = complete ? Outcome::infeasible : Outcome::stopped;
    if (complete) solution.lower_bound = kInfinity;
    return solution;
  }
  Check checked = check(problem, assignment);
  if (!checked.valid) throw std::logic_error("the search returned an assignment that the checker refuses");
  solution.outcome = complete ? Outcome::proved : Outcome::feasible;
  solution.cost = checked.cost;
  solution.lower_bound = complete ? checked.cost : std::min(checked.cost, solution.lower_bound);
  solution.violations = std::move(checked.violations);
  solution.assignment = std::move(assignment);
  return solution;
}

Solution Solver::Implementation::solve(const Assumptions& assumptions) {
  Budget budget(options.limits);
  std::vector<std::vector<Decision>> decisions(parts.components.size());
  const auto assume = [&](const Literal& literal, bool equal) {
    const auto& variables = problem.variables();
    if (literal.variable < 0 || literal.variable >= static_cast<int>(variables.size()) || literal.label < 0 ||
        literal.label >= static_cast<int>(variables[static_cast<std::size_t>(literal.variable)].labels.size()))
      throw Error("assumption: there is no literal (" + std::to_string(literal.variable) + ", " +
                  std::to_string(literal.label) + ")");
    const auto v = static_cast<std::size_t>(literal.variable);
    decisions[static_cast<std::size_t>(parts.component_of[v])].push_back({parts.index_in[v], literal.label, equal});
  };
  for (const Literal& literal : assumptions.fixed) assume(literal, true);
  for (const Literal& literal : assumptions.forbidden) assume(literal, false);
  if (!feasible()) return finish({}, true, kTop, budget);

  std::vector<int> assignment(problem.variables().size(), -1);
  bool complete = true, whole = true;
  Cost lower_bound = parts.constant;
  for (std::size_t c = 0; c < parts.components.size(); ++c) {
    Component& component = parts.components[c];
    const SearchResult part = solve(component, decisions[c], budget);
    if (part.complete && part.assignment.empty()) return finish({}, true, kTop, budget);
    complete = complete && part.complete;
    whole = whole && !part.assignment.empty();
    lower_bound += part.lower_bound;
    for (std::size_t i = 0; i < part.assignment.size(); ++i)
      assignment[static_cast<std::size_t>(component.variables[i])] = part.assignment[i];
  }
  if (!whole) assignment.clear();
  return finish(std::move(assignment), complete, lower_bound, budget);
}

Solver::Solver(const Problem& problem, SolverOptions options)
    : implementation_(std::make_unique<Implementation>(problem, options)) {}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

Solution Solver::solve(const Assumptions& assumptions) { return implementation_->solve(assumptions); }
std::vector<Solution> Solver::k_best(int k) { return implementation_->k_best(k); }
MinMarginals Solver::min_marginals() { return implementation_->min_marginals(); }
Marginals Solver::marginals(int most_worlds) { return implementation_->marginals(most_worlds); }

}  // namespace scenelore::engine
