// `scenelore rules profile`: what relations and rows cost, and whether they ever decide anything.
#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "options.hpp"
#include "scenelore/rules/profile.hpp"

namespace scenelore::tools {

namespace {

using Json = nlohmann::ordered_json;

class RulesProfileCommand : public Command {
 public:
  std::string name() const override { return "rules profile"; }
  std::string summary() const override { return "What each relation and constraint costs, pays and decides in the stored scans."; }
  std::string example() const override { return "scenelore rules profile office.gpkg"; }
  std::vector<Argument> arguments() override {
    return joined(std::vector<Argument>{positional("FILE", &file_, "FILE", "knowledge base file"),
                                        {"--scan", &scan_, "NAME", "only this scan (default: all)", Effect::result},
                                        json_argument(json_)},
                  labelling_.arguments());
  }

  int run() override {
    const kb::KnowledgeBase base = kb::KnowledgeBase::open(file_, kb::Access::read_only);
    rules::RuleSet rules = labelling_.rules.load(base, file_);
    const rules::LabellingOptions options = labelling_.options();
    rules::Profile sum;
    for (const kb::Scan& scan : scans_or_all(base, file_, scan_)) {
      const pipeline::Situation s = pipeline::assess(base, scan, rules);
      add(sum, rules::profile(s.knowledge, s.scene, s.evidence, rules, s.truth, options));
    }
    json_ ? print_json(sum) : print_text(sum);
    return kOk;
  }

 private:
  /// Rows and relations are the same in every scan of one knowledge base.
  static void add(rules::Profile& sum, const rules::Profile& more) {
    if (sum.rows.empty() && sum.relations.empty()) {
      sum = more;
      return;
    }
    for (std::size_t i = 0; i < std::min(sum.relations.size(), more.relations.size()); ++i) {
      sum.relations[i].asked += more.relations[i].asked;
      sum.relations[i].held += more.relations[i].held;
      sum.relations[i].milliseconds += more.relations[i].milliseconds;
    }
    for (std::size_t i = 0; i < std::min(sum.rows.size(), more.rows.size()); ++i) {
      sum.rows[i].constraints += more.rows[i].constraints;
      sum.rows[i].broken += more.rows[i].broken;
      sum.rows[i].paid += more.rows[i].paid;
      sum.rows[i].pruned += more.rows[i].pruned;
      sum.rows[i].decided += more.rows[i].decided;
    }
  }

  static void print_text(const rules::Profile& profile) {
    fmt::print("{:<24} {:>8} {:>8} {:>9}\n", "relation", "asked", "held", "ms");
    for (const rules::RelationCount& r : profile.relations) {
      fmt::print("{:<24} {:>8} {:>8} {:>9.2f}\n", r.relation, r.asked, r.held, r.milliseconds);
    }
    fmt::print("\n{:<28} {:>8} {:>7} {:>8} {:>7} {:>8}\n", "constraint", "places", "broken", "paid", "pruned", "decided");
    for (const rules::RowProfile& r : profile.rows) {
      fmt::print("{:<28} {:>8} {:>7} {:>8.2f} {:>7} {:>8}{}\n", r.constraint, r.constraints, r.broken, r.paid, r.pruned, r.decided,
                 r.decided == 0 ? "  never decided anything in these scans" : "");
    }
  }

  static void print_json(const rules::Profile& profile) {
    Json relations = Json::array(), rows = Json::array();
    for (const rules::RelationCount& r : profile.relations) {
      relations.push_back({{"relation", r.relation}, {"asked", r.asked}, {"held", r.held}, {"milliseconds", r.milliseconds}});
    }
    for (const rules::RowProfile& r : profile.rows) {
      rows.push_back({{"constraint", r.constraint}, {"relation", r.relation.empty() ? Json(nullptr) : Json(r.relation)},
                      {"places", r.constraints}, {"broken", r.broken}, {"paid", r.paid}, {"pruned", r.pruned}, {"decided", r.decided}});
    }
    fmt::print("{}\n", Json{{"relations", std::move(relations)}, {"constraints", std::move(rows)}}.dump(2, ' ', false, Json::error_handler_t::replace));
  }

  std::string file_, scan_;
  LabellingArguments labelling_;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> rules_profile_command() { return std::make_unique<RulesProfileCommand>(); }

}  // namespace scenelore::tools
