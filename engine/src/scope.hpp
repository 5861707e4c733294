// Which variables a constraint is about.
#pragma once

#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {

/// Visits them in the order in which they are written; one may come more than once.
void for_each_variable(const Constraint& constraint, const auto& visit) {
  if (const auto* conflict = std::get_if<Conflict>(&constraint.body)) {
    visit(conflict->a.variable);
    visit(conflict->b.variable);
  } else if (const auto* requirement = std::get_if<Requirement>(&constraint.body)) {
    visit(requirement->literal.variable);
    for (const Support& support : requirement->supports) visit(support.literal.variable);
  } else if (const auto* cardinality = std::get_if<Cardinality>(&constraint.body)) {
    if (cardinality->condition) visit(cardinality->condition->variable);
    for (const Literal& literal : cardinality->literals) visit(literal.variable);
  } else if (const auto* pair = std::get_if<PairTable>(&constraint.body)) {
    visit(pair->a);
    visit(pair->b);
  }
}

}  // namespace scenelore::engine
