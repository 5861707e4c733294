// Loading, validating, relating: what a rule author meets.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <sstream>

#include "pair_geometry.hpp"
#include "tiny.hpp"
#include "scenelore/rules/error.hpp"
#include "scenelore/rules/made_plane.hpp"
#include "scenelore/rules/rule_set.hpp"
#include "temporary_folder.hpp"

namespace scenelore::rules {
namespace {

/// The error of loading a folder with one file, without the folder's name.
std::string load_error(const std::string& text) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "r.lua", text);
  try {
    (void)RuleSet::load({folder.path()});
  } catch (const Error& error) {
    const std::string what = error.what(), prefix = folder.path().string() + "/";
    return what.rfind(prefix, 0) == 0 ? what.substr(prefix.size()) : what;
  }
  return "no error";
}

TEST(RuleSet, SaysWhatIsWrongWithAFile) {
  const std::string good = "api = 1,\n name = 'r',\n summary = 's',\n degree = function() return 1 end,\n";
  EXPECT_EQ(load_error("return relation { " + good + "}"), "no error");
  EXPECT_EQ(load_error("return relation { api = 1 name = 'r' }"), "r.lua:1: '}' expected near 'name'");
  EXPECT_EQ(load_error("local x = 1"), "r.lua: returned nothing; the file must end with  return relation { … }  or  return feature { … }");
  EXPECT_EQ(load_error("return 3"), "r.lua: returned a number; the file must end with  return relation { … }  or  return feature { … }");
  EXPECT_EQ(load_error("return {}"), "r.lua: returned a plain table; the file must end with  return relation { … }  or  return feature { … }");
  EXPECT_EQ(load_error("\nreturn relation {\n api = 2,\n name = 'r', summary = 's', degree = function() end }"),
            "r.lua:3: relation 'r': field 'api' is the version of the rule language, which must be 1, not 2");
  EXPECT_EQ(load_error("\nreturn relation {\n api = 1, name = 'r', summary = 's' }"), "r.lua:2: relation 'r': field 'degree' is missing");
  EXPECT_EQ(load_error("return relation {\n " + good + " sumary = 'x' }"),
            "r.lua:6: relation 'r': unknown field 'sumary'; did you mean 'summary'?");
  EXPECT_EQ(load_error("return relation {\n " + good + " witin = 3 }"),
            "r.lua:6: relation 'r': unknown field 'witin'; did you mean 'within'?");
  EXPECT_EQ(load_error("return relation {\n " + good + " within = -1 }"),
            "r.lua:6: relation 'r': field 'within' must be a distance in metres, 0 or more, not -1");
  EXPECT_EQ(load_error("return relation {\n " + good + " symmetric = 'yes' }"),
            "r.lua:6: relation 'r': field 'symmetric' must be true or false, not 'yes'");
  EXPECT_EQ(load_error("return relation {\n " + good + " slack = 1 / 0 }"),
            "r.lua:6: relation 'r': tolerance 'slack' must be a number, not inf");
  EXPECT_EQ(load_error("return relation { api = 1, name = 'a b', summary = 's', degree = function() end }"),
            "r.lua:1: relation 'a b': field 'name' must be a text of letters, digits and '_', not 'a b'");
  EXPECT_EQ(load_error("return relation {\n api = 1, name = 'r', extends = 'abov' }"),
            "r.lua:2: relation 'r': extends 'abov', which is no built-in relation");
  EXPECT_EQ(load_error("return relation {\n name = 'r', extends = 'above',\n rech = 1 }"),
            "r.lua:3: relation 'r': unknown field 'rech': 'above' has no such tolerance; did you mean 'reach'?");
  EXPECT_EQ(load_error("return feature {\n name = 'f', unit = 'm', low = 2,\n high = 1, value = function() end }"),
            "r.lua:3: feature 'f': field 'high' must be greater than 'low'");
  EXPECT_EQ(load_error("return relation"), "r.lua: returned a function; the file must end with  return relation { … }  or  return feature { … }");
  EXPECT_EQ(load_error("error('stop')"), "r.lua:1: stop");
}

TEST(RuleSet, LetsAUsersRelationReplaceABuiltInOne) {
  const test::TemporaryFolder folder;
  test::write_file(folder / "near.lua", "return relation { name = 'near', extends = 'near', full = 2, none = 3, within = 3, summary = 'mine' }");
  RuleSet rules = RuleSet::load({folder.path()});
  const Scene scene = make_scene(std::vector<MadePlane>{{}, {.center = {2.5, 0, 0}}});
  EXPECT_EQ(rules.degree("near", scene, 0, 1), 1) << "1.5 m apart";
  EXPECT_EQ(RuleSet::load().degree("near", scene, 0, 1), 0);
  for (const RelationInfo& relation : rules.relations()) {
    if (relation.name == "near") {
      EXPECT_EQ(relation.summary, "mine");
    }
  }
  EXPECT_NE(rules.hash(), RuleSet::load().hash());
  EXPECT_EQ(RuleSet::load().hash(), RuleSet::load().hash());
}

TEST(RuleSet, TakesTolerancesFromSettings) {
  const Scene scene = make_scene(std::vector<MadePlane>{{}, {.center = {0, 0, 0.25}}});
  EXPECT_EQ(RuleSet::load().degree("equal_height", scene, 0, 1), 0);
  EXPECT_EQ(RuleSet::load({}, {}, {{"equal_height.full", "0.3"}, {"equal_height.none", "0.4"}, {"floor", "ranked"}})
                .degree("equal_height", scene, 0, 1), 1);
  const auto error = [](const std::map<std::string, std::string>& settings) -> std::string {
    try {
      (void)RuleSet::load({}, {}, settings);
    } catch (const Error& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_EQ(error({{"abve.reach", "1"}}), "setting 'abve.reach': there is no relation 'abve'; did you mean 'above'?");
  EXPECT_EQ(error({{"above.reach", "far"}}), "setting 'above.reach': 'far' is no number");
  EXPECT_NE(error({{"above.rech", "1"}}).find("setting 'above.rech': the relation has no such tolerance; did you mean 'reach'?"),
            std::string::npos);
}

TEST(RuleSet, ComputesFeaturesOfLuaFiles) {
  RuleSet rules = RuleSet::load();
  const Scene scene = make_scene(std::vector<MadePlane>{{.length = 3, .width = 1}, {.center = {0, 0, 1}, .normal = {1, 0, 0}}});
  kb::FeatureTable table{.names = {"x"}, .values = {{0}, {0}}};
  rules.compute_features(scene, table);
  EXPECT_EQ(table.names, (std::vector<std::string>{"x", "aspect", "fill", "rise"}));
  EXPECT_DOUBLE_EQ(table.values[0][1], 3);
  EXPECT_DOUBLE_EQ(table.values[1][3], 1);
}

/// Rooms of 20 planes each on a square grid of rooms.
Scene building(int rooms) {
  std::mt19937 random(4);
  const auto uniform = [&](double low, double high) { return low + (high - low) * static_cast<double>(random() % 1000) / 1000; };
  std::vector<MadePlane> made;
  const int side = static_cast<int>(std::ceil(std::sqrt(rooms)));
  for (int room = 0; room < rooms; ++room) {
    const Eigen::Vector3d o(6.0 * (room % side), 5.0 * (room / side), 0);
    const auto at = [&](double x, double y, double z) { return Eigen::Vector3d(o + Eigen::Vector3d(x, y, z)); };
    made.push_back({.center = at(0, 0, 0), .length = 5.8, .width = 4.8});
    made.push_back({.center = at(0, 0, 2.6), .length = 5.8, .width = 4.8});
    for (const double s : {-1.0, 1.0}) {
      made.push_back({.center = at(0, 2.4 * s, 1.3), .normal = {0, -s, 0}, .length = 5.8, .width = 2.6});
      made.push_back({.center = at(2.9 * s, 0, 1.3), .normal = {-s, 0, 0}, .length = 4.8, .width = 2.6});
    }
    for (int i = 0; i < 4; ++i) {
      const double x = uniform(-2, 2), y = uniform(-1.5, 1.5);
      made.push_back({.center = at(x, y, 0.74), .length = 1.6, .width = 0.8});
      made.push_back({.center = at(x, y + 0.2, 1.05), .normal = {0, -1, 0.05}, .length = 0.5, .width = 0.35});
      made.push_back({.center = at(x, y - 0.1, 0.76), .length = 0.45, .width = 0.15});
    }
    made.push_back({.center = at(1, 1, 0.45), .length = 0.4, .width = 0.4});
    made.push_back({.center = at(1, 1.2, 0.8), .normal = {0, 1, 0}, .length = 0.4, .width = 0.4});
  }
  return make_scene(made);
}

std::vector<std::string> all_relations(const RuleSet& rules) {
  std::vector<std::string> names;
  for (const RelationInfo& relation : rules.relations()) names.push_back(relation.name);
  return names;
}

TEST(Relate, FindsWhatAskingEveryPairWithinReachFinds) {
  RuleSet rules = RuleSet::load();
  const Scene scene = building(1);
  const Facts facts = rules.relate(scene, all_relations(rules));
  const auto found = [&](const std::string& relation, int a, int b) {
    for (const kb::RelationFact& fact : facts.facts) {
      if (fact.relation == relation && fact.a == scene.ids[static_cast<std::size_t>(a)] &&
          fact.b == scene.ids[static_cast<std::size_t>(b)]) {
        return fact.degree;
      }
    }
    return 0.0;
  };
  for (const std::string relation : {"above", "under", "near", "supports", "stands_on", "in_front_of", "touching"}) {
    for (int a = 0; a < 20; ++a) {
      for (int b = 0; b < 20; ++b) {
        if (a == b) continue;
        const auto box = [&](int i) { return PlaneShape(scene.planes[static_cast<std::size_t>(i)]).box; };
        const Reach reach = facts.reach.at(relation);
        const bool near = in_reach(box(a), box(b), reach.within, reach.within_plan);
        EXPECT_EQ(found(relation, a, b), near ? rules.degree(relation, scene, a, b) : 0) << relation << a << " " << b;
      }
    }
  }
}

TEST(RuleSet, NamesEachBuiltInFileAfterWhatItDefines) {
  const RuleSet rules = RuleSet::load();
  for (const RelationInfo& relation : rules.relations()) EXPECT_EQ(relation.file, "rules/relations/" + relation.name + ".lua");
  EXPECT_EQ(rules.relation_names().size(), rules.relations().size());
  std::vector<std::string> names;
  for (const kb::Feature& feature : rules.features()) names.push_back(feature.name);
  EXPECT_EQ(names, (std::vector<std::string>{"aspect", "fill", "rise"}));
}

std::map<std::string, kb::StoredFacts> stored(const Facts& facts) {
  std::map<std::string, kb::StoredFacts> out;
  for (const auto& [relation, asked] : facts.asked) out[relation].asked = asked;
  for (const kb::RelationFact& fact : facts.facts) out[fact.relation].facts.push_back(fact);
  return out;
}

std::vector<std::string> asked(const Facts& facts) {
  std::vector<std::string> names;
  for (const RelationCount& count : facts.counts) names.push_back(count.relation);
  return names;
}

TEST(Relate, AsksAgainOnlyWhatHasChanged) {
  using Names = std::vector<std::string>;
  Scene scene = building(1);
  const Names names{"above", "near", "touching"};
  const Facts first = RuleSet::load().relate(scene, names);
  EXPECT_EQ(asked(first), names);
  const KnownAnswers known{stored(first), first.geometry};
  const Facts again = RuleSet::load().relate(scene, names, known);
  EXPECT_EQ(asked(again), Names{});
  ASSERT_EQ(again.facts.size(), first.facts.size());
  for (std::size_t i = 0; i < first.facts.size(); ++i) {
    EXPECT_EQ(again.facts[i].relation, first.facts[i].relation);
    EXPECT_EQ(std::tie(again.facts[i].a, again.facts[i].b, again.facts[i].degree),
              std::tie(first.facts[i].a, first.facts[i].b, first.facts[i].degree));
  }
  EXPECT_EQ(again.reach.at("above").within_plan, first.reach.at("above").within_plan);
  // A tolerance, a rule, a plane.
  EXPECT_EQ(asked(RuleSet::load({}, {}, {{"near.full", "0.2"}}).relate(scene, names, known)), Names{"near"});
  const test::TemporaryFolder folder;
  test::write_file(folder / "touching.lua", "return relation { name = 'touching', extends = 'touching' }");
  EXPECT_EQ(asked(RuleSet::load({folder.path()}).relate(scene, names, known)), Names{"touching"});
  scene.planes[3].hull.outer[0].x() += 0.001;
  EXPECT_EQ(asked(RuleSet::load().relate(scene, names, known)), names);
}

TEST(Relate, AsksAgainOnlyRelationsThatLookAtAChangedFeature) {
  const test::TemporaryFolder folder;
  const auto relation = [&](const std::string& name, const std::string& body) {
    test::write_file(folder / (name + ".lua"),
                     "return relation { api = 1, name = '" + name + "', summary = 's', within = 2, degree = function(a, b) return " + body + " end }");
  };
  const auto tallness = [&](const std::string& value) {
    test::write_file(folder / "tallness.lua", "return feature { name = 'tallness', unit = 'm', low = 0, high = 9, value = function(p) return " + value + " end }");
  };
  relation("taller", "a.tallness > b.tallness");
  relation("steeper", "a.tilt_deg > b.tilt_deg and a.normal.z < 0.5");
  relation("probing", "pcall(function() return a.depth end)");
  const std::vector<std::string> names{"above", "probing", "steeper", "taller"};
  const auto answers = [&](const KnownAnswers& known) {
    RuleSet rules = RuleSet::load({folder.path()});
    Scene scene = building(1);
    rules.compute_features(scene, scene.features);
    return rules.relate(scene, names, known);
  };
  tallness("p.z_max - p.z_min");
  const Facts first = answers({});
  EXPECT_EQ(first.asked.at("taller").features, "tallness\n");
  EXPECT_EQ(first.asked.at("steeper").features, "");
  EXPECT_EQ(first.asked.at("probing").features, "?\n");
  const KnownAnswers known{stored(first), {}};
  EXPECT_EQ(asked(answers(known)), std::vector<std::string>{});
  tallness("p.z_min - p.z_max");
  EXPECT_EQ(asked(answers(known)), std::vector<std::string>{"taller"});
  tallness("p.z_max - p.z_min");
  test::write_file(folder / "depth.lua", "return feature { name = 'depth', unit = 'm', low = 0, high = 9, value = function(p) return p.width end }");
  EXPECT_EQ(asked(answers(known)), std::vector<std::string>{"probing"});
}

TEST(RuleSet, AsksFeaturesAndConstraintsOnceForTheSamePlanes) {
  const test::TemporaryFolder folder;
  const auto write = [&](const std::string& depth, const std::string& weight) {
    test::write_file(folder / "depth.lua", "return feature { name = 'depth', unit = 'm', low = 0, high = 9, value = function(p) return " + depth + " end }");
    test::write_file(folder / "twice.lua", "return feature { name = 'twice', unit = 'm', low = 0, high = 9, value = function(p) return 2 * p.depth end }");
    test::write_file(folder / "pair.lua", "return constraint { api = 1, name = 'pair', summary = 's', classes = { 'p', 'p' }, quantifier = 'no', weight = " + weight +
                                              ", within = 0.2, degree = function(a, b) return a.twice > 1 and 0.5 or 0.25 end }");
  };
  std::map<std::string, kb::StoredAnswer> before;
  const auto run = [&](double shift = 0) {
    RuleSet rules = RuleSet::load({folder.path()});
    Scene scene = building(1);
    scene.planes[3].hull.outer[0].x() += shift;
    KeptAnswers kept{before};
    rules.compute_features(scene, scene.features, &kept);
    std::vector<TupleConstraint> constraints = rules.constraints(scene, tiny::knowledge({"p"}), nullptr, &kept);
    const auto column = std::find(scene.features.names.begin(), scene.features.names.end(), "twice") - scene.features.names.begin();
    return std::tuple(scene.features.values[0][static_cast<std::size_t>(column)], std::move(constraints.at(0).tuples), std::move(kept.now));
  };
  write("1", "2");
  auto [twice, fresh, kept] = run();
  EXPECT_EQ(twice, 2);
  ASSERT_FALSE(fresh.empty());
  EXPECT_EQ(kept.at("feature twice").features, "depth\n");
  EXPECT_EQ(kept.at("constraint pair").features, "twice\n");
  // Other answers in their place show where they are used.
  before = kept;
  const double nine = 9;
  std::memcpy(before.at("feature twice").answers.data(), &nine, sizeof nine);
  EXPECT_EQ(std::get<0>(run()), 9);
  before = kept;
  before.at("constraint pair").answers.clear();
  EXPECT_TRUE(std::get<1>(run()).empty());
  EXPECT_EQ(std::get<1>(run(0.001)).size(), fresh.size()) << "another plane";
  write("1", "3");
  EXPECT_EQ(std::get<1>(run()).size(), fresh.size()) << "another file";
  write("0.25", "2");
  EXPECT_EQ(std::get<0>(run()), 0.5) << "a feature that it looks at";
  EXPECT_EQ(std::get<1>(run()).at(0).degree, 0.25);
  before.at("constraint pair") = kept.at("constraint pair");
  before.at("constraint pair").answers.pop_back();
  write("1", "2");
  EXPECT_EQ(std::get<1>(run()).size(), fresh.size()) << "bytes that are no tuples";
}

using Fact = std::tuple<kb::PlaneId, kb::PlaneId, double>;

std::vector<Fact> facts_of(RuleSet rules, const Scene& scene, const std::string& relation, bool turned = false) {
  std::vector<Fact> out;
  for (const kb::RelationFact& f : rules.relate(scene, {relation}).facts) out.emplace_back(turned ? f.b : f.a, turned ? f.a : f.b, f.degree);
  std::sort(out.begin(), out.end());
  return out;
}

TEST(Converse, HoldsTheOtherWayRound) {
  const Scene scene = building(1);
  const auto above = facts_of(RuleSet::load(), scene, "above");
  ASSERT_GT(above.size(), 10U);
  EXPECT_EQ(facts_of(RuleSet::load(), scene, "under", true), above);
  EXPECT_EQ(facts_of(RuleSet::load(), scene, "stands_on", true), facts_of(RuleSet::load(), scene, "supports"));
  // By itself, in its own file's words, it says the same.
  RuleSet own = RuleSet::load({}, {}, {{"under.reach", "0.25"}});
  EXPECT_EQ(facts_of(std::move(own), scene, "under", true), above);
  EXPECT_NE(facts_of(RuleSet::load({}, {}, {{"under.reach", "0"}}), scene, "under", true), above);
  const RuleSet rules = RuleSet::load();
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      if (a == b) continue;
      EXPECT_EQ(rules.degree("under", scene, a, b), rules.degree("above", scene, b, a));
    }
  }
}

TEST(Converse, FollowsTheRelationInForce) {
  const Scene scene = building(1);
  const test::TemporaryFolder folder;
  test::write_file(folder / "above.lua", "return relation { name = 'above', extends = 'above', degree = function(a, b) return a.z > b.z + 1 end }");
  const auto mine = facts_of(RuleSet::load({folder.path()}), scene, "above");
  EXPECT_NE(mine, facts_of(RuleSet::load(), scene, "above"));
  EXPECT_EQ(facts_of(RuleSet::load({folder.path()}), scene, "under", true), mine);
  const std::map<std::string, std::string> loose{{"above.enough", "0.2"}};
  EXPECT_EQ(facts_of(RuleSet::load({}, {}, loose), scene, "under", true), facts_of(RuleSet::load({}, {}, loose), scene, "above"));
  // What is kept of it depends on that relation too.
  const Facts first = RuleSet::load().relate(scene, {"under"});
  EXPECT_EQ(asked(RuleSet::load().relate(scene, {"under"}, {stored(first), {}})), std::vector<std::string>{});
  EXPECT_EQ(asked(RuleSet::load({folder.path()}).relate(scene, {"under"}, {stored(first), {}})), (std::vector<std::string>{"above", "under"}));
  // Two files that mirror each other answer for themselves.
  test::write_file(folder / "above.lua", "return relation { api = 1, name = 'above', summary = 's', converse = 'supports' }");
  test::write_file(folder / "supports.lua", "return relation { api = 1, name = 'supports', summary = 's', converse = 'above' }");
  EXPECT_EQ(facts_of(RuleSet::load({folder.path()}), scene, "above"), facts_of(RuleSet::load(), scene, "supports", true));
}

TEST(Converse, HasNothingThatTheOtherDecides) {
  const auto error = [](const std::string& fields) { return load_error("return relation {\n api = 1, name = 'r', summary = 's',\n " + fields + " }"); };
  EXPECT_EQ(error("converse = 'above', degree = function() return 1 end"),
            "r.lua:3: relation 'r': field 'degree' comes from 'above', the other way round; leave it out");
  EXPECT_EQ(error("converse = 'near'"), "r.lua:3: relation 'r': 'near' is symmetric, so it is its own converse");
  EXPECT_EQ(error("converse = 'under'"), "r.lua:3: relation 'r': 'under' is a converse itself; name 'above'");
  EXPECT_EQ(error("converse = 'abov'"), "r.lua:3: relation 'r': is the converse of 'abov', which is no built-in relation");
  EXPECT_EQ(error("convers = 'above'"), "r.lua:3: relation 'r': unknown field 'convers'; did you mean 'converse'?");
}

TEST(Relate, TakesGeometryFromTheRunBeforeOnlyForTheSamePlanes) {
  Scene scene = building(1);
  const std::vector<std::string> names{"above", "near"};
  const Facts fresh = RuleSet::load().relate(scene, names);
  constexpr std::size_t kEntry = 32;  // planes a and b, reach, the bounds of the answer
  ASSERT_GT(fresh.geometry.answers.size(), kEntry);
  EXPECT_EQ(fresh.geometry.answers, RuleSet::load().relate(scene, names).geometry.answers);
  const auto degrees = [](const Facts& facts) {
    std::vector<std::tuple<std::string, kb::PlaneId, kb::PlaneId, double>> out;
    for (const kb::RelationFact& f : facts.facts) out.emplace_back(f.relation, f.a, f.b, f.degree);
    return out;
  };
  // Answers that say "far apart, nothing over anything": they show where they are used.
  kb::StoredGeometry wrong = fresh.geometry;
  for (std::size_t entry = 0; entry < wrong.answers.size(); entry += kEntry) {
    double reach = 0;
    std::memcpy(&reach, wrong.answers.data() + entry + 8, 8);
    const double value = reach < 0 ? 50 : 0;
    for (const std::size_t bound : {entry + 16, entry + 24}) std::memcpy(wrong.answers.data() + bound, &value, 8);
  }
  EXPECT_EQ(degrees(RuleSet::load().relate(scene, names, {{}, fresh.geometry})), degrees(fresh));
  EXPECT_TRUE(RuleSet::load().relate(scene, names, {{}, wrong}).facts.empty());
  // Neither a shortened text nor entries about planes that are not there do harm.
  EXPECT_EQ(degrees(RuleSet::load().relate(scene, names, {{}, {fresh.geometry.inputs_sha256, std::string(35, '\xff')}})), degrees(fresh));
  scene.planes[3].hull.outer[0].x() += 0.001;
  EXPECT_EQ(degrees(RuleSet::load().relate(scene, names, {{}, wrong})), degrees(RuleSet::load().relate(scene, names)));
}

TEST(Relate, GivesBuiltInFilesNoOtherAnswersThanTheSameFilesOfAUser) {
  const test::TemporaryFolder folder;
  const Scene scene = building(2);
  RuleSet built_in = RuleSet::load();
  const std::vector<std::string> names = all_relations(built_in);
  for (const std::string& name : names) test::write_file(folder / (name + ".lua"), built_in.text(name));
  const Facts trusted = built_in.relate(scene, names), guarded = RuleSet::load({folder.path()}).relate(scene, names);
  ASSERT_EQ(trusted.facts.size(), guarded.facts.size());
  for (std::size_t i = 0; i < trusted.facts.size(); ++i) {
    const kb::RelationFact &f = trusted.facts[i], &g = guarded.facts[i];
    EXPECT_EQ(std::tie(f.relation, f.a, f.b, f.degree), std::tie(g.relation, g.a, g.b, g.degree));
  }
}

TEST(Relate, SortsFactsAndGivesTheSameTwice) {
  RuleSet rules = RuleSet::load();
  const Scene scene = building(2);
  const Facts once = rules.relate(scene, all_relations(rules)), again = RuleSet::load().relate(scene, all_relations(rules));
  ASSERT_EQ(once.facts.size(), again.facts.size());
  for (std::size_t i = 0; i < once.facts.size(); ++i) {
    const kb::RelationFact &f = once.facts[i], &g = again.facts[i];
    EXPECT_EQ(std::tie(f.relation, f.a, f.b, f.degree), std::tie(g.relation, g.a, g.b, g.degree));
    if (i > 0) {
      const kb::RelationFact& e = once.facts[i - 1];
      EXPECT_LT(std::tie(e.relation, e.a, e.b), std::tie(f.relation, f.a, f.b));
    }
  }
  for (const RelationCount& count : once.counts) EXPECT_LE(count.held, 2 * count.asked) << count.relation;
  EXPECT_THROW((void)rules.relate(scene, {"abov"}), Error);
}

/// Files of a user's that show in which order they are asked, and that leave geometry for those after them.
void write_users_files(const std::filesystem::path& folder) {
  const auto relation = [&](const std::string& name, const std::string& fields) {
    test::write_file(folder / (name + ".lua"), "local n = 0\nreturn relation { api = 1, name = '" + name + "', summary = 's', within = 1,\n" + fields + " }");
  };
  relation("a_exact_gap", "degree = function(a, b) return geometry.gap(a, b) < 0.2 end");
  relation("counting", "degree = function(a, b) n = n + 1; return n % 7 / 7 end");
  relation("near", "symmetric = true, degree = function(a, b) return geometry.gap(a, b, 0.05, 0.1) == 0.05 and a.aspect > 1 end");
  relation("under", "degree = function(a, b) return geometry.footprint_overlap(b, a, 0.25, 0.2, 0.3) end");
}

/// All that relate tells, but how long it took.
std::string told(const Facts& facts) {
  std::ostringstream out;
  out.precision(17);
  for (const kb::RelationFact& f : facts.facts) out << f.relation << " " << f.a << " " << f.b << " " << f.degree << "\n";
  for (const RelationCount& c : facts.counts) out << c.relation << " " << c.asked << " " << c.held << "\n";
  for (const auto& [name, a] : facts.asked) out << name << " " << a.asked << " " << a.held << " " << a.within << " " << a.within_plan << " " << a.stored << " " << a.inputs_sha256 << a.features;
  return out.str() + facts.geometry.inputs_sha256 + facts.geometry.answers;
}

TEST(Relate, TellsTheSameWithAnyNumberOfThreads) {
  const test::TemporaryFolder folder;
  write_users_files(folder.path());
  for (const bool with_users_files : {false, true}) {
    std::vector<std::filesystem::path> folders;
    if (with_users_files) folders.push_back(folder.path());
    const auto ask = [&](int threads, const KnownAnswers& known, const std::vector<std::string>& left_out = {}) {
      RuleSet rules = RuleSet::load(folders);
      Scene scene = building(8);
      rules.compute_features(scene, scene.features);
      std::vector<std::string> names = all_relations(rules);
      for (const std::string& name : left_out) std::erase(names, name);
      return rules.relate(scene, names, known, threads);
    };
    const Facts one = ask(1, {});
    ASSERT_GT(one.facts.size(), 1000U);
    const Facts some = ask(1, {}, {"near", "supports", "stands_on", "touching"});
    const KnownAnswers geometry{{}, some.geometry}, facts{stored(some), some.geometry};
    for (const int threads : {2, 3, 5}) {
      EXPECT_TRUE(told(ask(threads, {})) == told(one)) << threads;
      EXPECT_TRUE(told(ask(threads, geometry)) == told(ask(1, geometry))) << threads;
      EXPECT_TRUE(told(ask(threads, facts)) == told(ask(1, facts))) << threads;
    }
  }
}

TEST(Relate, TellsTheSameTwiceInTwoThreads) {
  RuleSet rules = RuleSet::load();
  const Scene scene = building(8), other = building(7);
  const std::string first = told(rules.relate(scene, all_relations(rules)));
  (void)rules.relate(other, all_relations(rules));
  EXPECT_TRUE(told(rules.relate(scene, all_relations(rules))) == first);
}

TEST(Relate, MeetsTheSameErrorFirstWithAnyNumberOfThreads) {
  const auto error = [](const std::vector<std::filesystem::path>& folders, const Budget& budget, int threads, const std::string& further) {
    RuleSet rules = RuleSet::load(folders, budget);
    std::vector<std::string> names = all_relations(rules);
    names.push_back(further);
    try {
      (void)rules.relate(building(8), names, {}, threads);
    } catch (const Error& failed) {
      return std::string(failed.what());
    }
    return std::string("none");
  };
  const test::TemporaryFolder folder;
  write_users_files(folder.path());
  test::write_file(folder / "middle.lua", "local n = 0\nreturn relation { api = 1, name = 'middle', summary = 's', degree = function(a, b)\n n = n + 1\n if n == 500 then error('stop') end\n return 0 end }");
  test::write_file(folder / "zero.lua", "return relation { api = 1, name = 'zero', summary = 's', degree = function(a, b) error('too late') end }");
  const std::string users = error({folder.path()}, {}, 1, "zzz"), over = error({}, {.total = std::chrono::milliseconds(0)}, 1, "near");
  EXPECT_NE(users.find("middle.lua:4: stop (relation 'middle', planes"), users.npos) << users;
  EXPECT_NE(over.find("above.lua: stopped after 0 ms and 0 questions"), over.npos) << over;
  const std::string unknown = error({}, {}, 1, "abov");
  EXPECT_NE(unknown.find("there is no relation 'abov'"), unknown.npos) << unknown;
  for (const int threads : {2, 3}) {
    EXPECT_EQ(error({folder.path()}, {}, threads, "zzz"), users) << threads;
    EXPECT_EQ(error({}, {.total = std::chrono::milliseconds(0)}, threads, "near"), over) << threads;
    EXPECT_EQ(error({}, {}, threads, "abov"), unknown) << threads;
  }
}

TEST(Relate, AsksAsManyPairsPerPlaneInALargeBuildingAsInASmallOne) {
  RuleSet rules = RuleSet::load();
  const auto asked_per_plane = [&](int rooms) {
    const Scene scene = building(rooms);
    std::int64_t sum = 0;
    for (const RelationCount& count : rules.relate(scene, all_relations(rules)).counts) sum += count.asked;
    return static_cast<double>(sum) / static_cast<double>(scene.planes.size());
  };
  EXPECT_LT(asked_per_plane(100), 1.25 * asked_per_plane(36));  // how long it takes is for `make rules_bench`
}

}  // namespace
}  // namespace scenelore::rules
