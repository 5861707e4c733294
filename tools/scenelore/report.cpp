#include "report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "exit_code.hpp"

namespace scenelore::tools {

namespace {

using Json = nlohmann::ordered_json;

std::map<kb::PlaneId, std::vector<const kb::Reason*>> reasons_by_plane(const kb::Inference& inference) {
  std::map<kb::PlaneId, std::vector<const kb::Reason*>> out;
  for (const kb::Reason& reason : inference.reasons) out[reason.plane].push_back(&reason);
  return out;
}

/// The one reason to show beside a label: the constraint that mattered most, else what the features say.
std::string main_reason(const std::vector<const kb::Reason*>& reasons) {
  const kb::Reason* best = nullptr;
  for (const kb::Reason* reason : reasons) {
    const bool constraint = (reason->kind == "support" && reason->amount >= 0.005) || reason->kind == "truth";
    const bool best_is_constraint = best && best->kind != "evidence";
    if (!best || (constraint && (!best_is_constraint || reason->amount > best->amount))) best = reason;
  }
  return best ? best->sentence : "";
}

/// Why a label is no longer what it was: a truth row, what the old class would cost, else the label's own reason.
std::string reason_of_change(const std::vector<const kb::Reason*>& reasons, const std::string& was) {
  for (const kb::Reason* reason : reasons) {
    if (reason->kind == "truth" || (reason->kind == "runner_up" && reason->against == was)) return reason->sentence;
  }
  return main_reason(reasons);
}

/// JSON has no infinity and no NaN: null.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json changes_json(const Report& report) {
  Json out = Json::array();
  for (const LabelChange& c : changes(report)) out.push_back({{"plane", c.plane}, {"was", c.was}, {"is", c.is}, {"reason", c.reason}});
  return out;
}

/// "chair 1: seat 12, back 13": things of which more than one plane was found.
void print_objects(const kb::Inference& inference) {
  for (const kb::Object& object : inference.objects) {
    if (object.planes.size() < 2) continue;
    std::string parts;
    for (const auto& [plane, part] : object.planes) parts += fmt::format("{}{} {}", parts.empty() ? "" : ", ", part, plane);
    fmt::print("{} {}: {}\n", object.composite, object.number, parts);
  }
}

Json objects_json(const kb::Inference& inference) {
  Json out = Json::array();
  for (const kb::Object& object : inference.objects) {
    Json planes = Json::array();
    for (const auto& [plane, part] : object.planes) planes.push_back({{"plane", plane}, {"part", part}});
    out.push_back({{"composite", object.composite}, {"number", object.number}, {"planes", std::move(planes)}});
  }
  return out;
}

Json to_json(const Report& report) {
  const kb::Inference& inference = report.inference;
  auto reasons = reasons_by_plane(inference);
  Json planes = Json::array();
  for (const kb::Label& label : inference.labels) {
    Json plane{{"plane", label.plane},
               {"class", label.object_class},
               {"probability", label.probability},
               {"margin", finite(label.margin)},
               {"runner_up", label.runner_up ? Json(*label.runner_up) : Json(nullptr)},
               {"reasons", Json::array()}};
    for (const kb::Reason* reason : reasons[label.plane]) {
      plane["reasons"].push_back(reason_json(*reason));
    }
    planes.push_back(std::move(plane));
  }
  return {{"scan", report.scan.name},
          {"knowledge_base", report.file},
          {"points", report.scan.point_count},
          {"parameters", Json::parse(report.scan.parameters.empty() ? "{}" : report.scan.parameters)},
          {"outcome", inference.run.outcome},
          {"cost", finite(inference.run.cost)},
          {"lower_bound", finite(inference.run.lower_bound)},
          {"nodes", inference.run.nodes},
          {"seconds", inference.run.seconds},
          {"planes", std::move(planes)},
          {"objects", objects_json(inference)},
          {"corrected", report.corrected},
          {"changes", changes_json(report)},
          {"warnings", report.warnings},
          {"written", report.written}};
}

std::string outcome_sentence(const kb::Run& run) {
  if (run.outcome == "proved") return fmt::format("proved best, cost {:.2f}, {} nodes", run.cost, run.nodes);
  if (run.outcome == "feasible") {
    return fmt::format("stopped at a limit: cost {:.2f}, at most {:.2f} above the best", run.cost, run.cost - run.lower_bound);
  }
  if (run.outcome == "infeasible") return "no world model satisfies all hard constraints";
  return "stopped at a limit before any world model was found";
}

}  // namespace

nlohmann::ordered_json reason_json(const kb::Reason& reason) {
  const auto text = [](const std::optional<std::string>& value) { return value ? Json(*value) : Json(nullptr); };
  Json out{{"kind", reason.kind},
           {"class", reason.object_class},
           {"against", text(reason.against)},
           {"constraint", text(reason.constraint_name)},
           {"other_plane", reason.other_plane ? Json(*reason.other_plane) : Json(nullptr)},
           {"amount", finite(reason.amount)},
           {"sentence", reason.sentence}};
  if (reason.term) {
    out.update({{"feature", reason.term->feature}, {"value", reason.term->value}, {"mean", finite(reason.term->mean)},
                {"sigma", finite(reason.term->sigma)}});
  }
  return out;
}

std::vector<LabelChange> changes(const Report& report) {
  std::vector<LabelChange> out;
  if (report.before.empty()) return out;
  std::map<kb::PlaneId, std::string> old;
  for (const kb::Label& label : report.before) old[label.plane] = label.object_class;
  auto reasons = reasons_by_plane(report.inference);
  for (const kb::Label& label : report.inference.labels) {
    const auto found = old.find(label.plane);
    if (found == old.end() || found->second == label.object_class) continue;
    out.push_back({label.plane, found->second, label.object_class, reason_of_change(reasons[label.plane], found->second)});
  }
  return out;
}

std::vector<kb::PlaneId> new_corrections(const kb::KnowledgeBase& base, const kb::Scan& scan) {
  std::vector<kb::PlaneId> out;
  for (const auto& [plane, name] : base.truth(scan.id)) {
    const std::vector<kb::Reason> reasons = base.reasons(plane);
    const bool known = std::any_of(reasons.begin(), reasons.end(),
                                   [&](const kb::Reason& r) { return r.kind == "truth" && r.object_class == name; });
    if (!known) out.push_back(plane);
  }
  return out;
}

void print_changes(const Report& report) {
  if (report.before.empty()) return;
  std::map<kb::PlaneId, std::string> now;
  for (const kb::Label& label : report.inference.labels) now[label.plane] = label.object_class;
  for (const kb::PlaneId plane : report.corrected) fmt::print("corrected by a person: plane {} is {}\n", plane, now[plane]);
  const std::vector<LabelChange> all = changes(report);
  for (const LabelChange& c : all) fmt::print("changed: plane {} was {}, is {}: {}\n", c.plane, c.was, c.is, c.reason);
  if (all.empty()) fmt::print("no {}label changed\n", report.corrected.empty() ? "" : "other ");
}

void print_text(const Report& report, const std::string& fallback) {
  const kb::Inference& inference = report.inference;
  fmt::print("{}: {} points, {} planes; {}\n", report.scan.name, report.scan.point_count, inference.planes.size(),
             outcome_sentence(inference.run));
  auto reasons = reasons_by_plane(inference);
  std::size_t rest = 0;
  bool header = false;
  for (const kb::Label& label : inference.labels) {
    if (label.object_class == fallback) {
      ++rest;
      continue;
    }
    if (!header) fmt::print("{:>7}  {:<12} {:>5}  {}\n", "plane", "class", "prob.", "reason");
    header = true;
    fmt::print("{:>7}  {:<12} {:>5.2f}  {}\n", label.plane, label.object_class, label.probability,
               main_reason(reasons[label.plane]));
  }
  print_objects(inference);
  if (rest > 0) fmt::print("{} more planes fit no class ({})\n", rest, fallback);
  fmt::print("knowledge base: {}\n", report.file);
  for (const std::string& file : report.written) fmt::print("written: {}\n", file);
}

void print_json(const std::vector<Report>& reports) {
  Json out = Json::array();
  for (const Report& report : reports) out.push_back(to_json(report));
  fmt::print("{}\n", out.dump(2, ' ', false, Json::error_handler_t::replace));
}

int exit_code(const Report& report) {
  const std::string& outcome = report.inference.run.outcome;
  if (outcome == "feasible" || outcome == "stopped") return kLimit;
  if (outcome == "infeasible" || report.inference.planes.empty()) return kNegative;
  return kOk;
}

}  // namespace scenelore::tools
