// `scenelore learn`: what people have labelled becomes better rows.
#include <fmt/core.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "command_list.hpp"
#include "exit_code.hpp"
#include "learning/learning.hpp"
#include "options.hpp"
#include "usage_error.hpp"

namespace scenelore::tools {

namespace {

using Json = nlohmann::ordered_json;
using learning::Learned;

struct Change {
  std::string what;
  double before = 0, after = 0;
};

/// Weights that differ in the digits that are written.
struct Changes {
  std::vector<Change> features, constraints;

  Changes(const kb::Knowledge& before, const kb::Knowledge& after) {
    const auto differ = [](double a, double b) { return fmt::format("{:.3g}", a) != fmt::format("{:.3g}", b); };
    for (std::size_t f = 0; f < before.features.size(); ++f) {
      const double a = before.features[f].weight, b = after.features[f].weight;
      if (differ(a, b)) features.push_back({before.features[f].name, a, b});
    }
    for (std::size_t r = 0; r < before.constraints.size(); ++r) {
      const auto a = before.constraints[r].weight, b = after.constraints[r].weight;
      if (a && b && differ(*a, *b)) constraints.push_back({before.constraints[r].name, *a, *b});
    }
  }
};

void print_classes(const kb::Knowledge& before, const Learned& learned) {
  double sum = 0;
  for (const kb::ObjectClass& c : before.classes) sum += c.prior;
  fmt::print("{:<14} {:>8}  {:>6} {:>6}  {}\n", "class", "labelled", "prior", "now", "rows learned");
  for (std::size_t c = 0; c < before.classes.size(); ++c) {
    const kb::LearnedClass& rows = learned.rows.classes[c];
    if (rows.examples == 0) continue;
    fmt::print("{:<14} {:>8}  {:>6.3f} {:>6.3f}  {} Gaussians, {} bins of densities, {} kinds\n", rows.object_class, rows.examples,
               before.classes[c].prior / sum, learned.knowledge.classes[c].prior, rows.gaussians.size(), rows.densities.size(), rows.kinds.size());
  }
}

void print_weights(const char* title, const std::vector<Change>& changes) {
  if (changes.empty()) return;
  fmt::print("\n{:<28} {:>7} {:>7}\n", title, "was", "is");
  for (const Change& c : changes) fmt::print("{:<28} {:>7.3g} {:>7.3g}\n", c.what, c.before, c.after);
}

void print_effect(const Learned& learned) {
  fmt::print("\n{} labelled planes that were held back{:<6}{:>8} {:>8}\n", learned.after.planes, "", "before", "after");
  const auto line = [](const char* what, double before, double after) { fmt::print("{:<41}{:>8.3f} {:>8.3f}\n", what, before, after); };
  line("right class by evidence", learned.before.evidence_accuracy, learned.after.evidence_accuracy);
  line("right class in the best world", learned.before.accuracy, learned.after.accuracy);
  line("mean F1 of the classes", learned.before.macro_f1, learned.after.macro_f1);
  line("mean ln P of the right class", learned.before.log_likelihood, learned.after.log_likelihood);
  line("calibration error", learned.before.ece, learned.after.ece);
}

Json effect_json(const learning::Effect& e) {
  return {{"planes", e.planes}, {"evidence_accuracy", e.evidence_accuracy}, {"accuracy", e.accuracy}, {"macro_f1", e.macro_f1},
          {"log_likelihood", e.log_likelihood}, {"ece", e.ece}};
}

Json changes_json(const std::vector<Change>& changes) {
  Json out = Json::array();
  for (const Change& c : changes) out.push_back({{"name", c.what}, {"before", c.before}, {"after", c.after}});
  return out;
}

class LearnCommand : public Command {
 public:
  std::string name() const override { return "learn"; }
  std::string summary() const override {
    return "Learn Gaussians, densities, priors and weights from the planes that the table truth names, and show what it changes.";
  }
  std::string example() const override {
    return "scenelore kb init mine.gpkg\n"
           "scenelore run office.ply --kb mine.gpkg\n"
           "sqlite3 mine.gpkg \"INSERT INTO truth (plane_id, class) SELECT plane_id, class FROM label WHERE probability > 0.6\"\n"
           "scenelore learn mine.gpkg --dry-run\n"
           "scenelore learn mine.gpkg --force\n"
           "scenelore label mine.gpkg\n"
           "scenelore learn mine.gpkg --undo";
  }
  std::vector<Argument> arguments() override {
    const Effect result = Effect::result;
    return joined({positional("FILE", &file_, "FILE", "knowledge base file with truth rows"),
                   {"--scan", &scan_, "NAME", "only from this scan (default: all)", result},
                   {"--undo", &undo_, "", "bring back what the last learning replaced", result},
                   {"--dry-run", &dry_run_, "", "show, but write nothing", result},
                   {"--force", &force_, "", "write even when held-back planes are told worse than before", result},
                   {"--no-weights", &no_weights_, "", "leave the weights of features and constraints alone", result},
                   {"--folds", &options_.folds, "N", "parts of the cross-validation", result, 2, 100},
                   {"--min-examples", &options_.min_examples, "N", "labelled planes that a class needs", result, 2, 1e6},
                   {"--strength", &options_.present_strength, "N", "labelled planes that the present rows count as", result, 0, 1e6},
                   {"--threads", &options_.threads, "N", "threads; the result does not depend on them", Effect::speed, 1, 256},
                   json_argument(json_)},
                  rules_.arguments());
  }

  int run() override {
    if (undo_) return undo();
    kb::KnowledgeBase base = kb::KnowledgeBase::open(file_);
    rules::RuleSet rules = rules_.load(base, file_);
    base.register_features(rules.features());
    const kb::Knowledge knowledge = base.knowledge();
    options_.weights = !no_weights_;
    const Learned learned = learning::learn(knowledge, learning::labelled_scans(base, scans_or_all(base, file_, scan_), rules), options_);
    if (learned.refusal) {
      fmt::print(stderr, "scenelore: {}: nothing was learned: {}\n", file_, *learned.refusal);
      return kNegative;
    }
    const bool harmful = learned.harmful() && !force_ && !dry_run_, written = !dry_run_ && !harmful;
    const std::string what = fmt::format("learned from {} planes of {} scan{}", learned.planes, learned.scans, learned.scans == 1 ? "" : "s");
    if (written) base.learn_knowledge(learned.sql, what);
    if (json_) print_json(knowledge, learned, written);
    else print_text(knowledge, learned, what, written);
    if (harmful) fmt::print(stderr, "scenelore: {}: not written: held-back planes are told worse than before; --force writes all the same\n", file_);
    return harmful ? kNegative : kOk;
  }

 private:
  int undo() {
    kb::KnowledgeBase base = kb::KnowledgeBase::open(file_);
    const std::optional<std::string> what = base.undo_knowledge();
    if (!what) {
      fmt::print(stderr, "scenelore: {}: there is nothing to undo\n", file_);
      return kNegative;
    }
    fmt::print("{}: undone: {}\n", file_, *what);
    return kOk;
  }

  void print_text(const kb::Knowledge& before, const Learned& learned, const std::string& what, bool written) const {
    fmt::print("{}: {}\n\n", file_, what);
    print_classes(before, learned);
    const Changes changes(before, learned.knowledge);
    print_weights("feature weight", changes.features);
    print_weights("constraint weight", changes.constraints);
    fmt::print("\nprobabilities are told with slope {:.2f} and offset {:.2f} of their logit\n", learned.scale.slope, learned.scale.offset);
    print_effect(learned);
    if (!learned.suspects.empty()) fmt::print("\n{} labels do not fit the others and were left out; look at them:\n", learned.suspects.size());
    for (const learning::Suspect& s : learned.suspects) {
      fmt::print("  {} plane {}: labelled {} (P = {:.1g}), looks like {}\n", s.scan, s.plane, s.labelled, s.probability, s.seems);
    }
    if (!learned.notes.empty()) fmt::print("\n");
    for (const std::string& note : learned.notes) fmt::print("{}\n", note);
    if (!written) fmt::print("nothing was written\n");
    else fmt::print("`scenelore label {0}` uses the new rows, `scenelore learn {0} --undo` takes them back\n", file_);
  }

  void print_json(const kb::Knowledge& before, const Learned& learned, bool written) const {
    const Changes changes(before, learned.knowledge);
    Json classes = Json::array(), suspects = Json::array();
    for (std::size_t c = 0; c < before.classes.size(); ++c) {
      const kb::LearnedClass& rows = learned.rows.classes[c];
      classes.push_back({{"class", rows.object_class}, {"labelled", rows.examples}, {"prior_before", before.classes[c].prior},
                         {"prior_after", learned.knowledge.classes[c].prior}, {"gaussians", rows.gaussians.size()}, {"bins", rows.densities.size()},
                         {"kinds", rows.kinds.size()}});
    }
    for (const learning::Suspect& s : learned.suspects) {
      suspects.push_back({{"scan", s.scan}, {"plane", s.plane}, {"labelled", s.labelled}, {"seems", s.seems}, {"probability", s.probability}});
    }
    fmt::print("{}\n", Json{{"knowledge_base", file_}, {"planes", learned.planes}, {"scans", learned.scans}, {"written", written},
                            {"classes", std::move(classes)}, {"feature_weights", changes_json(changes.features)},
                            {"constraint_weights", changes_json(changes.constraints)}, {"probability_slope", learned.scale.slope},
                            {"probability_offset", learned.scale.offset}, {"before", effect_json(learned.before)},
                            {"after", effect_json(learned.after)}, {"suspects", std::move(suspects)}, {"notes", learned.notes}}
                           .dump(2, ' ', false, Json::error_handler_t::replace));
  }

  std::string file_, scan_;
  bool undo_ = false, dry_run_ = false, force_ = false, no_weights_ = false, json_ = false;
  learning::Options options_;
  RuleArguments rules_;
};

}  // namespace

std::unique_ptr<Command> learn_command() { return std::make_unique<LearnCommand>(); }

}  // namespace scenelore::tools
