#include "scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenelore::engine {
namespace {

double largest_finite(const std::vector<double>& costs) {
  double largest = 0;
  for (const double cost : costs)
    if (std::isfinite(cost)) largest = std::max(largest, cost);
  return largest;
}

/// The most that a soft constraint can cost.
double worst(const Problem& problem, const ConstraintView& constraint) {
  const double weight = constraint.weight;
  if (const auto* pair = constraint.as<PairTable>())
    return std::isfinite(weight) ? weight * largest_finite(problem.table(pair->table)) : 0;
  if (const auto* requirement = constraint.as<Requirement>()) {
    double most = std::isfinite(weight) ? weight : 0;
    for (const Support& support : requirement->supports)
      if (std::isfinite(support.cost)) most = std::max(most, support.cost);
    return most;
  }
  if (!std::isfinite(weight)) return 0;
  if (const auto* cardinality = constraint.as<Cardinality>()) {
    const double count = static_cast<double>(cardinality->literals.size());
    return weight * std::max(count, static_cast<double>(std::max(cardinality->low, 1)));
  }
  return weight;
}

}  // namespace

Scale::Scale(const Problem& problem) {
  double sum = 1;
  // Half a unit a term (a cardinality may pay its weight several times), and 2^-52 of the sum a term for the real sum,
  // which is below 2^48 units.
  double terms = 2 + static_cast<double>(problem.variables().size());
  for (const Variable& variable : problem.variables()) sum += largest_finite(variable.costs);
  const auto add_conflict = [&](std::size_t, double weight, const Conflict&) {
    if (weight != kHard) sum += weight;
    terms += 1;
  };
  problem.for_each_constraint(add_conflict, [&](std::size_t, const ConstraintView& constraint) {
    sum += worst(problem, constraint);
    const auto* cardinality = constraint.as<Cardinality>();
    terms += cardinality == nullptr ? 1 : static_cast<double>(cardinality->literals.size()) + std::max(cardinality->low, 1);
  });
  int exponent = 0;
  std::frexp(sum, &exponent);  // sum < 2^exponent
  units_ = std::ldexp(1.0, std::min(40, 48 - exponent));
  slack_ = static_cast<Cost>(std::min(0x1p50, terms));
}

double Scale::real(Cost cost) const {
  return is_forbidden(cost) ? std::numeric_limits<double>::infinity() : static_cast<double>(cost) / units_;
}

}  // namespace scenelore::engine
