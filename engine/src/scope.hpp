// Which variables a constraint is about.
#pragma once

#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {

/// Visits them in the order in which they are written; one may come more than once.
void for_each_variable(const ConstraintView& constraint, const auto& visit) {
  if (const auto* conflict = constraint.as<Conflict>()) {
    visit(conflict->a.variable);
    visit(conflict->b.variable);
  } else if (const auto* requirement = constraint.as<Requirement>()) {
    visit(requirement->literal.variable);
    for (const Support& support : requirement->supports) visit(support.literal.variable);
  } else if (const auto* cardinality = constraint.as<Cardinality>()) {
    if (cardinality->condition) visit(cardinality->condition->variable);
    for (const Literal& literal : cardinality->literals) visit(literal.variable);
  } else if (const auto* pair = constraint.as<PairTable>()) {
    visit(pair->a);
    visit(pair->b);
  }
}

}  // namespace scenelore::engine
