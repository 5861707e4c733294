// From rows to constraints; docs/rules.md, "What a row means", is the specification.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "compiler.hpp"
#include "names.hpp"
#include "scenelore/rules/error.hpp"
#include "suggestion.hpp"

namespace scenelore::rules {

using engine::Literal;
using kb::Quantifier;

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

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

void Compiler::fix(const std::vector<std::pair<kb::PlaneId, std::string>>& truth) {
  for (const auto& [plane, name] : truth) {
    const auto found = std::find(scene_.ids.begin(), scene_.ids.end(), plane);
    const std::string who = "truth of plane " + std::to_string(plane);
    if (found == scene_.ids.end()) throw Error(who + ": that plane is not in this scan");
    fixed_[static_cast<std::size_t>(found - scene_.ids.begin())] = require_class(knowledge_, name, who);
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

FactIndex::Relation Compiler::facts_of(const kb::ClassConstraint& row) const {
  return row.relation ? index_.relation(*row.relation) : FactIndex::Relation{};
}

/// Until the next call.
std::span<const FactIndex::Held> Compiler::held(const kb::ClassConstraint& row, const FactIndex::Relation& facts, int a) {
  if (row.relation) return facts.held(a);
  all_.clear();
  for (int b = 0; b < planes(); ++b) {
    if (b != a) all_.push_back({b, 1});
  }
  return all_;
}

void Compiler::add_some(int index, int subject, int other) {
  const kb::ClassConstraint& row = rows(index);
  const FactIndex::Relation facts = facts_of(row);
  for (int a = 0; a < planes(); ++a) {
    if (label(a, subject) < 0) continue;
    engine::Requirement requirement{.literal = literal(a, subject), .supports = {}};
    const std::span<const FactIndex::Held> others = held(row, facts, a);
    if (other >= 0) requirement.supports.reserve(others.size());
    for (const auto& [b, degree] : others) {
      if (!row.weight && degree < hold_) continue;
      const double cost = row.weight ? *row.weight * (1 - degree) : 0;
      for_each_other(b, other, [&](Literal support) { requirement.supports.push_back({support, cost}); });
    }
    add(index, a, -1, row.weight.value_or(hard_weight(a)), std::move(requirement));
  }
}

void Compiler::add_count(int index, int subject, int other) {
  const kb::ClassConstraint& row = rows(index);
  const bool at_most = row.quantifier == Quantifier::at_most;
  const FactIndex::Relation facts = facts_of(row);
  for (int a = 0; a < planes(); ++a) {
    if (label(a, subject) < 0) continue;
    engine::Cardinality body{.condition = literal(a, subject), .literals = {}};
    int others = 0;
    for (const auto& [b, degree] : facts.held(a)) {
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
      throw Error(row_name(row) + ": there is no relation '" + *row.relation + "'" + did_you_mean(*row.relation, known) +
                  "; write rules/" + *row.relation + ".lua beside the knowledge base, or change or delete the row");
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
                         const std::vector<std::vector<double>>& evidence, const Facts& facts, const FactIndex& index,
                         const std::vector<std::pair<kb::PlaneId, std::string>>& truth, HardRows hard_rows) {
  if (knowledge.fallback_index() < 0) throw Error("the knowledge has no fallback class");
  Compiler compiler(knowledge, scene, evidence, facts, index, hard_rows);
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

LabellingProblem compile(const kb::Knowledge& knowledge, const Scene& scene,
                         const std::vector<std::vector<double>>& evidence, const Facts& facts,
                         const std::vector<std::pair<kb::PlaneId, std::string>>& truth, HardRows hard_rows) {
  return compile(knowledge, scene, evidence, facts, FactIndex(scene, facts), truth, hard_rows);
}

}  // namespace scenelore::rules
