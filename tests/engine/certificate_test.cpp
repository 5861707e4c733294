// Proofs on paper: what the engine writes is accepted, what somebody else changes is accepted only when it is still true.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "plane_problem.hpp"
#include "random_problem.hpp"
#include "scenelore/engine/certificate.hpp"
#include "scenelore/engine/error.hpp"

namespace scenelore::engine {
namespace {

using testing::all_worlds;
using testing::random_problem;
using testing::Shape;

Verdict verified(const Problem& problem, const std::string& text) {
  std::istringstream in(text);
  return verify(problem, in);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// What a certificate says is so, and what it says is what enumeration says.
void expect_true(const Problem& problem, const Verdict& verdict, double tolerance) {
  const auto worlds = all_worlds(problem);
  if (verdict.outcome == Outcome::infeasible) {
    ASSERT_TRUE(worlds.empty());
    return;
  }
  ASSERT_FALSE(worlds.empty());
  ASSERT_NEAR(verdict.cost, worlds[0].first, tolerance);
  ASSERT_LE(verdict.tolerance, tolerance);
  ASSERT_EQ(check(problem, verdict.assignment).cost, verdict.cost);
}

class Certificates : public ::testing::TestWithParam<std::pair<const char*, Shape>> {
 protected:
  Problem problem(std::uint64_t seed) const { return random_problem(seed * 104729 + 7, GetParam().second); }
  double tolerance() const { return 1e-6 * GetParam().second.largest; }
};

TEST_P(Certificates, ShowTheOptimumOfSmallProblems) {
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE(seed);
    const Problem p = problem(seed);
    const Solution solution = Solver(p).solve();
    const auto text = certificate(p, solution);
    ASSERT_TRUE(text);
    const Verdict verdict = verified(p, *text);
    ASSERT_TRUE(verdict.accepted) << verdict.reason << '\n' << *text;
    ASSERT_EQ(verdict.outcome, solution.outcome);
    ASSERT_EQ(verdict.assignment, solution.assignment);
    expect_true(p, verdict, tolerance());
  }
}

TEST_P(Certificates, ThatWereChangedAreAcceptedOnlyWhenTheyAreStillTrue) {
  int refused = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const Problem p = problem(seed);
    const auto original = lines_of(*certificate(p, Solver(p).solve()));
    testing::Random random(seed);
    for (int attempt = 0; attempt < 12; ++attempt) {
      auto lines = original;
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(lines.size())));
      const auto other = static_cast<std::size_t>(random.below(static_cast<int>(lines.size())));
      switch (random.below(5)) {
        case 0:
          lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at));
          break;
        case 1:
          lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), lines[other]);
          break;
        case 2:
          std::swap(lines[at], lines[other]);
          break;
        default: {  // another number somewhere
          std::istringstream in(lines[at]);
          std::vector<std::string> words;
          for (std::string word; in >> word;) words.push_back(word);
          auto& word = words[static_cast<std::size_t>(random.below(static_cast<int>(words.size())))];
          word = random.chance(0.5) ? std::to_string(random.below(6))
                                    : std::to_string(static_cast<std::int64_t>(random.next() >> random.below(60)) - 3);
          lines[at].clear();
          for (const std::string& w : words) lines[at] += w + ' ';
        }
      }
      const Verdict verdict = verified(p, joined(lines));
      if (verdict.accepted)
        expect_true(p, verdict, tolerance());
      else
        ++refused;
      if (HasFatalFailure()) FAIL() << joined(original) << "\nchanged to\n" << joined(lines);
    }
  }
  EXPECT_GT(refused, 1000);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Certificates,
    ::testing::Values(std::pair{"mixed", Shape{}},
                      std::pair{"soft", Shape{.most_constraints = 14, .hard = 0, .forbidden = 0}},
                      std::pair{"hard", Shape{.most_constraints = 16, .hard = 0.9, .forbidden = 0.2}},
                      std::pair{"dense", Shape{.most_variables = 5, .most_constraints = 25, .hard = 0.15}},
                      std::pair{"huge", Shape{.largest = 1e9}}),
    [](const auto& shape) { return shape.param.first; });

TEST(Certificate, ShowsTheAnswerOfRoomsThatNeedASearch) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Problem p = testing::plane_problem(seed, {.planes = 30, .truth = seed == 3 ? 0.0 : 1.5, .graded = seed == 2});
    const Solution solution = Solver(p).solve();
    const auto text = certificate(p, solution);
    ASSERT_TRUE(text);
    const Verdict verdict = verified(p, *text);
    ASSERT_TRUE(verdict.accepted) << verdict.reason;
    EXPECT_EQ(verdict.cost, solution.cost);
  }
}

/// Three places in a row: neighbours differ, the cheapest labels are the same everywhere, and one of the labels is dear.
Problem small() {
  Problem p;
  for (const char* name : {"a", "b", "c"}) p.add_variable(name, {"x", "y", "z"}, {0, 1, 40});
  p.add("differ", kHard, 0, PairTable{0, 1, p.add_table(3, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1})});
  p.add("differ", 8, 0, PairTable{1, 2, 0});
  p.add("a y", 2, 0, Requirement{{2, 0}, {{{0, 1}, 0}, {{1, 1}, 1.5}}});
  return p;
}

TEST(Certificate, IsRefusedWhateverHasBeenTamperedWith) {
  const Problem p = small();
  const Solution solution = Solver(p).solve();
  ASSERT_EQ(solution.outcome, Outcome::proved);
  const std::string text = *certificate(p, solution);
  ASSERT_TRUE(verified(p, text).accepted) << verified(p, text).reason;
  const auto lines = lines_of(text);
  const auto reason = [&](std::size_t line, const std::string& instead) {
    auto changed = lines;
    changed[line] = instead;
    const Verdict verdict = verified(p, joined(changed));
    EXPECT_FALSE(verdict.accepted) << joined(changed);
    return verdict.reason;
  };
  const auto first = [&](const std::string& start) {
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].starts_with(start)) return i;
    ADD_FAILURE() << "no line starts with " << start << '\n' << text;
    return std::size_t{0};
  };
  const auto has = [](const std::string& all, const char* part) { return all.find(part) != std::string::npos; };
  const std::string unit_cost = lines[1].substr(7);
  EXPECT_TRUE(has(reason(0, "scenelore certificate 2"), "line 1: 'scenelore certificate 1' is expected"));
  EXPECT_TRUE(has(reason(1, "proved " + std::to_string(std::stoll(unit_cost) - 1)), "units, not"));  // cheaper
  EXPECT_TRUE(has(reason(1, "proved " + std::to_string(std::stoll(unit_cost) + 1)), "units, not"));  // dearer
  EXPECT_TRUE(has(reason(1, "infeasible"), "line 3"));
  EXPECT_TRUE(has(reason(2, "world 0 0 1"), "breaks a hard constraint"));
  EXPECT_TRUE(has(reason(2, "world 1 0"), "a whole number is expected"));
  EXPECT_TRUE(has(reason(2, "world 1 0 3"), "has no label 3"));
  EXPECT_TRUE(has(reason(2, "world 1 0 1 0"), "one word too many"));
  EXPECT_TRUE(has(reason(first("-"), "- 0 0"), "may be in a world cheaper"));
  EXPECT_TRUE(has(reason(first("part"), "part " + unit_cost + " 0 1 2 2"), "in a part already"));
  EXPECT_TRUE(has(reason(first("part"), "part " + unit_cost + " 0 1 9"), "there is no variable 9"));
  EXPECT_TRUE(has(reason(first("part"), "part none 0 1 2"), "less than impossible"));
  EXPECT_TRUE(has(reason(first("part"), "part 1 0 1 2"), "less than the claim"));
  EXPECT_FALSE(reason(first("part"), "part " + unit_cost + " 0 1").empty());  // a variable with its costs left out
  EXPECT_TRUE(has(reason(first("p "), "p 0 1 2 0 5"), "no such variable or label"));
  EXPECT_TRUE(has(reason(first("p "), "p 0 2 0 0 5"), "no constraint between"));
  EXPECT_TRUE(has(reason(first("p "), "c 0 0 0 5"), "no such constraint of many variables"));
  EXPECT_TRUE(has(reason(first("p "), "p 0 1 0 0 9223372036854775807"), "too large"));
  EXPECT_TRUE(has(reason(first("p "), "q 0 1 0 0 5"), "means nothing"));
  EXPECT_TRUE(has(reason(first("end"), ")"), "no '('"));
  EXPECT_TRUE(has(reason(first("end"), "( 0 9"), "has no label 9"));
  auto cut = lines;
  cut.pop_back();
  EXPECT_TRUE(has(verified(p, joined(cut)).reason, "'end' is missing"));
  EXPECT_TRUE(has(verified(p, text + "end\n").reason, "goes on after 'end'"));
  EXPECT_TRUE(has(verified(p, "").reason, "line 1"));
  Problem other = small();
  other.set_cost({1, 0}, 0.5);
  EXPECT_FALSE(verified(other, text).accepted);  // the proof of another problem
  Problem freer = small();
  freer.drop(0);
  EXPECT_FALSE(verified(freer, text).accepted);
}

TEST(Certificate, ThatNothingIsPossibleNeedsAProofToo) {
  Problem p;
  for (const char* name : {"a", "b", "c"}) p.add_variable(name, {"x", "y"}, {0, 1});
  const int differ = p.add_table(2, 2, {1, 0, 0, 1});
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}}) p.add("differ", kHard, 0, PairTable{a, b, differ});
  const std::string claim = "scenelore certificate 1\ninfeasible\n";
  EXPECT_FALSE(verified(p, claim + "end\n").accepted);
  EXPECT_FALSE(verified(p, claim + "part none 0 1 2\nend\n").accepted);
  EXPECT_FALSE(verified(p, claim + "part 4 0 1 2\nend\n").accepted);
  EXPECT_FALSE(verified(p, claim + "- 0 0\nend\n").accepted);
  p.add("differ", kHard, 0, PairTable{0, 2, differ});
  const Solution none = Solver(p).solve();
  ASSERT_EQ(none.outcome, Outcome::infeasible);
  const std::string text = *certificate(p, none);
  EXPECT_TRUE(verified(p, text).accepted) << verified(p, text).reason;
  EXPECT_TRUE(text.find("( ") != std::string::npos) << "three places and two labels need a branch";
  EXPECT_FALSE(verified(p, claim + "part none 0 1 2\nend\n").accepted) << "without the branch there is no proof";
}

TEST(Certificate, StopsAtItsLimitsAndRefusesWhatIsNotProved) {
  const Problem p = testing::plane_problem(3, {.planes = 40, .truth = 0.0});
  const Solution solution = Solver(p).solve();
  EXPECT_FALSE(certificate(p, solution, {.limits = {}, .most_bytes = 10000}));
  EXPECT_FALSE(certificate(p, solution, {.limits = {.nodes = 1}}));
  Solution cut = solution;
  cut.outcome = Outcome::feasible;
  EXPECT_THROW(certificate(p, cut), Error);
  Solution worse = solution;
  worse.assignment = Solver(p).k_best(2)[1].assignment;
  EXPECT_THROW(certificate(p, worse), Error);
  Solution none = solution;
  none.outcome = Outcome::infeasible;
  EXPECT_THROW(certificate(p, none), Error);
}

}  // namespace
}  // namespace scenelore::engine
