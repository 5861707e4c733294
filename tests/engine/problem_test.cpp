// What is put into a problem comes out of it as it was, however it is kept: against a list of plain constraints.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "random_problem.hpp"
#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {
namespace {

using Body = decltype(Constraint::body);

Body random_body(testing::Random& random) {
  const auto literal = [&] { return Literal{random.below(4), random.below(3)}; };
  switch (random.below(4)) {
    case 0: return Conflict{literal(), literal()};
    case 1: return Requirement{literal(), {{literal(), 0.25}, {literal(), 0.5}}};
    case 2: return Cardinality{literal(), {literal(), literal()}, random.below(2), 2 + random.below(2)};
    default: return PairTable{random.below(2), 2 + random.below(2), 0};
  }
}

std::string written(const std::vector<Literal>& literals) {
  std::string out;
  for (const Literal& l : literals) out += std::to_string(l.variable) + "=" + std::to_string(l.label) + " ";
  return out;
}

std::string written(const Constraint& constraint) {
  std::string out = constraint.name + " " + std::to_string(constraint.weight) + " " + std::to_string(constraint.reference) + ": ";
  if (const auto* conflict = std::get_if<Conflict>(&constraint.body)) out += "not " + written({conflict->a, conflict->b});
  if (const auto* requirement = std::get_if<Requirement>(&constraint.body)) {
    out += "some for " + written({requirement->literal});
    for (const Support& support : requirement->supports) out += written({support.literal}) + std::to_string(support.cost) + " ";
  }
  if (const auto* count = std::get_if<Cardinality>(&constraint.body)) {
    out += std::to_string(count->low) + " to " + std::to_string(count->high) + " of " + written(count->literals);
    if (count->condition) out += "if " + written({*count->condition});
  }
  if (const auto* pair = std::get_if<PairTable>(&constraint.body)) {
    out += "table " + std::to_string(pair->table) + " of " + std::to_string(pair->a) + " and " + std::to_string(pair->b);
  }
  return out;
}

TEST(Problem, GivesBackConstraintsOfAllKindsAsTheyWereAddedAndDropped) {
  testing::Random random(7);
  Problem problem;
  for (int v = 0; v < 4; ++v) problem.add_variable("v", {"a", "b", "c"}, {0, 1, 2});
  (void)problem.add_table(3, 3, std::vector<double>(9, 1.0));
  std::vector<Constraint> expected;
  for (int i = 0; i < 300; ++i) {
    const std::string name = "row " + std::to_string(random.below(3));  // names come back after others
    const Body body = random_body(random);
    const auto* conflict = std::get_if<Conflict>(&body);
    const int index = conflict != nullptr && i % 2 == 0 ? problem.add(name, 0.5 + i, i, *conflict) : problem.add(name, 0.5 + i, i, body);
    ASSERT_EQ(index, i);
    expected.push_back({name, 0.5 + i, i, body});
  }
  for (int i = 0; i < 300; i += 7) {
    problem.drop(i);
    expected[static_cast<std::size_t>(i)].body = Cardinality{};
  }
  const Problem copy = problem;
  ASSERT_EQ(copy.constraints().size(), expected.size());
  std::size_t i = 0;
  for (const ConstraintView constraint : copy.constraints()) {
    EXPECT_EQ(written(constraint), written(expected[i])) << i;
    EXPECT_EQ(written(copy.constraints()[i]), written(expected[i])) << i;
    EXPECT_EQ(constraint.as<Requirement>() != nullptr, std::holds_alternative<Requirement>(expected[i].body)) << i;
    ++i;
  }
  EXPECT_EQ(i, expected.size());
  i = 0;
  const auto of_conflict = [&](std::size_t index, double weight, const Conflict& conflict) {
    EXPECT_EQ(index, i);
    EXPECT_EQ(weight, expected[i].weight);
    EXPECT_EQ(&copy.conflict(index), &conflict);
    EXPECT_EQ(written(Constraint{expected[i].name, weight, expected[i].reference, conflict}), written(expected[i])) << i;
    ++i;
  };
  copy.for_each_constraint(of_conflict, [&](std::size_t index, const ConstraintView& constraint) {
    EXPECT_EQ(index, i);
    EXPECT_EQ(constraint.as<Conflict>(), nullptr);
    EXPECT_EQ(written(constraint), written(expected[i])) << i;
    ++i;
  });
  EXPECT_EQ(i, expected.size());
}

}  // namespace
}  // namespace scenelore::engine
