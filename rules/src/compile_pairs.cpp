// `every` and `no`: most constraints of a scene are theirs, one a pair of planes, so they are made with care.
#include "compiler.hpp"
#include "pair_geometry.hpp"

namespace scenelore::rules {

using engine::Literal;
using kb::Quantifier;

/// Room for as many constraints as there will be at most.
void Compiler::make_room() {
  find_pairs();
  std::size_t most = 0;
  for (const kb::ClassConstraint& row : knowledge_.constraints) {
    if (!row.enabled) continue;
    if (row.quantifier == Quantifier::every && row.relation) {
      most += 2 * in_reach_of(*row.relation).size();
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

/// `every` and `no`: each pair pays for itself. Both directions of a pair of one class are one constraint.
void Compiler::add_pairs(int index, int subject, int other) {
  const kb::ClassConstraint& row = rows(index);
  const bool every = row.quantifier == Quantifier::every;
  if (every && !row.relation) return;
  const bool both = subject == other;
  const FactIndex::Relation facts = facts_of(row);
  const auto degree = [&](int a, int b) { return row.relation ? facts.degree(a, b) : 1.0; };
  const Pairs pairs{.row = index, .subjects = literals_of(subject), .others = other < 0 ? std::vector<Literal>{} : literals_of(other)};
  if (!every) {
    for (int a = 0; a < planes(); ++a) {
      if (pairs.subjects[at(a)].label < 0) continue;
      for (const auto& [b, d] : held(row, facts, a)) {
        if (both && b < a && degree(b, a) > 0) continue;  // came from the other side
        add_pair(pairs, a, b, pair_cost(row, a, d) + (both ? pair_cost(row, b, degree(b, a)) : 0));
      }
    }
    return add_conflicts(index);
  }
  const std::vector<Degrees>& degrees = degrees_of(*row.relation);
  const std::vector<std::pair<int, int>>& in_reach = in_reach_of(*row.relation);
  for (std::size_t i = 0; i < in_reach.size(); ++i) {
    const auto [a, b] = in_reach[i];
    const auto [forth, back] = degrees[i];
    if (pairs.subjects[at(a)].label >= 0) add_pair(pairs, a, b, both ? pair_cost(row, a, forth) + pair_cost(row, b, back) : pair_cost(row, a, forth));
    if (!both && pairs.subjects[at(b)].label >= 0) add_pair(pairs, b, a, pair_cost(row, b, back));
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

/// Those that `every` speaks of: many rows use relations of one reach, and one sweep finds the pairs of all reaches.
void Compiler::find_pairs() {
  std::vector<Reach> reaches;
  for (const kb::ClassConstraint& row : knowledge_.constraints) {
    if (!row.enabled || row.quantifier != Quantifier::every || !row.relation) continue;
    const Reach reach = reach_of(*row.relation);
    if (pairs_.try_emplace({reach.within, reach.within_plan}).second) reaches.push_back(reach);
  }
  if (reaches.empty()) return;
  std::vector<rules::Pairs> found = pairs_in_reach(boxes_of(scene_.planes), reaches);
  for (std::size_t i = 0; i < reaches.size(); ++i) pairs_.at({reaches[i].within, reaches[i].within_plan}) = std::move(found[i]);
}

const std::vector<std::pair<int, int>>& Compiler::in_reach_of(const std::string& relation) const {
  const Reach reach = reach_of(relation);
  return pairs_.at({reach.within, reach.within_plan});
}

/// Of each of in_reach_of(): many rows speak of one relation.
const std::vector<Compiler::Degrees>& Compiler::degrees_of(const std::string& relation) {
  const auto [entry, fresh] = degrees_.try_emplace(relation);
  if (!fresh) return entry->second;
  const std::vector<std::pair<int, int>>& in_reach = in_reach_of(relation);
  FactIndex::Rising rising(index_.relation(relation), planes());
  entry->second.reserve(in_reach.size());
  for (const auto& [a, b] : in_reach) {
    const double forth = rising.degree(a, b);
    entry->second.push_back({forth, rising.degree(b, a)});
  }
  return entry->second;
}

void Compiler::add_table_of_pair(const Pairs& pairs, int a, int b, double cost) {
  const Literal of_a = pairs.subjects[at(a)];
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
