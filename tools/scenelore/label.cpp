// `scenelore label`: the second half of `run`, stored planes to labels; milliseconds after a row or a rule was edited.
#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "report.hpp"

namespace scenelore::tools {

namespace {

class LabelCommand : public Command {
 public:
  std::string name() const override { return "label"; }
  std::string summary() const override { return "Label stored scans again, with the knowledge and the rules as they are now."; }
  std::string example() const override { return "scenelore label office.gpkg"; }
  std::vector<Argument> arguments() override {
    return joined({positional("FILE", &file_, "FILE", "knowledge base file"),
                   {"--scan", &scan_, "NAME", "only this scan (default: all)", Effect::result},
                   isolate_argument(isolate_),
                   json_argument(json_)},
                  labelling_.arguments());
  }

  int run() override {
    kb::KnowledgeBase base = kb::KnowledgeBase::open(file_);
    std::optional<rules::RuleSet> rules;
    const std::vector<kb::Scan> scans = scans_or_all(base, file_, scan_);
    const kb::Knowledge knowledge = base.knowledge();
    const std::string fallback = knowledge.classes[static_cast<std::size_t>(knowledge.fallback_index())].name;
    std::vector<Report> reports;
    int code = kOk;
    for (const kb::Scan& scan : scans) {
      Report report{.file = file_, .scan = scan, .before = base.labels(scan.id), .corrected = new_corrections(base, scan)};
      report.inference = label_scan(base, file_, scan, labelling_, isolate_, rules);
      if (&scan == &scans.front()) report.warnings = warnings_about(base, knowledge);
      code = std::max(code, exit_code(report));
      if (!json_) {
        warn(file_, report.warnings);
        print_text(report, fallback);
        print_changes(report);
      }
      reports.push_back(std::move(report));
    }
    if (json_) print_json(reports);
    return code;
  }

 private:
  /// Rows that change nothing: a person who wrote one expects that it does.
  static std::vector<std::string> warnings_about(const kb::KnowledgeBase& base, const kb::Knowledge& knowledge) {
    std::vector<std::string> valued, out;
    base.query("SELECT name FROM feature WHERE EXISTS (SELECT 1 FROM plane_feature WHERE feature = name)", [](const auto&) {},
               [&](const kb::QueryRow& row) { valued.push_back(row.values.at(0).value_or("")); });
    for (const rules::Finding& finding : rules::idle_rows(knowledge, valued)) out.push_back(finding.where + ": warning: " + finding.text);
    return out;
  }

  std::string file_;
  std::string scan_;
  bool json_ = false, isolate_ = false;
  LabellingArguments labelling_;
};

}  // namespace

std::unique_ptr<Command> label_command() { return std::make_unique<LabelCommand>(); }

}  // namespace scenelore::tools
