// Labels, margins, alternatives and reasons against an enumeration of all worlds.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "scenelore/engine/checker.hpp"
#include "scenelore/rules/error.hpp"
#include "temporary_folder.hpp"
#include "tiny.hpp"

namespace scenelore::rules {
namespace {

using kb::Quantifier;

struct Small {
  kb::Knowledge knowledge = tiny::knowledge({"table", "flat_screen", "whiteboard"});
  Scene scene = tiny::scene(3);  // ids 10, 11, 12
  std::vector<std::vector<double>> evidence{{.1, .7, .1, .1}, {.1, .1, .35, .45}, {.5, .1, .2, .2}};
  Facts facts;

  Small() {
    knowledge.constraints.push_back(tiny::row(1, "flat_screen", Quantifier::some, "above", "table", 2.5));
    knowledge.constraints.back().message = "a flat screen stands over some table";
    knowledge.constraints.push_back(tiny::row(2, "whiteboard", Quantifier::no, "above", "table", 1.5));
    knowledge.constraints.back().message = "no whiteboard over a table";
    facts.facts = {{"above", 11, 10, 0.9}, {"above", 12, 10, 0.4}};
  }
};

/// All labellings that hold, by cost: assignment of classes by plane.
std::vector<std::pair<double, std::vector<int>>> all_worlds(const LabellingProblem& compiled) {
  std::vector<std::pair<double, std::vector<int>>> out;
  const auto& variables = compiled.problem.variables();
  std::vector<int> assignment(variables.size(), 0);
  while (true) {
    const engine::Check check = engine::check(compiled.problem, assignment);
    if (check.valid) {
      std::vector<int> classes(assignment.size());
      for (std::size_t v = 0; v < assignment.size(); ++v) {
        classes[static_cast<std::size_t>(compiled.plane_of_variable[v])] =
            compiled.class_of_label[v][static_cast<std::size_t>(assignment[v])];
      }
      out.emplace_back(check.cost, classes);
    }
    std::size_t v = 0;
    while (v < assignment.size() && ++assignment[v] == static_cast<int>(variables[v].labels.size())) assignment[v++] = 0;
    if (v == assignment.size()) break;
  }
  std::sort(out.begin(), out.end());
  return out;
}

const kb::Reason* find(const kb::Inference& inference, kb::PlaneId plane, const std::string& kind) {
  for (const kb::Reason& reason : inference.reasons) {
    if (reason.plane == plane && reason.kind == kind) return &reason;
  }
  return nullptr;
}

TEST(Label, GivesTheBestWorldWithExactMarginsAndProbabilities) {
  const Small s;
  const kb::Inference inference = label(s.knowledge, s.scene, s.evidence, s.facts, {});
  const auto worlds = all_worlds(compile(s.knowledge, s.scene, s.evidence, s.facts, {}));
  EXPECT_EQ(inference.run.outcome, "proved");
  EXPECT_NEAR(inference.run.cost, worlds[0].first, 1e-9);
  double all = 0;
  for (const auto& [cost, classes] : worlds) all += std::exp(-cost);
  ASSERT_EQ(inference.labels.size(), 3U);
  for (std::size_t plane = 0; plane < 3; ++plane) {
    const int best = worlds[0].second[plane];
    double mass = 0;
    for (const auto& [cost, classes] : worlds) mass += classes[plane] == best ? std::exp(-cost) : 0;
    const auto other = std::find_if(worlds.begin(), worlds.end(), [&](const auto& w) { return w.second[plane] != best; });
    const kb::Label& label = inference.labels[plane];
    EXPECT_EQ(label.plane, s.scene.ids[plane]);
    EXPECT_EQ(label.object_class, s.knowledge.classes[static_cast<std::size_t>(best)].name);
    EXPECT_NEAR(label.margin, other->first - worlds[0].first, 1e-9);
    EXPECT_EQ(label.runner_up, s.knowledge.classes[static_cast<std::size_t>(other->second[plane])].name);
    EXPECT_NEAR(label.probability, mass / all, 1e-6);
  }
  EXPECT_EQ(inference.classes.size(), 4U);
  EXPECT_EQ(inference.facts.size(), 2U);
}

TEST(Label, ListsAlternativesWhereTheyDiffer) {
  const Small s;
  const kb::Inference inference = label(s.knowledge, s.scene, s.evidence, s.facts, {}, {.alternatives = 2});
  const auto worlds = all_worlds(compile(s.knowledge, s.scene, s.evidence, s.facts, {}));
  std::vector<std::tuple<int, kb::PlaneId, std::string>> expected, found;
  for (std::size_t rank = 1; rank <= 2; ++rank) {
    for (std::size_t plane = 0; plane < 3; ++plane) {
      if (worlds[rank].second[plane] == worlds[0].second[plane]) continue;
      expected.emplace_back(static_cast<int>(rank) + 1, s.scene.ids[plane],
                            s.knowledge.classes[static_cast<std::size_t>(worlds[rank].second[plane])].name);
    }
  }
  for (const kb::Alternative& a : inference.alternatives) found.emplace_back(a.rank, a.plane, a.object_class);
  EXPECT_EQ(found, expected);
}

TEST(Label, TellsWhatSupportsALabelAndWhatWouldBeOtherwise) {
  const Small s;
  const kb::Inference inference = label(s.knowledge, s.scene, s.evidence, s.facts, {});
  ASSERT_EQ(inference.labels[1].object_class, "flat_screen");
  const kb::Reason* evidence = find(inference, 11, "evidence");
  ASSERT_NE(evidence, nullptr);
  EXPECT_NEAR(evidence->amount, std::log(.35 / .45), 1e-12);
  EXPECT_NE(evidence->sentence.find("from features alone 0.35, which prefer whiteboard with 0.45"), std::string::npos)
      << evidence->sentence;
  const kb::Reason* support = find(inference, 11, "support");
  ASSERT_NE(support, nullptr);
  EXPECT_EQ(support->other_plane, 10);
  EXPECT_NEAR(support->amount, 2.5 * 0.9, 1e-12);
  EXPECT_EQ(support->sentence,
            "thanks to table 10 (above, 0.9): 'a flat screen stands over some table'; without it 2.25 more");
  const kb::Reason* carried = find(inference, 10, "support");
  ASSERT_NE(carried, nullptr);
  EXPECT_EQ(carried->sentence, "flat_screen 11 relies on it (above, 0.9): 'a flat screen stands over some table'");
  const kb::Reason* violation = find(inference, 11, "violation");
  ASSERT_NE(violation, nullptr) << "0.25 for the last tenth of the degree";
  EXPECT_EQ(violation->sentence,
            "pays 0.25 for 'a flat screen stands over some table': the best is table 10 (above, 0.9)");
  const kb::Reason* runner_up = find(inference, 11, "runner_up");
  ASSERT_NE(runner_up, nullptr);
  EXPECT_NE(runner_up->sentence.find("next best: "), std::string::npos);
  EXPECT_NEAR(runner_up->amount, inference.labels[1].margin, 1e-12);
}

TEST(Label, KeepsWhatAPersonKnows) {
  const Small s;
  const kb::Inference inference = label(s.knowledge, s.scene, s.evidence, s.facts, {{11, "whiteboard"}});
  EXPECT_EQ(inference.labels[1].object_class, "whiteboard");
  EXPECT_TRUE(std::isinf(inference.labels[1].margin));
  EXPECT_FALSE(inference.labels[1].runner_up.has_value());
  ASSERT_NE(find(inference, 11, "truth"), nullptr);
  EXPECT_EQ(find(inference, 11, "truth")->sentence, "plane 11 is whiteboard because a truth row says so");
}

TEST(Label, SaysSoWhenNoFloorIsLikelyEnough) {
  kb::Knowledge knowledge = tiny::knowledge({"floor"});
  knowledge.settings["floor"] = "threshold";
  const kb::Inference inference = label(knowledge, tiny::scene(2), {{.7, .3}, {.9, .1}}, {}, {});
  ASSERT_NE(find(inference, 10, "floor"), nullptr);
  EXPECT_EQ(find(inference, 10, "floor")->sentence,
            "no floor to start from: plane 10 comes closest (0.3, less than 0.4 by its features)");
}

TEST(Label, AnswersAnEmptyScene) {
  const kb::Inference inference = label(tiny::knowledge({"p"}), Scene{}, {}, {}, {});
  EXPECT_EQ(inference.run.outcome, "proved");
  EXPECT_TRUE(inference.labels.empty());
}

TEST(WhyNot, FindsTheCheapestWorldAndWhatItBreaks) {
  const Small s;
  const WhyNot answer = why_not(s.knowledge, s.scene, s.evidence, s.facts, {}, 11, "whiteboard");
  ASSERT_TRUE(answer.possible);
  const auto worlds = all_worlds(compile(s.knowledge, s.scene, s.evidence, s.facts, {}));
  const auto there = std::find_if(worlds.begin(), worlds.end(), [](const auto& w) { return w.second[1] == 3; });
  EXPECT_NEAR(answer.extra_cost, there->first - worlds[0].first, 1e-9);
  const auto& sentences = answer.sentences;
  EXPECT_TRUE(std::any_of(sentences.begin(), sentences.end(), [](const std::string& t) {
    return t == "it would break 'no whiteboard over a table': 1.35 more";
  })) << sentences[0];
  EXPECT_EQ(sentences.back().rfind("plane 11 is flat_screen; the best labelling with it as whiteboard costs ", 0), 0U);
}

TEST(WhyNot, NamesTheRowsThatForbidAClass) {
  Small s;
  s.knowledge.constraints[0].weight.reset();
  const WhyNot answer = why_not(s.knowledge, s.scene, s.evidence, s.facts, {}, 10, "flat_screen");
  EXPECT_FALSE(answer.possible);
  ASSERT_EQ(answer.sentences.size(), 1U);
  EXPECT_EQ(answer.sentences[0], "plane 10 cannot be flat_screen in any valid labelling; what forbids it: "
                                 "'a flat screen stands over some table'");
  EXPECT_TRUE(why_not(s.knowledge, s.scene, s.evidence, s.facts, {}, 10, "table").possible);
  EXPECT_THROW((void)why_not(s.knowledge, s.scene, s.evidence, s.facts, {}, 99, "table"), Error);
  EXPECT_THROW((void)why_not(s.knowledge, s.scene, s.evidence, s.facts, {}, 10, "tabel"), Error);
}

TEST(Check, FindsRowsThatCannotWork) {
  kb::Knowledge knowledge = tiny::knowledge({"table", "chair"});
  knowledge.constraints = {
      tiny::row(1, "tabel", Quantifier::some, "abov", "table", 1.0),
      tiny::row(2, "table", Quantifier::some, "near", "chair", std::nullopt),
      tiny::row(3, "table", Quantifier::no, "near", "chair", std::nullopt),
      tiny::row(4, "unknown", Quantifier::no, "near", "chair", 1.0),
      tiny::row(5, "chair", Quantifier::every, std::nullopt, "table", 1.0),
      tiny::row(6, "chair", Quantifier::at_most, "near", "table", 1.0),
  };
  const std::vector<Finding> findings = check(knowledge, RuleSet::load());
  std::vector<std::string> texts;
  for (const Finding& finding : findings) texts.push_back((finding.error ? "E " : "W ") + finding.where + ": " + finding.text);
  EXPECT_EQ(texts, (std::vector<std::string>{
                       "E class_constraint row 1 ('row_1'): there is no class 'tabel'; did you mean 'table'?",
                       "E class_constraint row 1 ('row_1'): there is no relation 'abov'; did you mean 'above'?",
                       "E class_constraint row 6 ('row_6'): at_most and at_least need a count of 0 or more",
                       "W class_constraint row 4 ('row_4'): never matters: 'unknown' is the fallback class, which has no constraints; "
                       "name another class",
                       "W class_constraint row 5 ('row_5'): never matters: 'every' needs a relation; name one",
                       "W class_constraint row 2 ('row_2'): can never hold: class_constraint row 3 ('row_3') forbids what it "
                       "asks for, so nothing is 'table'",
                   }));
}

TEST(Check, TellsRowsThatChangeNothingAndTheWayOut) {
  kb::Knowledge knowledge = tiny::knowledge({"table", "chair", "lamp"});
  knowledge.features = {{.name = "height", .unit = "m", .low = 0, .high = 4, .weight = 0.4},
                        {.name = "length", .unit = "m", .low = 0, .high = 9, .weight = 0},
                        {.name = "spread_length", .unit = "m", .low = 0, .high = 9, .weight = 0.3},
                        {.name = "gone", .unit = "1", .low = 0, .high = 1, .weight = 1}};
  knowledge.class_features = {{"table", "height", 0.7, 0.1}, {"table", "length", 1.5, 0.1}, {"chair", "length", 0.5, 0.1}, {"chair", "gone", 1, 1}};
  knowledge.class_densities = {{"table", "length", 0, 9, 1}};  // learned: that it counts for nothing was found out
  knowledge.settings["hold_degre"] = "0.4";
  knowledge.constraints = {tiny::row(1, "table", Quantifier::some, "near", "chair", 0.0)};
  const auto told = [&] {
    std::vector<std::string> texts;
    for (const Finding& finding : idle_rows(knowledge, {"height", "length", "spread_length"})) texts.push_back(finding.where + ": " + finding.text);
    return texts;
  };
  EXPECT_EQ(told(), (std::vector<std::string>{
                        "class_feature row ('chair', 'length'): has no effect: the weight of feature 'length' is 0; give it one (UPDATE feature "
                        "SET weight = 0.3 WHERE name = 'length'), write the row for 'spread_length', which counts, or leave the row out",
                        "class_feature row ('chair', 'gone'): has no effect: no plane has a value of 'gone', since no rule file defines it any "
                        "more: put the file of the feature back, or leave the row out",
                        "object_class row 3 ('lamp'): only its prior speaks for it: no class_feature row says what it looks like; insert some, or "
                        "run `scenelore learn` with examples",
                        "class_constraint row 1 ('row_1'): never matters: its weight is 0; give it one in nats, NULL for a hard row, or set "
                        "enabled = 0",
                        "setting 'hold_degre': has no effect: there is no such setting; did you mean 'hold_degree'?"}));
  knowledge.features[1].weight = 0.2;
  knowledge.features[3].weight = 0;
  knowledge.settings.clear();
  knowledge.constraints[0].weight.reset();
  EXPECT_EQ(told().size(), 2U) << "the feature that is gone, and the lamp";
  knowledge.features.push_back({.name = "edge_free", .unit = "1", .low = 0, .high = 1, .weight = 1});
  knowledge.class_features.push_back({"table", "edge_free", 0.5, 0.1});
  EXPECT_EQ(told().size(), 2U) << "what is not known of a scan without the sensor's position is nobody's mistake";
}

TEST(Check, AsksRelationsThatReadTheFeaturesOfLuaFiles) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "slender.lua",
                   "return feature { api = 1, name = 'slender', summary = 's', unit = '1', scale = 'log', low = 1, high = 100, value = function(a) return a.length / a.width end }");
  test::write_file(folder / "slenderer.lua", "return relation { api = 1, name = 'slenderer', summary = 's', "
                                             "degree = function(a, b) return a.slender > b.slender end }");
  kb::Knowledge knowledge = tiny::knowledge({"p"});
  knowledge.constraints = {tiny::row(1, "p", Quantifier::some, "slenderer", "p", 1.0)};
  for (const Finding& finding : check(knowledge, RuleSet::load({folder.path()}))) ADD_FAILURE() << finding.where << ": " << finding.text;
}

TEST(Check, FindsARelationThatIsNotSymmetricAfterAll) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "taller.lua",
                   "return relation { api = 1, name = 'taller', summary = 's', symmetric = true, degree = function(a, b) return a.z > b.z end }");
  const std::vector<Finding> findings = check(tiny::knowledge({"p"}), RuleSet::load({folder.path()}));
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_TRUE(findings[0].error);
  EXPECT_NE(findings[0].text.find("is declared symmetric, but is"), std::string::npos);
  EXPECT_EQ(findings[1].text, "no enabled row of class_constraint uses relation 'taller'");
}

}  // namespace
}  // namespace scenelore::rules
