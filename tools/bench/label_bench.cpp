// What each step from stored planes to labels and reasons costs, in one process and in memory: rooms of 45 to 125 planes, or the
// scans of any knowledge bases given. Usage: label_bench [FILE.gpkg…]. Prints medians of the CPU time of all threads, and of the time on the clock
// where there are two.
#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/rooms.hpp"
#include "scenelore/engine/solver.hpp"
#include "scenelore/perception/memory.hpp"
#include "scenelore/rules/labelling.hpp"

namespace {

using namespace scenelore;

constexpr int kRuns = 9;

double milliseconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// The times of each part over all runs.
class Times {
 public:
  template <typename Work>
  auto measure(const std::string& part, Work work) {
    const double cpu = milliseconds(CLOCK_PROCESS_CPUTIME_ID), clock = milliseconds(CLOCK_MONOTONIC);
    auto result = work();
    cpu_[part].push_back(milliseconds(CLOCK_PROCESS_CPUTIME_ID) - cpu);
    clock_[part].push_back(milliseconds(CLOCK_MONOTONIC) - clock);
    return result;
  }
  [[nodiscard]] double of(const std::string& part) const { return median(cpu_.at(part)); }
  [[nodiscard]] double on_clock(const std::string& part) const { return median(clock_.at(part)); }

 private:
  std::map<std::string, std::vector<double>> cpu_, clock_;
};

/// What a person has in a file: knowledge, and the planes of one scan.
struct Job {
  std::string name;
  kb::Knowledge knowledge;
  kb::Scan scan;
  std::vector<kb::StoredPlane> planes;
};

/// What the knowledge base would hand out in the next run.
rules::KnownAnswers known_from(const rules::Facts& facts) {
  rules::KnownAnswers known{.facts = {}, .geometry = facts.geometry, .rules = facts.answers};
  for (const auto& [relation, asked] : facts.asked) known.facts[relation].asked = asked;
  for (const kb::RelationFact& fact : facts.facts) known.facts[fact.relation].facts.push_back(fact);
  return known;
}

/// All steps once. "rules" is loading and the first question to each rule file, which a process pays once.
void run(const Job& job, Times& times) {
  rules::RuleSet rules = times.measure("rules", [&] {
    rules::RuleSet fresh = rules::RuleSet::load({}, {}, job.knowledge.settings);
    rules::Scene none;
    fresh.compute_features(none, none.features);
    (void)fresh.relate(none, rules::used_relations(job.knowledge, fresh));
    return fresh;
  });
  const std::vector<std::string> relations = rules::used_relations(job.knowledge, rules);
  rules::Scene scene = times.measure("scene", [&] { return rules::make_scene(job.scan, job.planes, kb::built_in_features(job.scan, job.planes)); });
  times.measure("features", [&] {
    rules.compute_features(scene, scene.features);
    return 0;
  });
  const auto evidence = times.measure("preclassify", [&] { return kb::preclassify(job.knowledge, scene.features); });
  const rules::Facts facts = times.measure("relate", [&] { return rules.relate(scene, relations); });
  const rules::KnownAnswers known = known_from(facts);
  (void)times.measure("relate, facts kept", [&] { return rules.relate(scene, relations, known); });
  (void)times.measure("relate, geometry kept", [&] {
    return rules.relate(scene, relations, {.facts = {}, .geometry = known.geometry, .rules = {}});
  });
  const rules::LabellingProblem compiled = times.measure("compile", [&] { return rules::compile(job.knowledge, scene, evidence, facts, {}); });
  (void)times.measure("solve", [&] { return engine::Solver(compiled.problem).solve(); });
  const auto label = [&](const std::string& part, int alternatives, bool reasons) {
    (void)times.measure(part, [&] { return rules::label(job.knowledge, scene, evidence, facts, {}, {.alternatives = alternatives, .reasons = reasons}); });
  };
  label("labels", 0, false);
  label("labels, alternatives", 3, false);
  label("labels, alternatives, reasons", 3, true);
}

void print_head() {
  fmt::print("CPU ms of all threads, medians of {} runs; clock = ms on the clock; goal = preclassify + relate + compile + solve on the clock\n", kRuns);
  fmt::print("{:<16} {:>6} {:>6} {:>6} {:>8} {:>12} {:>12} {:>7} {:>6} {:>6} | {:>7} {:>12} {:>7} | {:>14}\n", "", "", "", "", "", "preclassify:", "relate:", "", "",
             "goal", "", "", "", "relate, kept:");
  fmt::print("{:<16} {:>6} {:>6} {:>6} {:>8} {:>6} {:>5} {:>6} {:>5} {:>7} {:>6} {:>6} | {:>7} {:>12} {:>7} | {:>5} {:>8}\n", "scan", "planes", "rules", "scene",
             "features", "CPU", "clock", "CPU", "clock", "compile", "solve", "clock", "margins", "alternatives", "reasons", "facts", "geometry");
}

void print(const Job& job, const Times& times) {
  const double labels = times.of("labels"), alternatives = times.of("labels, alternatives");
  double goal = 0;
  for (const char* part : {"preclassify", "relate", "compile", "solve"}) goal += times.on_clock(part);
  fmt::print("{:<16} {:>6} {:>6.1f} {:>6.1f} {:>8.1f} {:>6.1f} {:>5.1f} {:>6.1f} {:>5.1f} {:>7.1f} {:>6.1f} {:>6.1f} | {:>7.1f} {:>12.1f} {:>7.1f} | {:>5.1f} {:>8.1f}\n",
             job.name, job.planes.size(), times.of("rules"), times.of("scene"), times.of("features"), times.of("preclassify"), times.on_clock("preclassify"),
             times.of("relate"), times.on_clock("relate"), times.of("compile"), times.of("solve"), goal, labels - times.of("compile") - times.of("solve"),
             alternatives - labels, times.of("labels, alternatives, reasons") - alternatives, times.of("relate, facts kept"),
             times.of("relate, geometry kept"));
}

std::vector<Job> simulated_jobs() {
  const kb::Knowledge office = experiment::knowledge_pack("office");
  std::vector<Job> jobs;
  const auto add = [&](const std::string& name, const simulator::SimulationOptions& options) {
    experiment::Room room = std::move(experiment::perceive_rooms({options}, 1).front());
    jobs.push_back({name, office, room.record, std::move(room.planes)});
  };
  for (const std::uint64_t seed : {7, 11, 12}) add(fmt::format("room {}", seed), {.seed = seed});
  for (const std::uint64_t seed : {3, 17, 6, 2, 16}) add(fmt::format("three poses {}", seed), {.seed = seed, .poses = 3});
  return jobs;
}

std::vector<Job> stored_jobs(const std::string& file) {
  const kb::KnowledgeBase base = kb::KnowledgeBase::open(file, kb::Access::read_only);
  std::vector<Job> jobs;
  for (const kb::Scan& scan : base.scans()) jobs.push_back({scan.name, base.knowledge(), scan, base.planes(scan.id)});
  return jobs;
}

}  // namespace

int main(int argc, char** argv) {
  perception::keep_memory(perception::Work::labelling);  // as the program does
  try {
    std::vector<Job> jobs;
    for (int i = 1; i < argc; ++i) {
      for (Job& job : stored_jobs(argv[i])) jobs.push_back(std::move(job));
    }
    if (argc == 1) jobs = simulated_jobs();
    print_head();
    for (const Job& job : jobs) {
      Times times;
      for (int i = 0; i < kRuns; ++i) run(job, times);
      print(job, times);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
