// How long `scenelore label FILE` takes after one changed row, the whole command: nine simulated rooms, and any scans given.
// Usage: relabel [SCAN…]. Prints the CPU time (user + system, median of several runs) and the time on the clock.
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenelore/kb/knowledge_base.hpp"

namespace {

using namespace scenelore;
namespace fs = std::filesystem;

constexpr int kRuns = 7;

struct Time {
  double cpu = 0, clock = 0;  ///< milliseconds
};

/// Runs a command with its output thrown away; it must succeed.
Time run(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const auto start = std::chrono::steady_clock::now();
  std::fflush(stdout);  // else the child prints it again
  const pid_t child = fork();
  if (child == 0) {
    if (freopen("/dev/null", "w", stdout) == nullptr) _exit(126);
    execv(words[0], words.data());
    _exit(127);
  }
  int status = 0;
  rusage used{};
  if (child < 0 || wait4(child, &status, 0, &used) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw std::runtime_error("failed: " + fmt::format("{}", fmt::join(command, " ")));
  }
  const auto milliseconds = [](const timeval& t) { return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec); };
  return {milliseconds(used.ru_utime) + milliseconds(used.ru_stime),
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count()};
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// The row that is changed: the weight of the first soft constraint, up and down by turns.
void change_a_row(const fs::path& file, int turn) {
  kb::KnowledgeBase::open(file).apply_knowledge(
      fmt::format("UPDATE class_constraint SET weight = weight {} 0.01 WHERE id = (SELECT min(id) FROM class_constraint "
                  "WHERE weight IS NOT NULL AND enabled)", turn % 2 == 0 ? '+' : '-'), "benchmark");
}

}  // namespace

int main(int argc, char** argv) {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "scenelore";
  const fs::path folder = fs::temp_directory_path() / ("scenelore_relabel_" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::vector<fs::path> scans;
  const auto simulate = [&](const std::string& name, std::vector<std::string> options) {
    scans.push_back(folder / (name + ".ply"));
    std::vector<std::string> command{program.string(), "simulate", scans.back().string()};
    command.insert(command.end(), options.begin(), options.end());
    run(command);
  };
  int code = 0;
  try {
    for (const char* seed : {"7", "11", "12"}) simulate(std::string("room ") + seed, {"--seed", seed});
    for (const char* room : {"1", "2", "3", "4", "5", "6"}) {
      simulate(std::string("paper room ") + room, {"--seed", "5001", "--paper-room", room});
    }
    for (int i = 1; i < argc; ++i) scans.emplace_back(argv[i]);
    fmt::print("{:<24} {:>6} {:>9} {:>9}\n", "scan", "planes", "CPU ms", "clock ms");
    std::vector<double> medians;
    for (const fs::path& scan : scans) {
      const fs::path file = folder / (scan.stem().string() + ".gpkg");
      run({program.string(), "segment", scan.string(), "--kb", file.string()});
      run({program.string(), "label", file.string()});
      std::vector<double> cpu, clock;
      for (int turn = 0; turn < kRuns; ++turn) {
        change_a_row(file, turn);
        const Time time = run({program.string(), "label", file.string()});
        cpu.push_back(time.cpu);
        clock.push_back(time.clock);
      }
      const kb::KnowledgeBase base = kb::KnowledgeBase::open(file, kb::Access::read_only);
      medians.push_back(median(cpu));
      fmt::print("{:<24} {:>6} {:>9.0f} {:>9.0f}\n", scan.stem().string(), base.planes(base.scans().at(0).id).size(), medians.back(),
                 median(clock));
    }
    fmt::print("median {:.0f} ms, worst {:.0f} ms of CPU time\n", median(medians), *std::max_element(medians.begin(), medians.end()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    code = 1;
  }
  fs::remove_all(folder);
  return code;
}
