// Options that several commands share, as small pieces that a command holds and lists.
#pragma once

#include <cstdint>
#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "pipeline/pipeline.hpp"

namespace scenelore::tools {

/// How a scan becomes planes: the paper's five parameters, the upright frame, threads.
struct PerceptionArguments {
  perception::SegmentationParameters parameters;
  std::optional<std::string> up;
  std::optional<double> floor;
  int threads = 2;

  [[nodiscard]] std::vector<Argument> arguments();
  /// Throws UsageError for an --up that is no direction.
  [[nodiscard]] perception::PerceptionOptions options() const;
};

/// Where rules come from, and what a rule file may use up.
struct RuleArguments {
  std::vector<std::string> folders;
  double instructions = 10e6, milliseconds = 2000, megabytes = 16, seconds = 60;

  [[nodiscard]] std::vector<Argument> arguments();
  [[nodiscard]] rules::Budget budget() const;
  /// The rules of a knowledge base under these budgets.
  [[nodiscard]] rules::RuleSet load(const kb::KnowledgeBase& base, const std::string& file) const;
};

/// How planes become labels: rule folders, limits of the search.
struct LabellingArguments {
  RuleArguments rules;
  std::optional<double> seconds;
  std::optional<double> nodes;
  int alternatives = 3;
  bool paper_bound = false;
  bool no_reasons = false;

  [[nodiscard]] std::vector<Argument> arguments();
  /// Options with the interrupt flag that SIGINT and SIGTERM set.
  [[nodiscard]] rules::LabellingOptions options() const;
};

/// Set by SIGINT and SIGTERM from the first call on.
[[nodiscard]] const std::atomic<bool>* interrupt_flag();

[[nodiscard]] Argument json_argument(bool& json);

/// --isolate, for the commands that label.
[[nodiscard]] Argument isolate_argument(bool& isolate);

/// Labels one scan with the rules of the arguments, in this process or (isolate) in one of their own. `loaded` keeps the
/// rules between scans.
[[nodiscard]] kb::Inference label_scan(kb::KnowledgeBase& base, const std::string& file, const kb::Scan& scan,
                                       const LabellingArguments& arguments, bool isolate, std::optional<rules::RuleSet>& loaded);

template <typename... Lists>
[[nodiscard]] std::vector<Argument> joined(std::vector<Argument> first, const Lists&... more) {
  (first.insert(first.end(), more.begin(), more.end()), ...);
  return first;
}

/// "reading… segmenting…" on stderr when that is a terminal.
[[nodiscard]] pipeline::Progress terminal_progress(const std::string& subject);

/// One line a warning on stderr, with the subject before it.
void warn(const std::string& subject, const std::vector<std::string>& warnings);

/// The scan of that name, or the only one when no name is given. Throws kb::Error with the names there are.
[[nodiscard]] kb::Scan require_scan(const kb::KnowledgeBase& base, const std::string& file, const std::string& name);

/// The scan of that name, or all of them when no name is given. Throws kb::Error where there is none.
[[nodiscard]] std::vector<kb::Scan> scans_or_all(const kb::KnowledgeBase& base, const std::string& file, const std::string& name);

/// The scan that a plane belongs to. Throws kb::Error when there is no such plane.
[[nodiscard]] kb::Scan scan_of_plane(const kb::KnowledgeBase& base, const std::string& file, kb::PlaneId plane);

}  // namespace scenelore::tools
