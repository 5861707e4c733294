// The compiled problem against a naive reading of the rows, over every labelling of small scenes.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "scenelore/engine/checker.hpp"
#include "scenelore/rules/error.hpp"
#include "tiny.hpp"

namespace scenelore::rules {
namespace {

using kb::Quantifier;

/// What the table in docs/rules.md says, written as loops over planes and nothing else.
class NaiveReader {
 public:
  NaiveReader(const kb::Knowledge& knowledge, const Scene& scene, const Facts& facts) : knowledge_(knowledge), scene_(scene) {
    for (const kb::RelationFact& fact : facts.facts) degree_[{fact.relation, fact.a, fact.b}] = fact.degree;
  }

  double cost(const std::vector<int>& classes) const {
    double sum = 0;
    for (const kb::ClassConstraint& row : knowledge_.constraints) {
      if (row.enabled && row.object_class != "unknown") sum += cost(row, classes);
    }
    return sum;
  }

 private:
  double cost(const kb::ClassConstraint& row, const std::vector<int>& classes) const {
    const bool counts = row.quantifier == Quantifier::at_most || row.quantifier == Quantifier::at_least;
    double sum = 0;
    if (counts && !row.relation) {
      int found = 0;
      for (int c : classes) found += knowledge_.classes[static_cast<std::size_t>(c)].name == row.object_class;
      return count_cost(row, found, row.weight.value_or(row.quantifier == Quantifier::at_most ? INFINITY : kBrokenRow));
    }
    for (std::size_t a = 0; a < classes.size(); ++a) {
      if (knowledge_.classes[static_cast<std::size_t>(classes[a])].name == row.object_class) sum += cost_at(row, classes, a);
    }
    return sum;
  }

  static double count_cost(const kb::ClassConstraint& row, int found, double weight) {
    const int off = row.quantifier == Quantifier::at_most ? found - *row.count : *row.count - found;
    return off > 0 ? off * weight : 0;
  }

  double cost_at(const kb::ClassConstraint& row, const std::vector<int>& classes, std::size_t a) const {
    double best = 0, missing = 0, present = 0;
    int found = 0;
    bool every = true, none = true;
    for (std::size_t b = 0; b < classes.size(); ++b) {
      const std::string& name = knowledge_.classes[static_cast<std::size_t>(classes[b])].name;
      if (b == a || (row.other_class ? name != *row.other_class : name == "unknown")) continue;
      double d = 1;
      if (row.relation) {
        const auto fact = degree_.find({*row.relation, scene_.ids[a], scene_.ids[b]});
        d = fact == degree_.end() ? 0 : fact->second;
      }
      best = std::max(best, d);
      missing += 1 - d;
      present += d;
      found += d >= 0.5;
      every = every && d >= 0.5;
      none = none && d < 0.5;
    }
    if (row.quantifier == Quantifier::every && !row.relation) return 0;
    if (row.quantifier == Quantifier::at_most || row.quantifier == Quantifier::at_least) {
      return count_cost(row, found, row.weight.value_or(INFINITY));
    }
    if (row.weight) {
      return *row.weight * (row.quantifier == Quantifier::some ? 1 - best : row.quantifier == Quantifier::every ? missing : present);
    }
    const bool good = row.quantifier == Quantifier::some ? best >= 0.5 : row.quantifier == Quantifier::every ? every : none;
    return good ? 0 : INFINITY;
  }

  const kb::Knowledge& knowledge_;
  const Scene& scene_;
  std::map<std::tuple<std::string, kb::PlaneId, kb::PlaneId>, double> degree_;
};

/// Compares cost and validity of every labelling.
void expect_same_everywhere(const kb::Knowledge& knowledge, const Scene& scene,
                            const std::vector<std::vector<double>>& evidence, const Facts& facts) {
  const LabellingProblem compiled = compile(knowledge, scene, evidence, facts, {});
  const NaiveReader naive(knowledge, scene, facts);
  const int planes = static_cast<int>(scene.planes.size()), classes = static_cast<int>(knowledge.classes.size());
  ASSERT_EQ(compiled.origins.size(), compiled.problem.constraints().size());
  std::vector<int> labelling(scene.planes.size(), 0);
  for (int number = 0; number < static_cast<int>(std::pow(classes, planes) + 0.5); ++number) {
    double cost = 0;
    std::vector<int> assignment(scene.planes.size());
    for (int i = 0, rest = number; i < planes; ++i, rest /= classes) {
      const auto plane = static_cast<std::size_t>(i);
      labelling[plane] = rest % classes;
      cost -= std::log(evidence[plane][static_cast<std::size_t>(labelling[plane])]);
      const auto variable = static_cast<std::size_t>(compiled.variable_of_plane[plane]);
      assignment[variable] = compiled.label_of_class[variable][static_cast<std::size_t>(labelling[plane])];
    }
    cost += naive.cost(labelling);
    const engine::Check check = engine::check(compiled.problem, assignment);
    ASSERT_EQ(check.valid, std::isfinite(cost)) << "labelling " << number;
    if (check.valid) {
      ASSERT_NEAR(check.cost, cost, 1e-9) << "labelling " << number;
    }
  }
}

class RowsOfEveryKind : public testing::TestWithParam<Quantifier> {};

TEST_P(RowsOfEveryKind, CostWhatANaiveReadingSays) {
  std::mt19937 random(7);
  const kb::Knowledge base = tiny::knowledge({"p", "q"});
  const Scene scene = tiny::scene(4);
  for (int round = 0; round < 24; ++round) {
    kb::Knowledge knowledge = base;
    Facts facts;
    for (kb::PlaneId a = 10; a < 14; ++a) {
      for (kb::PlaneId b = 10; b < 14; ++b) {
        if (a != b && random() % 2 == 0) facts.facts.push_back({"r", a, b, static_cast<double>(1 + random() % 10) / 10});
      }
    }
    const bool relation = round % 8 != 7, hard = round % 2 == 0;
    const std::optional<std::string> other =
        round % 3 == 0 ? std::nullopt : std::optional<std::string>(round % 3 == 1 ? "p" : "q");
    knowledge.constraints.push_back(tiny::row(
        1, "p", GetParam(), relation ? std::optional<std::string>("r") : std::nullopt, other,
        hard ? std::nullopt : std::optional<double>(1.5), static_cast<int>(random() % 3)));
    SCOPED_TRACE("round " + std::to_string(round));
    expect_same_everywhere(knowledge, scene, tiny::evidence(random, 4, 3), facts);
  }
}

std::string quantifier_name(const testing::TestParamInfo<Quantifier>& tested) {
  switch (tested.param) {
    case Quantifier::some: return "Some";
    case Quantifier::every: return "Every";
    case Quantifier::no: return "No";
    case Quantifier::at_most: return "AtMost";
    case Quantifier::at_least: return "AtLeast";
  }
  return "";
}

INSTANTIATE_TEST_SUITE_P(Compile, RowsOfEveryKind,
                         testing::Values(Quantifier::some, Quantifier::every, Quantifier::no, Quantifier::at_most,
                                         Quantifier::at_least),
                         quantifier_name);

TEST(Compile, AddsUpRowsThatSpeakOfTheSamePlanes) {
  std::mt19937 random(11);
  const Scene scene = tiny::scene(4);
  for (int round = 0; round < 30; ++round) {
    kb::Knowledge knowledge = tiny::knowledge({"p", "q", "s"});
    Facts facts;
    for (const char* relation : {"r", "t"}) {
      for (kb::PlaneId a = 10; a < 14; ++a) {
        for (kb::PlaneId b = 10; b < 14; ++b) {
          if (a != b && random() % 2 == 0) facts.facts.push_back({relation, a, b, static_cast<double>(1 + random() % 10) / 10});
        }
      }
    }
    const char* names[] = {"p", "q", "s", "unknown"};
    for (int id = 1; id <= 5; ++id) {
      const bool hard = random() % 4 == 0;
      const auto other = random() % 4;
      knowledge.constraints.push_back(tiny::row(
          id, names[random() % 4], static_cast<Quantifier>(random() % 5), random() % 2 == 0 ? "r" : "t",
          other == 3 ? std::nullopt : std::optional<std::string>(names[other]),
          hard ? std::nullopt : std::optional<double>(static_cast<double>(random() % 5) / 2), static_cast<int>(random() % 3)));
      knowledge.constraints.back().enabled = random() % 8 != 0;
    }
    SCOPED_TRACE("round " + std::to_string(round));
    expect_same_everywhere(knowledge, scene, tiny::evidence(random, 4, 4), facts);
  }
}

TEST(Compile, OrdersPlanesByHeightAndLabelsByEvidence) {
  const kb::Knowledge knowledge = tiny::knowledge({"p", "q"});
  Scene scene = make_scene(std::vector<MadePlane>{{.center = {0, 0, 2}}, {.center = {0, 0, 1}}, {.center = {0, 0, 3}}});
  const LabellingProblem compiled = compile(knowledge, scene, {{.2, .3, .5}, {.5, .3, .2}, {.3, .4, .3}}, {}, {});
  EXPECT_EQ(compiled.plane_of_variable, (std::vector<int>{1, 0, 2}));
  EXPECT_EQ(compiled.variable_of_plane, (std::vector<int>{1, 0, 2}));
  EXPECT_EQ(compiled.class_of_label[0], (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(compiled.class_of_label[1], (std::vector<int>{2, 1, 0}));
  EXPECT_EQ(compiled.class_of_label[2], (std::vector<int>{1, 0, 2}));
  EXPECT_EQ(compiled.problem.variables()[0].name, "plane 2");
}

TEST(Compile, LetsEveryOnlySpeakOfPlanesWithinReach) {
  kb::Knowledge knowledge = tiny::knowledge({"p"});
  knowledge.constraints.push_back(tiny::row(1, "p", Quantifier::every, "r", "p", std::nullopt));
  const Scene scene = tiny::scene(3);  // half a metre apart
  Facts facts;
  facts.reach["r"] = {.within = 0.6};
  EXPECT_EQ(compile(knowledge, scene, {{.5, .5}, {.5, .5}, {.5, .5}}, facts, {}).problem.constraints().size(), 2U);
  facts.reach.clear();
  EXPECT_EQ(compile(knowledge, scene, {{.5, .5}, {.5, .5}, {.5, .5}}, facts, {}).problem.constraints().size(), 3U);
}

TEST(Compile, TakesTruthAsTheOnlyLabelAndKeepsAValidWorld) {
  kb::Knowledge knowledge = tiny::knowledge({"p", "q"});
  knowledge.constraints.push_back(tiny::row(1, "p", Quantifier::some, "r", "q", std::nullopt));
  knowledge.constraints.push_back(tiny::row(2, "p", Quantifier::at_most, std::nullopt, std::nullopt, std::nullopt, 1));
  const Scene scene = tiny::scene(3);
  const LabellingProblem compiled =
      compile(knowledge, scene, {{.5, 0, .5}, {.5, .5, 0}, {1, 0, 0}}, {}, {{10, "p"}, {11, "p"}});
  EXPECT_EQ(compiled.class_of_label[0], (std::vector<int>{1}));
  EXPECT_EQ(compiled.label_of_class[0], (std::vector<int>{-1, 0, -1}));
  EXPECT_DOUBLE_EQ(compiled.problem.variables()[0].costs[0], kImpossibleEvidence);
  const engine::Check check = engine::check(compiled.problem, {0, 0, 0});
  EXPECT_TRUE(check.valid);
  EXPECT_NEAR(check.cost, kImpossibleEvidence - std::log(.5) + 2 * kBrokenRow, 1e-9);
}

TEST(Compile, StartsFromTheLowestPlaneThatIsFloorEnough) {
  kb::Knowledge knowledge = tiny::knowledge({"floor"});
  knowledge.settings = {{"floor", "threshold"}, {"floor_threshold", "0.4"}};
  const Scene scene = tiny::scene(3);
  const LabellingProblem found = compile(knowledge, scene, {{.7, .3}, {.55, .45}, {.1, .9}}, {}, {});
  ASSERT_TRUE(found.floor);
  EXPECT_TRUE(found.floor->found);
  EXPECT_EQ(found.floor->plane, 1);
  EXPECT_EQ(found.class_of_label[1].size(), 1U);
  const LabellingProblem none = compile(knowledge, scene, {{.7, .3}, {.65, .35}, {.9, .1}}, {}, {});
  EXPECT_FALSE(none.floor->found);
  EXPECT_EQ(none.floor->plane, 1);
  EXPECT_EQ(none.class_of_label[1].size(), 2U);
}

std::string error_of(const kb::Knowledge& knowledge, const std::vector<std::pair<kb::PlaneId, std::string>>& truth = {}) {
  try {
    (void)compile(knowledge, tiny::scene(1), {std::vector<double>(knowledge.classes.size(), 0.5)}, {}, truth);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Compile, SaysWhichRowNamesNoClass) {
  kb::Knowledge knowledge = tiny::knowledge({"table"});
  knowledge.constraints.push_back(tiny::row(4, "tabel", Quantifier::some, "r", "table", 1.0));
  EXPECT_EQ(error_of(knowledge), "constraint 'row_4' (row 4): there is no class 'tabel'; did you mean 'table'?");
  knowledge.constraints = {tiny::row(5, "table", Quantifier::at_most, "r", "table", 1.0)};
  EXPECT_EQ(error_of(knowledge), "constraint 'row_5' (row 5): at_most and at_least need a count");
  knowledge.constraints.clear();
  EXPECT_EQ(error_of(knowledge, {{10, "tables"}}), "truth of plane 10: there is no class 'tables'; did you mean 'table'?");
  EXPECT_EQ(error_of(knowledge, {{77, "table"}}), "truth of plane 77: that plane is not in this scan");
  knowledge.settings["hold_degree"] = "much";
  EXPECT_EQ(error_of(knowledge), "setting 'hold_degree' is 'much'; it must be a number from 0 to 1");
}

}  // namespace
}  // namespace scenelore::rules
