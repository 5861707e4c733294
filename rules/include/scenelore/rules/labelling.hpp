// From evidence, facts and constraint rows to an engine problem, and back to labels with reasons.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scenelore/engine/problem.hpp"
#include "scenelore/engine/solver.hpp"
#include "scenelore/kb/inference.hpp"
#include "scenelore/kb/knowledge.hpp"
#include "scenelore/rules/rule_set.hpp"
#include "scenelore/rules/scene.hpp"

namespace scenelore::rules {

/// Names of the relations that enabled constraint rows use. Throws Error with "did you mean" for one that `rules` lacks.
[[nodiscard]] std::vector<std::string> used_relations(const kb::Knowledge& knowledge, const RuleSet& rules);

/// An engine problem about a scene: one variable a plane (by height, bottom up), one label a class.
struct LabellingProblem {
  engine::Problem problem;
  std::vector<int> plane_of_variable;                ///< index into Scene::planes
  std::vector<int> variable_of_plane;
  std::vector<std::vector<int>> class_of_label;      ///< [variable][label] → index into Knowledge::classes, best first
  std::vector<std::vector<int>> label_of_class;      ///< [variable][class] → label, −1 = ruled out (truth)
};

/// Unary cost = −ln P(C|Φ); constraints by the semantics of docs/rules.md; `truth` fixes labels. Constraint reference = rowid.
/// Setting `floor` = `ranked` (default): floor is chosen by cost; `threshold`: the paper's start, a floor has P ≥ `floor_threshold`.
[[nodiscard]] LabellingProblem compile(const kb::Knowledge& knowledge, const Scene& scene,
                                       const std::vector<std::vector<double>>& evidence, const Facts& facts,
                                       const std::vector<std::pair<kb::PlaneId, std::string>>& truth);

/// Labels, adjusted probabilities, margins, alternatives and reasons of the best world model.
/// `outcome` infeasible leaves labels empty; run.outcome tells.
struct LabellingOptions {
  engine::SolverOptions solver;
  int alternatives = 3;  ///< how many world models besides the best one
};
[[nodiscard]] kb::Inference label(const kb::Knowledge& knowledge, const Scene& scene,
                                  const std::vector<std::vector<double>>& evidence, const Facts& facts,
                                  const std::vector<std::pair<kb::PlaneId, std::string>>& truth,
                                  const LabellingOptions& options = {});

/// Why a plane is not `object_class`: the cheapest world where it is, as sentences (last one a summary); what else changes.
struct WhyNot {
  bool possible = false;
  double extra_cost = 0;
  std::vector<std::pair<kb::PlaneId, std::string>> changes;  ///< other planes whose class would change
  std::vector<std::string> sentences;
};
[[nodiscard]] WhyNot why_not(const kb::Knowledge& knowledge, const Scene& scene,
                             const std::vector<std::vector<double>>& evidence, const Facts& facts,
                             const std::vector<std::pair<kb::PlaneId, std::string>>& truth, kb::PlaneId plane,
                             const std::string& object_class, const LabellingOptions& options = {});

/// The findings of `rules check` on knowledge and rule files: unknown names, rows that can never hold or never matter.
struct Finding {
  bool error = false;  ///< else a warning
  std::string where;   ///< file:line or table row
  std::string text;
};
[[nodiscard]] std::vector<Finding> check(const kb::Knowledge& knowledge, const RuleSet& rules);

}  // namespace scenelore::rules
