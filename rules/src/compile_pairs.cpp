// `every` and `no`: most constraints of a scene are theirs, one a pair of planes, so they are made with care.
#include "compiler.hpp"
#include "pair_geometry.hpp"

namespace scenelore::rules {

using engine::Literal;
using kb::Quantifier;

/// Room for as many constraints as there will be at most.
void Compiler::make_room() {
  std::size_t most = 0;
  for (const kb::ClassConstraint& row : knowledge_.constraints) {
    if (!row.enabled) continue;
    if (row.quantifier == Quantifier::every && row.relation) {
      most += 2 * in_reach_of(reach_of(*row.relation)).size();
    } else if (row.quantifier == Quantifier::no && row.relation) {
      const FactIndex::Relation relation = index_.relation(*row.relation);
      for (int a = 0; a < planes(); ++a) most += relation.held(a).size();
    } else {
      most += scene_.planes.size();
    }
  }
  out.origins.reserve(most);
  out.problem.reserve(most);
}

/// What a pair of the row costs in one direction; infinite = not allowed.
double Compiler::pair_cost(const kb::ClassConstraint& row, int a, double degree) const {
  const bool every = row.quantifier == Quantifier::every;
  if (row.weight) return *row.weight * (every ? 1 - degree : degree);
  return (degree >= hold_) == every ? 0 : hard_weight(a);
}

/// `every` and `no`: each pair pays for itself. Both directions of a pair of one class are one constraint.
void Compiler::add_pairs(int index, int subject, int other) {
  const kb::ClassConstraint& row = rows(index);
  const bool every = row.quantifier == Quantifier::every;
  if (every && !row.relation) return;
  const bool both = subject == other;
  const FactIndex::Relation facts = row.relation ? index_.relation(*row.relation) : FactIndex::Relation{};
  const auto degree = [&](int a, int b) { return row.relation ? facts.degree(a, b) : 1.0; };
  const Pairs pairs{.row = index, .subjects = literals_of(subject), .others = other < 0 ? std::vector<Literal>{} : literals_of(other)};
  if (!every) {
    for (int a = 0; a < planes(); ++a) {
      if (pairs.subjects[at(a)].label < 0) continue;
      for (const auto& [b, d] : held(row, a)) {
        if (both && b < a && degree(b, a) > 0) continue;  // came from the other side
        add_pair(pairs, a, b, pair_cost(row, a, d) + (both ? pair_cost(row, b, degree(b, a)) : 0));
      }
    }
    return add_conflicts(index);
  }
  FactIndex::Rising rising(facts, planes());
  const auto take = [&](int a, int b) {
    if (pairs.subjects[at(a)].label < 0) return;
    const double forth = pair_cost(row, a, rising.degree(a, b));
    add_pair(pairs, a, b, both ? forth + pair_cost(row, b, rising.degree(b, a)) : forth);
  };
  for (const auto& [a, b] : in_reach_of(reach_of(*row.relation))) {
    take(a, b);
    if (!both) take(b, a);
  }
  add_conflicts(index);
}

/// Those of the row, all at once.
void Compiler::add_conflicts(int row) {
  out.problem.add(short_name_, rows(row).id, conflicts_);
  conflicts_.clear();
}

/// A class at every plane; label −1 where truth rules it out.
std::vector<Literal> Compiler::literals_of(int object_class) const {
  std::vector<Literal> literals;
  literals.reserve(scene_.planes.size());
  for (int plane = 0; plane < planes(); ++plane) literals.push_back(literal(plane, object_class));
  return literals;
}

/// Many rows use relations of one reach.
const std::vector<std::pair<int, int>>& Compiler::in_reach_of(const Reach& reach) {
  const auto [entry, fresh] = pairs_.try_emplace({reach.within, reach.within_plan});
  if (fresh) entry->second = pairs_in_reach(boxes_of(scene_.planes), reach.within, reach.within_plan);
  return entry->second;
}

void Compiler::add_pair(const Pairs& pairs, int a, int b, double cost) {
  if (cost <= 0) return;
  const Literal of_a = pairs.subjects[at(a)];
  if (!pairs.others.empty()) {
    const Literal of_b = pairs.others[at(b)];
    if (of_b.label < 0) return;
    conflicts_.push_back({cost, {of_a, of_b}});
    out.origins.push_back({.row = pairs.row, .a = a, .b = b});
    return;
  }
  const int variable_b = out.variable_of_plane[at(b)], spared = label(b, fallback_);
  const int labels_a = static_cast<int>(out.class_of_label[at(of_a.variable)].size());
  const int labels_b = static_cast<int>(out.class_of_label[at(variable_b)].size());
  if (labels_b == 1 && spared == 0) return;
  add(pairs.row, a, b, cost, engine::PairTable{of_a.variable, variable_b, shared_table(labels_a, of_a.label, labels_b, spared)});
}

/// 1 in the row of one label of a, but for one label of b. Many pairs share it; the weight is their own.
int Compiler::shared_table(int labels_a, int label_a, int labels_b, int spared_b) {
  const auto [entry, fresh] = tables_.try_emplace({labels_a, label_a, labels_b, spared_b}, 0);
  if (fresh) {
    std::vector<double> costs(at(labels_a) * at(labels_b), 0.0);
    for (int l = 0; l < labels_b; ++l) costs[at(label_a) * at(labels_b) + at(l)] = l == spared_b ? 0 : 1;
    entry->second = out.problem.add_table(labels_a, labels_b, std::move(costs));
  }
  return entry->second;
}

}  // namespace scenelore::rules
