// `scenelore label`: the second half of `run`, stored planes to labels; milliseconds after a row or a rule was edited.
#include <fmt/core.h>

#include <algorithm>
#include <map>

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
                   json_argument(json_)},
                  labelling_.arguments());
  }

  int run() override {
    kb::KnowledgeBase base = kb::KnowledgeBase::open(file_);
    rules::RuleSet rules = pipeline::load_rules(base, file_, labelling_.rules);
    const rules::LabellingOptions options = labelling_.options();
    const std::vector<kb::Scan> scans = scan_.empty() && !base.scans().empty() ? base.scans()
                                                                               : std::vector{require_scan(base, file_, scan_)};
    const kb::Knowledge knowledge = base.knowledge();
    const std::string fallback = knowledge.classes[static_cast<std::size_t>(knowledge.fallback_index())].name;
    std::vector<Report> reports;
    int code = kOk;
    for (const kb::Scan& scan : scans) {
      const std::vector<kb::Label> before = base.labels(scan.id);
      reports.push_back({file_, scan, pipeline::label_scan(base, scan, rules, options), {}, {}});
      code = std::max(code, exit_code(reports.back()));
      if (!json_) {
        print_text(reports.back(), fallback);
        print_changes(before, reports.back().inference.labels);
      }
    }
    if (json_) print_json(reports);
    return code;
  }

 private:
  static void print_changes(const std::vector<kb::Label>& before, const std::vector<kb::Label>& after) {
    if (before.empty()) return;
    std::map<kb::PlaneId, std::string> old;
    for (const kb::Label& label : before) old[label.plane] = label.object_class;
    std::size_t changes = 0;
    for (const kb::Label& label : after) {
      const auto found = old.find(label.plane);
      if (found == old.end() || found->second == label.object_class) continue;
      fmt::print("changed: plane {} was {}, is {}\n", label.plane, found->second, label.object_class);
      ++changes;
    }
    if (changes == 0) fmt::print("no label changed\n");
  }

  std::string file_;
  std::string scan_;
  bool json_ = false;
  LabellingArguments labelling_;
};

}  // namespace

std::unique_ptr<Command> label_command() { return std::make_unique<LabelCommand>(); }

}  // namespace scenelore::tools
