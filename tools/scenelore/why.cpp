// `scenelore why`: the reasons of a label, or what it would take for another one.
#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "scenelore/kb/error.hpp"

namespace scenelore::tools {

namespace {

using Json = nlohmann::ordered_json;

class WhyCommand : public Command {
 public:
  std::string name() const override { return "why"; }
  std::string summary() const override { return "Why a plane has its label, or why it is not of another class."; }
  std::string example() const override {
    return "scenelore why office.gpkg 3\n"
           "scenelore why office.gpkg 3 table";
  }
  std::vector<Argument> arguments() override {
    return {positional("FILE", &file_, "FILE", "knowledge base file"),
            positional("PLANE", &plane_, "ID", "id of the plane"),
            {"CLASS", &object_class_, "NAME", "the class that it is not"},
            {"--rules", &rules_, "DIR", "folder of relation and feature files besides the built-in ones; may be repeated",
             Effect::result},
            json_argument(json_)};
  }

  int run() override {
    const kb::KnowledgeBase base = kb::KnowledgeBase::open(file_, kb::Access::read_only);
    const auto plane = static_cast<kb::PlaneId>(plane_);
    const kb::Scan scan = scan_of_plane(base, file_, plane);
    return object_class_ ? explain_other(base, scan, plane) : explain_label(base, scan, plane);
  }

 private:
  int explain_label(const kb::KnowledgeBase& base, const kb::Scan& scan, kb::PlaneId plane) const {
    std::optional<kb::Label> label;
    for (const kb::Label& candidate : base.labels(scan.id)) {
      if (candidate.plane == plane) label = candidate;
    }
    if (!label) {
      throw kb::Error(fmt::format("{}: plane {} has no label yet; `scenelore label {}` labels its scan", file_, plane, file_));
    }
    const std::vector<kb::Reason> reasons = base.reasons(plane);
    if (!json_) {
      fmt::print("plane {} of {} is a {} ({:.2f})\n", plane, scan.name, label->object_class, label->probability);
      for (const kb::Reason& reason : reasons) fmt::print("- {}\n", reason.sentence);
      return kOk;
    }
    Json list = Json::array();
    for (const kb::Reason& reason : reasons) {
      list.push_back({{"kind", reason.kind},
                      {"class", reason.object_class},
                      {"constraint", reason.constraint_name ? Json(*reason.constraint_name) : Json(nullptr)},
                      {"other_plane", reason.other_plane ? Json(*reason.other_plane) : Json(nullptr)},
                      {"amount", std::isfinite(reason.amount) ? Json(reason.amount) : Json(nullptr)},
                      {"sentence", reason.sentence}});
    }
    print(Json{{"plane", plane},
               {"scan", scan.name},
               {"class", label->object_class},
               {"probability", label->probability},
               {"margin", std::isfinite(label->margin) ? Json(label->margin) : Json(nullptr)},
               {"runner_up", label->runner_up ? Json(*label->runner_up) : Json(nullptr)},
               {"reasons", std::move(list)}});
    return kOk;
  }

  int explain_other(const kb::KnowledgeBase& base, const kb::Scan& scan, kb::PlaneId plane) const {
    rules::RuleSet rules = pipeline::load_rules(base, file_, rules_);
    const pipeline::Situation situation = pipeline::assess(base, scan, rules);
    const rules::WhyNot answer = rules::why_not(situation.knowledge, situation.scene, situation.evidence, situation.facts,
                                                situation.truth, plane, *object_class_);
    if (!json_) {
      for (const std::string& sentence : answer.sentences) fmt::print("{}\n", sentence);
      return kOk;
    }
    Json changes = Json::array();
    for (const auto& [other, name] : answer.changes) changes.push_back({{"plane", other}, {"class", name}});
    print(Json{{"plane", plane},
               {"class", *object_class_},
               {"possible", answer.possible},
               {"extra_cost", answer.possible ? Json(answer.extra_cost) : Json(nullptr)},
               {"changes", std::move(changes)},
               {"sentences", answer.sentences}});
    return kOk;
  }

  static void print(const Json& json) { fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace)); }

  std::string file_;
  std::uint64_t plane_ = 0;
  std::optional<std::string> object_class_;
  std::vector<std::string> rules_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> why_command() { return std::make_unique<WhyCommand>(); }

}  // namespace scenelore::tools
