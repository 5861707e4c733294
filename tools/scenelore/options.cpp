#include "options.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <sstream>

#include "scenelore/kb/error.hpp"
#include "usage_error.hpp"

namespace scenelore::tools {

namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

extern "C" void on_interrupt(int) { interrupted.store(true); }

Eigen::Vector3d parse_direction(const std::string& text) {
  if (text == "x") return Eigen::Vector3d::UnitX();
  if (text == "y") return Eigen::Vector3d::UnitY();
  if (text == "z") return Eigen::Vector3d::UnitZ();
  std::istringstream stream(text);
  Eigen::Vector3d direction;
  char comma1 = 0, comma2 = 0;
  if (!(stream >> direction.x() >> comma1 >> direction.y() >> comma2 >> direction.z()) || comma1 != ',' || comma2 != ',' ||
      !stream.eof() || !direction.allFinite() || direction.norm() < 1e-9) {
    throw UsageError(fmt::format("--up '{}' is no direction: give x, y, z or three numbers like 0,0,1", text));
  }
  return direction.normalized();
}

}  // namespace

std::vector<Argument> PerceptionArguments::arguments() {
  const Effect result = Effect::result;
  return {
      {"--max-point-distance", &parameters.max_point_distance, "m",
       "largest distance between neighbouring points of a plane (default: from the cloud's spacing)", result, 1e-6, 1e6},
      {"--max-plane-distance", &parameters.max_plane_distance, "m",
       "largest distance of a point to its plane (default: from the cloud's noise)", result, 1e-9, 1e6},
      {"--max-mse", &parameters.max_mse, "m2", "largest mean squared error of a plane (default: from the cloud's noise)", result,
       1e-18, 1e12},
      {"--min-points", &parameters.min_points, "N", "smallest number of points of a plane (default: from the cloud's density)",
       result, 3, 1e9},
      {"--max-neighbours", &parameters.max_neighbours, "N", "with how many neighbours one point is compared at most", result, 1,
       1e6},
      {"--up", &up, "x|y|z|X,Y,Z", "up direction in the file's frame (default: estimated from the planes)", result},
      {"--floor", &floor, "m", "floor level along the up direction (default: estimated from the planes)", result},
      {"--threads", &threads, "N", "threads; the result does not depend on them", Effect::speed, 1, 256},
  };
}

perception::PerceptionOptions PerceptionArguments::options() const {
  perception::PerceptionOptions options{.parameters = parameters, .floor_z = floor, .threads = threads};
  if (up) options.up = parse_direction(*up);
  return options;
}

std::vector<Argument> RuleArguments::arguments() {
  const Effect result = Effect::result;
  return {
      {"--rules", &folders, "DIR", "folder of relation and feature files besides the built-in ones; may be repeated (default: the "
       "folder `rules` beside the knowledge base, if there is one)", result},
      {"--rule-instructions", &instructions, "N", "what one call into a rule file may take: Lua instructions", result, 1000, 1e15},
      {"--rule-time", &milliseconds, "ms", "and time", result, 1, 1e9},
      {"--rule-memory", &megabytes, "MB", "and memory of its state", result, 1, 1e6},
      {"--relation-time", &seconds, "s", "what all calls of one relation on one scan may take", result, 0.001, 1e9},
  };
}

rules::Budget RuleArguments::budget() const {
  rules::Budget budget;
  budget.instructions = static_cast<std::int64_t>(instructions);
  budget.time = std::chrono::milliseconds(static_cast<std::int64_t>(milliseconds));
  budget.memory_bytes = static_cast<std::size_t>(megabytes * (1 << 20));
  budget.total = std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1e3));
  return budget;
}

rules::RuleSet RuleArguments::load(const kb::KnowledgeBase& base, const std::string& file) const {
  return pipeline::load_rules(base, file, folders, budget());
}

std::vector<Argument> LabellingArguments::arguments() {
  return joined(rules.arguments(), std::vector<Argument>{
      {"--time", &seconds, "s", "stop the search of one scan after so long and keep the best answer so far", Effect::result, 0, 1e9},
      {"--nodes", &nodes, "N", "stop the search of one scan after so many nodes", Effect::result, 0, 1e18},
      {"--alternatives", &alternatives, "N", "how many further world models to store", Effect::output, 0, 100},
      {"--paper-bound", &paper_bound, "", "search with the paper's plain heuristic instead of soft local consistency",
       Effect::speed},
      {"--no-reasons", &no_reasons, "", "store no reasons; the labels are the same", Effect::output},
  });
}

rules::LabellingOptions LabellingArguments::options() const {
  rules::LabellingOptions options{.alternatives = alternatives, .reasons = !no_reasons};
  options.solver.bound = paper_bound ? engine::Bound::paper : engine::Bound::soft_consistency;
  options.solver.limits.interrupt = interrupt_flag();
  if (seconds) options.solver.limits.seconds = *seconds;
  if (nodes) options.solver.limits.nodes = static_cast<std::uint64_t>(*nodes);
  return options;
}

const std::atomic<bool>* interrupt_flag() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  return &interrupted;
}

Argument isolate_argument(bool& isolate) {
  return {"--isolate", &isolate, "", "rules from strangers: load and ask them in a process that can write nothing and use up only so much",
          Effect::speed};
}

kb::Inference label_scan(kb::KnowledgeBase& base, const std::string& file, const kb::Scan& scan, const LabellingArguments& arguments,
                         bool isolate, std::optional<rules::RuleSet>& loaded) {
  if (isolate) {
    return pipeline::label_scan_isolated(base, scan, pipeline::rule_folders(file, arguments.rules.folders), arguments.rules.budget(),
                                         arguments.options());
  }
  if (!loaded) loaded = arguments.rules.load(base, file);
  return pipeline::label_scan(base, scan, *loaded, arguments.options());
}

Argument json_argument(bool& json) { return {"--json", &json, "", "print JSON"}; }

pipeline::Progress terminal_progress(const std::string& subject) {
  if (isatty(STDERR_FILENO) == 0) return [](const std::string&) {};
  return [subject](const std::string& step) { fmt::print(stderr, "{}: {}…\n", subject, step); };
}

void warn(const std::string& subject, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "{}: {}\n", subject, warning);
}

kb::Scan require_scan(const kb::KnowledgeBase& base, const std::string& file, const std::string& name) {
  const std::vector<kb::Scan> scans = base.scans();
  if (name.empty() && scans.size() == 1) return scans.front();
  std::string names;
  for (const kb::Scan& scan : scans) {
    if (scan.name == name) return scan;
    names += (names.empty() ? "" : ", ") + scan.name;
  }
  if (scans.empty()) throw kb::Error(file + ": no scan is stored yet; `scenelore segment SCAN --kb " + file + "` stores one");
  if (name.empty()) throw kb::Error(file + ": several scans are stored, name one of: " + names);
  throw kb::Error(fmt::format("{}: no scan '{}'; stored are: {}", file, name, names));
}

std::vector<kb::Scan> scans_or_all(const kb::KnowledgeBase& base, const std::string& file, const std::string& name) {
  std::vector<kb::Scan> all = base.scans();
  if (name.empty() && !all.empty()) return all;
  return {require_scan(base, file, name)};
}

kb::Scan scan_of_plane(const kb::KnowledgeBase& base, const std::string& file, kb::PlaneId plane) {
  kb::ScanId id = 0;
  base.query(
      fmt::format("SELECT scan_id FROM plane WHERE id = {}", plane), [](const std::vector<std::string>&) {},
      [&](const kb::QueryRow& row) { id = std::stoll(row.values.at(0).value()); });
  for (const kb::Scan& scan : base.scans()) {
    if (scan.id == id) return scan;
  }
  throw kb::Error(fmt::format("{}: there is no plane {}; `scenelore query {} \"SELECT plane, class FROM labelled_plane\"` lists them",
                              file, plane, file));
}

}  // namespace scenelore::tools
