// `scenelore solve` on problem files.
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "command_line.hpp"

namespace scenelore::test {
namespace {

class Solve : public CommandLine {
 protected:
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  static std::string two(const std::string& mustbe) {
    return R"({"problem":{"name":"two","mustbe":")" + mustbe + R"("},"variables":{"a":["x","y"],"b":["x","y"]},
      "functions":{"f":{"scope":["a","b"],"costs":[3,1.5,2,9]}}})";
  }
  /// Random costs between all pairs: no bound proves that quickly.
  static std::string hard() {
    std::string text = "hard 60 8 1770 1000000\n";
    for (int v = 0; v < 60; ++v) text += "8 ";
    unsigned state = 1;
    for (int a = 0; a < 60; ++a)
      for (int b = a + 1; b < 60; ++b) {
        text += "\n2 " + std::to_string(a) + " " + std::to_string(b) + " 0 64";
        for (int i = 0; i < 64; ++i) {
          state = state * 1664525u + 1013904223u;
          text += "\n" + std::to_string(i / 8) + " " + std::to_string(i % 8) + " " + std::to_string((state >> 16) % 1000);
        }
      }
    return text;
  }
};

TEST_F(Solve, PrintsOutcomeCostBoundAndAssignment) {
  write("two.cfn", two("<100"));
  const Finished text = scenelore({"solve", "@two.cfn"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, testing::HasSubstr("outcome      proved\ncost         1.5\nlower_bound  1.5\nnodes "));
  EXPECT_THAT(text.out, testing::HasSubstr("a = x\nb = y\n"));
  for (const char* bound : {"default", "paper"}) {
    const Finished answer = scenelore({"solve", "@two.cfn", "--json", "--bound", bound});
    const auto json = nlohmann::json::parse(answer.out);
    EXPECT_EQ(json["outcome"], "proved");
    EXPECT_EQ(json["cost"], 1.5);
    EXPECT_EQ(json["assignment"], (nlohmann::json{{"a", "x"}, {"b", "y"}}));
  }
}

TEST_F(Solve, TellsByItsExitCodeHowItEnded) {
  write("none.cfn", two("<1.5"));
  const Finished none = scenelore({"solve", "@none.cfn", "--json"});
  EXPECT_EQ(none.code, 1);
  EXPECT_EQ(nlohmann::json::parse(none.out)["outcome"], "infeasible");
  write("bad.cfn", "{\"variables\":");
  const Finished bad = scenelore({"solve", "@bad.cfn"});
  EXPECT_EQ(bad.code, 3);
  EXPECT_THAT(bad.err, testing::HasSubstr("bad.cfn, line 1"));
  EXPECT_EQ(scenelore({"solve", "@missing.cfn"}).code, 3);
  write("two.cfn", two("<100"));
  EXPECT_EQ(scenelore({"solve", "@two.cfn", "--bound", "best"}).code, 2);
  write("hard.wcsp", hard());
  const Finished cut = scenelore({"solve", "@hard.wcsp", "--time", "0.2", "--json"});
  EXPECT_EQ(cut.code, 5);
  const auto json = nlohmann::json::parse(cut.out);
  EXPECT_EQ(json["outcome"], "feasible");
  EXPECT_LT(json["lower_bound"], json["cost"]);
  EXPECT_LT(json["seconds"], 5);
}

TEST_F(Solve, WritesAProofThatAnybodyCanVerify) {
  write("two.cfn", two("<100"));
  write("none.cfn", two("<1.5"));
  EXPECT_EQ(scenelore({"solve", "@two.cfn", "--certificate", "@two.proof"}).code, 0);
  const Finished verified = scenelore({"solve", "@two.cfn", "--check", "@two.proof", "--json"});
  EXPECT_EQ(verified.code, 0) << verified.err;
  const auto json = nlohmann::json::parse(verified.out);
  EXPECT_EQ(json["outcome"], "proved");
  EXPECT_EQ(json["certificate"], "verified");
  EXPECT_EQ(json["cost"], 1.5);
  EXPECT_NEAR(json["lower_bound"], 1.5, 1e-9);
  EXPECT_EQ(json["assignment"], (nlohmann::json{{"a", "x"}, {"b", "y"}}));

  // Nothing is cheaper than 1.5: the same proof shows it.
  EXPECT_EQ(scenelore({"solve", "@none.cfn", "--certificate", "@none.proof"}).code, 1);
  const Finished none = scenelore({"solve", "@none.cfn", "--check", "@none.proof", "--json"});
  EXPECT_EQ(none.code, 0) << none.err;
  EXPECT_EQ(nlohmann::json::parse(none.out)["outcome"], "infeasible");

  write("two.proof", "scenelore certificate 1\nproved 1\nworld 0 1\nend\n");
  const Finished refused = scenelore({"solve", "@two.cfn", "--check", "@two.proof"});
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.err, testing::HasSubstr("two.proof: refused: line 3: this world costs"));
  EXPECT_EQ(scenelore({"solve", "@two.cfn", "--check", "@missing.proof"}).code, 3);
  write("hard.wcsp", hard());
  const Finished cut = scenelore({"solve", "@hard.wcsp", "--time", "0.1", "--certificate", "@hard.proof"});
  EXPECT_EQ(cut.code, 5);
  EXPECT_THAT(cut.err, testing::HasSubstr("a limit came before"));
}

TEST_F(Solve, KeepsTheBestAnswerWhenInterrupted) {
  write("hard.wcsp", hard());
  const pid_t child = start(full({"solve", "@hard.wcsp", "--json"}), folder_);
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  kill(child, SIGINT);
  const Finished cut = finish(child, folder_);
  EXPECT_EQ(cut.code, 5) << cut.err;
  const auto json = nlohmann::json::parse(cut.out);
  EXPECT_EQ(json["outcome"], "feasible");
  EXPECT_EQ(json["assignment"].size(), 60u);
}

}  // namespace
}  // namespace scenelore::test
