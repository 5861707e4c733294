// `scenelore watch`: labels again whenever a rule file or a row changes, and tells what that changed.
#include <fmt/core.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <thread>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "report.hpp"
#include "scenelore/kb/error.hpp"
#include "scenelore/rules/error.hpp"
#include "scenelore/rules/testing.hpp"

namespace scenelore::tools {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Time and size of every file of the rule folders.
std::map<std::string, std::pair<fs::file_time_type, std::uintmax_t>> stamps(const std::vector<fs::path>& folders) {
  std::map<std::string, std::pair<fs::file_time_type, std::uintmax_t>> out;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
      if (entry->path().extension() != ".lua") continue;
      std::error_code gone;  // an editor may be replacing the file just now
      const auto time = entry->last_write_time(gone);
      const auto size = entry->file_size(gone);
      if (!gone) out[entry->path().string()] = {time, size};
    }
  }
  return out;
}

class WatchCommand : public Command {
 public:
  std::string name() const override { return "watch"; }
  std::string summary() const override { return "Label again whenever a rule file or a row changes, and tell which labels that changed."; }
  std::string example() const override { return "scenelore watch office.gpkg --rules rules --for 1"; }
  std::vector<Argument> arguments() override {
    return joined(std::vector<Argument>{positional("FILE", &file_, "FILE", "knowledge base file"),
                                        {"--for", &seconds_, "s", "stop after so long (default: until interrupted)", Effect::output, 0, 1e9},
                                        {"--every", &milliseconds_, "ms", "how often to look", Effect::output, 10, 60'000},
                                        isolate_argument(isolate_)},
                  labelling_.arguments());
  }

  int run() override {
    kb::KnowledgeBase base = kb::KnowledgeBase::open(file_);
    const std::atomic<bool>* interrupted = interrupt_flag();
    const Clock::time_point start = Clock::now();
    const auto time_left = [&] {
      return !interrupted->load() &&
             (!seconds_ || std::chrono::duration<double>(Clock::now() - start).count() < *seconds_);
    };
    const std::vector<fs::path> folders = pipeline::rule_folders(file_, labelling_.rules.folders);
    std::string version;
    std::map<std::string, std::pair<fs::file_time_type, std::uintmax_t>> files;
    for (bool first = true; first || time_left(); first = false) {
      const std::string now = data_version(base);
      auto found = stamps(folders);
      if (first || now != version || found != files) {
        version = now;
        files = std::move(found);
        label(base, folders);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(static_cast<std::int64_t>(milliseconds_)));
    }
    return kOk;
  }

 private:
  /// Changes when another program has written to the file.
  static std::string data_version(const kb::KnowledgeBase& base) {
    std::string out;
    base.query("PRAGMA data_version", [](const auto&) {}, [&](const kb::QueryRow& row) { out = row.values.at(0).value_or(""); });
    return out;
  }

  /// A rule that is broken, or whose tests fail, or a row that makes no sense: the old answer stays.
  void label(kb::KnowledgeBase& base, const std::vector<fs::path>& folders) const {
    try {
      if (!folders.empty() && !tests_pass(folders)) return;
      std::optional<rules::RuleSet> rules;
      for (const kb::Scan& scan : base.scans()) {
        Report report{.file = file_, .scan = scan, .before = base.labels(scan.id), .corrected = new_corrections(base, scan)};
        report.inference = label_scan(base, file_, scan, labelling_, isolate_, rules);
        fmt::print("{}: {} planes, {}\n", scan.name, report.inference.planes.size(), report.inference.run.outcome);
        print_changes(report);
      }
    } catch (const rules::Error& error) {
      fmt::print("{}\n{}the labels stay as they were\n", error.what(), error.traceback());
    } catch (const kb::Error& error) {
      fmt::print("{}\nthe labels stay as they were\n", error.what());
    }
    std::fflush(stdout);
  }

  [[nodiscard]] bool tests_pass(const std::vector<fs::path>& folders) const {
    const rules::Budget budget = labelling_.rules.budget();
    const auto tests = isolate_ ? rules::run_rule_tests_isolated(folders, budget) : rules::run_rule_tests(folders, budget);
    for (const rules::RuleTestFile& file : tests) {
      if (file.passed()) continue;
      fmt::print("{}the labels stay as they were\n", rules::as_text(tests));
      std::fflush(stdout);
      return false;
    }
    return true;
  }

  std::string file_;
  std::optional<double> seconds_;
  double milliseconds_ = 300;
  bool isolate_ = false;
  LabellingArguments labelling_;
};

}  // namespace

std::unique_ptr<Command> watch_command() { return std::make_unique<WatchCommand>(); }

}  // namespace scenelore::tools
