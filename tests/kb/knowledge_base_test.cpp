#include "scenelore/kb/knowledge_base.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "rooms.hpp"
#include "scenelore/kb/error.hpp"
#include "sqlite.hpp"

namespace scenelore::kb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ask;
using testing::error_of;
using testing::TemporaryFolder;

TEST(KnowledgeBase, CreatesEachPackWithKnowledgeThatPassesItsOwnChecks) {
  const TemporaryFolder folder;
  const KnowledgeBase office = KnowledgeBase::create(folder / "office.gpkg");
  EXPECT_EQ(office.knowledge().classes.size(), 14U);
  EXPECT_EQ(office.knowledge().setting("combination", ""), "product");
  const Knowledge paper = KnowledgeBase::create(folder / "paper.gpkg", "paper").knowledge();
  EXPECT_EQ(paper.setting("combination", ""), "mean");
  EXPECT_EQ(paper.setting("floor_threshold", ""), "0.4");
  for (const ClassConstraint& c : paper.constraints) EXPECT_FALSE(c.weight) << c.name;
  const Knowledge empty = KnowledgeBase::create(folder / "empty.gpkg", "empty").knowledge();
  ASSERT_EQ(empty.classes.size(), 1U);
  EXPECT_TRUE(empty.classes[0].fallback);
}

TEST(KnowledgeBase, NeverOverwritesAFile) {
  const TemporaryFolder folder;
  test::write_file(folder / "office.gpkg", "mine");
  EXPECT_THAT(error_of([&] { KnowledgeBase::create(folder / "office.gpkg"); }), HasSubstr("never overwritten"));
  EXPECT_EQ(test::read_file(folder / "office.gpkg"), "mine");
}

TEST(KnowledgeBase, RefusesAnUnknownPackAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of([&] { KnowledgeBase::create(folder / "a.gpkg", "kitchen"); }), HasSubstr("no knowledge pack 'kitchen'"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(KnowledgeBase, GivesBackAScanAsItWasStored) {
  const TemporaryFolder folder;
  KnowledgeBase base = KnowledgeBase::create(folder / "office.gpkg");
  testing::Room room = testing::room();
  room.scan.origin = {690000, 5330000, 510};
  room.scan.rotation = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX());
  room.scan.floor_z = -1.25;
  const ScanId id = base.store_scan(room.scan, room.planes, room.plane_of_point);
  const std::optional<Scan> scan = base.find_scan("room");
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->id, id);
  EXPECT_EQ(scan->origin, room.scan.origin);
  EXPECT_EQ(scan->rotation.coeffs(), room.scan.rotation.coeffs());
  EXPECT_EQ(scan->floor_z, -1.25);
  EXPECT_EQ(scan->parameters, room.scan.parameters);
  EXPECT_EQ(scan->imported_at, room.scan.imported_at);
  const std::vector<StoredPlane> planes = base.planes(id);
  ASSERT_EQ(planes.size(), room.planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const perception::Plane &stored = planes[i].plane, &given = room.planes[i];
    EXPECT_EQ(stored.centroid, given.centroid);
    EXPECT_EQ(stored.normal, given.normal);
    EXPECT_EQ(stored.orientation.coeffs(), given.orientation.coeffs());
    EXPECT_EQ(stored.hull.outer, given.hull.outer);
    EXPECT_EQ(stored.hull.holes, given.hull.holes);
    EXPECT_EQ(stored.area_m2, given.area_m2);
    EXPECT_EQ(stored.tilt_deg, given.tilt_deg);
    EXPECT_EQ(stored.z_max, given.z_max);
    EXPECT_EQ(stored.rmse, given.rmse);
    EXPECT_EQ(stored.seen_share, given.seen_share);
    EXPECT_EQ(stored.behind, given.behind);
    EXPECT_EQ(stored.edge_free, given.edge_free);
    EXPECT_EQ(stored.edge_free_top, given.edge_free_top);
    EXPECT_EQ(stored.edge_joined, given.edge_joined);
    EXPECT_EQ(stored.edge_unseen, given.edge_unseen);
    EXPECT_EQ(stored.point_count, given.point_count);
  }
  const std::vector<std::int64_t> of_point = base.plane_of_point(id);
  ASSERT_EQ(of_point.size(), 450U);
  EXPECT_EQ(of_point[150], planes[1].id);
  EXPECT_EQ(of_point[449], -1);
}

TEST(KnowledgeBase, StoresTheInferenceAndReplacesItAsAWhole) {
  const TemporaryFolder folder;
  KnowledgeBase base = KnowledgeBase::create(folder / "office.gpkg");
  const testing::Room room = testing::room();
  const ScanId scan = base.store_scan(room.scan, room.planes, room.plane_of_point);
  Inference inference = testing::inference(base.planes(scan));
  inference.labels[0].margin = std::numeric_limits<double>::infinity();
  const std::int64_t first = base.store_inference(scan, inference);
  const auto labels = ask(base, "SELECT * FROM label");
  EXPECT_EQ(base.store_inference(scan, inference), first);
  EXPECT_EQ(ask(base, "SELECT * FROM label"), labels);
  EXPECT_THAT(ask(base, "SELECT a, b FROM labelled_relation WHERE relation = 'above' AND a_class = 'flat_screen' AND b_class = 'table'"),
              ElementsAre("4|3"));
  EXPECT_THAT(ask(base, "SELECT class, planes FROM class_count ORDER BY class"),
              ElementsAre("flat_screen|1", "floor|1", "table|1", "wall|1"));
  EXPECT_THAT(ask(base, "SELECT plane, evidence FROM labelled_plane WHERE class = 'table'"), ElementsAre("3|0.8"));
  EXPECT_THAT(ask(base, "SELECT plane FROM needs_review LIMIT 2"), ElementsAre("2", "3"));  // the floor's margin is infinite
  EXPECT_EQ(base.labels(scan)[0].margin, std::numeric_limits<double>::infinity());
  ASSERT_EQ(base.reasons(4).size(), 2U);
  EXPECT_EQ(base.reasons(4)[1].other_plane, 3);
  inference.evidence[2] = {0.1, 0.1, 0.6, 0.1, 0.1};
  inference.facts[0].degree = 0.25;
  std::swap(inference.facts[1].a, inference.facts[1].b);
  base.store_inference(scan, inference);
  EXPECT_THAT(ask(base, "SELECT probability FROM evidence WHERE plane_id = 3 AND class = 'table'"), ElementsAre("0.6"));
  EXPECT_THAT(ask(base, "SELECT a, b, degree FROM relation_fact WHERE relation = 'near' ORDER BY a, b"), ElementsAre("1|2|0.25", "3|2|0.5", "3|4|0.5"));
  inference.labels.clear();
  inference.alternatives.clear();
  inference.reasons.clear();
  inference.facts.clear();
  base.store_inference(scan, inference);
  EXPECT_TRUE(base.labels(scan).empty());
  EXPECT_THAT(ask(base, "SELECT (SELECT count(*) FROM reason) + (SELECT count(*) FROM alternative) + (SELECT count(*) FROM relation_fact)"),
              ElementsAre("0"));
}

TEST(KnowledgeBase, HandsOutFactsUntilSomebodyChangesThem) {
  const TemporaryFolder folder;
  KnowledgeBase base = KnowledgeBase::create(folder / "office.gpkg");
  const testing::Room room = testing::room();
  const ScanId scan = base.store_scan(room.scan, room.planes, room.plane_of_point);
  Inference inference = testing::inference(base.planes(scan));
  inference.facts = {{"above", 4, 3, 0.75}, {"near", 1, 2, 0.5}, {"near", 3, 4, 1.0 / 3}};
  inference.asked = {{"above", {.asked = 12, .held = 1, .within_plan = 0.3, .inputs_sha256 = "x"}},
                     {"near", {.asked = 12, .held = 2, .inputs_sha256 = "y"}},
                     {"never", {.asked = 12, .inputs_sha256 = "z"}}};
  base.store_inference(scan, inference);
  const auto facts = base.facts(scan);
  ASSERT_EQ(facts.size(), 3U);
  EXPECT_EQ(facts.at("above").asked.within_plan, 0.3);
  EXPECT_EQ(facts.at("above").asked.within, std::numeric_limits<double>::infinity());
  ASSERT_EQ(facts.at("near").facts.size(), 2U);
  EXPECT_EQ(facts.at("near").facts[1].degree, 1.0 / 3);
  EXPECT_EQ(facts.at("near").asked.inputs_sha256, "y");
  EXPECT_TRUE(facts.at("never").facts.empty());

  // Taken over as they are, the rows stay; a relation that is asked anew gets new ones.
  const auto ids = ask(base, "SELECT id FROM relation_fact WHERE relation = 'near'");
  for (const auto& [relation, stored] : facts) inference.asked[relation] = stored.asked;
  inference.asked["above"] = {.asked = 12, .held = 1, .inputs_sha256 = "other"};
  inference.facts[0].degree = 0.25;
  base.store_inference(scan, inference);
  EXPECT_EQ(ask(base, "SELECT id FROM relation_fact WHERE relation = 'near'"), ids);
  EXPECT_THAT(ask(base, "SELECT degree FROM relation_fact WHERE relation = 'above'"), ElementsAre("0.25"));

  Database(folder / "office.gpkg", OpenMode::read_write).execute("UPDATE relation_fact SET degree = 0.9 WHERE a = 1");
  EXPECT_FALSE(base.facts(scan).contains("near"));
  EXPECT_TRUE(base.facts(scan).contains("above"));
  Database(folder / "office.gpkg", OpenMode::read_write).execute("DELETE FROM relation_fact WHERE relation = 'above'");
  EXPECT_FALSE(base.facts(scan).contains("above"));
  EXPECT_TRUE(base.facts(scan).contains("never"));
  Database(folder / "office.gpkg", OpenMode::read_write)
      .execute("INSERT INTO relation_fact (scan_id, relation, a, b, degree) SELECT id, 'never', 1, 2, 0.5 FROM scan");
  EXPECT_TRUE(base.facts(scan).empty());
}

TEST(KnowledgeBase, WritesOfARelationOnlyTheFactsThatDiffer) {
  const TemporaryFolder folder;
  KnowledgeBase base = KnowledgeBase::create(folder / "office.gpkg");
  const testing::Room room = testing::room();
  const ScanId scan = base.store_scan(room.scan, room.planes, room.plane_of_point);
  Inference inference = testing::inference(base.planes(scan));
  const auto store = [&](const std::vector<RelationFact>& near) {
    inference.facts = near;
    inference.facts.insert(inference.facts.begin(), {"above", 4, 3, 0.75});
    inference.asked = {{"above", {.asked = 12, .held = 1, .inputs_sha256 = "x"}},
                       {"near", {.asked = 12, .held = static_cast<std::int64_t>(near.size()), .inputs_sha256 = std::to_string(near.size())}}};
    base.store_inference(scan, inference);
  };
  const auto rows = [&] { return ask(base, "SELECT id, a, b, degree FROM relation_fact WHERE relation = 'near' ORDER BY a, b"); };
  store({{"near", 1, 2, 0.5}, {"near", 1, 3, 0.5}, {"near", 2, 3, 0.5}});
  EXPECT_THAT(rows(), ElementsAre("2|1|2|0.5", "3|1|3|0.5", "4|2|3|0.5"));
  store({{"near", 1, 2, 0.5}, {"near", 1, 4, 0.5}, {"near", 2, 1, 0.25}, {"near", 2, 3, 0.75}});
  EXPECT_THAT(rows(), ElementsAre("2|1|2|0.5", "5|1|4|0.5", "6|2|1|0.25", "4|2|3|0.75"));
  // Read back by a and b, whatever the rows' ids, and apart from those of other relations between them.
  const auto facts = base.facts(scan);
  std::vector<std::pair<PlaneId, PlaneId>> pairs;
  for (const RelationFact& fact : facts.at("near").facts) pairs.emplace_back(fact.a, fact.b);
  EXPECT_THAT(pairs, ElementsAre(std::pair(1, 2), std::pair(1, 4), std::pair(2, 1), std::pair(2, 3)));
  EXPECT_EQ(facts.at("above").facts.size(), 1U);
  store({});
  EXPECT_TRUE(rows().empty());
  EXPECT_TRUE(base.facts(scan).at("near").facts.empty());
}

TEST(KnowledgeBase, KeepsWhatRulesAnswered) {
  const TemporaryFolder folder;
  KnowledgeBase base = KnowledgeBase::create(folder / "office.gpkg");
  const testing::Room room = testing::room();
  const ScanId scan = base.store_scan(room.scan, room.planes, room.plane_of_point);
  Inference inference = testing::inference(base.planes(scan));
  inference.rule_answers = {{"feature depth", {"width\n", "x", std::string("\0\1\2", 3)}}, {"constraint between", {"", "y", ""}}};
  inference.asked = {{"near", {.asked = 12, .held = 3, .inputs_sha256 = "z", .features = "depth\n"}}};
  base.store_inference(scan, inference);
  EXPECT_EQ(base.rule_answers(scan), inference.rule_answers);
  EXPECT_EQ(base.facts(scan).at("near").asked.features, "depth\n");
  const auto kept = inference.rule_answers;
  inference.rule_answers.clear();  // as isolated rules leave them
  base.store_inference(scan, inference);
  EXPECT_EQ(base.rule_answers(scan), kept);
  inference.rule_answers = {{"feature depth", {"", "other", "1"}}};
  base.store_inference(scan, inference);
  EXPECT_EQ(base.rule_answers(scan), inference.rule_answers);
}

/// A knowledge base whose room has evidence by the program, and bytes put in the place of what is kept, which show whether it is used.
class KeptEvidence : public ::testing::Test {
 protected:
  KeptEvidence() {
    const testing::Room room = testing::room();
    scan_ = base_.store_scan(room.scan, room.planes, room.plane_of_point);
    features_ = built_in_features(*base_.find_scan("room"), base_.planes(scan_));
    computed_ = base_.evidence(scan_, ids_, features_).probabilities;
    store();
    mark();
  }
  void store() {
    const Evidence evidence = base_.evidence(scan_, ids_, features_);
    Inference inference = testing::inference(base_.planes(scan_));
    inference.classes.clear();
    for (const ObjectClass& c : base_.knowledge().classes) inference.classes.push_back(c.name);
    inference.evidence = evidence.probabilities;
    inference.evidence_inputs = evidence.inputs_sha256;
    base_.store_features(scan_, ids_, features_);
    base_.store_inference(scan_, inference);
  }
  void execute(const std::string& sql) { Database(file_, OpenMode::read_write).execute(sql); }
  void mark() { execute("UPDATE kept_result SET content = zeroblob(length(content)) WHERE what = 'evidence'"); }
  [[nodiscard]] bool is_used() const {
    const auto now = base_.evidence(scan_, ids_, features_).probabilities;
    const std::vector marked(ids_.size(), std::vector<double>(computed_[0].size(), 0.0));
    EXPECT_TRUE(now == computed_ || now == marked);
    return now == marked;
  }
  /// Rows of the evidence that are not as computed.
  [[nodiscard]] std::size_t wrong_rows() const {
    std::size_t row = 0, wrong = 0;
    base_.query("SELECT probability FROM evidence ORDER BY plane_id, id", [](const auto&) {}, [&](const QueryRow& values) {
      const double wanted = computed_[row / computed_[0].size()][row % computed_[0].size()];
      if (std::abs(std::stod(*values.values[0]) - wanted) > 1e-12 * wanted) ++wrong;
      ++row;
    });
    EXPECT_EQ(row, ids_.size() * computed_[0].size());
    return wrong;
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "office.gpkg";
  KnowledgeBase base_ = KnowledgeBase::create(file_);
  ScanId scan_ = 0;
  std::vector<PlaneId> ids_{1, 2, 3, 4};
  FeatureTable features_;
  std::vector<std::vector<double>> computed_;
};

TEST_F(KeptEvidence, IsUsedUntilSomethingItDependsOnChanges) {
  ASSERT_EQ(computed_, preclassify(base_.knowledge(), features_));
  EXPECT_TRUE(is_used());
  execute("UPDATE class_constraint SET weight = 7 WHERE name = 'table_level'");
  EXPECT_TRUE(is_used()) << "a constraint says nothing about a plane alone";
  FeatureTable other = features_;
  std::swap(features_, other);
  features_.values[2][0] *= 2;
  EXPECT_EQ(base_.evidence(scan_, ids_, features_).probabilities, preclassify(base_.knowledge(), features_));
  std::swap(features_, other);
  features_.errors["height"] = {0.5, 0.5, 0.5, 0.5};
  EXPECT_EQ(base_.evidence(scan_, ids_, features_).probabilities, preclassify(base_.knowledge(), features_));
  features_.errors.erase("height");
  EXPECT_TRUE(is_used());
  execute("UPDATE object_class SET prior = 2 * prior WHERE name = 'table'");
  EXPECT_EQ(base_.evidence(scan_, ids_, features_).probabilities, preclassify(base_.knowledge(), features_));
}

TEST_F(KeptEvidence, IsVoidWhenSomebodyChangesTheRowsWhichTheNextRunPutsRight) {
  for (const char* const change :
       {"UPDATE evidence SET probability = 0.5 WHERE plane_id = 3 AND class = 'table'", "DELETE FROM evidence WHERE plane_id = 2 AND class = 'wall'",
        "DELETE FROM evidence WHERE plane_id = 1 AND class = 'table'; INSERT INTO evidence (plane_id, class, probability) VALUES (1, 'table', 0.25)"}) {
    SCOPED_TRACE(change);
    ASSERT_TRUE(is_used());
    execute(std::string("PRAGMA foreign_keys = OFF; ") + change);
    EXPECT_FALSE(is_used());
    store();
    EXPECT_EQ(wrong_rows(), 0U);
    mark();
  }
}

TEST_F(KeptEvidence, LeavesRowsAloneThatAreAsTheyWere) {
  const auto version = [&] {
    std::string out;
    base_.query("SELECT group_concat(id || ' ' || feature || ' ' || value) FROM plane_feature", [](const auto&) {},
                [&](const QueryRow& row) { out = row.values[0].value_or(""); });
    return out;
  };
  const std::string before = version();
  store();
  EXPECT_EQ(version(), before) << "rows that are written again get other ids";
  execute("UPDATE plane_feature SET value = 77 WHERE id = 3");
  store();
  const std::string now = version();
  EXPECT_EQ(now.find(" 77.0"), std::string::npos) << now;
  EXPECT_EQ(std::count(now.begin(), now.end(), ','), std::count(before.begin(), before.end(), ','));
}

TEST(KnowledgeBase, ReplacesReasonsWhicheverOfThemChangedAndWhoeverChangedThem) {
  const TemporaryFolder folder;
  KnowledgeBase base = KnowledgeBase::create(folder / "office.gpkg");
  const testing::Room room = testing::room();
  const ScanId scan = base.store_scan(room.scan, room.planes, room.plane_of_point);
  Inference inference = testing::inference(base.planes(scan));
  std::mt19937 random(5);
  const auto draw = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  const auto any_reason = [&] {
    Reason r{.plane = 1 + draw(4), .object_class = "table", .kind = draw(2) == 0 ? "support" : "feature", .amount = draw(3) * 0.5,
             .sentence = std::string(static_cast<std::size_t>(draw(20)), 'x') + std::to_string(draw(3))};
    if (draw(2) == 0) r.constraint_name = "row " + std::to_string(draw(2));
    if (draw(2) == 0) r.other_plane = 1 + draw(2);
    if (r.kind == "feature") r.term = {"height", draw(2) * 1.0, draw(2) == 0 ? std::nan("") : 1.0, 0.5};
    if (draw(2) == 0) r.against = "wall";
    return r;
  };
  const auto in_words = [](const Reason& r) {
    const auto number = [](double value) { return std::isnan(value) ? "-" : std::to_string(value); };
    return std::to_string(r.plane) + r.object_class + r.kind + r.constraint_name.value_or("-") + std::to_string(r.other_plane.value_or(0)) +
           number(r.amount) + r.sentence + r.against.value_or("-") +
           (r.term ? r.term->feature + number(r.term->value) + number(r.term->mean) + number(r.term->sigma) : "-");
  };
  const std::vector<std::string> tampering = {
      "", "UPDATE reason SET sentence = 'mine' WHERE id = (SELECT min(id) FROM reason)", "DELETE FROM reason WHERE id % 3 = 0",
      "INSERT INTO reason (run_id, plane_id, class, kind, amount, sentence) SELECT id, 1, 'table', 'support', 1, 'mine' FROM run",
      "UPDATE kept_result SET content = x'00ff' WHERE what = 'reasons'"};
  for (int turn = 0; turn < 60; ++turn) {
    std::vector<Reason>& reasons = inference.reasons;
    const int wanted = draw(3) == 0 ? draw(12) : static_cast<int>(reasons.size());
    while (static_cast<int>(reasons.size()) < wanted) reasons.push_back(any_reason());
    reasons.resize(static_cast<std::size_t>(wanted));
    for (Reason& reason : reasons) {
      if (draw(4) == 0) reason = any_reason();
    }
    const std::string& change = tampering[static_cast<std::size_t>(draw(static_cast<int>(tampering.size())))];
    if (!change.empty()) Database(folder / "office.gpkg", OpenMode::read_write).execute(change);
    base.store_inference(scan, inference);
    for (PlaneId plane = 1; plane <= 4; ++plane) {
      std::vector<std::string> expected, found;
      for (const Reason& reason : reasons) {
        if (reason.plane == plane) expected.push_back(in_words(reason));
      }
      for (const Reason& reason : base.reasons(plane)) found.push_back(in_words(reason));
      ASSERT_EQ(found, expected) << "turn " << turn << " " << change;
    }
  }
}

TEST(KnowledgeBase, SeesAtOnceWhatAnotherConnectionChanged) {
  const TemporaryFolder folder;
  const KnowledgeBase base = KnowledgeBase::create(folder / "office.gpkg");
  const std::string hash = base.knowledge_hash();
  EXPECT_EQ(base.knowledge_hash(), hash);
  Database(folder / "office.gpkg", OpenMode::read_write).execute("UPDATE object_class SET prior = 0.5 WHERE name = 'table'");
  EXPECT_EQ(base.knowledge().classes[static_cast<std::size_t>(base.knowledge().class_index("table"))].prior, 0.5);
  EXPECT_NE(base.knowledge_hash(), hash);
}

}  // namespace
}  // namespace scenelore::kb
