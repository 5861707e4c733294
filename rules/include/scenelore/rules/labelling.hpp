// From evidence, facts and constraint rows to an engine problem, and back to labels with reasons.
#pragma once

#include <map>
#include <optional>
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

/// The knowledge with a row for each Lua constraint of the facts, so that labels, reasons and profiles speak of it as of any
/// other row: named as it is, its summary as message, id −1, −2, …
[[nodiscard]] kb::Knowledge with_tuple_constraints(kb::Knowledge knowledge, const Facts& facts);

/// Where a constraint of the problem comes from. A scene has tens of thousands of them, hence no more in here.
struct ConstraintOrigin {
  int row = -1;  ///< index into Knowledge::constraints, −1 = of no row
  int a = -1;    ///< index into Scene::planes of the plane that the row speaks about, −1 = the whole scene
  int b = -1;    ///< the other plane of a pair, −1 = several
  /// Only says what a conjunction stands for; never broken.
  [[nodiscard]] bool is_definition() const { return row < 0; }
};

/// How the floor to start from was found under `floor` = `threshold`.
struct FloorStart {
  int plane = -1;  ///< index into Scene::planes; the most likely one when none reaches the threshold
  bool found = false;
  double probability = 0, threshold = 0;
};

/// Finite stand-ins, in nats: for −ln 0, and for a hard row that what is known for certain (truth, the floor to start
/// from, a hard `at_least` of the scene) leaves no way to keep. With them a valid world model always exists.
inline constexpr double kImpossibleEvidence = 60;
inline constexpr double kBrokenRow = 1000;

/// An engine problem about a scene: one variable a plane (by height, bottom up), one label a class; then one a conjunction.
struct LabellingProblem {
  engine::Problem problem;
  std::vector<int> plane_of_variable;                ///< index into Scene::planes
  std::vector<int> variable_of_plane;
  std::vector<std::vector<int>> class_of_label;      ///< [variable][label] → index into Knowledge::classes, best first
  std::vector<std::vector<int>> label_of_class;      ///< [variable][class] → label, −1 = ruled out (truth)
  std::vector<ConstraintOrigin> origins;             ///< one a constraint of the problem
  std::map<int, std::vector<int>> more_planes;       ///< by constraint, of tuples: the planes after a and b
  /// "These planes are all of these classes": variables of their own after those of the planes, labels no (0) and yes (1),
  /// that follow from the labels of the planes. `some` over several planes leans on them.
  std::vector<std::vector<engine::Literal>> conjunctions;
  std::optional<FloorStart> floor;                   ///< only under `floor` = `threshold`
};

/// A hard row, and the counting of at_most and at_least, take a relation as holding from this degree on; setting
/// `hold_degree`, 0.5 without one. Soft rows use the degree itself.
[[nodiscard]] double hold_degree(const kb::Knowledge& knowledge);

/// Whether hard rows give way to what is certain (at kBrokenRow), or are as hard as that: then there may be no world at all.
enum class HardRows { give_way, strict };

/// Unary cost = −ln P(C|Φ); constraints by the semantics of docs/rules.md; `truth` fixes labels. Constraint reference = rowid.
/// Setting `floor` = `ranked` (default): floor is chosen by cost; `threshold`: the paper's start, the lowest plane with
/// P(floor) ≥ `floor_threshold` (0.4) is the floor. Throws Error for rows, truth or evidence that name or hold nonsense.
[[nodiscard]] LabellingProblem compile(const kb::Knowledge& knowledge, const Scene& scene,
                                       const std::vector<std::vector<double>>& evidence, const Facts& facts,
                                       const std::vector<std::pair<kb::PlaneId, std::string>>& truth,
                                       HardRows hard_rows = HardRows::give_way);

/// Labels, adjusted probabilities, margins, alternatives and reasons of the best world model.
/// `outcome` infeasible leaves labels empty; run.outcome tells.
struct LabellingOptions {
  engine::SolverOptions solver;
  int alternatives = 3;  ///< how many world models besides the best one
  bool reasons = true;   ///< without them the answer is the same, a little sooner
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
  std::vector<std::pair<std::string, double>> violated;      ///< constraints that would be broken (more), and by how many nats
  std::vector<std::string> sentences;
  std::vector<kb::Reason> features;  ///< what each feature says for the class against the plane's own, strongest first
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

/// The warnings among them about rows that change nothing, as `label` tells them too; `features` are the names that planes have
/// values of. Cheap: nothing is asked of any rule.
[[nodiscard]] std::vector<Finding> idle_rows(const kb::Knowledge& knowledge, const std::vector<std::string>& features);

}  // namespace scenelore::rules
