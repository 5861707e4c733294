// Thousands of random problems, all answers about each one; and the shrinking itself. Millions: the target `nightly`.
#include <gtest/gtest.h>

#include "model.hpp"
#include "shrink.hpp"

namespace scenelore::engine {
namespace {

TEST(Models, OfAllShapesAgreeWithEnumerationInEveryAnswer) {
  for (std::uint64_t number = 0; number < 4000; ++number) ASSERT_EQ(testing::report(number), "");
}

TEST(Shrinking, LeavesOnlyWhatTheFaultNeeds) {
  // The "fault": a hard conflict whose first literal costs more than 3.
  const auto fails = [](const Problem& problem) {
    for (const Constraint& constraint : problem.constraints())
      if (const auto* conflict = std::get_if<Conflict>(&constraint.body); conflict != nullptr && constraint.weight == kHard)
        if (problem.variables()[static_cast<std::size_t>(conflict->a.variable)].costs[static_cast<std::size_t>(conflict->a.label)] > 3)
          return true;
    return false;
  };
  int tried = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Problem problem = testing::random_problem(seed, {.most_constraints = 20, .hard = 0.5});
    if (!fails(problem)) continue;
    ++tried;
    const Problem small = testing::shrink(problem, fails);
    ASSERT_TRUE(fails(small));
    ASSERT_EQ(small.constraints().size(), 1u);
    ASSERT_LE(small.variables().size(), 2u);
    for (const Variable& v : small.variables()) ASSERT_LE(v.labels.size(), 2u);
  }
  EXPECT_GT(tried, 50);
}

TEST(Shrinking, FindsTheFewestSupportsLiteralsAndPlainNumbers) {
  const auto fails = [](const Problem& problem) {
    bool requirement = false, cardinality = false, table = false;
    for (const Constraint& constraint : problem.constraints()) {
      if (const auto* r = std::get_if<Requirement>(&constraint.body)) requirement = requirement || r->supports.size() >= 2;
      if (const auto* c = std::get_if<Cardinality>(&constraint.body)) cardinality = cardinality || c->literals.size() >= 2;
      if (const auto* t = std::get_if<PairTable>(&constraint.body))
        for (const double entry : problem.table(t->table)) table = table || entry > 0.5;
    }
    return requirement && cardinality && table;
  };
  int tried = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Problem problem = testing::random_problem(seed, {.most_constraints = 20});
    if (!fails(problem)) continue;
    ++tried;
    const Problem small = testing::shrink(problem, fails);
    ASSERT_TRUE(fails(small));
    ASSERT_EQ(small.constraints().size(), 3u);
    for (const Constraint& constraint : small.constraints()) {
      if (const auto* r = std::get_if<Requirement>(&constraint.body)) {
        ASSERT_EQ(r->supports.size(), 2u);
      }
      if (const auto* c = std::get_if<Cardinality>(&constraint.body)) {
        ASSERT_EQ(c->literals.size(), 2u);
      }
    }
    for (const Variable& v : small.variables())
      for (const double cost : v.costs) ASSERT_EQ(cost, 0);
  }
  EXPECT_GT(tried, 20);
}

}  // namespace
}  // namespace scenelore::engine
