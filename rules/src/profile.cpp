// A row decides what it changes: the scene is labelled with all rows, then with each one left out.
#include "scenelore/rules/profile.hpp"

#include <algorithm>
#include <map>

namespace scenelore::rules {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Counts the nodes that each constraint ends.
class Pruning : public engine::Observer {
 public:
  void pruned(int, engine::Literal, int constraint) override { ++by_constraint[constraint]; }
  std::map<int, std::int64_t> by_constraint;
};

/// Class by plane; empty when no labelling was found.
std::vector<int> classes(const LabellingProblem& compiled, const engine::Solution& solution) {
  std::vector<int> out(solution.assignment.empty() ? 0 : compiled.plane_of_variable.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    out[at(compiled.plane_of_variable[v])] = compiled.class_of_label[v][at(solution.assignment[v])];
  }
  return out;
}

}  // namespace

Profile profile(const kb::Knowledge& knowledge, const Scene& scene, const std::vector<std::vector<double>>& evidence,
                RuleSet& rules, const std::vector<std::pair<kb::PlaneId, std::string>>& truth, const LabellingOptions& options) {
  std::vector<std::string> names = used_relations(knowledge, rules);
  for (const RelationInfo& relation : rules.relations()) {
    if (!relation.file.starts_with("rules/relations/")) names.push_back(relation.name);
  }
  Facts facts = rules.relate(scene, names);
  kb::Knowledge rows = knowledge;  // without those of Lua constraints, which are made anew
  std::erase_if(rows.constraints, [](const kb::ClassConstraint& row) { return row.id < 0; });
  facts.constraints = rules.constraints(scene, rows);
  Profile out{.relations = facts.counts, .rows = {}};

  const LabellingProblem compiled = compile(knowledge, scene, evidence, facts, truth);
  Pruning pruning;
  engine::SolverOptions watched = options.solver;
  watched.observer = &pruning;
  const engine::Solution best = engine::Solver(compiled.problem, watched).solve();
  const std::vector<int> labels = classes(compiled, best);

  std::map<int, std::size_t> entry;  // row → place in out.rows
  for (std::size_t row = 0; row < knowledge.constraints.size(); ++row) {
    if (!knowledge.constraints[row].enabled) continue;
    entry[static_cast<int>(row)] = out.rows.size();
    out.rows.push_back({.constraint = knowledge.constraints[row].name, .relation = knowledge.constraints[row].relation.value_or("")});
  }
  const auto of = [&](int constraint) -> RowProfile& { return out.rows[entry.at(compiled.origins[at(constraint)].row)]; };
  const auto is_definition = [&](int constraint) { return compiled.origins[at(constraint)].is_definition(); };
  for (int i = 0; i < static_cast<int>(compiled.origins.size()); ++i) {
    if (!is_definition(i)) ++of(i).constraints;
  }
  for (const engine::Violation& violation : best.violations) {
    ++of(violation.constraint).broken;
    of(violation.constraint).paid += violation.amount;
  }
  for (const auto& [constraint, nodes] : pruning.by_constraint) {
    if (constraint >= 0 && !is_definition(constraint)) of(constraint).pruned += nodes;
  }
  kb::Knowledge without = knowledge;
  for (const auto& [row, place] : entry) {
    if (out.rows[place].constraints == 0) continue;
    without.constraints[at(row)].enabled = false;
    const LabellingProblem freer = compile(without, scene, evidence, facts, truth);
    const std::vector<int> other = classes(freer, engine::Solver(freer.problem, options.solver).solve());
    without.constraints[at(row)].enabled = true;
    for (std::size_t plane = 0; plane < std::min(labels.size(), other.size()); ++plane) {
      out.rows[place].decided += labels[plane] != other[plane];
    }
  }
  return out;
}

}  // namespace scenelore::rules
