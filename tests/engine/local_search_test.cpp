// Local search keeps what it knows about needs and counts up to date while labels change. The checker is the oracle: where
// it ends, no change of one label may be for the better.
#include "local_search.hpp"

#include <gtest/gtest.h>

#include "random_problem.hpp"

namespace scenelore::engine {
namespace {

using testing::Random;

/// The most that a change of one label would save.
double best_step(const Problem& problem, const std::vector<int>& assignment) {
  const double now = check(problem, assignment).cost;
  double most = 0;
  for (std::size_t v = 0; v < assignment.size(); ++v) {
    std::vector<int> other = assignment;
    for (other[v] = 0; other[v] < static_cast<int>(problem.variables()[v].labels.size()); ++other[v])
      most = std::max(most, now - check(problem, other).cost);
  }
  return most;
}

/// With requirements that many variables meet, at prices of which many are equal.
Problem well_supported(std::uint64_t seed) {
  Random random(seed);
  Problem problem = testing::random_problem(seed, {.most_variables = 10, .most_constraints = 40, .hard = 0, .forbidden = 0});
  const auto literal = [&] {
    const int v = random.below(static_cast<int>(problem.variables().size()));
    return Literal{v, random.below(static_cast<int>(problem.variables()[static_cast<std::size_t>(v)].labels.size()))};
  };
  for (int r = 0; r < 10; ++r) {
    Requirement requirement{literal(), {}};
    for (int i = 0; i < 12; ++i) requirement.supports.push_back({literal(), 0.25 * random.below(4)});
    problem.add("many", 2 + random.below(3), -1, requirement);
  }
  return problem;
}

TEST(LocalSearch, EndsWhereNoChangeOfOneLabelIsForTheBetterHoweverItGotThere) {
  int changed = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = well_supported(seed);
    const Scale scale(problem);
    const Outline outline(problem, scale);
    LocalSearch search(outline);
    Budget budget{Limits{}};
    Random random(seed);
    std::vector<int> assignment = search.begin({});
    for (int turn = 0; turn < 6; ++turn) {  // each goes on from what the one before left
      for (std::size_t v = 0; v < assignment.size(); ++v)
        if (turn > 0 && random.chance(0.5)) assignment[v] = random.below(static_cast<int>(problem.variables()[v].labels.size()));
      const std::vector<int> before = assignment;
      if (turn % 2 == 0)
        search.descend(assignment, budget);
      else
        search.anneal(assignment, 20, budget);
      changed += assignment != before ? 1 : 0;
      EXPECT_LE(check(problem, assignment).cost, check(problem, before).cost + 1e-6);
      ASSERT_LE(best_step(problem, assignment), 1e-6);
    }
  }
  EXPECT_GT(changed, 2000) << "descents that go nowhere show nothing";
}

}  // namespace
}  // namespace scenelore::engine
