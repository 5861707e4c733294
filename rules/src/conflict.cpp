// Hard rows never rule out every labelling, since what is certain wins against them; but they are then broken. Compiled
// strictly they cannot all hold, and the engine names a minimal set of constraints.
#include "scenelore/rules/conflict.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <tuple>

#include "fact_index.hpp"
#include "world.hpp"

namespace scenelore::rules {

namespace {

using Truth = std::vector<std::pair<kb::PlaneId, std::string>>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Of a tuple: the planes after the first two.
std::vector<int> planes_after(const LabellingProblem& compiled, int constraint) {
  const auto found = compiled.more_planes.find(constraint);
  return found == compiled.more_planes.end() ? std::vector<int>{} : found->second;
}

ConflictPart part_of(const Case& about, int constraint) {
  const ConstraintOrigin& origin = about.compiled.origins[at(constraint)];
  const kb::ClassConstraint& row = about.row(constraint);
  ConflictPart part{.constraint = row.name, .planes = {}, .sentence = {}};
  std::string where = " in the whole scene";
  if (origin.a >= 0) {
    part.planes.push_back(about.id(origin.a));
    where = " at plane " + std::to_string(about.id(origin.a));
  }
  if (origin.b >= 0) {
    part.planes.push_back(about.id(origin.b));
    where += " and plane " + std::to_string(about.id(origin.b));
  }
  for (const int plane : planes_after(about.compiled, constraint)) {
    part.planes.push_back(about.id(plane));
    where += " and plane " + std::to_string(about.id(plane));
  }
  part.sentence = about.quoted(row) + " (constraint '" + row.name + "')" + where;
  return part;
}

/// The variables of a problem with some of its constraints.
engine::Problem restricted(const engine::Problem& problem, const std::vector<int>& constraints) {
  engine::Problem out;
  for (const engine::Variable& v : problem.variables()) out.add_variable(v.name, v.labels, v.costs);
  for (int table = 0; table < problem.tables(); ++table) {
    const auto [labels_a, labels_b] = problem.table_size(table);
    out.add_table(labels_a, labels_b, problem.table(table));
  }
  for (const int index : constraints) {
    const engine::Constraint c = problem.constraints()[at(index)];
    out.add(c.name, c.weight, c.reference, c.body);
  }
  return out;
}

using Place = std::tuple<int, int, int, std::vector<int>>;  // row, a, b, more
Place place_of(const LabellingProblem& compiled, int constraint) {
  const ConstraintOrigin& origin = compiled.origins[at(constraint)];
  return {origin.row, origin.a, origin.b, planes_after(compiled, constraint)};
}

/// Constraints of another compilation of the same rows at the same places, and what their conjunctions stand for.
std::vector<int> same_places(const LabellingProblem& compiled, const std::set<Place>& places) {
  std::vector<int> out;
  for (int i = 0; i < static_cast<int>(compiled.origins.size()); ++i) {
    if (compiled.origins[at(i)].is_definition() || places.contains(place_of(compiled, i))) out.push_back(i);
  }
  return out;
}

}  // namespace

Contradiction find_contradiction(const kb::Knowledge& knowledge, const Scene& scene,
                                 const std::vector<std::vector<double>>& evidence, const Facts& facts, const Truth& truth,
                                 const LabellingOptions& options) {
  Contradiction out;
  const FactIndex index(scene, facts);
  const LabellingProblem strict = compile(knowledge, scene, evidence, facts, truth, HardRows::strict);
  const Case about{knowledge, scene, evidence, index, strict};
  const std::vector<int> core = engine::Solver(strict.problem, options.solver).conflict().constraints;
  if (core.empty()) return out;

  std::set<Place> places;
  for (const int constraint : core) {
    if (strict.origins[at(constraint)].is_definition()) continue;
    places.insert(place_of(strict, constraint));
    out.parts.push_back(part_of(about, constraint));
  }
  // A truth row belongs to the contradiction when the rows could hold without it; those that do not matter go first.
  Truth needed = truth;
  for (const auto& entry : truth) {
    Truth less;
    std::copy_if(needed.begin(), needed.end(), std::back_inserter(less), [&](const auto& t) { return t.first != entry.first; });
    const LabellingProblem freer = compile(knowledge, scene, evidence, facts, less, HardRows::strict);
    const engine::Problem problem = restricted(freer.problem, same_places(freer, places));
    if (engine::Solver(problem, options.solver).solve().outcome == engine::Outcome::infeasible) needed = std::move(less);
  }
  for (const auto& [plane, name] : needed) {
    out.parts.push_back({.constraint = {}, .planes = {plane}, .sentence = "plane " + std::to_string(plane) + " is " + name +
                                                                           " because a truth row says so"});
  }

  const LabellingProblem relaxed = compile(knowledge, scene, evidence, facts, truth);
  const Case soft{knowledge, scene, evidence, index, relaxed};
  for (const engine::Violation& violation : engine::Solver(relaxed.problem, options.solver).solve().violations) {
    if (!soft.row(violation.constraint).weight) out.relaxation.push_back(part_of(soft, violation.constraint));
  }
  return out;
}

}  // namespace scenelore::rules
