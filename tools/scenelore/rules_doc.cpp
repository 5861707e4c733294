// `scenelore rules doc`: what relations mean, and the rule language as files for editors.
#include <fmt/core.h>

#include <optional>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "export/rule_picture.hpp"
#include "scenelore/rules/error.hpp"
#include "scenelore/rules/language.hpp"
#include "usage_error.hpp"

namespace scenelore::tools {

namespace {

class RulesDocCommand : public Command {
 public:
  std::string name() const override { return "rules doc"; }
  std::string summary() const override { return "Describe relations, or print the rule language for editors and luacheck."; }
  std::string example() const override { return "scenelore rules doc above"; }
  std::vector<Argument> arguments() override {
    return {{"RELATION", &relation_, "NAME", "only this one (default: all)", Effect::result},
            {"--rules", &folders_, "DIR", "folder of rule files besides the built-in ones; may be repeated", Effect::result},
            {"--format", &format_, "FORMAT", "text; svg, a picture of one relation from the planes of its tests; or the language itself as: "
             "meta (lua-language-server), luarc, luacheckrc"}};
  }

  int run() override {
    if (format_ == "meta") return print(rules::language_meta());
    if (format_ == "luarc") return print(rules::language_luarc());
    if (format_ == "luacheckrc") return print(rules::language_luacheckrc());
    if (format_ == "svg") return print(picture());
    if (format_ != "text") throw UsageError("--format '" + format_ + "': must be text, svg, meta, luarc or luacheckrc");
    const rules::RuleSet rules = rules::RuleSet::load({folders_.begin(), folders_.end()});
    const std::string only = relation_ ? (void(rules.text(*relation_)), *relation_) : "";
    std::string out;
    for (const rules::RelationInfo& relation : rules.relations()) {
      if (!only.empty() && relation.name != only) continue;
      out += (out.empty() ? "" : "\n") + rules::describe(relation, rules.text(relation.name));
    }
    return print(out);
  }

 private:
  /// Of the user's relation of that name, else of the built-in one.
  [[nodiscard]] std::string picture() const {
    if (!relation_) throw UsageError("--format svg draws one relation: name it");
    std::vector<rules::RuleTestFile> tests = rules::run_rule_tests();
    if (!folders_.empty()) {
      for (rules::RuleTestFile& file : rules::run_rule_tests({folders_.begin(), folders_.end()})) tests.insert(tests.begin(), std::move(file));
    }
    for (const rules::RuleTestFile& file : tests) {
      if (file.rule != *relation_) continue;
      if (std::string out = exports::rule_picture(file); !out.empty()) return out;
    }
    throw rules::Error("there is no relation '" + *relation_ + "' with a test that asks about two planes");
  }

  static int print(const std::string& text) {
    fmt::print("{}", text);
    return kOk;
  }

  std::optional<std::string> relation_;
  std::vector<std::string> folders_;
  std::string format_ = "text";
};

}  // namespace

std::unique_ptr<Command> rules_doc_command() { return std::make_unique<RulesDocCommand>(); }

}  // namespace scenelore::tools
