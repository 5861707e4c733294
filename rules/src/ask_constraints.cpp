// Asks constraints of Lua files about tuples of planes.
#include "scenelore/rules/rule_set.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "byte_stream.hpp"
#include "deadline.hpp"
#include "kept_answers.hpp"
#include "kept_geometry.hpp"
#include "loaded_rules.hpp"
#include "names.hpp"
#include "scenelore/rules/error.hpp"
#include "shown_scene.hpp"

namespace scenelore::rules {

namespace {

using Tuple = TupleConstraint::Tuple;

std::string encoded(const std::vector<Tuple>& tuples) {
  Writer out;
  for (const Tuple& tuple : tuples) {
    for (const kb::PlaneId plane : tuple.planes) out.number(plane);
    out.number(tuple.degree);
  }
  return std::move(out.bytes);
}

/// Tuples of so many planes; nothing for bytes that are none.
std::optional<std::vector<Tuple>> decoded(std::string_view bytes, std::size_t planes) {
  const std::size_t size = planes * sizeof(kb::PlaneId) + sizeof(double);
  if (bytes.size() % size != 0) return std::nullopt;
  Reader in(bytes);
  std::vector<Tuple> out(bytes.size() / size);
  for (Tuple& tuple : out) {
    for (std::size_t i = 0; i < planes; ++i) tuple.planes.push_back(in.number<kb::PlaneId>());
    tuple.degree = in.number<double>();
  }
  return out;
}

void require_fit(const TupleConstraint& constraint, const kb::Knowledge& knowledge) {
  for (const std::string& object_class : constraint.classes) (void)require_class(knowledge, object_class, constraint.file);
  for (const kb::ClassConstraint& row : knowledge.constraints) {
    if (row.name == constraint.name) throw Error(constraint.file + ": the name '" + row.name + "' is taken by a row of class_constraint");
  }
}

/// Of each plane, those whose boxes are within reach of its own, rising.
std::vector<std::vector<int>> neighbours_of(const std::vector<Box3>& boxes, double within) {
  std::vector<std::vector<int>> neighbours(boxes.size());
  for (const auto& [a, b] : pairs_in_reach(boxes, within, within)) {  // which rise, so that each list does
    neighbours[static_cast<std::size_t>(a)].push_back(b);
    neighbours[static_cast<std::size_t>(b)].push_back(a);
  }
  return neighbours;
}

/// Visits all tuples of `size` different planes that begin with this one and go on with planes of `near`, in its order.
template <typename Visit>
void for_each_tuple(std::vector<int>& tuple, const std::vector<int>& near, std::size_t size, const Visit& visit) {
  if (tuple.size() == size) {
    visit(tuple);
    return;
  }
  for (const int plane : near) {
    if (std::find(tuple.begin(), tuple.end(), plane) != tuple.end()) continue;
    tuple.push_back(plane);
    for_each_tuple(tuple, near, size, visit);
    tuple.pop_back();
  }
}

bool changes_nothing(kb::Quantifier quantifier, double degree) {
  return quantifier == kb::Quantifier::every ? degree >= 1 : degree <= 0;
}

/// The tuples that change something, of a file that has been shown the scene.
std::vector<Tuple> found_tuples(RuleFile& file, const Scene& scene, const std::vector<Box3>& boxes, const Budget& budget) {
  const Deadline deadline(file, budget);
  const TupleConstraint& constraint = file.constraint();
  const std::vector<std::vector<int>> neighbours = neighbours_of(boxes, constraint.within);
  std::vector<Tuple> out;
  std::int64_t asked = 0;
  const auto ask = [&](const std::vector<int>& tuple) {
    if (asked++ % 64 == 0) deadline.check(asked);
    const std::optional<double> degree = file.degree(tuple);
    if (!degree || changes_nothing(constraint.quantifier, *degree)) return;
    std::vector<kb::PlaneId> ids;
    for (const int plane : tuple) ids.push_back(scene.ids[static_cast<std::size_t>(plane)]);
    out.push_back({std::move(ids), *degree});
  };
  for (std::size_t first = 0; first < neighbours.size(); ++first) {
    std::vector<int> tuple{static_cast<int>(first)};
    for_each_tuple(tuple, neighbours[first], constraint.classes.size(), ask);
  }
  return out;
}

}  // namespace

std::vector<TupleConstraint> RuleSet::constraints(const Scene& scene, const kb::Knowledge& knowledge, kb::StoredGeometry* known,
                                                  KeptAnswers* answers) const {
  std::vector<TupleConstraint> out;
  if (loaded_->tuple_constraints().empty()) return out;
  const SceneDigest digest = loaded_->digest_of(scene);
  KeptGeometry kept(scene, digest);
  PairGeometry& geometry = kept.with(known == nullptr ? kb::StoredGeometry{} : *known);
  ShownScene shown(scene);
  const std::vector<Box3> boxes = boxes_of(scene.planes);
  for (auto& [name, entry] : loaded_->tuple_constraints()) {
    RuleFile& file = loaded_->file(entry);
    TupleConstraint& constraint = out.emplace_back(file.constraint());
    require_fit(constraint, knowledge);
    const std::string rule = "constraint " + name;
    const kb::StoredAnswer* const before = kept_answer(answers, rule, entry.source, digest);
    if (auto tuples = before == nullptr ? std::nullopt : decoded(before->answers, constraint.classes.size())) {
      constraint.tuples = std::move(*tuples);
      continue;
    }
    shown.show_to(file, geometry);
    constraint.tuples = found_tuples(file, scene, boxes, loaded_->budget());
    keep(answers, rule, file, digest, encoded(constraint.tuples));
  }
  if (known != nullptr) *known = kept.kept(*known);
  return out;
}

}  // namespace scenelore::rules
