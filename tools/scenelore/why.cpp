// `scenelore why`: the reasons of a label, or what it would take for another one.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "report.hpp"
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
    return joined(std::vector<Argument>{positional("FILE", &file_, "FILE", "knowledge base file"),
            positional("PLANE", &plane_, "ID", "id of the plane"),
            {"CLASS", &object_class_, "NAME", "the class that it is not"},
            json_argument(json_)},
                  rules_.arguments());
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
      print_text(scan, *label, reasons);
      return kOk;
    }
    Json list = Json::array();
    for (const kb::Reason& reason : reasons) {
      if (!reason.term) list.push_back(reason_json(reason));
    }
    print(Json{{"plane", plane},
               {"scan", scan.name},
               {"class", label->object_class},
               {"probability", label->probability},
               {"margin", finite(label->margin)},
               {"runner_up", label->runner_up ? Json(*label->runner_up) : Json(nullptr)},
               {"features", features_json(reasons)},
               {"reasons", std::move(list)}});
    return kOk;
  }

  void print_text(const kb::Scan& scan, const kb::Label& label, const std::vector<kb::Reason>& reasons) const {
    fmt::print("plane {} of {} is a {} ({:.2f})\n", label.plane, scan.name, label.object_class, label.probability);
    if (reasons.empty()) fmt::print("no reasons are stored; `scenelore label {}` stores them\n", file_);
    for (const kb::Reason& reason : reasons) {
      if (!reason.term) fmt::print("- {}\n", reason.sentence);
    }
    print_features(label.object_class, reasons);
  }

  static void print_features(const std::string& object_class, const std::vector<kb::Reason>& reasons) {
    bool header = false;
    for (const kb::Reason& reason : reasons) {
      if (!reason.term) continue;
      if (!header) fmt::print("what each feature says, in nats for {} against {}:\n", object_class, reason.against.value_or("?"));
      header = true;
      fmt::print("{:+8.2f}  {}\n", reason.amount, reason.sentence.substr(0, reason.sentence.rfind(": ")));
    }
  }

  static Json features_json(const std::vector<kb::Reason>& reasons) {
    Json terms = Json::array();
    for (const kb::Reason& reason : reasons) {
      if (!reason.term) continue;
      terms.push_back({{"feature", reason.term->feature}, {"value", reason.term->value}, {"mean", finite(reason.term->mean)},
                       {"sigma", finite(reason.term->sigma)}, {"contribution", reason.amount}, {"against", reason.against.value_or("")},
                       {"sentence", reason.sentence}});
    }
    return terms;
  }

  /// JSON has no infinity and no NaN: null.
  static Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

  int explain_other(const kb::KnowledgeBase& base, const kb::Scan& scan, kb::PlaneId plane) const {
    rules::RuleSet rules = rules_.load(base, file_);
    const pipeline::Situation situation = pipeline::assess(base, scan, rules);
    const rules::WhyNot answer = rules::why_not(situation.knowledge, situation.scene, situation.evidence, situation.facts,
                                                situation.truth, plane, *object_class_);
    if (!json_) {
      fmt::print("{}\n", answer.sentences.back());  // the summary
      for (std::size_t i = 0; i + 1 < answer.sentences.size(); ++i) fmt::print("- {}\n", answer.sentences[i]);
      print_features(*object_class_, answer.features);
      return kOk;
    }
    Json changes = Json::array();
    for (const auto& [other, name] : answer.changes) changes.push_back({{"plane", other}, {"class", name}});
    Json violated = Json::array();
    for (const auto& [constraint, amount] : answer.violated) violated.push_back({{"constraint", constraint}, {"amount", amount}});
    print(Json{{"plane", plane},
               {"class", *object_class_},
               {"possible", answer.possible},
               {"extra_cost", answer.possible ? Json(answer.extra_cost) : Json(nullptr)},
               {"changes", std::move(changes)},
               {"violated", std::move(violated)},
               {"features", features_json(answer.features)},
               {"sentences", answer.sentences}});
    return kOk;
  }

  static void print(const Json& json) { fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace)); }

  std::string file_;
  std::uint64_t plane_ = 0;
  std::optional<std::string> object_class_;
  RuleArguments rules_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> why_command() { return std::make_unique<WhyCommand>(); }

}  // namespace scenelore::tools
