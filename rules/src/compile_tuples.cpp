// Rows of several planes at once, which Lua constraints declare.
#include <cmath>

#include "compiler.hpp"
#include "conjunctions.hpp"
#include "names.hpp"
#include "scenelore/rules/error.hpp"

namespace scenelore::rules {

using engine::Literal;
using kb::Quantifier;

/// The literals behind the tuples of a Lua constraint. Nothing for one that truth rules out.
std::optional<std::vector<Literal>> Compiler::members_of(int row, const std::vector<int>& classes, const TupleConstraint::Tuple& tuple) {
  if (tuple.planes.size() != classes.size() || !(tuple.degree >= 0 && tuple.degree <= 1)) {
    throw Error(row_name(rows(row)) + ": a tuple needs a degree from 0 to 1 and " + std::to_string(classes.size()) + " planes");
  }
  std::vector<Literal> members;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const auto found = index_of_id_.find(tuple.planes[i]);
    if (found == index_of_id_.end()) throw Error(row_name(rows(row)) + ": there is no plane " + std::to_string(tuple.planes[i]));
    if (label(found->second, classes[i]) < 0) return std::nullopt;
    members.push_back(literal(found->second, classes[i]));
  }
  return members;
}

void Compiler::add_tuples(int index, const TupleConstraint& constraint) {
  std::vector<int> classes;
  for (const std::string& name : constraint.classes) classes.push_back(require_class(knowledge_, name, row_name(rows(index))));
  if (std::find(classes.begin(), classes.end(), fallback_) != classes.end()) return;
  if (index_of_id_.empty()) {
    for (int i = 0; i < planes(); ++i) index_of_id_[scene_.ids[at(i)]] = i;
  }
  std::map<int, std::vector<std::pair<std::vector<Literal>, double>>> by_first;  // by plane; members and degree
  for (const TupleConstraint::Tuple& tuple : constraint.tuples) {
    if (auto members = members_of(index, classes, tuple)) {
      by_first[index_of_id_.at(tuple.planes[0])].emplace_back(std::move(*members), tuple.degree);
    }
  }
  if (constraint.quantifier == Quantifier::some) {
    for (int a = 0; a < planes(); ++a) {
      if (label(a, classes[0]) >= 0) add_some_tuple(index, literal(a, classes[0]), a, by_first[a]);
    }
    return;
  }
  for (const auto& [a, tuples] : by_first) {
    for (const auto& [members, degree] : tuples) add_tuple(index, a, members, pair_cost(rows(index), a, degree));
  }
}

/// If the first plane is what the constraint says, at most all but one of the others are: then the tuple does not hold.
/// Exact for any number of planes, since the engine counts.
void Compiler::add_tuple(int index, int a, const std::vector<Literal>& members, double cost) {
  if (cost <= 0) return;
  engine::Cardinality body{.condition = members[0], .literals = {members.begin() + 1, members.end()}};
  body.high = static_cast<int>(body.literals.size()) - 1;
  add(index, a, out.plane_of_variable[at(members[1].variable)], cost, std::move(body));
  for (std::size_t i = 2; i < members.size(); ++i) {
    out.more_planes[static_cast<int>(out.origins.size()) - 1].push_back(out.plane_of_variable[at(members[i].variable)]);
  }
}

/// One requirement; what supports it is a plane, or the conjunction of all the other planes of a tuple.
void Compiler::add_some_tuple(int index, Literal subject, int a, const std::vector<std::pair<std::vector<Literal>, double>>& tuples) {
  const kb::ClassConstraint& row = rows(index);
  engine::Requirement requirement{.literal = subject, .supports = {}};
  for (const auto& [members, degree] : tuples) {
    if (!row.weight && degree < hold_) continue;
    const double cost = row.weight ? *row.weight * (1 - degree) : 0;
    requirement.supports.push_back({members.size() == 2 ? members[1] : conjunction({members.begin() + 1, members.end()}), cost});
  }
  add(index, a, -1, row.weight.value_or(hard_weight(a)), std::move(requirement));
}

/// A variable that is `yes` exactly where all members hold: it needs each of them, and they do not go with its `no`.
Literal Compiler::conjunction(std::vector<Literal> members) {
  std::sort(members.begin(), members.end());
  const auto [entry, fresh] = conjunctions_.try_emplace(members, 0);
  if (!fresh) return {entry->second, kYes};
  std::string name;
  for (const Literal& m : members) {
    const engine::Variable& variable = out.problem.variables()[at(m.variable)];
    name += (name.empty() ? "" : " and ") + variable.name + " " + variable.labels[at(m.label)];
  }
  const int variable = entry->second = out.problem.add_variable(name, {"no", "yes"}, {0, 0});
  const auto define = [&](auto body) {
    out.problem.add(name, engine::kHard, -1, std::move(body));
    out.origins.push_back({});
  };
  for (const Literal& m : members) define(engine::Requirement{.literal = {variable, kYes}, .supports = {{m, 0}}});
  engine::Cardinality body{.condition = members[0], .literals = {members.begin() + 1, members.end()}};
  body.literals.push_back({variable, kNo});
  body.high = static_cast<int>(body.literals.size()) - 1;
  define(std::move(body));
  out.conjunctions.push_back(std::move(members));
  return {variable, kYes};
}

}  // namespace scenelore::rules
