// `scenelore rules check`: what is wrong with the rules and the rows that use them.
#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"

namespace scenelore::tools {

namespace {

class RulesCheckCommand : public Command {
 public:
  std::string name() const override { return "rules check"; }
  std::string summary() const override { return "Check the rule files and the constraint rows of a knowledge base."; }
  std::string example() const override { return "scenelore rules check office.gpkg"; }
  std::vector<Argument> arguments() override {
    return joined(std::vector<Argument>{positional("FILE", &file_, "FILE", "knowledge base file"),
            json_argument(json_)},
                  rules_.arguments());
  }

  int run() override {
    const kb::KnowledgeBase base = kb::KnowledgeBase::open(file_, kb::Access::read_only);
    const rules::RuleSet rules = rules_.load(base, file_);
    const std::vector<rules::Finding> findings = rules::check(base.knowledge(), rules);
    const auto errors = std::count_if(findings.begin(), findings.end(), [](const rules::Finding& f) { return f.error; });
    if (json_) {
      nlohmann::ordered_json out = nlohmann::ordered_json::array();
      for (const rules::Finding& finding : findings) {
        out.push_back({{"severity", finding.error ? "error" : "warning"}, {"where", finding.where}, {"text", finding.text}});
      }
      fmt::print("{}\n", out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    } else {
      for (const rules::Finding& finding : findings) {
        fmt::print("{}: {}: {}\n", finding.where, finding.error ? "error" : "warning", finding.text);
      }
      fmt::print("{} relations, {} errors, {} warnings\n", rules.relations().size(), errors,
                 static_cast<std::ptrdiff_t>(findings.size()) - errors);
    }
    return errors > 0 ? kKnowledge : kOk;
  }

 private:
  std::string file_;
  RuleArguments rules_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> rules_check_command() { return std::make_unique<RulesCheckCommand>(); }

}  // namespace scenelore::tools
