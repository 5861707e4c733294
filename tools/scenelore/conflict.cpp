// `scenelore conflict`: rows and truth that cannot hold together, and what is cheapest to give up.
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "scenelore/rules/conflict.hpp"

namespace scenelore::tools {

namespace {

using Json = nlohmann::ordered_json;

class ConflictCommand : public Command {
 public:
  std::string name() const override { return "conflict"; }
  std::string summary() const override {
    return "Name a minimal set of hard rows and truth that cannot hold together, and the cheapest way out.";
  }
  std::string example() const override { return "scenelore conflict office.gpkg"; }
  std::vector<Argument> arguments() override {
    return joined(std::vector<Argument>{positional("FILE", &file_, "FILE", "knowledge base file"),
                                        {"--scan", &scan_, "NAME", "only this scan (default: all)", Effect::result},
                                        json_argument(json_)},
                  labelling_.arguments());
  }

  int run() override {
    const kb::KnowledgeBase base = kb::KnowledgeBase::open(file_, kb::Access::read_only);
    rules::RuleSet rules = labelling_.rules.load(base, file_);
    Json out = Json::array();
    bool any = false;
    for (const kb::Scan& scan : scans_or_all(base, file_, scan_)) {
      const pipeline::Situation s = pipeline::assess(base, scan, rules);
      const rules::Contradiction found =
          rules::find_contradiction(s.knowledge, s.scene, s.evidence, s.facts, s.truth, labelling_.options());
      any = any || !found.parts.empty();
      if (json_) {
        out.push_back({{"scan", scan.name}, {"cannot_hold_together", to_json(found.parts)}, {"cheapest_relaxation", to_json(found.relaxation)}});
      } else {
        print_text(scan.name, found);
      }
    }
    if (json_) fmt::print("{}\n", out.dump(2, ' ', false, Json::error_handler_t::replace));
    return any ? kNegative : kOk;
  }

 private:
  static Json to_json(const std::vector<rules::ConflictPart>& parts) {
    Json out = Json::array();
    for (const rules::ConflictPart& part : parts) {
      out.push_back({{"constraint", part.constraint.empty() ? Json(nullptr) : Json(part.constraint)}, {"planes", part.planes}, {"sentence", part.sentence}});
    }
    return out;
  }

  static void print_text(const std::string& scan, const rules::Contradiction& found) {
    if (found.parts.empty()) {
      fmt::print("{}: nothing contradicts: all hard rows and truth rows can hold together\n", scan);
      return;
    }
    fmt::print("{}: these cannot hold together, and without any one of them the others can:\n", scan);
    for (const rules::ConflictPart& part : found.parts) fmt::print("- {}\n", part.sentence);
    fmt::print("the cheapest way out, which labelling takes, gives up:\n");
    for (const rules::ConflictPart& part : found.relaxation) fmt::print("- {}\n", part.sentence);
  }

  std::string file_, scan_;
  LabellingArguments labelling_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> conflict_command() { return std::make_unique<ConflictCommand>(); }

}  // namespace scenelore::tools
