// The same optimum as toulbar2 (https://toulbar2.github.io) on problems too large to enumerate.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "plane_problem.hpp"
#include "scenelore/engine/cfn.hpp"
#include "scenelore/engine/problem_file.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {
namespace {

bool installed() { return std::system("command -v toulbar2 > /dev/null 2>&1") == 0; }

struct Answer {
  std::string last;  ///< optimum, none or unknown
  double cost = 0;
};

Answer toulbar2_on(const std::string& text, const std::string& name, const char* ending) {
  const auto stem = std::filesystem::temp_directory_path() / ("scenelore_" + std::to_string(getpid()) + "_" + name);
  const std::string path = stem.string() + ending, log = stem.string() + ".log";
  std::ofstream(path) << text;
  if (std::system(("toulbar2 '" + path + "' -timer=20 > '" + log + "' 2>&1").c_str()) < 0) return {"unknown"};
  Answer answer{"unknown"};
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("Optimum: ", 0) == 0) {
      const std::size_t energy = line.find("energy: ");
      answer = {"optimum", std::atof(line.c_str() + (energy == std::string::npos ? 9 : energy + 8))};
    }
    if (line.rfind("No solution", 0) == 0) answer = {"none"};
    if (line.rfind("Time limit expired", 0) == 0) answer = {"unknown"};
  }
  std::filesystem::remove(path);
  std::filesystem::remove(log);
  return answer;
}

Answer toulbar2(const Problem& problem, const std::string& name) {
  std::ostringstream text;
  write_cfn(problem, text);
  return toulbar2_on(text.str(), name, ".cfn");
}

void compare(const Problem& problem, const std::string& name) {
  SCOPED_TRACE(name);
  const Answer theirs = toulbar2(problem, name);
  if (theirs.last == "unknown") return;  // too slow on this machine: nothing to compare
  const Solution ours = Solver(problem).solve();
  ASSERT_EQ(ours.outcome, theirs.last == "none" ? Outcome::infeasible : Outcome::proved);
  if (theirs.last == "none") return;
  // Its costs have six decimals.
  EXPECT_NEAR(ours.cost, theirs.cost, 1e-6 * (1 + static_cast<double>(problem.constraints().size())));
}

TEST(Toulbar2, AgreesOnRandomProblemsOfEveryKind) {
  if (!installed()) GTEST_SKIP() << "toulbar2 is not installed: nothing to compare with";
  for (std::uint64_t seed = 0; seed < 60; ++seed)
    compare(testing::random_problem(
                seed + 5000,
                {.most_variables = 14, .most_labels = 5, .most_constraints = 40, .hard = 0.15, .forbidden = 0.02}),
            "random" + std::to_string(seed));
}

TEST(Toulbar2, AgreesOnTheSameFile) {
  if (!installed()) GTEST_SKIP() << "toulbar2 is not installed: nothing to compare with";
  const auto agree = [](const std::string& text, const char* ending, FileFormat format, double of_one_cost) {
    std::istringstream in(text);
    const ProblemFile file = read_problem(in, "file", format);
    const Answer theirs = toulbar2_on(text, "file", ending);
    const Solution ours = Solver(file.problem).solve({.fixed = {}, .forbidden = {}, .below = file.below});
    ASSERT_EQ(theirs.last, ours.assignment.empty() ? "none" : "optimum") << text;
    if (!ours.assignment.empty()) {
      EXPECT_NEAR(file.in_file(ours.cost), theirs.cost, of_one_cost) << text;
    }
  };
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    testing::Random random(seed + 300);
    const int n = 3 + random.below(6);
    // Whole costs, functions of one to three variables, an upper bound that is sometimes too low.
    std::ostringstream wcsp, uai, tables;
    const int functions = 2 * n;
    wcsp << "random " << n << " 3 " << functions << " " << (random.chance(0.3) ? 12 : 1000) << "\n";
    uai << "MARKOV\n" << n << "\n";
    for (int v = 0; v < n; ++v) wcsp << "3 ", uai << "3 ";
    uai << "\n" << functions << "\n";
    wcsp << "\n";
    for (int f = 0; f < functions; ++f) {
      // In ascending order: toulbar2 1.1.1 misreads .uai tables whose scopes are other permutations of one it has met.
      const int arity = 1 + random.below(3), first = random.below(n - arity + 1);
      const int size = arity == 1 ? 3 : arity == 2 ? 9 : 27;
      wcsp << arity;
      uai << arity;
      for (int i = 0; i < arity; ++i) wcsp << " " << first + i, uai << " " << first + i;
      wcsp << " 0 " << size << "\n";
      uai << "\n";
      tables << size;
      for (int t = 0; t < size; ++t) {
        for (int i = arity - 1, place = size / 3; i >= 0; --i, place /= 3) wcsp << (t / place) % 3 << " ";
        wcsp << random.below(10) << "\n";
        tables << " " << 0.05 + 0.9 * random.real();
      }
      tables << "\n";
    }
    agree(wcsp.str(), ".wcsp", FileFormat::wcsp, 1e-9);
    // toulbar2 tells −ln of the product too, of entries that it rounds.
    agree(uai.str() + tables.str(), ".uai", FileFormat::uai, 1e-3);
  }
}

TEST(Toulbar2, AgreesOnRoomsOfPlanes) {
  if (!installed()) GTEST_SKIP() << "toulbar2 is not installed: nothing to compare with";
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    compare(testing::plane_problem(seed, {.planes = 60, .classes = 8}), "planes" + std::to_string(seed));
    compare(testing::plane_problem(
                seed, {.planes = 30, .classes = 10, .truth = 5, .reach = 0.2, .requirements = 3, .graded = true}),
            "graded" + std::to_string(seed));
  }
  compare(testing::plane_problem(9, {.planes = 120, .classes = 6, .truth = 4, .reach = 0.05}), "planes120");
}

}  // namespace
}  // namespace scenelore::engine
