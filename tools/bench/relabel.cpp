// How long `scenelore label FILE` takes after one changed row, and after one edited rule, the whole command: eleven simulated
// rooms, and any scans given; and how long `scenelore watch FILE --every 10`, which stays in memory, takes after an edited rule.
// Usage: relabel [SCAN…]. Prints the CPU time (user + system, median of several runs) and the time on the clock, which for
// `watch` has up to 10 ms in it until it looks again.
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <ctime>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
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

/// As execv wants them, good as long as the command is.
std::vector<char*> words_of(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  return words;
}

/// Runs a command with its output thrown away; it must succeed.
Time run(const std::vector<std::string>& command) {
  const std::vector<char*> words = words_of(command);
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

/// A `scenelore watch` at work; it hears of an edit as it does from a person's editor, by the file alone.
class Watch {
 public:
  explicit Watch(const std::vector<std::string>& command) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    const std::vector<char*> words = words_of(command);
    std::fflush(stdout);
    child_ = fork();
    if (child_ == 0) {
      dup2(ends[1], STDOUT_FILENO);
      close(ends[0]);
      execv(words[0], words.data());
      _exit(127);
    }
    close(ends[1]);
    answers_ = fdopen(ends[0], "r");
    if (child_ < 0 || answers_ == nullptr || clock_getcpuclockid(child_, &cpu_) != 0) throw std::runtime_error("watch does not start");
    wait_for_answer();
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch() {
    kill(child_, SIGTERM);
    waitpid(child_, nullptr, 0);
    std::fclose(answers_);
  }

  template <typename Change>
  Time time(Change change) {
    const double before = cpu();
    const auto start = std::chrono::steady_clock::now();
    change();
    wait_for_answer();
    return {cpu() - before, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count()};
  }

 private:
  [[nodiscard]] double cpu() const {
    timespec used{};
    clock_gettime(cpu_, &used);
    return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
  }
  /// "room: 83 planes, proved", which comes with what changed when all is stored.
  void wait_for_answer() {
    for (char line[512]; std::fgets(line, sizeof line, answers_) != nullptr;) {
      if (std::string(line).find(" planes, ") != std::string::npos) return;
    }
    throw std::runtime_error("watch ended");
  }

  pid_t child_ = -1;
  clockid_t cpu_{};
  std::FILE* answers_ = nullptr;
};

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

/// The rule that is edited: `above` with another tolerance, in the folder of rules beside the files.
void edit_a_rule(const fs::path& folder, int turn) {
  fs::create_directories(folder / "rules");
  std::ofstream(folder / "above.new")
      << fmt::format("return relation {{ name = \"above\", extends = \"above\", enough = {} }}\n", turn % 2 == 0 ? 0.45 : 0.4);
  fs::rename(folder / "above.new", folder / "rules" / "above.lua");  // in one step: `watch` never sees half of it
}

/// Medians of several measurements.
template <typename Measure>
Time median_time(Measure measure) {
  std::vector<double> cpu, clock;
  for (int turn = 0; turn < kRuns; ++turn) {
    const Time time = measure(turn);
    cpu.push_back(time.cpu);
    clock.push_back(time.clock);
  }
  return {median(cpu), median(clock)};
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
    // Seen from three places: 100 planes and more.
    for (const char* seed : {"6", "16"}) simulate(std::string("three poses ") + seed, {"--seed", seed, "--poses", "3"});
    for (int i = 1; i < argc; ++i) scans.emplace_back(argv[i]);
    fmt::print("{:<24} {:>6} {:>18} {:>18} {:>18}\n{:<24} {:>6} {:>9}{:>9} {:>9}{:>9} {:>9}{:>9}\n", "", "", "after a row", "after a rule",
               "a rule, in watch", "scan", "planes", "CPU ms", "clock", "CPU ms", "clock", "CPU ms", "clock");
    std::vector<double> row_times, rule_times, watch_times;
    for (const fs::path& scan : scans) {
      const fs::path home = folder / ("of " + scan.stem().string());
      fs::create_directories(home);
      const fs::path file = home / "room.gpkg";
      run({program.string(), "segment", scan.string(), "--kb", file.string()});
      const std::vector<std::string> label{program.string(), "label", file.string()};
      run(label);
      const Time row = median_time([&](int turn) {
        change_a_row(file, turn);
        return run(label);
      });
      edit_a_rule(home, 1);
      run(label);
      const Time rule = median_time([&](int turn) {
        edit_a_rule(home, turn);
        return run(label);
      });
      Watch watch({program.string(), "watch", file.string(), "--every", "10"});
      const Time watched = median_time([&](int turn) { return watch.time([&] { edit_a_rule(home, turn + kRuns); }); });
      row_times.push_back(row.cpu);
      rule_times.push_back(rule.cpu);
      watch_times.push_back(watched.cpu);
      const kb::KnowledgeBase base = kb::KnowledgeBase::open(file, kb::Access::read_only);
      fmt::print("{:<24} {:>6} {:>9.0f}{:>9.0f} {:>9.0f}{:>9.0f} {:>9.0f}{:>9.0f}\n", scan.stem().string(), base.planes(base.scans().at(0).id).size(), row.cpu,
                 row.clock, rule.cpu, rule.clock, watched.cpu, watched.clock);
    }
    const auto worst = [](const std::vector<double>& times) { return *std::max_element(times.begin(), times.end()); };
    fmt::print("CPU time after a row: median {:.0f} ms, worst {:.0f} ms; after a rule: median {:.0f} ms, worst {:.0f} ms; in watch: median {:.0f} ms, "
               "worst {:.0f} ms\n", median(row_times), worst(row_times), median(rule_times), worst(rule_times), median(watch_times),
               worst(watch_times));
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    code = 1;
  }
  fs::remove_all(folder);
  return code;
}
