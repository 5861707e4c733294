#include "scenelore/rules/learn_weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "conjunctions.hpp"
#include "flip_costs.hpp"
#include "log_linear.hpp"
#include "names.hpp"
#include "scenelore/rules/error.hpp"

namespace scenelore::rules {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Nats. A row of weight 0 would drop out of the problem and never come back; the schema forbids it, too.
constexpr double kLeastRow = 0.01;

/// Soft rows of the table class_constraint; what composites and Lua files ask for (ids below 0) keeps its weight.
bool is_learned(const kb::ClassConstraint& row) { return row.enabled && row.id >= 0 && row.weight && *row.weight > 0; }

/// Where the weights stand in the vector of parameters: features that count, then classes, then soft rows, then kinds.
struct Layout {
  std::vector<int> features, rows;  // index into the knowledge
  std::size_t classes = 0;

  explicit Layout(const kb::Knowledge& knowledge) : classes(knowledge.classes.size()) {
    for (int i = 0; i < static_cast<int>(knowledge.features.size()); ++i) {
      if (knowledge.features[at(i)].weight > 0) features.push_back(i);
    }
    for (int i = 0; i < static_cast<int>(knowledge.constraints.size()); ++i) {
      const kb::ClassConstraint& row = knowledge.constraints[at(i)];
      if (row.id >= 0 && is_learned(row)) rows.push_back(i);  // those below 0 stand in Lua files
    }
  }
  [[nodiscard]] std::size_t first_class() const { return features.size(); }
  [[nodiscard]] std::size_t first_row() const { return features.size() + classes; }
  /// How usual the kinds are that a plane looks like, which has no weight of its own: its parameter stays 1.
  [[nodiscard]] std::size_t of_kinds() const { return first_row() + rows.size(); }
  [[nodiscard]] std::size_t size() const { return of_kinds() + 1; }
};

/// Class by plane, −1 = not known.
std::vector<int> true_classes(const kb::Knowledge& knowledge, const LabelledScene& scene) {
  if (scene.classes.size() != scene.scene.planes.size()) {
    throw Error("learning weights: " + std::to_string(scene.classes.size()) + " classes for " +
                std::to_string(scene.scene.planes.size()) + " planes");
  }
  std::vector<int> out;
  for (const std::string& name : scene.classes) out.push_back(name.empty() ? -1 : require_class(knowledge, name, "learning weights"));
  return out;
}

/// What the features say about every class of every plane: [plane][class][feature of the layout, then what is said by kinds]. Where
/// classes have kinds it depends on the present weights, as in expectation maximisation.
using Terms = std::vector<std::vector<std::vector<double>>>;

Terms feature_terms(const kb::Knowledge& knowledge, const Layout& layout, const kb::FeatureTable& table) {
  std::vector<std::pair<std::size_t, std::size_t>> entries;
  for (std::size_t p = 0; p < table.values.size(); ++p) {
    for (std::size_t c = 0; c < layout.classes; ++c) entries.emplace_back(p, c);
  }
  Terms out(table.values.size(), std::vector<std::vector<double>>(layout.classes, std::vector<double>(layout.features.size() + 1, 0.0)));
  const auto contributions = kb::contributions(knowledge, table, entries);
  for (std::size_t e = 0; e < entries.size(); ++e) {
    for (const kb::Contribution& term : contributions[e]) {
      if (term.feature == kb::kKindTerm) out[entries[e].first][entries[e].second].back() = term.log_likelihood;
      for (std::size_t f = 0; f < layout.features.size(); ++f) {
        if (knowledge.features[at(layout.features[f])].name == term.feature) out[entries[e].first][entries[e].second][f] = term.log_likelihood;
      }
    }
  }
  return out;
}

/// One example a plane of known class, in the world `classes` (of all planes).
void add_examples(const kb::Knowledge& knowledge, const Layout& layout, const LabellingProblem& compiled, const Terms& terms,
                  const std::vector<int>& classes, const std::vector<int>& truth, std::vector<Example>& out) {
  std::vector<int> assignment(compiled.plane_of_variable.size());
  for (std::size_t p = 0; p < classes.size(); ++p) {
    const int variable = compiled.variable_of_plane[p];
    assignment[at(variable)] = compiled.label_of_class[at(variable)][at(classes[p])];
  }
  settle(compiled, assignment);
  std::vector<std::vector<int>> of_row(knowledge.constraints.size());
  for (std::size_t i = 0; i < compiled.origins.size(); ++i) {
    if (!compiled.origins[i].is_definition()) of_row[at(compiled.origins[i].row)].push_back(static_cast<int>(i));
  }
  std::vector<std::vector<std::vector<double>>> costs;  // [row of the layout][variable][label]
  for (const int row : layout.rows) costs.push_back(flip_costs(compiled.problem, assignment, of_row[at(row)]));
  for (std::size_t p = 0; p < classes.size(); ++p) {
    if (truth[p] < 0) continue;
    const std::size_t variable = at(compiled.variable_of_plane[p]);
    Example example;
    example.truth = truth[p];
    for (std::size_t c = 0; c < layout.classes; ++c) {
      std::vector<double> x(terms[p][c].begin(), terms[p][c].end() - 1);
      x.resize(layout.size(), 0.0);
      x[layout.of_kinds()] = terms[p][c].back();
      x[layout.first_class() + c] = 1;
      const std::size_t label = at(compiled.label_of_class[variable][c]);
      for (std::size_t r = 0; r < layout.rows.size(); ++r) {
        x[layout.first_row() + r] = -costs[r][variable][label] / *knowledge.constraints[at(layout.rows[r])].weight;
      }
      example.of_class.push_back(std::move(x));
    }
    out.push_back(std::move(example));
  }
}

std::vector<double> parameters_of(const kb::Knowledge& knowledge, const Layout& layout) {
  std::vector<double> out;
  for (const int f : layout.features) out.push_back(knowledge.features[at(f)].weight);
  for (const kb::ObjectClass& c : knowledge.classes) out.push_back(std::log(c.prior));
  for (const int row : layout.rows) out.push_back(*knowledge.constraints[at(row)].weight);
  out.push_back(1);
  return out;
}

LearnedWeights weights_of(const kb::Knowledge& knowledge, const Layout& layout, const std::vector<double>& parameters) {
  LearnedWeights out;
  out.features.assign(knowledge.features.size(), 0.0);
  out.constraints.assign(knowledge.constraints.size(), 0.0);
  for (std::size_t f = 0; f < layout.features.size(); ++f) out.features[at(layout.features[f])] = parameters[f];
  double sum = 0;
  for (std::size_t c = 0; c < layout.classes; ++c) sum += std::exp(parameters[layout.first_class() + c]);
  for (std::size_t c = 0; c < layout.classes; ++c) out.priors.push_back(std::exp(parameters[layout.first_class() + c]) / sum);
  for (std::size_t r = 0; r < layout.rows.size(); ++r) out.constraints[at(layout.rows[r])] = parameters[layout.first_row() + r];
  return out;
}

std::vector<int> classes_of(const LabellingProblem& compiled, const std::vector<int>& assignment) {
  std::vector<int> out(compiled.plane_of_variable.size());
  for (std::size_t v = 0; v < out.size(); ++v) out[at(compiled.plane_of_variable[v])] = compiled.class_of_label[v][at(assignment[v])];
  return out;
}

}  // namespace

LearnedWeights learn_weights(const kb::Knowledge& knowledge, std::span<const LabelledScene> scenes, const LearnWeightsOptions& options) {
  const Layout layout(knowledge);
  std::vector<std::vector<int>> truths;
  for (const LabelledScene& scene : scenes) truths.push_back(true_classes(knowledge, scene));
  const std::vector<double> present = parameters_of(knowledge, layout);
  LogLinearFit fit{.start = present, .strength = options.strength, .low = std::vector<double>(present.size(), 0.0),
                   .high = std::vector<double>(present.size(), options.most), .free = layout.first_class(), .frees = layout.classes};
  std::fill(fit.high.begin(), fit.high.begin() + static_cast<std::ptrdiff_t>(layout.first_class()), options.most_of_feature);
  std::fill(fit.low.begin() + static_cast<std::ptrdiff_t>(layout.first_row()), fit.low.end(), kLeastRow);
  fit.low.back() = fit.high.back() = 1;
  std::vector<double> parameters = present, log_likelihood;
  for (std::size_t f = 0; f < layout.first_class(); ++f) parameters[f] = std::min(parameters[f], options.most_of_feature);
  for (int round = 0; round < options.rounds; ++round) {
    const kb::Knowledge now = with_weights(knowledge, weights_of(knowledge, layout, parameters));
    std::vector<Example> examples;
    for (std::size_t s = 0; s < scenes.size(); ++s) {
      const LabelledScene& scene = scenes[s];
      const auto evidence = kb::preclassify(now, scene.scene.features);
      const Terms terms = feature_terms(now, layout, scene.scene.features);
      const LabellingProblem compiled = compile(now, scene.scene, evidence, scene.facts, {});
      const engine::Solution best = engine::Solver(compiled.problem, options.solver).solve();
      if (best.assignment.empty()) continue;
      const std::vector<int> predicted = classes_of(compiled, best.assignment);
      std::vector<int> truth = predicted;
      for (std::size_t p = 0; p < truth.size(); ++p) {
        if (truths[s][p] >= 0) truth[p] = truths[s][p];
      }
      add_examples(now, layout, compiled, terms, truth, truths[s], examples);
      add_examples(now, layout, compiled, terms, predicted, truths[s], examples);
    }
    log_likelihood.push_back(fit_log_linear(examples, fit, parameters));
  }
  LearnedWeights out = weights_of(knowledge, layout, parameters);
  out.log_likelihood = std::move(log_likelihood);
  return out;
}

kb::Knowledge with_weights(kb::Knowledge knowledge, const LearnedWeights& weights) {
  for (std::size_t f = 0; f < knowledge.features.size(); ++f) knowledge.features[f].weight = weights.features[f];
  for (std::size_t c = 0; c < knowledge.classes.size(); ++c) knowledge.classes[c].prior = weights.priors[c];
  for (std::size_t r = 0; r < knowledge.constraints.size(); ++r) {
    kb::ClassConstraint& row = knowledge.constraints[r];
    if (row.id >= 0 && is_learned(row)) row.weight = weights.constraints[r];
  }
  return knowledge;
}

std::string to_sql(const kb::Knowledge& knowledge, const LearnedWeights& weights) {
  std::string sql;
  const auto update = [&](const char* table, const char* column, const std::string& name, double value, double present) {
    const std::string now = fmt::format("{:.3g}", value);
    if (now != fmt::format("{:.3g}", present)) sql += fmt::format("UPDATE {} SET {} = {} WHERE name = '{}';\n", table, column, now, name);
  };
  for (std::size_t f = 0; f < knowledge.features.size(); ++f) {
    update("feature", "weight", knowledge.features[f].name, weights.features[f], knowledge.features[f].weight);
  }
  for (std::size_t c = 0; c < knowledge.classes.size(); ++c) {
    update("object_class", "prior", knowledge.classes[c].name, weights.priors[c], knowledge.classes[c].prior);
  }
  for (std::size_t r = 0; r < knowledge.constraints.size(); ++r) {
    const kb::ClassConstraint& row = knowledge.constraints[r];
    if (row.id >= 0 && is_learned(row)) update("class_constraint", "weight", row.name, weights.constraints[r], *row.weight);
  }
  return sql;
}

}  // namespace scenelore::rules
