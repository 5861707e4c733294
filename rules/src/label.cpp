// Solve, then ask the solver again what each plane would be otherwise, and tell why.
#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>
#include <set>

#include "reasons.hpp"
#include "scenelore/rules/labelling.hpp"

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

/// The best world in which each plane is something else; nothing where there is none or the time is up.
std::vector<std::optional<World>> rivals(const Case& about, const World& best, engine::Solver& solver, double seconds) {
  const Clock::time_point start = Clock::now();
  std::vector<std::optional<World>> out(at(about.planes()));
  for (int plane = 0; plane < about.planes(); ++plane) {
    const int variable = about.compiled.variable_of_plane[at(plane)];
    if (about.compiled.class_of_label[at(variable)].size() < 2) continue;
    if (std::chrono::duration<double>(Clock::now() - start).count() > seconds) break;
    const int label = about.compiled.label_of_class[at(variable)][at(best.class_of(plane))];
    const engine::Solution other = solver.solve({.fixed = {}, .forbidden = {{variable, label}}});
    if (!other.assignment.empty()) out[at(plane)].emplace(about, other);
  }
  return out;
}

kb::Label label_of(const Case& about, const World& best, const std::optional<World>& rival,
                   const std::vector<std::vector<double>>& probability, int plane) {
  const int variable = about.compiled.variable_of_plane[at(plane)];
  const int label = about.compiled.label_of_class[at(variable)][at(best.class_of(plane))];
  kb::Label out{.plane = about.id(plane), .object_class = about.class_name(best.class_of(plane)),
                .probability = std::clamp(probability[at(variable)][at(label)], 0.0, 1.0)};
  if (rival) {
    out.margin = std::max(0.0, rival->cost() - best.cost());
    out.runner_up = about.class_name(rival->class_of(plane));
  } else if (about.compiled.class_of_label[at(variable)].size() < 2) {
    out.margin = std::numeric_limits<double>::infinity();
  }
  return out;
}

}  // namespace

kb::Inference label(const kb::Knowledge& knowledge, const Scene& scene, const std::vector<std::vector<double>>& evidence,
                    const Facts& facts, const std::vector<std::pair<kb::PlaneId, std::string>>& truth,
                    const LabellingOptions& options) {
  const LabellingProblem compiled = compile(knowledge, scene, evidence, facts, truth);
  engine::Solver solver(compiled.problem, options.solver);
  const engine::Solution solution = solver.solve();

  kb::Inference out;
  out.run = run_of(solution);
  for (const kb::ObjectClass& object_class : knowledge.classes) out.classes.push_back(object_class.name);
  out.planes = scene.ids;
  out.evidence = evidence;
  out.facts = facts.facts;
  if (solution.assignment.empty() || scene.planes.empty()) return out;

  const FactIndex index(scene, facts);
  const Case about{knowledge, scene, evidence, index, compiled};
  const World best(about, solution);
  const auto other_worlds = rivals(about, best, solver, options.solver.limits.seconds);
  const auto probability = solver.marginals().probability;
  std::vector<double> margins;
  for (int plane = 0; plane < about.planes(); ++plane) {
    out.labels.push_back(label_of(about, best, other_worlds[at(plane)], probability, plane));
    margins.push_back(out.labels.back().margin);
  }
  add_alternatives(about, best, solver, options.alternatives, out);

  std::set<kb::PlaneId> known;
  for (const auto& [plane, name] : truth) known.insert(plane);
  Reasoner reasoner(about, best);
  for (int plane = 0; plane < about.planes(); ++plane) {
    if (known.contains(about.id(plane))) reasoner.add_truth(plane);
    reasoner.add_evidence(plane, out.labels[at(plane)]);
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
