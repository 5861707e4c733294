// A run that is cut short in the middle loses nothing that was in the file before.
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "command_line.hpp"

namespace scenelore::test {
namespace {

using Interruption = CommandLine;

TEST_F(Interruption, ByKillLeavesTheKnowledgeBaseWhole) {
  make_labelled();
  edit("office.gpkg", "INSERT INTO truth (plane_id, class) SELECT plane_id, class FROM label ORDER BY plane_id LIMIT 3");
  const std::string truth = ask("office.gpkg", "SELECT count(*) FROM truth");
  const std::string labels = ask("office.gpkg", "SELECT plane_id, class, probability FROM label ORDER BY plane_id");
  for (int delay_ms = 0; delay_ms < 600; delay_ms += 40) {
    const pid_t child = start(full({"run", "@office.ply", "--kb", "@office.gpkg"}), folder_);
    std::this_thread::sleep_for(std::chrono::milliseconds(delay_ms));
    kill(child, SIGKILL);
    finish(child, folder_);
    ASSERT_EQ(ask("office.gpkg", "PRAGMA integrity_check"), "ok\n") << delay_ms;
    ASSERT_EQ(ask("office.gpkg", "SELECT count(*) FROM truth"), truth) << delay_ms;
    ASSERT_EQ(ask("office.gpkg", "SELECT count(*) FROM object_class WHERE name = 'floor'"), "1\n") << delay_ms;
  }
  EXPECT_EQ(scenelore({"run", "@office.ply", "--kb", "@office.gpkg"}).code, 0);
  EXPECT_EQ(ask("office.gpkg", "SELECT count(*) FROM truth"), truth);
}

TEST_F(Interruption, ByANodeLimitKeepsTheBestAnswerSoFar) {
  make_labelled();
  // Features that say next to nothing leave the search much to find out, and the paper's heuristic needs more than one node for it.
  edit("office.gpkg", "UPDATE feature SET weight = weight / 10");
  ASSERT_EQ(scenelore({"label", "@office.gpkg"}).code, 0);
  const std::string planes = ask("office.gpkg", "SELECT count(*) FROM plane");
  const std::string optimum = ask("office.gpkg", "SELECT cost FROM run");
  const Finished cut = scenelore({"label", "@office.gpkg", "--paper-bound", "--nodes", "1"});
  EXPECT_EQ(cut.code, 5) << cut.err;
  EXPECT_EQ(ask("office.gpkg", "SELECT outcome, nodes <= 1, lower_bound < cost FROM run"), "feasible,1,1\n");
  EXPECT_EQ(ask("office.gpkg", "SELECT count(*) FROM label"), planes);
  EXPECT_EQ(ask("office.gpkg", "SELECT lower_bound <= " + optimum.substr(0, optimum.find('\n')) + " + 1e-6 FROM run"), "1\n");
  // Without the limit the same search ends with a proof.
  EXPECT_EQ(scenelore({"label", "@office.gpkg", "--paper-bound"}).code, 0);
  EXPECT_EQ(ask("office.gpkg", "SELECT outcome FROM run"), "proved\n");
}

}  // namespace
}  // namespace scenelore::test
