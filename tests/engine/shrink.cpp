#include "shrink.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace scenelore::engine::testing {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// A problem that can be taken apart; each pair table has a table of its own.
struct Draft {
  struct Part {
    Constraint constraint;
    std::vector<double> table;
  };
  std::vector<Variable> variables;
  std::vector<Part> parts;

  explicit Draft(const Problem& problem) : variables(problem.variables()) {
    for (const Constraint& constraint : problem.constraints()) {
      parts.push_back({constraint, {}});
      if (const auto* pair = std::get_if<PairTable>(&constraint.body)) parts.back().table = problem.table(pair->table);
    }
  }

  Problem problem() const {
    Problem result;
    for (const Variable& v : variables) result.add_variable(v.name, v.labels, v.costs);
    for (Part part : parts) {
      if (auto* pair = std::get_if<PairTable>(&part.constraint.body))
        pair->table = result.add_table(labels(pair->a), labels(pair->b), part.table);
      result.add(part.constraint.name, part.constraint.weight, part.constraint.reference, part.constraint.body);
    }
    return result;
  }

  int labels(int v) const { return static_cast<int>(variables[index(v)].labels.size()); }
};

/// Renames the literals of a constraint; false when one that it cannot do without is gone.
bool rename(Constraint& constraint, const std::function<std::optional<Literal>(Literal)>& name) {
  const auto needed = [&](Literal& literal) {
    const auto renamed = name(literal);
    if (renamed) literal = *renamed;
    return renamed.has_value();
  };
  if (auto* conflict = std::get_if<Conflict>(&constraint.body)) return needed(conflict->a) && needed(conflict->b);
  if (auto* requirement = std::get_if<Requirement>(&constraint.body)) {
    std::erase_if(requirement->supports, [&](Support& support) { return !needed(support.literal); });
    return needed(requirement->literal);
  }
  if (auto* cardinality = std::get_if<Cardinality>(&constraint.body)) {
    std::erase_if(cardinality->literals, [&](Literal& literal) { return !needed(literal); });
    return !cardinality->condition || needed(*cardinality->condition);
  }
  return true;
}

Draft without_label(const Draft& draft, Literal gone) {
  Draft result = draft;
  for (Draft::Part& part : result.parts)
    if (const auto* pair = std::get_if<PairTable>(&part.constraint.body)) {
      std::vector<double> kept;
      for (int a = 0; a < draft.labels(pair->a); ++a)
        for (int b = 0; b < draft.labels(pair->b); ++b)
          if (!(pair->a == gone.variable && a == gone.label) && !(pair->b == gone.variable && b == gone.label))
            kept.push_back(part.table[index(a * draft.labels(pair->b) + b)]);
      part.table = std::move(kept);
    }
  std::erase_if(result.parts, [&](Draft::Part& part) {
    return !rename(part.constraint, [&](Literal literal) -> std::optional<Literal> {
      if (literal == gone) return std::nullopt;
      if (literal.variable == gone.variable && literal.label > gone.label) --literal.label;
      return literal;
    });
  });
  Variable& variable = result.variables[index(gone.variable)];
  variable.labels.erase(variable.labels.begin() + gone.label);
  variable.costs.erase(variable.costs.begin() + gone.label);
  return result;
}

Draft without_variable(const Draft& draft, int gone) {
  Draft result = draft;
  std::erase_if(result.parts, [&](Draft::Part& part) {
    if (auto* pair = std::get_if<PairTable>(&part.constraint.body)) {
      if (pair->a == gone || pair->b == gone) return true;
      pair->a -= pair->a > gone ? 1 : 0;
      pair->b -= pair->b > gone ? 1 : 0;
    }
    return !rename(part.constraint, [&](Literal literal) -> std::optional<Literal> {
      if (literal.variable == gone) return std::nullopt;
      if (literal.variable > gone) --literal.variable;
      return literal;
    });
  });
  result.variables.erase(result.variables.begin() + gone);
  return result;
}

class Shrinking {
 public:
  Shrinking(const Problem& problem, const std::function<bool(const Problem&)>& fails) : best_(problem), fails_(fails) {}

  Problem run() {
    for (bool any = true; any;) {
      any = false;
      for (std::size_t c = best_.parts.size(); c-- > 0;) {
        Draft without = best_;
        without.parts.erase(without.parts.begin() + static_cast<std::ptrdiff_t>(c));
        any = attempt(std::move(without)) || any;
      }
      for (int v = static_cast<int>(best_.variables.size()); v-- > 0;) any = attempt(without_variable(best_, v)) || any;
      for (int v = static_cast<int>(best_.variables.size()); v-- > 0;)
        for (int l = best_.labels(v); l-- > 0;)
          if (best_.labels(v) > 1) any = attempt(without_label(best_, {v, l})) || any;
      any = members() || any;
      any = numbers() || any;
    }
    return best_.problem();
  }

 private:
  bool attempt(Draft draft) {
    if (!fails_(draft.problem())) return false;
    best_ = std::move(draft);
    return true;
  }

  bool members() {
    bool any = false;
    for (std::size_t c = 0; c < best_.parts.size(); ++c) {
      const auto drop = [&](std::size_t i) {
        Draft draft = best_;
        auto& body = draft.parts[c].constraint.body;
        const auto offset = static_cast<std::ptrdiff_t>(i);
        if (auto* requirement = std::get_if<Requirement>(&body)) requirement->supports.erase(requirement->supports.begin() + offset);
        if (auto* cardinality = std::get_if<Cardinality>(&body)) cardinality->literals.erase(cardinality->literals.begin() + offset);
        return attempt(std::move(draft));
      };
      const auto size = [&] {
        const auto& body = best_.parts[c].constraint.body;
        if (const auto* requirement = std::get_if<Requirement>(&body)) return requirement->supports.size();
        if (const auto* cardinality = std::get_if<Cardinality>(&body)) return cardinality->literals.size();
        return std::size_t{0};
      };
      for (std::size_t i = size(); i-- > 0;) any = drop(i) || any;
    }
    return any;
  }

  /// Every number of the problem, in a fixed order.
  static std::vector<double*> all_numbers(Draft& draft) {
    std::vector<double*> all;
    for (Variable& v : draft.variables)
      for (double& cost : v.costs) all.push_back(&cost);
    for (Draft::Part& part : draft.parts) {
      all.push_back(&part.constraint.weight);
      for (double& cost : part.table) all.push_back(&cost);
      if (auto* requirement = std::get_if<Requirement>(&part.constraint.body))
        for (Support& support : requirement->supports) all.push_back(&support.cost);
    }
    return all;
  }

  bool numbers() {
    bool any = false;
    const std::size_t count = all_numbers(best_).size();
    for (std::size_t i = 0; i < count; ++i) {
      const double now = *all_numbers(best_)[i];
      for (const double plain : {0.0, 1.0, std::floor(now)}) {
        if (now <= plain && !(plain == 0 && now == 0)) continue;
        if (now == plain) break;
        Draft draft = best_;
        *all_numbers(draft)[i] = plain;
        if (!is_sound(draft) || !attempt(std::move(draft))) continue;
        any = true;
        break;
      }
    }
    return any;
  }

  /// Weights stay above 0, and supports cost no more than them.
  static bool is_sound(const Draft& draft) {
    return std::all_of(draft.parts.begin(), draft.parts.end(), [](const Draft::Part& part) {
      const double weight = part.constraint.weight;
      const auto* requirement = std::get_if<Requirement>(&part.constraint.body);
      return weight > 0 && (requirement == nullptr ||
                            std::all_of(requirement->supports.begin(), requirement->supports.end(),
                                        [&](const Support& support) { return support.cost <= weight; }));
    });
  }

  Draft best_;
  const std::function<bool(const Problem&)>& fails_;
};

}  // namespace

Problem shrink(const Problem& problem, const std::function<bool(const Problem&)>& fails) {
  return Shrinking(problem, fails).run();
}

}  // namespace scenelore::engine::testing
