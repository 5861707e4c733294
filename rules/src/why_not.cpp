#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "names.hpp"
#include "reasons.hpp"
#include "scenelore/rules/error.hpp"
#include "scenelore/rules/labelling.hpp"

namespace scenelore::rules {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Rows that, with the plane held at the class, cannot all hold.
std::vector<std::string> forbidding_rows(const Case& about, engine::Literal wanted, const LabellingOptions& options) {
  engine::Problem problem = about.compiled.problem;
  const int labels = static_cast<int>(problem.variables()[at(wanted.variable)].labels.size());
  for (int l = 0; l < labels; ++l) {
    if (l != wanted.label) problem.set_cost({wanted.variable, l}, std::numeric_limits<double>::infinity());
  }
  std::set<std::string> rows;
  const engine::Conflicting conflicting = engine::Solver(problem, options.solver).conflict();
  for (const int constraint : conflicting.constraints) {
    if (!about.compiled.origins[at(constraint)].is_definition()) rows.insert(about.quoted(about.row(constraint)));
  }
  return {rows.begin(), rows.end()};
}

/// "2.3 times", "about 12000 times": two digits are enough for a ratio.
std::string times(double ratio) {
  if (!(ratio < 1e12)) return "more than a million million times";
  if (ratio < 100) return number(ratio, 1) + " times";
  const double unit = std::pow(10, std::floor(std::log10(ratio)) - 1);
  return "about " + number(std::round(ratio / unit) * unit, 0) + " times";
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
  return out;
}

void tell_differences(const Case& about, const World& best, const World& other, int plane, WhyNot& out) {
  for (const Difference& d : differences(about, best, other)) {
    const std::string amount = number(std::abs(d.amount)) + (d.amount > 0 ? " more" : " less");
    if (d.row < 0 && d.plane == plane) {
      const auto& p = about.evidence[at(plane)];
      out.sentences.push_back("its features speak of " + about.class_name(other.class_of(plane)) + " with " +
                              number(p[at(other.class_of(plane))], 4) + ", of " + about.class_name(best.class_of(plane)) +
                              " with " + number(p[at(best.class_of(plane))], 4) + ": " + amount);
    } else if (d.row < 0) {
      out.sentences.push_back(best.named(d.plane) + " would become " + about.class_name(other.class_of(d.plane)) + ": " + amount);
    } else {
      const std::string row = about.quoted(about.knowledge.constraints[at(d.row)]);
      if (d.amount > 0) out.violated.emplace_back(about.knowledge.constraints[at(d.row)].name, d.amount);
      out.sentences.push_back((d.amount > 0 ? "it would break " : "it would no longer break ") + row + ": " + amount);
    }
  }
}

}  // namespace

WhyNot why_not(const kb::Knowledge& knowledge, const Scene& scene, const std::vector<std::vector<double>>& evidence,
               const Facts& facts, const std::vector<std::pair<kb::PlaneId, std::string>>& truth, kb::PlaneId plane_id,
               const std::string& object_class, const LabellingOptions& options) {
  const std::string who = "plane " + std::to_string(plane_id);
  const auto found = std::find(scene.ids.begin(), scene.ids.end(), plane_id);
  if (found == scene.ids.end()) throw Error(who + " is not in this scan");
  const int plane = static_cast<int>(found - scene.ids.begin());
  const int wanted = require_class(knowledge, object_class, who);
  const LabellingProblem compiled = compile(knowledge, scene, evidence, facts, truth);
  const FactIndex index(scene, facts);
  const Case about{knowledge, scene, evidence, index, compiled};
  engine::Solver solver(compiled.problem, options.solver);
  const engine::Solution solution = solver.solve();
  WhyNot out;
  const int variable = compiled.variable_of_plane[at(plane)];
  const int label = compiled.label_of_class[at(variable)][at(wanted)];
  const auto end = [&](std::string sentence) {
    out.sentences.push_back(who + std::move(sentence));
    return out;
  };
  if (label < 0) return end(" cannot be " + object_class + ": its class is fixed by a truth row or as the floor to start from");
  if (solution.assignment.empty()) return end(": no labelling was found at all (" + std::string(engine::to_string(solution.outcome)) + ")");
  const World best(about, solution);
  if (best.class_of(plane) == wanted) {
    out.possible = true;
    return end(" is " + object_class + " already");
  }
  out.features = feature_reasons(about, plane, wanted, best.class_of(plane));
  const engine::Solution other = solver.solve({.fixed = {{variable, label}}, .forbidden = {}});
  if (other.assignment.empty()) {
    if (other.outcome != engine::Outcome::infeasible) return end(": the search ended at a limit before it found out");
    const std::vector<std::string> rows = forbidding_rows(about, {variable, label}, options);
    return end(" cannot be " + object_class + " in any valid labelling" +
               (rows.empty() ? std::string() : "; what forbids it: " + joined(rows)));
  }
  const World there(about, other);
  out.possible = true;
  out.extra_cost = std::max(0.0, there.cost() - best.cost());
  for (int i = 0; i < about.planes(); ++i) {
    if (i != plane && there.class_of(i) != best.class_of(i)) {
      out.changes.emplace_back(about.id(i), about.class_name(there.class_of(i)));
    }
  }
  tell_differences(about, best, there, plane, out);
  return end(" is " + about.class_name(best.class_of(plane)) + "; the best labelling with it as " + object_class + " costs " +
             number(out.extra_cost) + " more, which makes it " + times(std::exp(out.extra_cost)) + " less likely");
}

}  // namespace scenelore::rules
