// The same optimum as toulbar2 (https://toulbar2.github.io) on problems too large to enumerate.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "plane_problem.hpp"
#include "scenelore/engine/cfn.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {
namespace {

bool installed() { return std::system("command -v toulbar2 > /dev/null 2>&1") == 0; }

struct Answer {
  std::string last;  ///< optimum, none or unknown
  double cost = 0;
};

Answer toulbar2(const Problem& problem, const std::string& name) {
  const auto stem = std::filesystem::temp_directory_path() / ("scenelore_" + name);
  const std::string cfn = stem.string() + ".cfn", log = stem.string() + ".log";
  {
    std::ofstream file(cfn);
    write_cfn(problem, file);
  }
  if (std::system(("toulbar2 '" + cfn + "' -timer=20 > '" + log + "' 2>&1").c_str()) < 0) return {"unknown"};
  Answer answer{"unknown"};
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("Optimum: ", 0) == 0) answer = {"optimum", std::atof(line.c_str() + 9)};
    if (line.rfind("No solution in", 0) == 0) answer = {"none"};
    if (line.rfind("Time limit expired", 0) == 0) answer = {"unknown"};
  }
  std::filesystem::remove(cfn);
  std::filesystem::remove(log);
  return answer;
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
