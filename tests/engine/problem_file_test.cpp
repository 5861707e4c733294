// Problem files: what we write is what we read, small files with known answers, and files that are wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "random_problem.hpp"
#include "scenelore/engine/cfn.hpp"
#include "scenelore/engine/error.hpp"
#include "scenelore/engine/problem_file.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {
namespace {

ProblemFile read(const std::string& text, FileFormat format) {
  std::istringstream in(text);
  return read_problem(in, "file", format);
}

/// Cost of the best world in the file's terms; infinite when there is none.
double best_of(const ProblemFile& file) {
  const Solution best = Solver(file.problem).solve({.fixed = {}, .forbidden = {}, .below = file.below});
  return best.assignment.empty() ? kHard : file.in_file(best.cost);
}

std::string why_not(const std::string& text, FileFormat format) {
  try {
    read(text, format);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

const char* const kTwo = R"({"problem":{"name":"two","mustbe":"<100.0"},
"variables":{"a":["x","y"],"b":["x","y","z"]},
"functions":{"fa":{"scope":["a"],"costs":[0.5,0]},
"fab":{"scope":["a","b"],"defaultcost":4,"costs":["x","y",1.5,1,2,2]}}})";

TEST(CfnFile, NamesAndNumbersOfLabelsMeanTheSame) {
  const ProblemFile file = read(kTwo, FileFormat::cfn);
  ASSERT_EQ(file.variables.size(), 2u);
  EXPECT_EQ(file.problem.variables()[1].labels[2], "z");
  EXPECT_NEAR(best_of(file), 2, 1e-9);
}

TEST(CfnFile, NegativeCostsMaximisationAndSharedTablesAreUnderstood) {
  const std::string text = R"({"problem":{"name":"m","mustbe":">-5"}, "variables":{"a":2,"b":2,"c":2},
    "functions":{"f":{"scope":["a","b"],"costs":[-1,2,3,-4]},"g":{"scope":["b","c"],"costs":"f"},
    "h":{"scope":["c"],"costs":[0,-7]}}})";
  // a, b, c = v1, v0, v1: 3 + 2 − 7; v1, v0, v0: 3 − 1; v0, v1, v0: 2 + 3.
  EXPECT_NEAR(best_of(read(text, FileFormat::cfn)), 5, 1e-9);
}

TEST(CfnFile, WorldsThatReachTheBoundDoNotCount) {
  std::string text = kTwo;
  text.replace(text.find("100.0"), 5, "2.000");
  EXPECT_TRUE(std::isinf(best_of(read(text, FileFormat::cfn))));
  text.replace(text.find("2.000"), 5, "2.001");
  EXPECT_NEAR(best_of(read(text, FileFormat::cfn)), 2, 1e-9);
}

TEST(CfnFile, WhatIsWrittenHasTheSameOptimumWhenRead) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const Problem problem = testing::random_problem(seed + 77, {.hard = 0.25});
    std::ostringstream out;
    write_cfn(problem, out);
    const ProblemFile file = read(out.str(), FileFormat::cfn);
    const Solution ours = Solver(problem).solve();
    const double theirs = best_of(file);
    if (ours.assignment.empty())
      ASSERT_TRUE(std::isinf(theirs));
    else
      ASSERT_NEAR(theirs, ours.cost, 1e-4);
  }
}

TEST(WcspFile, TablesDefaultsSharedOnesAndConstantsAreUnderstood) {
  // Two variables that differ at cost 5, a shared table, a function of three variables, a constant.
  const std::string text =
      "p 3 2 5 100\n2 2 2\n-2 0 1 5 2\n0 1 0\n1 0 0\n2 1 2 0 -1\n3 0 1 2 7 1\n0 1 0 1\n1 0 0 1\n1 3\n0 4 0\n";
  EXPECT_NEAR(best_of(read(text, FileFormat::wcsp)), 0 + 0 + 1 + 0 + 4, 1e-9);
}

TEST(UaiFile, TheBestWorldIsThatOfGreatestProduct) {
  const std::string text = "MARKOV\n2\n2 3\n2\n1 0\n2 0 1\n2 0.25 0.75\n6 0.5 0.1 0.1 0.2 0.3 0\n";
  EXPECT_NEAR(best_of(read(text, FileFormat::uai)), -std::log(0.75 * 0.3), 1e-9);
}

TEST(ProblemFiles, ThatAreWrongAreRefusedByLineAndName) {
  EXPECT_NE(why_not("p 1 2 1 10\n2\n2 0 7 0 0", FileFormat::wcsp).find("line 3"), std::string::npos);
  EXPECT_NE(why_not("p 1 2 1 10\n2\n1 0 -1 salldiff var 3", FileFormat::wcsp).find("salldiff"), std::string::npos);
  EXPECT_NE(why_not("p 1 2 1 10\n99999999999", FileFormat::wcsp).find("domain size"), std::string::npos);
  EXPECT_NE(why_not("p 9999999 2 1 10\n2", FileFormat::wcsp).find("number of variables"), std::string::npos);
  EXPECT_NE(why_not("GRAPH 1", FileFormat::uai).find("MARKOV"), std::string::npos);
  EXPECT_NE(why_not("MARKOV 1 2 1 1 0 2 0.5 -1", FileFormat::uai).find("negative"), std::string::npos);
  EXPECT_NE(why_not("MARKOV 1 2 1 1 0 2 nan 1", FileFormat::uai).find("nan"), std::string::npos);
  EXPECT_NE(why_not("MARKOV 1 2 1 1 0 3 0.5 1 1", FileFormat::uai).find("product of its domain sizes"), std::string::npos);
  EXPECT_NE(why_not(R"({"variables":{"a":2,"a":3}})", FileFormat::cfn).find("two variables 'a'"), std::string::npos);
  EXPECT_NE(why_not(R"({"variables":{"a":2},"functions":{"f":{"scope":["b"],"costs":[0,0]}}})", FileFormat::cfn)
                .find("no variable 'b'"),
            std::string::npos);
  EXPECT_NE(why_not(R"({"variables":{"a":2},"functions":{"f":{"scope":["a"],"type":"salldiff"}}})", FileFormat::cfn)
                .find("salldiff"),
            std::string::npos);
  EXPECT_NE(why_not(R"({"variables":{"a":2},"functions":{"f":{"scope":["a"],"costs":[1]}}})", FileFormat::cfn)
                .find("1 costs for 2 tuples"),
            std::string::npos);
  EXPECT_THROW(read_problem_file("there is no such file.cfn"), FileError);
  EXPECT_THROW(read_problem_file("problem.xml"), FileError);
  EXPECT_THROW(read_problem_file("problem.cfn.xz"), FileError);
}

TEST(ProblemFiles, ThatAreCutShortAreRefusedOrReadButNeverCrash) {
  const std::string uai = "MARKOV\n2\n2 3\n2\n1 0\n2 0 1\n2 0.25 0.75\n6 0.5 0.1 0.1 0.2 0.3 0.7";
  const std::string wcsp = "p 3 2 2 100\n2 2 2\n-2 0 1 5 2\n0 1 0\n1 0 0\n2 1 2 0 -1";
  for (const auto& [text, format] : {std::pair{std::string(kTwo), FileFormat::cfn}, {uai, FileFormat::uai}, {wcsp, FileFormat::wcsp}})
    for (std::size_t length = 0; length + 3 < text.size(); ++length)
      EXPECT_NE(why_not(text.substr(0, length), format), "") << length;
}

TEST(ProblemFiles, WithDamagedBytesAreRefusedOrReadButNeverCrash) {
  testing::Random random(5);
  const std::string alphabet = "{}[]:,\" -0129ex.\n\xff";
  for (int round = 0; round < 3000; ++round) {
    std::string text = kTwo;
    for (int i = 0; i < 3; ++i)
      text[static_cast<std::size_t>(random.below(static_cast<int>(text.size())))] =
          alphabet[static_cast<std::size_t>(random.below(static_cast<int>(alphabet.size())))];
    try {
      const ProblemFile file = read(text, FileFormat::cfn);
      EXPECT_GE(file.variables.size(), 0u);
    } catch (const FileError&) {
    } catch (const Error&) {
    }
  }
}

TEST(ProblemFiles, ThatWeWroteHaveTheirRequirementsAndCardinalitiesBack) {
  Problem problem;
  for (int v = 0; v < 4; ++v) problem.add_variable("v" + std::to_string(v), {"a", "b", "c"}, {0.5, 0.25 * v, 1});
  problem.add("needs", kHard, -1, Requirement{{0, 1}, {{{1, 0}, 0.125}, {{1, 2}, 0}, {{3, 0}, 0.75}}});
  problem.add("should have", 1.5, -1, Requirement{{2, 0}, {{{0, 0}, 0}, {{3, 1}, 0}}});
  problem.add("at most one", 0.3333333, -1, Cardinality{{}, {{0, 0}, {1, 0}, {2, 0}, {3, 0}}, 0, 1});
  problem.add("one or two", kHard, -1, Cardinality{Literal{3, 2}, {{0, 1}, {1, 1}, {1, 2}, {2, 1}}, 1, 2});
  std::stringstream text;
  write_cfn(problem, text);
  const ProblemFile file = read_problem(text, "problem", FileFormat::cfn);
  EXPECT_EQ(file.variables.size(), 4u + 2 + 7);
  EXPECT_EQ(file.followers.size(), 9u);
  ASSERT_EQ(file.problem.variables().size(), 4u);
  ASSERT_EQ(file.problem.constraints().size(), 4u);
  int requirements = 0, cardinalities = 0;
  for (const Constraint& constraint : file.problem.constraints()) {
    if (const auto* requirement = std::get_if<Requirement>(&constraint.body)) {
      ++requirements;
      EXPECT_EQ(requirement->supports.size(), (requirement->literal == Literal{0, 1} ? 3u : 2u));
    }
    if (const auto* cardinality = std::get_if<Cardinality>(&constraint.body)) {
      ++cardinalities;
      EXPECT_EQ(cardinality->literals.size(), 4u);
      EXPECT_EQ(cardinality->condition, (cardinality->low == 1 ? std::optional(Literal{3, 2}) : std::nullopt));
    }
  }
  EXPECT_EQ(requirements, 2);
  EXPECT_EQ(cardinalities, 2);
  EXPECT_NEAR(Solver(file.problem).solve().cost + file.constant, Solver(problem).solve().cost, 1e-5);
  // v0 = b is held up by v1 = c, its cheapest support there; two of {v0 = b, v1 = b or c, v2 = b}.
  EXPECT_EQ(file.in_file({1, 2, 2, 2}), (std::vector<int>{1, 2, 2, 2, 2, 0, 0, 0, 0, 0, 1, 2, 2}));
}

}  // namespace
}  // namespace scenelore::engine
