#include "file_builder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Makes the least finite cost 0 and returns what it was.
double lower_to_zero(std::vector<double>& costs) {
  const double least = *std::min_element(costs.begin(), costs.end());
  if (!std::isfinite(least) || least == 0) return 0;
  for (double& cost : costs) cost -= least;
  return least;
}

}  // namespace

void FileBuilder::add_variable(std::string name, std::vector<std::string> labels) {
  std::vector<double> costs(labels.size(), 0.0);
  variables_.push_back({std::move(name), std::move(labels), std::move(costs)});
}

std::size_t FileBuilder::tuples(const std::vector<int>& scope) const {
  std::size_t product = 1;
  for (const int v : scope) product = std::min(kMostTuples + 1, product * labels(v).size());
  return product;
}

void FileBuilder::add_function(const std::string& name, const std::vector<int>& scope, std::vector<double> costs) {
  for (double& cost : costs)
    if (cost >= top_) cost = kHard;
  if (scope.empty()) {
    if (std::isfinite(costs[0])) {
      constant_ += costs[0];
    } else {  // nothing is allowed
      functions_.push_back({name, {}, {kHard}});
    }
  } else if (scope.size() == 1) {
    auto& own = variables_[index(scope[0])].costs;
    for (std::size_t l = 0; l < own.size(); ++l) own[l] += costs[l];
  } else {
    constant_ += lower_to_zero(costs);
    if (std::any_of(costs.begin(), costs.end(), [](double cost) { return cost > 0; }))
      functions_.push_back({name, scope, std::move(costs)});
  }
}

ProblemFile FileBuilder::finish() {
  Auxiliaries auxiliaries = find_auxiliaries(variables_, functions_);
  constant_ += auxiliaries.constant;
  for (const auto& [literal, cost] : auxiliaries.charges) variables_[index(literal.variable)].costs[index(literal.label)] += cost;
  ProblemFile result;
  in_problem_.assign(variables_.size(), 0);
  for (const Follower& follower : auxiliaries.followers) in_problem_[index(follower.variable)] = -1;
  for (std::size_t v = 0; v < variables_.size(); ++v) {
    Variable& variable = variables_[v];
    if (in_problem_[v] == 0) {
      constant_ += lower_to_zero(variable.costs);
      in_problem_[v] = problem_.add_variable(variable.name, variable.labels, variable.costs);
    }
    result.variables.push_back({variable.name, variable.labels, in_problem_[v]});
  }
  for (std::size_t f = 0; f < functions_.size(); ++f)
    if (auxiliaries.gone[f] != 0) functions_[f].costs = {};
  const auto each = [&](const auto& visit) {
    for (std::size_t f = 0; f < functions_.size(); ++f)
      if (auxiliaries.gone[f] == 0) visit(functions_[f]);
  };
  each([&](const FileFunction& function) {
    if (function.scope.empty())
      problem_.add_variable(function.name, {"nothing"}, {kHard});
    else if (function.scope.size() > 2)
      add_many(function);
  });
  each([&](FileFunction& function) {
    if (function.scope.size() == 2) add_pair(function);
  });
  for (Constraint& constraint : auxiliaries.constraints) add_found(constraint);
  result.followers = std::move(auxiliaries.followers);
  result.problem = std::move(problem_);
  result.constant = constant_;
  if (std::isfinite(top_)) result.below = top_ - constant_;
  return result;
}

/// From variables of the file to those of the problem.
void FileBuilder::add_found(Constraint& constraint) {
  const auto translate = [&](Literal& literal) { literal.variable = in_problem_[index(literal.variable)]; };
  if (auto* requirement = std::get_if<Requirement>(&constraint.body)) {
    translate(requirement->literal);
    for (Support& support : requirement->supports) translate(support.literal);
  } else if (auto* cardinality = std::get_if<Cardinality>(&constraint.body)) {
    if (cardinality->condition) translate(*cardinality->condition);
    for (Literal& literal : cardinality->literals) translate(literal);
  }
  problem_.add(constraint.name, constraint.weight, -1, constraint.body);
}

void FileBuilder::add_pair(FileFunction& function) {
  const int a = function.scope[0], b = function.scope[1];
  const int table = problem_.add_table(static_cast<int>(labels(a).size()), static_cast<int>(labels(b).size()), std::move(function.costs));
  problem_.add(function.name, 1, -1, PairTable{in_problem_[index(a)], in_problem_[index(b)], table});
}

/// A variable whose labels are the allowed tuples, each agreeing with the variables of the scope.
void FileBuilder::add_many(const FileFunction& function) {
  std::vector<std::vector<int>> tuples;
  std::vector<std::string> names;
  std::vector<double> costs;
  std::vector<int> tuple(function.scope.size(), 0);
  for (const double cost : function.costs) {
    if (std::isfinite(cost)) {
      tuples.push_back(tuple);
      names.push_back("t" + std::to_string(names.size()));
      costs.push_back(cost);
    }
    for (std::size_t i = tuple.size(); i-- > 0;) {
      if (++tuple[i] < static_cast<int>(labels(function.scope[i]).size())) break;
      tuple[i] = 0;
    }
  }
  if (tuples.empty()) {
    problem_.add_variable(function.name, {"nothing"}, {kHard});
    return;
  }
  const int variable = problem_.add_variable(function.name, std::move(names), std::move(costs));
  for (std::size_t i = 0; i < function.scope.size(); ++i) {
    const std::size_t columns = labels(function.scope[i]).size();
    std::vector<double> differs(tuples.size() * columns, 1.0);
    for (std::size_t t = 0; t < tuples.size(); ++t) differs[t * columns + index(tuples[t][i])] = 0;
    const int table = problem_.add_table(static_cast<int>(tuples.size()), static_cast<int>(columns), std::move(differs));
    problem_.add(function.name, kHard, -1, PairTable{variable, in_problem_[index(function.scope[i])], table});
  }
}

}  // namespace scenelore::engine
