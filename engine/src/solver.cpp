#include "scenelore/engine/solver.hpp"

#include <algorithm>
#include <cmath>
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

void require_literal(const Problem& problem, const Literal& literal) {
  const auto& variables = problem.variables();
  if (literal.variable < 0 || literal.variable >= static_cast<int>(variables.size()) || literal.label < 0 ||
      literal.label >= static_cast<int>(variables[static_cast<std::size_t>(literal.variable)].labels.size()))
    throw Error("assumption: there is no literal (" + std::to_string(literal.variable) + ", " +
                std::to_string(literal.label) + ")");
}

}  // namespace

Solver::Implementation::Implementation(const Problem& of, SolverOptions with)
    : problem(of), options(with), scale(of), revision(of.revision()) {}

void Solver::Implementation::refresh() {
  if (revision == problem.revision()) return;
  revision = problem.revision();
  scale = Scale(problem);
  cutoff = -1;
  asked = 0;
  parts = {};
  met.clear();
  best_world.clear();
  polished_world.clear();
  local_search.reset();
  outlined.reset();
}

Search::Report Solver::Implementation::report(const Component& component) const {
  if (options.observer == nullptr) return {};
  return {options.observer,
          [&component](int v, int label) {
            const auto place = static_cast<std::size_t>(v);
            return Literal{component.variables[place], component.labels[place][static_cast<std::size_t>(label)]};
          },
          [this](Cost cost) { return scale.real(cost); }};
}

const Outline& Solver::Implementation::outline() const {
  if (!outlined) outlined.emplace(problem, scale);
  return *outlined;
}

bool Solver::Implementation::feasible() const {
  return parts.broken < 0 && !is_forbidden(parts.constant) && std::all_of(parts.components.begin(), parts.components.end(),
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

Cost Solver::Implementation::least_cost(const Component& component) const {
  return component.best.empty() ? component.network.bound() : component.best_cost;
}

/// A label was forbidden: one search for each other label of its variable, the most promising first. Each begins with
/// more known than one search over all of them, and most need not begin, since the root says that they cost too much.
SearchResult Solver::Implementation::split(Component& component, Search& search, const std::vector<Decision>& decisions,
                                           Cost limit) const {
  const Network& network = component.network;
  const int v = decisions.back().variable;
  std::vector<std::pair<Cost, int>> labels;
  for (const int label : network.live(v))
    if (std::none_of(decisions.begin(), decisions.end(),
                     [&](const Decision& d) { return d.variable == v && (d.label == label) != d.equal; }))
      labels.emplace_back(network.bound() + network.unary(v, label), label);
  std::sort(labels.begin(), labels.end());
  SearchResult result;
  result.cost = result.lower_bound = limit;
  result.complete = true;
  for (const auto& [bound, label] : labels) {
    if (bound >= result.cost) break;
    std::vector<Decision> with = decisions;
    with.push_back({v, label, true});
    const SearchResult part = search.run(with, result.cost);
    result.complete = result.complete && part.complete;
    result.lower_bound = std::min(result.lower_bound, std::max(bound, part.lower_bound));
    if (part.assignment.empty()) continue;
    result.cost = part.cost;
    result.assignment = part.assignment;
  }
  result.lower_bound = std::min(result.lower_bound, result.cost);
  return result;
}

SearchResult Solver::Implementation::solve(Component& component, const std::vector<Decision>& decisions, Budget& budget,
                                           Cost limit) {
  SearchResult result;
  result.cost = limit;
  if (!component.feasible) {
    result.complete = true;
    result.lower_bound = kTop;
    return result;
  }
  if (!component.best.empty() && component.best_cost < limit && agrees(component.best, decisions))
    return {component.best_cost, component.best_cost, component.best, true};
  if (Reduction* reduced = reduction(component, limit))
    return solve_reduced(component, *reduced, decisions, budget, limit);
  std::vector<int> known;
  for (const auto& [cost, labels] : component.pool)
    if (cost < result.cost && agrees(labels, decisions)) result.cost = cost, known = labels;
  const Search::Report events = report(component);
  Search search(component.network, budget, events);
  if (!known.empty())
    search.prefer(known);
  else if (!component.best.empty())
    search.prefer(component.best);
  search.eliminate(options.elimination);
  search.dominate(options.dominance && options.bound != Bound::paper && decisions.empty());
  if (component.whole && options.bound != Bound::paper)
    search.polish_with([&](Cost of, std::uint64_t sweeps) { return polished(component, decisions, of, sweeps, budget); });
  const bool splits = !decisions.empty() && !decisions.back().equal;
  result = splits ? split(component, search, decisions, result.cost) : search.run(decisions, result.cost);
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
  if (assignment.empty() && (!complete || lower_bound == kTop)) {  // an empty problem has an empty answer
    solution.outcome = complete ? Outcome::infeasible : Outcome::stopped;
    if (complete) solution.lower_bound = kInfinity;
    return solution;
  }
  Check checked = check(problem, assignment, outline().relevant(assignment));
  if (!checked.valid) throw std::logic_error("the search returned an assignment that the checker refuses");
  solution.outcome = complete ? Outcome::proved : Outcome::feasible;
  solution.cost = checked.cost;
  solution.lower_bound = complete ? checked.cost : std::min(checked.cost, solution.lower_bound);
  solution.violations = std::move(checked.violations);
  solution.assignment = std::move(assignment);
  return solution;
}

Solution Solver::Implementation::solve(const Assumptions& assumptions, Budget& budget) {
  for (const auto* literals : {&assumptions.fixed, &assumptions.forbidden})
    for (const Literal& literal : *literals) require_literal(problem, literal);
  const Cost below = std::min(scale.whole(std::max(assumptions.below, 0.0)), kTop / 2);
  const Cost limit = std::min(below, upper_limit(assumptions, budget));
  if (!reach(limit, budget)) return unbuilt(assumptions, budget);
  const auto none_below = [&] {
    return is_forbidden(below) ? finish({}, true, kTop, budget) : finish({}, false, below, budget);
  };
  if (!feasible()) return none_below();

  std::vector<std::vector<Decision>> decisions(parts.components.size());
  const auto assume = [&](const Literal& literal, bool equal) {
    const auto v = static_cast<std::size_t>(literal.variable);
    const int label = parts.label_in[v][static_cast<std::size_t>(literal.label)];
    if (parts.component_of[v] < 0) return (label >= 0) == equal;
    if (label >= 0)
      decisions[static_cast<std::size_t>(parts.component_of[v])].push_back({parts.index_in[v], label, equal});
    return label >= 0 || !equal;
  };
  for (const Literal& literal : assumptions.fixed)
    if (!assume(literal, true)) return none_below();
  for (const Literal& literal : assumptions.forbidden)
    if (!assume(literal, false)) return none_below();

  Cost least = parts.constant;
  for (const Component& component : parts.components) least += least_cost(component);
  if (least >= limit && !is_forbidden(limit)) return none_below();
  std::vector<int> assignment = parts.settled;
  bool complete = true, whole = true;
  Cost lower_bound = parts.constant;
  for (std::size_t c = 0; c < parts.components.size(); ++c) {
    Component& component = parts.components[c];
    const Cost of_part = is_forbidden(limit) ? limit : std::max<Cost>(0, limit - (least - least_cost(component)));
    const SearchResult part = solve(component, decisions[c], budget, of_part);
    if (part.complete && part.assignment.empty()) return none_below();
    complete = complete && part.complete;
    whole = whole && !part.assignment.empty();
    lower_bound += part.lower_bound;
    translate(component, part.assignment, assignment);
  }
  if (!whole) assignment.clear();
  Solution solution = finish(std::move(assignment), complete, lower_bound, budget);
  if (!solution.assignment.empty()) meet(solution.assignment, solution.cost);
  if (complete && assumptions.fixed.empty() && assumptions.forbidden.empty()) best_world = solution.assignment;
  return solution;
}

Solver::Solver(const Problem& problem, SolverOptions options)
    : implementation_(std::make_unique<Implementation>(problem, options)) {}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

Solution Solver::solve(const Assumptions& assumptions) {
  implementation_->refresh();
  Budget budget(implementation_->options.limits);
  return implementation_->solve(assumptions, budget);
}
std::vector<Solution> Solver::k_best(int k) {
  implementation_->refresh();
  return implementation_->k_best(k);
}
MinMarginals Solver::min_marginals() {
  implementation_->refresh();
  return implementation_->min_marginals();
}
Marginals Solver::marginals(int most_worlds) {
  implementation_->refresh();
  return implementation_->marginals(most_worlds);
}
Conflicting Solver::conflict() {
  implementation_->refresh();
  Conflicting result;
  result.constraints = implementation_->conflict(result.minimal);
  return result;
}

}  // namespace scenelore::engine
