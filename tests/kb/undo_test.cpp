// Learned rows in place and taken back; composites as rows.
#include <gmock/gmock.h>

#include <cmath>

#include "composites.hpp"
#include "rooms.hpp"
#include "scenelore/kb/error.hpp"
#include "scenelore/kb/knowledge_base.hpp"
#include "scenelore/kb/learn.hpp"

namespace scenelore::kb {
namespace {

using ::testing::HasSubstr;
using testing::error_of;
using testing::TemporaryFolder;

LabelledPlanes tables(const Knowledge& knowledge, int count) {
  LabelledPlanes planes;
  for (const Feature& f : knowledge.features) planes.features.names.push_back(f.name);
  for (int i = 0; i < count; ++i) {
    std::vector<double>& row = planes.features.values.emplace_back();
    for (const Feature& f : knowledge.features) row.push_back(f.low + (f.high - f.low) * (0.3 + 0.01 * (i % 7)));
    planes.classes.push_back("table");
  }
  return planes;
}

TEST(LearnedRows, JoinThePresentOnesAsPretendedExamples) {
  Knowledge knowledge;
  knowledge.classes = {{0, "unknown", 0.5, "", "#000000", true}, {1, "table", 0.5, "", "#000000", false}};
  knowledge.features = {{"height", "m", Scale::linear, 0, 10, 1, ""}};
  knowledge.class_features = {{"table", "height", 2, 0.5}};
  LabelledPlanes planes{{{"height"}, {}}, {}};
  for (int i = 0; i < 10; ++i) planes.features.values.push_back({i < 5 ? 3.0 : 5.0}), planes.classes.push_back("table");
  const LearnedRows rows = learn(knowledge, planes, {.min_examples = 5, .present_strength = 30});
  const ClassFeature& row = rows.classes[1].gaussians.at(0);
  EXPECT_DOUBLE_EQ(row.mean, (10 * 4.0 + 30 * 2.0) / 40);
  const double own = 10.0 / 9;  // variance of the examples
  EXPECT_NEAR(row.sigma * row.sigma, (10 * own + 30 * 0.25 + 10 * 30 / 40.0 * 4) / 40, 1e-9);
  double mass = 0, mean = 0;
  for (const ClassDensity& bin : rows.classes[1].densities) {
    mass += bin.density * (bin.high - bin.low), mean += bin.density * (bin.high - bin.low) * (bin.high + bin.low) / 2;
  }
  EXPECT_NEAR(mass, 1, 1e-9);
  EXPECT_NEAR(mean, (22 * 4.0 + 30 * 2.0) / 52, 0.3);  // 10 examples and 12 of their Gaussian, 30 of the present one
}

TEST(LearnedRows, StandInMemoryAsTheyStandInTheFile) {
  TemporaryFolder folder;
  KnowledgeBase base = KnowledgeBase::create(folder / "a.gpkg");
  const Knowledge before = base.knowledge();
  const LearnedRows rows = learn(before, tables(before, 40));
  base.apply_knowledge(to_sql(rows), "test");
  const FeatureTable planes = tables(before, 5).features;
  const auto a = preclassify(base.knowledge(), planes), b = preclassify(with_rows(before, rows), planes);
  for (std::size_t p = 0; p < a.size(); ++p) {
    for (std::size_t c = 0; c < a[p].size(); ++c) EXPECT_NEAR(a[p][c], b[p][c], 2e-3);
  }
}

TEST(Undo, BringsBackEveryBitOneLearningAfterTheOther) {
  TemporaryFolder folder;
  KnowledgeBase base = KnowledgeBase::create(folder / "a.gpkg");
  const std::string first = base.knowledge_hash();
  EXPECT_EQ(base.undo_knowledge(), std::nullopt);
  base.learn_knowledge(to_sql(learn(base.knowledge(), tables(base.knowledge(), 40))), "once");
  const std::string second = base.knowledge_hash();
  base.learn_knowledge("UPDATE feature SET weight = 0.1234567 WHERE name = 'height'; UPDATE class_constraint SET weight = 0.77", "twice");
  EXPECT_NE(first, second);
  EXPECT_EQ(base.undo_knowledge(), "twice");
  EXPECT_EQ(base.knowledge_hash(), second);
  EXPECT_EQ(base.undo_knowledge(), "once");
  EXPECT_EQ(base.knowledge_hash(), first);
  EXPECT_THROW(base.learn_knowledge("UPDATE feature SET weight = -1", "broken"), Error);
  EXPECT_EQ(base.undo_knowledge(), std::nullopt);
}

TEST(Composites, AskForTheirPartsBothWays) {
  const std::vector<Composite> sofa{{"sofa", {{.part = "seat", .object_class = "sofa"},
                                              {.part = "back", .object_class = "sofa_back", .relation = "near", .fewest = 1, .weight = 2},
                                              {.part = "arm", .object_class = "arm", .relation = "touching", .fewest = 2, .most = 2, .weight = 1},
                                              {.part = "cushion", .object_class = "cushion", .relation = "near"}}}};
  const auto rows = composite_needs(sofa);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].name, "sofa.back");
  EXPECT_EQ(rows[0].object_class, "sofa_back");
  EXPECT_EQ(rows[0].other_class, "sofa");
  EXPECT_EQ(rows[1].object_class, "sofa");
  EXPECT_EQ(rows[1].other_class, "sofa_back");
  EXPECT_EQ(rows[1].quantifier, Quantifier::some);
  EXPECT_EQ(rows[3].quantifier, Quantifier::at_least);
  EXPECT_EQ(rows[3].count, 2);
  EXPECT_EQ(rows[3].weight, 1);
}

TEST(Composites, AreCheckedLikeAllKnowledge) {
  TemporaryFolder folder;
  KnowledgeBase base = KnowledgeBase::create(folder / "a.gpkg");
  const std::string hash = base.knowledge_hash();
  const auto add = [&](const std::string& parts) {
    return error_of([&] {
      base.apply_knowledge("INSERT INTO composite (name) VALUES ('desk'); INSERT INTO composite_part (composite, part, class, relation) VALUES " + parts, "test");
    });
  };
  EXPECT_THAT(add("('desk', 'top', 'table', 'near')"), HasSubstr("the anchor"));
  EXPECT_THAT(add("('desk', 'top', 'tabel', NULL)"), HasSubstr("FOREIGN KEY"));
  EXPECT_EQ(base.knowledge_hash(), hash);
  base.apply_knowledge("INSERT INTO composite (name) VALUES ('desk'); INSERT INTO composite_part (composite, part, class, relation) VALUES "
                       "('desk', 'top', 'table', NULL), ('desk', 'screen', 'flat_screen', 'above')", "test");
  EXPECT_NE(base.knowledge_hash(), hash);
  EXPECT_EQ(base.knowledge().composites.back().parts.size(), 2u);
}

}  // namespace
}  // namespace scenelore::kb
