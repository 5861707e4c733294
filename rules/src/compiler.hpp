// From rows to constraints; docs/rules.md, "What a row means", is the specification. Private to compile*.cpp.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "fact_index.hpp"
#include "scenelore/rules/labelling.hpp"

namespace scenelore::rules {

class Compiler {
  using Literal = engine::Literal;

 public:
  Compiler(const kb::Knowledge& knowledge, const Scene& scene, const std::vector<std::vector<double>>& evidence,
           const Facts& facts, const FactIndex& index, HardRows hard_rows)
      : strict_(hard_rows == HardRows::strict), knowledge_(knowledge), scene_(scene), evidence_(evidence), facts_(facts), index_(index),
        hold_(hold_degree(knowledge)), fallback_(knowledge.fallback_index()), fixed_(scene.planes.size(), -1) {
    check_evidence();
  }

  void fix(const std::vector<std::pair<kb::PlaneId, std::string>>& truth);
  void choose_floor();
  void add_variables();
  void make_room();
  void add_row(int row);

  LabellingProblem out;

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  void check_evidence() const;
  void add(int row, int a, int b, double weight, std::variant<engine::Conflict, engine::Requirement,
           engine::Cardinality, engine::PairTable> body) {
    out.problem.add(short_name_, weight, rows(row).id, std::move(body));
    out.origins.push_back({.row = row, .a = a, .b = b});
  }
  [[nodiscard]] const kb::ClassConstraint& rows(int row) const { return knowledge_.constraints[at(row)]; }
  [[nodiscard]] int planes() const { return static_cast<int>(scene_.planes.size()); }

  /// Label of a class at a plane, −1 when truth rules it out.
  [[nodiscard]] int label(int plane, int object_class) const {
    return out.label_of_class[at(out.variable_of_plane[at(plane)])][at(object_class)];
  }
  [[nodiscard]] Literal literal(int plane, int object_class) const {
    return {out.variable_of_plane[at(plane)], label(plane, object_class)};
  }
  /// The literals by which a plane is an `other` of the row: of one class, or (−1) of any but the fallback.
  template <typename Visit>
  void for_each_other(int plane, int other, Visit visit) const {
    for (int c = other < 0 ? 0 : other; c < (other < 0 ? static_cast<int>(knowledge_.classes.size()) : other + 1); ++c) {
      if (other < 0 && c == fallback_) continue;
      if (label(plane, c) >= 0) visit(literal(plane, c));
    }
  }
  /// What a hard row costs where plane `a` is what it is for certain.
  [[nodiscard]] double hard_weight(int a) const {
    return !strict_ && a >= 0 && fixed_[at(a)] >= 0 ? kBrokenRow : engine::kHard;
  }

  /// Of the row's relation; none without one.
  [[nodiscard]] FactIndex::Relation facts_of(const kb::ClassConstraint& row) const;
  /// Planes b in the row's relation, whose facts are given, to a, with degrees; without a relation all others, fully.
  [[nodiscard]] std::span<const FactIndex::Held> held(const kb::ClassConstraint& row, const FactIndex::Relation& facts, int a);
  void add_some(int row, int subject, int other);
  void add_pairs(int row, int subject, int other);
  /// What the pairs of a row have in common. `others` is empty where the row speaks of planes of any class.
  struct Pairs {
    int row;
    std::vector<Literal> subjects, others;  // by plane
  };
  void add_pair(const Pairs& pairs, int a, int b, double cost) {
    if (cost <= 0) return;
    if (pairs.others.empty()) return add_table_of_pair(pairs, a, b, cost);
    if (pairs.others[at(b)].label < 0) return;
    conflicts_.push_back({cost, {pairs.subjects[at(a)], pairs.others[at(b)]}});
    out.origins.push_back({.row = pairs.row, .a = a, .b = b});
  }
  void add_table_of_pair(const Pairs& pairs, int a, int b, double cost);
  struct Degrees {
    double forth, back;
  };
  [[nodiscard]] const std::vector<Degrees>& degrees_of(const std::string& relation);
  void add_conflicts(int row);
  [[nodiscard]] std::vector<Literal> literals_of(int object_class) const;
  void add_count(int row, int subject, int other);
  void add_scene_count(int row, int subject);
  void add_tuples(int row, const TupleConstraint& constraint);
  std::optional<std::vector<Literal>> members_of(int row, const std::vector<int>& classes, const TupleConstraint::Tuple& tuple);
  void add_tuple(int row, int a, const std::vector<Literal>& members, double cost);
  void add_some_tuple(int row, Literal subject, int a, const std::vector<std::pair<std::vector<Literal>, double>>& tuples);
  Literal conjunction(std::vector<Literal> members);
  void find_pairs();
  [[nodiscard]] const std::vector<std::pair<int, int>>& in_reach_of(const std::string& relation) const;
  [[nodiscard]] Reach reach_of(const std::string& relation) const {
    const auto found = facts_.reach.find(relation);
    return found == facts_.reach.end() ? Reach{} : found->second;
  }
  /// What a pair of the row costs in one direction; infinite = not allowed.
  [[nodiscard]] double pair_cost(const kb::ClassConstraint& row, int a, double degree) const {
    const bool every = row.quantifier == kb::Quantifier::every;
    if (row.weight) return *row.weight * (every ? 1 - degree : degree);
    return (degree >= hold_) == every ? 0 : hard_weight(a);
  }
  int shared_table(int labels_a, int label_a, int labels_b, int spared_b);

  bool strict_;
  std::string short_name_;  // of the row at work: so short that each of its thousand constraints holds it without a block of its own
  const kb::Knowledge& knowledge_;
  const Scene& scene_;
  const std::vector<std::vector<double>>& evidence_;
  const Facts& facts_;
  const FactIndex& index_;
  double hold_;
  std::vector<FactIndex::Held> all_;  // what held() gives for a row without a relation
  int fallback_;
  std::vector<int> fixed_;  // class of each plane that is known for certain, −1 = open
  std::map<std::pair<double, double>, std::vector<std::pair<int, int>>> pairs_;  // by reach, of the relations of `every`
  std::map<std::string, std::vector<Degrees>> degrees_;                          // by relation, as pairs_
  std::map<std::tuple<int, int, int, int>, int> tables_;
  std::vector<engine::WeightedConflict> conflicts_;        // of the row at work
  std::map<kb::PlaneId, int> index_of_id_;                 // made when a Lua constraint needs it
  std::map<std::vector<Literal>, int> conjunctions_;       // by members: their variable
};

/// As compile(), for one who has the index of the facts already.
[[nodiscard]] LabellingProblem compile(const kb::Knowledge& knowledge, const Scene& scene, const std::vector<std::vector<double>>& evidence,
                                       const Facts& facts, const FactIndex& index, const std::vector<std::pair<kb::PlaneId, std::string>>& truth,
                                       HardRows hard_rows);

}  // namespace scenelore::rules
