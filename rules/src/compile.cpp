// From rows to constraints; docs/rules.md, "What a row means", is the specification.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "conjunctions.hpp"
#include "fact_index.hpp"
#include "names.hpp"
#include "pair_geometry.hpp"
#include "scenelore/rules/error.hpp"
#include "scenelore/rules/labelling.hpp"
#include "suggestion.hpp"

namespace scenelore::rules {

namespace {

using engine::Literal;
using kb::Quantifier;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Compiler {
 public:
  Compiler(const kb::Knowledge& knowledge, const Scene& scene, const std::vector<std::vector<double>>& evidence,
           const Facts& facts, HardRows hard_rows)
      : strict_(hard_rows == HardRows::strict), knowledge_(knowledge), scene_(scene), evidence_(evidence), facts_(facts), index_(scene, facts),
        hold_(hold_degree(knowledge)), fallback_(knowledge.fallback_index()), fixed_(scene.planes.size(), -1) {
    check_evidence();
  }

  void fix(const std::vector<std::pair<kb::PlaneId, std::string>>& truth) {
    for (const auto& [plane, name] : truth) {
      const auto found = std::find(scene_.ids.begin(), scene_.ids.end(), plane);
      const std::string who = "truth of plane " + std::to_string(plane);
      if (found == scene_.ids.end()) throw Error(who + ": that plane is not in this scan");
      fixed_[static_cast<std::size_t>(found - scene_.ids.begin())] = require_class(knowledge_, name, who);
    }
  }

  void choose_floor();
  void add_variables();
  void make_room();
  void add_row(int row);

  LabellingProblem out;

 private:
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

  /// Planes b in the row's relation to a, with degrees; without a relation all others, fully.
  [[nodiscard]] std::vector<FactIndex::Held> held(const kb::ClassConstraint& row, int a) const;
  void add_some(int row, int subject, int other);
  void add_pairs(int row, int subject, int other);
  void add_pair(int row, int subject, int other, int a, int b, double forth, double back);
  void add_count(int row, int subject, int other);
  void add_scene_count(int row, int subject);
  void add_tuples(int row, const TupleConstraint& constraint);
  std::optional<std::vector<Literal>> members_of(int row, const std::vector<int>& classes, const TupleConstraint::Tuple& tuple);
  void add_tuple(int row, int a, const std::vector<Literal>& members, double cost);
  void add_some_tuple(int row, Literal subject, int a, const std::vector<std::pair<std::vector<Literal>, double>>& tuples);
  Literal conjunction(std::vector<Literal> members);
  const std::vector<std::pair<int, int>>& in_reach_of(const Reach& reach);
  [[nodiscard]] Reach reach_of(const std::string& relation) const {
    const auto found = facts_.reach.find(relation);
    return found == facts_.reach.end() ? Reach{} : found->second;
  }
  [[nodiscard]] double pair_cost(const kb::ClassConstraint& row, int a, double degree) const;
  int shared_table(int labels_a, int label_a, int labels_b, int spared_b);

  bool strict_;
  std::string short_name_;  // of the row at work: so short that each of its thousand constraints holds it without a block of its own
  const kb::Knowledge& knowledge_;
  const Scene& scene_;
  const std::vector<std::vector<double>>& evidence_;
  const Facts& facts_;
  FactIndex index_;
  double hold_;
  int fallback_;
  std::vector<int> fixed_;  // class of each plane that is known for certain, −1 = open
  std::map<std::pair<double, double>, std::vector<std::pair<int, int>>> pairs_;  // by reach, made when a row needs them
  std::map<std::tuple<int, int, int, int>, int> tables_;
  std::map<kb::PlaneId, int> index_of_id_;                 // made when a Lua constraint needs it
  std::map<std::vector<Literal>, int> conjunctions_;       // by members: their variable
};

void Compiler::check_evidence() const {
  if (scene_.ids.size() != scene_.planes.size() || evidence_.size() != scene_.planes.size()) {
    throw Error("the scene has " + std::to_string(scene_.planes.size()) + " planes and " +
                std::to_string(scene_.ids.size()) + " ids, but the evidence speaks of " +
                std::to_string(evidence_.size()));
  }
  for (std::size_t i = 0; i < evidence_.size(); ++i) {
    const bool good = evidence_[i].size() == knowledge_.classes.size() &&
                      std::all_of(evidence_[i].begin(), evidence_[i].end(), [](double p) { return p >= 0 && p <= 1 + 1e-9; });
    if (!good) {
      throw Error("evidence of plane " + std::to_string(scene_.ids[i]) + ": one probability from 0 to 1 for each of the " +
                  std::to_string(knowledge_.classes.size()) + " classes is needed");
    }
  }
}

/// The start of Goldhoorn & Hartanto 2014: going up from the lowest plane, the first that is floor likely enough.
void Compiler::choose_floor() {
  const std::string mode = knowledge_.setting("floor", "ranked");
  if (mode == "ranked") return;
  if (mode != "threshold") throw Error("setting 'floor' is '" + mode + "'; it must be 'ranked' or 'threshold'");
  const int floor = knowledge_.class_index("floor");
  if (floor < 0) throw Error("setting 'floor' is 'threshold', but there is no class 'floor'");
  FloorStart start{.threshold = number_setting(knowledge_, "floor_threshold", 0.4, 0, 1)};
  for (int plane : out.plane_of_variable) {
    const double p = evidence_[at(plane)][at(floor)];
    if (fixed_[at(plane)] >= 0 && fixed_[at(plane)] != floor) continue;
    if (start.plane >= 0 && p <= start.probability) continue;
    start.plane = plane;
    start.probability = p;
    start.found = p >= start.threshold;
    if (start.found) break;
  }
  if (start.found) fixed_[at(start.plane)] = floor;
  out.floor = start;
}

void Compiler::add_variables() {
  const int classes = static_cast<int>(knowledge_.classes.size());
  out.variable_of_plane.resize(scene_.planes.size());
  for (int variable = 0; variable < planes(); ++variable) {
    const int plane = out.plane_of_variable[at(variable)];
    out.variable_of_plane[at(plane)] = variable;
    const std::vector<double>& p = evidence_[at(plane)];
    std::vector<int> order;
    for (int c = 0; c < classes; ++c) {
      if (fixed_[at(plane)] < 0 || fixed_[at(plane)] == c) order.push_back(c);
    }
    std::stable_sort(order.begin(), order.end(), [&](int c, int d) { return p[at(c)] > p[at(d)]; });
    std::vector<int> label_of(at(classes), -1);
    std::vector<std::string> names;
    std::vector<double> costs;
    for (int c : order) {
      label_of[at(c)] = static_cast<int>(names.size());
      names.push_back(knowledge_.classes[at(c)].name);
      costs.push_back(std::clamp(-std::log(p[at(c)]), 0.0, kImpossibleEvidence));
    }
    out.problem.add_variable("plane " + std::to_string(scene_.ids[at(plane)]), std::move(names), std::move(costs));
    out.class_of_label.push_back(std::move(order));
    out.label_of_class.push_back(std::move(label_of));
  }
}

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
    out.origins.back().more.push_back(out.plane_of_variable[at(members[i].variable)]);
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
    out.origins.push_back({.definition = true});
  };
  for (const Literal& m : members) define(engine::Requirement{.literal = {variable, kYes}, .supports = {{m, 0}}});
  engine::Cardinality body{.condition = members[0], .literals = {members.begin() + 1, members.end()}};
  body.literals.push_back({variable, kNo});
  body.high = static_cast<int>(body.literals.size()) - 1;
  define(std::move(body));
  out.conjunctions.push_back(std::move(members));
  return {variable, kYes};
}

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

void Compiler::add_row(int index) {
  const kb::ClassConstraint& row = rows(index);
  short_name_ = "row " + std::to_string(row.id);
  for (const TupleConstraint& constraint : facts_.constraints) {
    if (constraint.name == row.name) return add_tuples(index, constraint);
  }
  const int subject = require_class(knowledge_, row.object_class, row_name(row));
  const int other = row.other_class ? require_class(knowledge_, *row.other_class, row_name(row)) : -1;
  if (row.weight && !(*row.weight >= 0 && std::isfinite(*row.weight))) {
    throw Error(row_name(row) + ": the weight must be 0 or more, or NULL for a hard constraint");
  }
  const bool counts = row.quantifier == Quantifier::at_most || row.quantifier == Quantifier::at_least;
  if (counts && !(row.count && *row.count >= 0)) throw Error(row_name(row) + ": at_most and at_least need a count");
  if (subject == fallback_ || (row.weight && *row.weight == 0)) return;
  if (counts && !row.relation) return add_scene_count(index, subject);
  if (counts) return add_count(index, subject, other);
  if (row.quantifier == Quantifier::some) return add_some(index, subject, other);
  add_pairs(index, subject, other);
}

std::vector<FactIndex::Held> Compiler::held(const kb::ClassConstraint& row, int a) const {
  if (row.relation) return index_.held(*row.relation, a);
  std::vector<FactIndex::Held> all;
  for (int b = 0; b < planes(); ++b) {
    if (b != a) all.push_back({b, 1});
  }
  return all;
}

void Compiler::add_some(int index, int subject, int other) {
  const kb::ClassConstraint& row = rows(index);
  for (int a = 0; a < planes(); ++a) {
    if (label(a, subject) < 0) continue;
    engine::Requirement requirement{.literal = literal(a, subject), .supports = {}};
    for (const auto& [b, degree] : held(row, a)) {
      if (!row.weight && degree < hold_) continue;
      const double cost = row.weight ? *row.weight * (1 - degree) : 0;
      for_each_other(b, other, [&](Literal support) { requirement.supports.push_back({support, cost}); });
    }
    add(index, a, -1, row.weight.value_or(hard_weight(a)), std::move(requirement));
  }
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
  const auto back = [&](int a, int b) { return both ? pair_cost(row, b, degree(b, a)) : 0; };
  if (!every) {
    for (int a = 0; a < planes(); ++a) {
      if (label(a, subject) < 0) continue;
      for (const auto& [b, d] : held(row, a)) {
        if (both && b < a && degree(b, a) > 0) continue;  // came from the other side
        add_pair(index, subject, other, a, b, pair_cost(row, a, d), back(a, b));
      }
    }
    return;
  }
  FactIndex::Rising rising(facts, planes());
  const auto take = [&](int a, int b) {
    if (label(a, subject) >= 0) add_pair(index, subject, other, a, b, pair_cost(row, a, rising.degree(a, b)), back(a, b));
  };
  for (const auto& [a, b] : in_reach_of(reach_of(*row.relation))) {
    take(a, b);
    if (!both) take(b, a);
  }
}

/// Many rows use relations of one reach.
const std::vector<std::pair<int, int>>& Compiler::in_reach_of(const Reach& reach) {
  const auto [entry, fresh] = pairs_.try_emplace({reach.within, reach.within_plan});
  if (fresh) entry->second = pairs_in_reach(boxes_of(scene_.planes), reach.within, reach.within_plan);
  return entry->second;
}

void Compiler::add_pair(int row, int subject, int other, int a, int b, double forth, double back) {
  const double cost = forth + back;
  if (cost <= 0) return;
  if (other >= 0) {
    if (label(b, other) >= 0) add(row, a, b, cost, engine::Conflict{literal(a, subject), literal(b, other)});
    return;
  }
  const Literal of_a = literal(a, subject);
  const int variable_b = out.variable_of_plane[at(b)], spared = label(b, fallback_);
  const int labels_a = static_cast<int>(out.class_of_label[at(of_a.variable)].size());
  const int labels_b = static_cast<int>(out.class_of_label[at(variable_b)].size());
  if (labels_b == 1 && spared == 0) return;
  add(row, a, b, cost, engine::PairTable{of_a.variable, variable_b, shared_table(labels_a, of_a.label, labels_b, spared)});
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

void Compiler::add_count(int index, int subject, int other) {
  const kb::ClassConstraint& row = rows(index);
  const bool at_most = row.quantifier == Quantifier::at_most;
  for (int a = 0; a < planes(); ++a) {
    if (label(a, subject) < 0) continue;
    engine::Cardinality body{.condition = literal(a, subject), .literals = {}};
    int others = 0;
    for (const auto& [b, degree] : index_.held(*row.relation, a)) {
      if (degree < hold_) continue;
      ++others;
      for_each_other(b, other, [&](Literal counted) { body.literals.push_back(counted); });
    }
    if (at_most ? others <= *row.count : *row.count <= 0) continue;  // cannot be broken
    (at_most ? body.high : body.low) = *row.count;
    add(index, a, -1, row.weight.value_or(hard_weight(a)), std::move(body));
  }
}

void Compiler::add_scene_count(int index, int subject) {
  const kb::ClassConstraint& row = rows(index);
  const bool at_most = row.quantifier == Quantifier::at_most;
  engine::Cardinality body;
  int certain = 0;
  for (int a = 0; a < planes(); ++a) {
    if (label(a, subject) < 0) continue;
    body.literals.push_back(literal(a, subject));
    certain += fixed_[at(a)] == subject;
  }
  const int size = static_cast<int>(body.literals.size());
  if (at_most ? size <= *row.count : *row.count <= 0) return;
  if (at_most) {
    body.high = row.weight || strict_ ? *row.count : std::max(*row.count, certain);
    return add(index, -1, -1, row.weight.value_or(engine::kHard), std::move(body));
  }
  body.low = *row.count;
  add(index, -1, -1, row.weight.value_or(strict_ ? engine::kHard : kBrokenRow), std::move(body));
}

}  // namespace

double hold_degree(const kb::Knowledge& knowledge) {
  return number_setting(knowledge, "hold_degree", 0.5, 1e-9, 1);
}

kb::Knowledge with_tuple_constraints(kb::Knowledge knowledge, const Facts& facts) {
  std::int64_t id = 0;
  for (const TupleConstraint& c : facts.constraints) {
    knowledge.constraints.push_back({.id = --id, .name = c.name, .object_class = c.classes.at(0),
                                     .quantifier = c.quantifier, .relation = std::nullopt,
                                     .other_class = c.classes.at(1), .count = std::nullopt, .weight = c.weight,
                                     .message = c.summary, .enabled = true});
  }
  return knowledge;
}

std::vector<std::string> used_relations(const kb::Knowledge& knowledge, const RuleSet& rules) {
  const std::vector<std::string> known = rules.relation_names();
  std::vector<std::string> used;
  for (const kb::ClassConstraint& row : knowledge.constraints) {
    if (!row.enabled || !row.relation) continue;
    if (!std::binary_search(known.begin(), known.end(), *row.relation)) {
      throw Error(row_name(row) + ": there is no relation '" + *row.relation + "'" + did_you_mean(*row.relation, known));
    }
    used.push_back(*row.relation);
  }
  for (const kb::Composite& composite : knowledge.composites) {
    for (const kb::CompositePart& part : composite.parts) {
      if (!composite.enabled || !part.relation) continue;
      if (!std::binary_search(known.begin(), known.end(), *part.relation)) {
        throw Error("composite '" + composite.name + "', part '" + part.part + "': there is no relation '" + *part.relation + "'" +
                    did_you_mean(*part.relation, known));
      }
      used.push_back(*part.relation);
    }
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

LabellingProblem compile(const kb::Knowledge& knowledge, const Scene& scene,
                         const std::vector<std::vector<double>>& evidence, const Facts& facts,
                         const std::vector<std::pair<kb::PlaneId, std::string>>& truth, HardRows hard_rows) {
  if (knowledge.fallback_index() < 0) throw Error("the knowledge has no fallback class");
  Compiler compiler(knowledge, scene, evidence, facts, hard_rows);
  compiler.fix(truth);
  std::vector<int>& order = compiler.out.plane_of_variable;
  order.resize(scene.planes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    return std::pair(scene.planes[at(i)].height, scene.ids[at(i)]) < std::pair(scene.planes[at(j)].height, scene.ids[at(j)]);
  });
  compiler.choose_floor();
  compiler.add_variables();
  compiler.make_room();
  for (std::size_t row = 0; row < knowledge.constraints.size(); ++row) {
    if (knowledge.constraints[row].enabled) compiler.add_row(static_cast<int>(row));
  }
  return std::move(compiler.out);
}

}  // namespace scenelore::rules
