// The engine beside toulbar2 on the same instances: process against process on the same .cfn file, and our time in
// process from the problem as rules/ builds it. `engine_bench SCENELORE [KB.gpkg…]`; `make engine_bench`.
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "bench/instances.hpp"
#include "pipeline/pipeline.hpp"
#include "scenelore/engine/cfn.hpp"
#include "scenelore/engine/solver.hpp"
#include "scenelore/rules/labelling.hpp"

namespace {

using namespace scenelore;
namespace fs = std::filesystem;

/// Seconds that each may take; ENGINE_BENCH_SECONDS changes it.
const double kLimit = std::getenv("ENGINE_BENCH_SECONDS") != nullptr ? std::atof(std::getenv("ENGINE_BENCH_SECONDS")) : 60;
constexpr int kRuns = 3;

struct Instance {
  std::string family, name;
  engine::Problem problem;
};

struct Timing {
  double seconds = 0;  ///< CPU, user and system
  std::optional<double> cost;
  bool none = false;
};

double cpu() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Runs a program with its output in `log`; returns its CPU time.
double run(const std::vector<std::string>& arguments, const fs::path& log) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    execvp(argv[0], argv.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

Timing toulbar2(const fs::path& file, const fs::path& log) {
  Timing timing{.seconds = run({"toulbar2", file.string(), fmt::format("-timer={}", kLimit)}, log), .cost = {}};
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("Optimum: ")) timing.cost = std::atof(line.c_str() + 9);
    if (line.starts_with("No solution")) timing.none = true;
  }
  return timing;
}

Timing scenelore_process(const std::string& program, const fs::path& file, const fs::path& log) {
  Timing timing{.seconds = run({program, "solve", file.string(), "--time", fmt::format("{}", kLimit)}, log), .cost = {}};
  std::ifstream in(log);
  std::string word, outcome;
  double cost = 0;
  while (in >> word) {
    if (word == "outcome") in >> outcome;
    if (word == "cost") in >> cost;
  }
  if (outcome == "proved") timing.cost = cost;
  timing.none = outcome == "infeasible";
  return timing;
}

Timing in_process(const engine::Problem& problem) {
  const double start = cpu();
  const engine::Solution solution = engine::Solver(problem, {.limits = {.seconds = kLimit}}).solve();
  Timing timing{.seconds = cpu() - start, .cost = {}};
  if (solution.outcome == engine::Outcome::proved) timing.cost = solution.cost;
  timing.none = solution.outcome == engine::Outcome::infeasible;
  return timing;
}

/// The run of median time.
Timing median(const std::function<Timing()>& once) {
  std::vector<Timing> runs{once()};
  while (runs.size() < kRuns && runs[0].seconds < 5) runs.push_back(once());
  std::sort(runs.begin(), runs.end(), [](const Timing& a, const Timing& b) { return a.seconds < b.seconds; });
  return runs[runs.size() / 2];
}

std::string told(const Timing& timing) {
  if (!timing.cost && !timing.none) return fmt::format("> {:.0f} s", kLimit);
  return fmt::format("{:.4f} s", timing.seconds);
}

/// False when two proofs contradict each other.
bool compare(const std::string& program, const fs::path& folder, const Instance& instance) {
  const fs::path file = folder / "instance.cfn", log = folder / "log";
  {
    std::ofstream out(file);
    engine::write_cfn(instance.problem, out);
  }
  const Timing theirs = median([&] { return toulbar2(file, log); });
  const Timing ours = median([&] { return scenelore_process(program, file, log); });
  const Timing inside = median([&] { return in_process(instance.problem); });
  const double tolerance = 1e-6 * static_cast<double>(1 + instance.problem.constraints().size() + instance.problem.variables().size());
  const auto differ = [&](const Timing& a, const Timing& b) {
    if (a.none || b.none) return (a.none && b.cost) || (b.none && a.cost);
    return a.cost && b.cost && std::abs(*a.cost - *b.cost) > tolerance;
  };
  const bool wrong = differ(theirs, ours) || differ(theirs, inside) || differ(ours, inside);
  fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", instance.family, instance.name, instance.problem.variables().size(),
             told(theirs), told(ours), told(inside),
             wrong ? "DIFFER" : inside.cost ? fmt::format("{:.4f}", *inside.cost) : inside.none ? "none" : "not proved");
  std::fflush(stdout);
  return !wrong;
}

std::vector<Instance> rooms(const std::string& file) {
  std::vector<Instance> all;
  kb::KnowledgeBase base = kb::KnowledgeBase::open(file);
  rules::RuleSet rules = pipeline::load_rules(base, file, {});
  for (const kb::Scan& scan : base.scans()) {
    const pipeline::Situation s = pipeline::assess(base, scan, rules);
    all.push_back({"(a) labelling", scan.name, rules::compile(s.knowledge, s.scene, s.evidence, s.facts, s.truth).problem});
  }
  return all;
}

std::vector<Instance> made() {
  std::vector<Instance> all;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const std::string name = fmt::format("seed {}", seed);
    for (const int planes : {60, 200, 500})
      all.push_back({"(b) random planes", fmt::format("{}, {}", planes, name), bench::random_planes(seed, planes, 8)});
    for (const int planes : {60, 200, 500})
      all.push_back({"(b) rooms with a truth", fmt::format("{}, {}", planes, name), bench::noisy_room(seed, planes, 8)});
    all.push_back({"(d) Max-CSP", name, bench::max_csp(seed, 25, 5, 0.4, 0.4)});
    all.push_back({"(d) grid MRF", name, bench::grid_mrf(seed, 15, 4)});
    all.push_back({"(d) warehouses", name, bench::warehouses(seed, 20, 50)});
    all.push_back({"(d) radio links", name, bench::radio_links(seed, 60, 12)});
  }
  all.push_back({"(c) building", "100 rooms of 50", bench::building(1, 100, 50)});
  std::stable_sort(all.begin(), all.end(), [](const Instance& a, const Instance& b) { return a.family < b.family; });
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: engine_bench SCENELORE [KB.gpkg…]\n");
    return 2;
  }
  const std::string only = std::getenv("ENGINE_BENCH_ONLY") != nullptr ? std::getenv("ENGINE_BENCH_ONLY") : "";
  const fs::path folder = fs::temp_directory_path() / fmt::format("scenelore_bench_{}", getpid());
  fs::create_directories(folder);
  fmt::print("CPU seconds, median of {} runs (one when it takes more than 5 s), limit {} s\n\n", kRuns, kLimit);
  fmt::print("| family | instance | variables | toulbar2, process | scenelore solve, process | engine, in process | optimum |\n"
             "| --- | --- | --- | --- | --- | --- | --- |\n");
  std::vector<Instance> all;
  for (int i = 2; i < argc; ++i)
    for (Instance& instance : rooms(argv[i])) all.push_back(std::move(instance));
  for (Instance& instance : made()) all.push_back(std::move(instance));
  bool agree = true;
  for (const Instance& instance : all)
    if ((instance.family + ' ' + instance.name).find(only) != std::string::npos) agree = compare(argv[1], folder, instance) && agree;
  fs::remove_all(folder);
  return agree ? 0 : 1;
}
