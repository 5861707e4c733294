// Solve, then ask the solver again what each plane would be otherwise, and tell why.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "compiler.hpp"
#include "conjunctions.hpp"
#include "reasons.hpp"
#include "scenelore/engine/checker.hpp"
#include "scenelore/rules/labelling.hpp"
#include "scenelore/rules/objects.hpp"

namespace scenelore::rules {

namespace {

using Clock = std::chrono::steady_clock;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

kb::Run run_of(const engine::Solution& solution) {
  kb::Run run;
  run.outcome = engine::to_string(solution.outcome);
  run.cost = solution.cost;
  run.lower_bound = solution.lower_bound;
  run.nodes = static_cast<std::int64_t>(solution.nodes);
  run.seconds = solution.seconds;
  return run;
}

void add_alternatives(const Case& about, const World& best, engine::Solver& solver, int count, kb::Inference& out) {
  if (count <= 0) return;
  const std::vector<engine::Solution> worlds = solver.k_best(count + 1);
  for (std::size_t rank = 1; rank < worlds.size(); ++rank) {
    const World world(about, worlds[rank]);
    for (int plane = 0; plane < about.planes(); ++plane) {
      if (world.class_of(plane) == best.class_of(plane)) continue;
      out.alternatives.push_back(
          {static_cast<int>(rank) + 1, about.id(plane), about.class_name(world.class_of(plane))});
    }
  }
}

/// Margins are told up to this many nats (odds of 20 to 1). Proving how much dearer than that another class would be
/// takes most of the time of a relabelling and tells a person nothing.
constexpr double kMarginReach = 3;

/// Nodes that all margins of a scan together may take. A furnished room needs a few dozen; a scan full of unclear planes could
/// take minutes. Counted in nodes, not seconds, so that the answer is the same on every machine.
constexpr std::uint64_t kRivalNodes = 600;

/// The best world but for the label of one variable; nothing when that label cannot change alone.
std::optional<engine::Solution> nearest_other(const LabellingProblem& compiled, const engine::Solution& best,
                                              const std::vector<double>& flips, int variable) {
  const auto least = std::min_element(flips.begin(), flips.end());  // the label itself has an infinite price
  if (least == flips.end() || !std::isfinite(*least)) return std::nullopt;
  engine::Solution other = best;
  other.assignment[at(variable)] = static_cast<int>(least - flips.begin());
  settle(compiled, other.assignment);
  const engine::Check checked = engine::check(compiled.problem, other.assignment);
  other.cost = checked.cost;
  other.violations = checked.violations;
  return other;
}

/// The best world in which each plane is something else; nothing where there is none within reach or the time is up. When
/// the nodes are used up, the best world but for this label stands in: its extra cost is no less than the true margin.
std::vector<std::optional<World>> rivals(const Case& about, const World& best, const engine::Solution& solution,
                                         engine::Solver& solver, double seconds) {
  std::vector<std::vector<double>> flips;  // only made when it is needed
  std::uint64_t nodes = 0;
  const Clock::time_point start = Clock::now();
  std::vector<std::optional<World>> out(at(about.planes()));
  for (int plane = 0; plane < about.planes(); ++plane) {
    const int variable = about.compiled.variable_of_plane[at(plane)];
    if (about.compiled.class_of_label[at(variable)].size() < 2) continue;
    if (std::chrono::duration<double>(Clock::now() - start).count() > seconds) break;
    const int label = about.compiled.label_of_class[at(variable)][at(best.class_of(plane))];
    if (nodes > kRivalNodes) {
      if (flips.empty()) flips = label_flip_costs(about.compiled, solution.assignment);
      std::vector<double> prices = flips[at(variable)];
      prices[at(label)] = std::numeric_limits<double>::infinity();
      const auto other = nearest_other(about.compiled, solution, prices, variable);
      if (other && other->cost < best.cost() + kMarginReach) out[at(plane)].emplace(about, *other);
      continue;
    }
    const engine::Solution other =
        solver.solve({.fixed = {}, .forbidden = {{variable, label}}, .below = best.cost() + kMarginReach});
    nodes += other.nodes;
    if (!other.assignment.empty()) out[at(plane)].emplace(about, other);
  }
  return out;
}

/// Whether variables share constraints with more others than elimination can cope with: a graph with more than k edges a
/// variable has a treewidth above k (it is no partial k-tree), so that elimination needs tables of more than k variables.
constexpr std::size_t kMostPairsAVariable = 6;  // ten classes: a million entries
bool too_entangled(const engine::Problem& problem) {
  const std::size_t n = problem.variables().size(), most = kMostPairsAVariable * std::max<std::size_t>(n, 1);
  std::vector<bool> adjacent(n * n);
  std::size_t pairs = 0;
  const auto join = [&](int a, int b) {
    if (a == b) return;
    auto entry = adjacent[at(std::min(a, b)) * n + at(std::max(a, b))];
    pairs += entry ? 0 : 1;
    entry = true;
  };
  for (const engine::ConstraintView constraint : problem.constraints()) {
    if (pairs >= most) break;
    if (const auto* conflict = constraint.as<engine::Conflict>()) join(conflict->a.variable, conflict->b.variable);
    if (const auto* table = constraint.as<engine::PairTable>()) join(table->a, table->b);
    if (const auto* needs = constraint.as<engine::Requirement>()) {
      for (const engine::Support& support : needs->supports) join(needs->literal.variable, support.literal.variable);
    }
  }
  return pairs >= most;
}

/// Adjusted probability of each plane's label. Exact where the engine can sum over all worlds. Where it cannot, from the
/// best world with each other label, e^−(extra cost): that of the runner-up is known exactly, those of the other labels
/// are taken as the cost of changing this label alone, so that they are if anything too dear.
class Probabilities {
 public:
  Probabilities(const Case& about, engine::Solver& solver, const engine::Solution& best)
      : about_(about), best_(best), flips_(label_flip_costs(about.compiled, best.assignment)) {
    if (!too_entangled(about.compiled.problem)) summed_ = solver.marginals(1);
  }

  [[nodiscard]] double of(int plane, const std::optional<World>& rival) const {
    const int variable = about_.compiled.variable_of_plane[at(plane)], label = best_.assignment[at(variable)];
    const double summed = summed_.probability.empty() ? 1 : summed_.probability[at(variable)][at(label)];
    if (!summed_.probability.empty() && (summed_.exact || summed < 1)) return std::clamp(summed, 0.0, 1.0);
    double others = 0;
    const double margin = rival ? std::max(0.0, rival->cost() - best_.cost) : 0;
    for (int l = 0; l < static_cast<int>(flips_[at(variable)].size()); ++l) {
      if (l == label) continue;
      const int object_class = about_.compiled.class_of_label[at(variable)][at(l)];
      const bool is_rival = rival && rival->class_of(plane) == object_class;
      others += std::exp(is_rival ? -margin : -std::max(flips_[at(variable)][at(l)], margin));
    }
    return 1 / (1 + others);
  }

 private:
  const Case& about_;
  const engine::Solution& best_;
  engine::Marginals summed_;
  std::vector<std::vector<double>> flips_;
};

kb::Label label_of(const Case& about, const World& best, const std::optional<World>& rival, double probability, int plane) {
  const int variable = about.compiled.variable_of_plane[at(plane)];
  kb::Label out{.plane = about.id(plane), .object_class = about.class_name(best.class_of(plane)),
                .probability = probability};
  if (rival) {
    out.margin = std::max(0.0, rival->cost() - best.cost());
    out.runner_up = about.class_name(rival->class_of(plane));
  } else {
    const bool fixed = about.compiled.class_of_label[at(variable)].size() < 2;
    out.margin = fixed ? std::numeric_limits<double>::infinity() : kMarginReach;
  }
  return out;
}

}  // namespace

kb::Inference label(const kb::Knowledge& knowledge, const Scene& scene, const std::vector<std::vector<double>>& evidence,
                    const Facts& facts, const std::vector<std::pair<kb::PlaneId, std::string>>& truth,
                    const LabellingOptions& options) {
  const FactIndex index(scene, facts);
  const LabellingProblem compiled = compile(knowledge, scene, evidence, facts, index, truth, HardRows::give_way);
  engine::Solver solver(compiled.problem, options.solver);
  const engine::Solution solution = solver.solve();

  kb::Inference out;
  out.run = run_of(solution);
  for (const kb::ObjectClass& object_class : knowledge.classes) out.classes.push_back(object_class.name);
  out.planes = scene.ids;
  out.evidence = evidence;
  out.facts = facts.facts;
  out.asked = facts.asked;
  out.geometry = facts.geometry;
  out.rule_answers = facts.answers;
  if (solution.assignment.empty() || scene.planes.empty()) return out;

  const Case about{knowledge, scene, evidence, index, compiled};
  const World best(about, solution);
  const auto other_worlds = rivals(about, best, solution, solver, options.solver.limits.seconds);
  const kb::ProbabilityScale scale = knowledge.probability_scale();
  const Probabilities probabilities(about, solver, solution);
  std::vector<double> margins;
  for (int plane = 0; plane < about.planes(); ++plane) {
    const auto& rival = other_worlds[at(plane)];
    out.labels.push_back(label_of(about, best, rival, scale(probabilities.of(plane, rival)), plane));
    margins.push_back(out.labels.back().margin);
  }
  out.objects = group_objects(knowledge, scene, out.labels, facts.facts);
  add_alternatives(about, best, solver, options.alternatives, out);
  if (!options.reasons) return out;

  std::set<kb::PlaneId> known;
  for (const auto& [plane, name] : truth) known.insert(plane);
  Reasoner reasoner(about, best);
  for (int plane = 0; plane < about.planes(); ++plane) {
    if (known.contains(about.id(plane))) reasoner.add_truth(plane);
    reasoner.add_evidence(plane);
  }
  reasoner.add_floor();
  reasoner.add_supports(margins);
  reasoner.add_violations();
  for (int plane = 0; plane < about.planes(); ++plane) {
    const auto& rival = other_worlds[at(plane)];
    reasoner.add_rival(plane, out.labels[at(plane)], rival ? &*rival : nullptr);
  }
  out.reasons = reasoner.take();
  return out;
}

}  // namespace scenelore::rules
