// `scenelore rules test`: the tests that lie beside rule files, in the sandbox of the rule.
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "scenelore/rules/testing.hpp"

namespace scenelore::tools {

namespace {

class RulesTestCommand : public Command {
 public:
  std::string name() const override { return "rules test"; }
  std::string summary() const override { return "Run the tests beside rule files: x_test.lua beside x.lua."; }
  std::string example() const override { return "scenelore rules test --tap"; }
  std::vector<Argument> arguments() override {
    return joined(std::vector<Argument>{{"DIR", &folders_, "DIR", "folders of rules (default: the built-in ones)", Effect::result},
                                        {"--tap", &tap_, "", "print the Test Anything Protocol, version 13"},
                                        isolate_argument(isolate_),
                                        json_argument(json_)},
                  rules_.arguments());
  }

  int run() override {
    folders_.insert(folders_.end(), rules_.folders.begin(), rules_.folders.end());
    const std::vector<std::filesystem::path> folders(folders_.begin(), folders_.end());
    const auto files = isolate_ ? rules::run_rule_tests_isolated(folders, rules_.budget()) : rules::run_rule_tests(folders, rules_.budget());
    if (json_) {
      print_json(files);
    } else {
      fmt::print("{}", tap_ ? rules::as_tap(files) : rules::as_text(files));
    }
    return std::all_of(files.begin(), files.end(), [](const auto& file) { return file.passed(); }) ? kOk : kNegative;
  }

 private:
  static void print_json(const std::vector<rules::RuleTestFile>& files) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const rules::RuleTestFile& file : files) {
      nlohmann::ordered_json cases = nlohmann::ordered_json::array();
      for (const rules::RuleTestCase& test : file.cases) cases.push_back({{"name", test.name}, {"failure", test.failure}});
      out.push_back({{"file", file.file}, {"rule", file.rule}, {"passed", file.passed()}, {"failure", file.failure},
                     {"cases", std::move(cases)}});
    }
    fmt::print("{}\n", out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  }

  std::vector<std::string> folders_;
  RuleArguments rules_;
  bool tap_ = false, json_ = false, isolate_ = false;
};

}  // namespace

std::unique_ptr<Command> rules_test_command() { return std::make_unique<RulesTestCommand>(); }

}  // namespace scenelore::tools
