#include "relevant.hpp"

#include <algorithm>

namespace scenelore::engine {

Relevant::Relevant(const Problem& problem) {
  int labels = 0;
  for (const Variable& variable : problem.variables()) {
    first_label_.push_back(labels);
    labels += static_cast<int>(variable.labels.size());
  }
  of_label_.resize(static_cast<std::size_t>(labels));
  const auto of = [&](const Literal& literal) -> std::vector<Entry>& {
    return of_label_[static_cast<std::size_t>(first_label_[static_cast<std::size_t>(literal.variable)] + literal.label)];
  };
  for (std::size_t c = 0; c < problem.constraints().size(); ++c) {
    const auto& body = problem.constraints()[c].body;
    if (const auto* conflict = std::get_if<Conflict>(&body))
      of(conflict->a).push_back({static_cast<int>(c), conflict->b});
    else if (const auto* requirement = std::get_if<Requirement>(&body))
      of(requirement->literal).push_back({static_cast<int>(c), requirement->literal});
    else
      always_.push_back(static_cast<int>(c));
  }
}

std::vector<int> Relevant::constraints(const std::vector<int>& assignment) const {
  std::vector<int> all = always_;
  for (std::size_t v = 0; v < assignment.size(); ++v) {
    const auto& own = of_label_[static_cast<std::size_t>(first_label_[v] + assignment[v])];
    for (const auto& [constraint, too] : own) {
      if (assignment[static_cast<std::size_t>(too.variable)] == too.label) all.push_back(constraint);
    }
  }
  const auto found = all.begin() + static_cast<std::ptrdiff_t>(always_.size());
  std::sort(found, all.end());
  std::inplace_merge(all.begin(), found, all.end());
  return all;
}

}  // namespace scenelore::engine
