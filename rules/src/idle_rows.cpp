// Rows that a person wrote and that change nothing: told with the row and the way out, since nothing else would show it.
#include <algorithm>
#include <array>
#include <set>

#include "names.hpp"
#include "scenelore/rules/labelling.hpp"
#include "suggestion.hpp"

namespace scenelore::rules {

namespace {

using kb::Quantifier;

/// All keys that are not `relation.tolerance`.
constexpr std::array kSettings = {"combination",  "floor",         "floor_threshold",   "hold_degree",
                                  "outlier_share", "probability_slope", "probability_offset"};

class IdleRows {
 public:
  IdleRows(const kb::Knowledge& knowledge, std::vector<std::string> valued) : knowledge_(knowledge), valued_(std::move(valued)) {
    std::sort(valued_.begin(), valued_.end());
    const kb::ClassDensity* before = nullptr;  // many bins of one histogram follow each other
    for (const kb::ClassDensity& row : knowledge.class_densities) {
      if (before == nullptr || before->feature != row.feature || before->object_class != row.object_class) learned_.emplace(row.object_class, row.feature);
      before = &row;
    }
    for (const kb::ClassKind& kind : knowledge.kinds) with_kinds_.insert(kind.object_class);
  }

  void add_features() {
    // Those that perception measures may be unknown of a whole scan (where its sensor stood, say): nothing that a person could mend.
    const std::vector<std::string> measured = kb::built_in_features({}, {}).names;
    for (const kb::ClassFeature& row : knowledge_.class_features) {
      const auto feature = std::find_if(knowledge_.features.begin(), knowledge_.features.end(),
                                        [&](const kb::Feature& f) { return f.name == row.feature; });
      if (feature == knowledge_.features.end()) continue;  // the table itself allows no such row
      const std::string where = "class_feature row ('" + row.object_class + "', '" + row.feature + "')";
      const std::string leave_out = ", or leave the row out";
      if (!std::binary_search(valued_.begin(), valued_.end(), row.feature)) {
        if (std::find(measured.begin(), measured.end(), row.feature) != measured.end()) continue;
        note(where, "has no effect: no plane has a value of '" + row.feature + "', since no rule file defines it any more: put the file of "
                    "the feature back" + leave_out);
      } else if (feature->weight <= 0 && !learned_.contains({row.object_class, row.feature}) && !with_kinds_.contains(row.object_class) && !told_otherwise(row)) {
        // What was learned has a histogram or kinds; that the feature counts for nothing was found out, not overlooked.
        note(where, "has no effect: the weight of feature '" + row.feature + "' is 0; give it one (UPDATE feature SET weight = 0.3 WHERE name = '" +
                    row.feature + "')" + instead_of(row.feature) + leave_out);
      }
    }
  }

  void add_classes() {
    std::set<std::string> described;
    for (const kb::ClassFeature& row : knowledge_.class_features) described.insert(row.object_class);
    for (const auto& [object_class, feature] : learned_) described.insert(object_class);
    if (described.empty()) return;  // knowledge without features is complete in itself
    for (const kb::ObjectClass& c : knowledge_.classes) {
      if (c.fallback || described.contains(c.name)) continue;
      note("object_class row " + std::to_string(c.id) + " ('" + c.name + "')",
           "only its prior speaks for it: no class_feature row says what it looks like; insert some, or run `scenelore learn` with examples");
    }
  }

  void add_constraints() {
    for (const kb::ClassConstraint& row : knowledge_.constraints) {
      if (!row.enabled) continue;
      const std::string where = "class_constraint row " + std::to_string(row.id) + " ('" + row.name + "')";
      const int subject = knowledge_.class_index(row.object_class);
      if (row.weight && *row.weight == 0) note(where, "never matters: its weight is 0; give it one in nats, NULL for a hard row, or set enabled = 0");
      if (subject >= 0 && subject == knowledge_.fallback_index()) {
        note(where, "never matters: '" + row.object_class + "' is the fallback class, which has no constraints; name another class");
      }
      if (row.quantifier == Quantifier::every && !row.relation) note(where, "never matters: 'every' needs a relation; name one");
      if (row.quantifier == Quantifier::at_least && row.count == 0) note(where, "never matters: at least 0 always holds; raise the count");
    }
  }

  void add_settings() {
    const std::vector<std::string> known(kSettings.begin(), kSettings.end());
    for (const auto& [key, value] : knowledge_.settings) {
      if (key.find('.') != std::string::npos || std::find(known.begin(), known.end(), key) != known.end()) continue;
      note("setting '" + key + "'", "has no effect: there is no such setting" + did_you_mean(key, known));
    }
  }

  std::vector<Finding> findings;

 private:
  void note(const std::string& where, const std::string& text) { findings.push_back({false, where, text}); }

  /// The robust measure of the same thing, where the default knowledge prefers it.
  [[nodiscard]] std::string instead_of(const std::string& feature) const {
    const std::string other = "spread_" + feature;
    const auto counts = [&](const kb::Feature& f) { return f.name == other && f.weight > 0; };
    const bool known = std::any_of(knowledge_.features.begin(), knowledge_.features.end(), counts);
    return known ? ", write the row for '" + other + "', which counts" : "";
  }

  /// Whether robust measures that count say the size of the class as well: then nothing was overlooked, as in the packs.
  [[nodiscard]] bool told_otherwise(const kb::ClassFeature& row) const {
    const auto counts = [&](const std::string& feature) {
      const auto same = [&](const kb::ClassFeature& r) { return r.object_class == row.object_class && r.feature == feature; };
      const auto weighs = [&](const kb::Feature& f) { return f.name == feature && f.weight > 0; };
      return std::any_of(knowledge_.class_features.begin(), knowledge_.class_features.end(), same) &&
             std::any_of(knowledge_.features.begin(), knowledge_.features.end(), weighs);
    };
    return row.feature == "area_m2" ? counts("spread_length") && counts("spread_width") : counts("spread_" + row.feature);
  }

  const kb::Knowledge& knowledge_;
  std::vector<std::string> valued_;
  std::set<std::pair<std::string, std::string>> learned_;  // class and feature with a histogram
  std::set<std::string> with_kinds_;  // classes
};

}  // namespace

std::vector<Finding> idle_rows(const kb::Knowledge& knowledge, const std::vector<std::string>& features) {
  IdleRows rows(knowledge, features);
  rows.add_features();
  rows.add_classes();
  rows.add_constraints();
  rows.add_settings();
  return std::move(rows.findings);
}

}  // namespace scenelore::rules
