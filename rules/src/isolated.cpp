#include "scenelore/rules/isolated.hpp"

#include "byte_stream.hpp"
#include "confined_process.hpp"
#include "scenelore/rules/error.hpp"
#include "scenelore/rules/labelling.hpp"

namespace scenelore::rules {

namespace {

void write_answers(Writer& out, const RuleAnswers& answers) {
  out.number(answers.features.size());
  for (const kb::Feature& f : answers.features) {
    out.text(f.name);
    out.text(f.unit);
    out.number(f.scale);
    for (const double value : {f.low, f.high, f.weight}) out.number(value);
    out.text(f.description);
  }
  out.number(answers.table.names.size());
  for (const std::string& name : answers.table.names) out.text(name);
  out.number(answers.table.values.size());
  for (const std::vector<double>& row : answers.table.values) {
    for (const double value : row) out.number(value);
  }
  out.number(answers.facts.facts.size());
  for (const kb::RelationFact& fact : answers.facts.facts) {
    out.text(fact.relation);
    out.number(fact.a);
    out.number(fact.b);
    out.number(fact.degree);
  }
  out.number(answers.facts.asked.size());
  for (const auto& [relation, asked] : answers.facts.asked) {
    out.text(relation);
    out.number(asked.asked);
    out.number(asked.held);
    out.number(asked.within);
    out.number(asked.within_plan);
    out.text(asked.inputs_sha256);
    out.number(asked.stored);
    out.text(asked.features);
  }
  out.number(answers.facts.constraints.size());
  for (const TupleConstraint& c : answers.facts.constraints) {
    out.text(c.name);
    out.text(c.summary);
    out.number(c.classes.size());
    for (const std::string& name : c.classes) out.text(name);
    out.number(c.quantifier);
    out.number(c.weight.value_or(-1));
    out.number(c.within);
    out.number(c.tuples.size());
    for (const TupleConstraint::Tuple& tuple : c.tuples) {
      for (const kb::PlaneId plane : tuple.planes) out.number(plane);
      out.number(tuple.degree);
    }
  }
  out.text(answers.hash);
}

RuleAnswers read_answers(Reader& in, std::size_t planes) {
  RuleAnswers out;
  for (std::size_t i = 0, n = in.count(); i < n; ++i) {
    kb::Feature f;
    f.name = in.text();
    f.unit = in.text();
    f.scale = in.number<kb::Scale>();
    if (f.scale != kb::Scale::log && f.scale != kb::Scale::circular) f.scale = kb::Scale::linear;
    f.low = in.number<double>();
    f.high = in.number<double>();
    f.weight = in.number<double>();
    f.description = in.text();
    out.features.push_back(std::move(f));
  }
  for (std::size_t i = 0, n = in.count(); i < n; ++i) out.table.names.push_back(in.text());
  if (in.count() != planes) throw Error("the isolated rules sent features of other planes");
  for (std::size_t i = 0; i < planes; ++i) {
    std::vector<double>& row = out.table.values.emplace_back();
    for (std::size_t f = 0; f < out.table.names.size(); ++f) row.push_back(in.number<double>());
  }
  for (std::size_t i = 0, n = in.count(); i < n; ++i) {
    kb::RelationFact fact{.relation = in.text()};
    fact.a = in.number<kb::PlaneId>();
    fact.b = in.number<kb::PlaneId>();
    fact.degree = in.number<double>();
    out.facts.facts.push_back(std::move(fact));
  }
  for (std::size_t i = 0, n = in.count(); i < n; ++i) {
    const std::string relation = in.text();
    kb::RelationAsked& asked = out.facts.asked[relation];
    asked.asked = in.number<std::int64_t>();
    asked.held = in.number<std::int64_t>();
    asked.within = in.number<double>();
    asked.within_plan = in.number<double>();
    asked.inputs_sha256 = in.text();
    asked.stored = in.number<bool>();
    asked.features = in.text();
    out.facts.reach[relation] = {asked.within, asked.within_plan};
  }
  for (std::size_t i = 0, n = in.count(); i < n; ++i) {
    TupleConstraint c{.name = in.text(), .summary = {}, .file = {}, .classes = {}, .weight = {}, .tuples = {}};
    c.summary = in.text();
    for (std::size_t k = 0, m = in.count(); k < m; ++k) c.classes.push_back(in.text());
    c.quantifier = in.number<kb::Quantifier>();
    const auto weight = in.number<double>();
    if (weight > 0) c.weight = weight;
    c.within = in.number<double>();
    for (std::size_t k = 0, m = in.count(); k < m; ++k) {
      TupleConstraint::Tuple& tuple = c.tuples.emplace_back();
      for (std::size_t p = 0; p < c.classes.size(); ++p) tuple.planes.push_back(in.number<kb::PlaneId>());
      tuple.degree = in.number<double>();
    }
    out.facts.constraints.push_back(std::move(c));
  }
  out.hash = in.text();
  return out;
}

}  // namespace

RuleAnswers answer(RuleSet& rules, const kb::Knowledge& knowledge, Scene& scene,
                   const KnownAnswers& known, int threads) {
  RuleAnswers out;
  out.features = rules.new_features(knowledge);
  KeptAnswers kept{known.rules};
  rules.compute_features(scene, scene.features, &kept);
  out.table = scene.features;
  out.facts = rules.relate(scene, used_relations(knowledge, rules), known, threads);
  out.facts.constraints = rules.constraints(scene, knowledge, &out.facts.geometry, &kept);
  out.facts.answers = std::move(kept.now);
  out.hash = rules.hash();
  return out;
}

RuleAnswers answer_isolated(const std::vector<std::filesystem::path>& directories, const Budget& budget,
                            const kb::Knowledge& knowledge, const Scene& scene,
                            const KnownAnswers& known, const Isolation& limits) {
  const std::string bytes = in_confined_process(limits, [&](Writer& out) {
    Scene own = scene;
    RuleSet rules = RuleSet::load(directories, budget, knowledge.settings);
    write_answers(out, answer(rules, knowledge, own, known, 1));
  });
  Reader in(bytes);
  return read_answers(in, scene.planes.size());
}

std::vector<RuleTestFile> run_rule_tests_isolated(const std::vector<std::filesystem::path>& directories, const Budget& budget,
                                                  const Isolation& limits) {
  const std::string bytes = in_confined_process(limits, [&](Writer& out) {
    const std::vector<RuleTestFile> files = run_rule_tests(directories, budget);
    out.number(files.size());
    for (const RuleTestFile& file : files) {
      for (const std::string* text : {&file.file, &file.rule, &file.failure}) out.text(*text);
      out.number(file.cases.size());
      for (const RuleTestCase& test : file.cases) {
        out.text(test.name);
        out.text(test.failure);
      }
    }
  });
  Reader in(bytes);
  std::vector<RuleTestFile> out;
  for (std::size_t i = 0, n = in.count(); i < n; ++i) {
    RuleTestFile& file = out.emplace_back();
    for (std::string* text : {&file.file, &file.rule, &file.failure}) *text = in.text();
    for (std::size_t k = 0, m = in.count(); k < m; ++k) {
      RuleTestCase& test = file.cases.emplace_back();
      test.name = in.text();
      test.failure = in.text();
    }
  }
  return out;
}

}  // namespace scenelore::rules
