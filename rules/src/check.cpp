// Findings on knowledge and rules that no single run would show.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "names.hpp"
#include "scenelore/rules/error.hpp"
#include "scenelore/rules/labelling.hpp"
#include "scenelore/rules/made_plane.hpp"
#include "suggestion.hpp"

namespace scenelore::rules {

namespace {

using kb::Quantifier;

/// A desk with what stands on it, walls, floor and ceiling, some of them slanted: enough for a relation to show itself.
Scene sample_scene() {
  return make_scene(std::vector<MadePlane>{
      {.center = {0, 0, 0}, .length = 5, .width = 4},
      {.center = {0, 0, 2.6}, .normal = {0, 0, -1}, .length = 5, .width = 4},
      {.center = {0, 2, 1.3}, .normal = {0, -1, 0}, .length = 5, .width = 2.6},
      {.center = {2.5, 0, 1.3}, .normal = {-1, 0, 0.02}, .length = 4, .width = 2.6},
      {.center = {0, 1.4, 0.74}, .normal = {0.02, 0, 1}, .length = 1.6, .width = 0.8},
      {.center = {0.1, 1.5, 1.05}, .normal = {0, -1, 0.1}, .length = 0.5, .width = 0.35},
      {.center = {0.1, 1.2, 0.77}, .normal = {0, -0.05, 1}, .length = 0.45, .width = 0.15},
      {.center = {-1.5, 0.3, 0.45}, .length = 0.45, .width = 0.42},
      {.center = {-1.5, 0.1, 0.8}, .normal = {0, 1, 0.2}, .length = 0.45, .width = 0.4},
      {.center = {1.2, 1.97, 1.5}, .normal = {0, -1, 0}, .length = 1.2, .width = 0.9},
      {.center = {-1.9, 1.2, 0.9}, .normal = {1, 0.3, 0.4}, .length = 0.8, .width = 0.5},
  });
}

class Checker {
 public:
  Checker(const kb::Knowledge& knowledge, const RuleSet& rules) : knowledge_(knowledge), rules_(rules) {
    for (const RelationInfo& relation : rules.relations()) relations_.push_back(relation.name);
    scene_ = sample_scene();
  }

  void check_features();
  void check_row(const kb::ClassConstraint& row);
  void check_rows_against_each_other();
  void check_relations();
  void check_tuple_constraints();
  void check_settings();
  std::vector<Finding> findings;

 private:
  void note(bool error, const std::string& where, const std::string& text) { findings.push_back({error, where, text}); }
  /// "file:3: what" becomes what, at file:3.
  void note_at_line(const std::string& file, const std::string& message) {
    const std::size_t line = file.size() + 1;
    const std::size_t end = message.compare(0, line, file + ":") == 0 ? message.find(": ", line) : message.npos;
    if (end == message.npos) return note(true, file, message);
    note(true, message.substr(0, end), message.substr(end + 2));
  }
  void check_count(const kb::ClassConstraint& row, const std::string& where);
  void check_asking(const RelationInfo& relation);
  void check_converse(const RelationInfo& relation);

  const kb::Knowledge& knowledge_;
  const RuleSet& rules_;
  std::vector<std::string> relations_;
  Scene scene_;  ///< a small room, with the features of Lua files
};

std::string where_of(const kb::ClassConstraint& row) {
  return "class_constraint row " + std::to_string(row.id) + " ('" + row.name + "')";
}

void Checker::check_count(const kb::ClassConstraint& row, const std::string& where) {
  if (!row.count || *row.count < 0) return note(true, where, "at_most and at_least need a count of 0 or more");
  if (!row.relation && row.other_class) {
    note(false, where, "other_class is not looked at: without a relation the row counts the planes of '" + row.object_class +
                           "' in the scene");
  }
}

void Checker::check_row(const kb::ClassConstraint& row) {
  const std::string where = where_of(row);
  const std::vector<std::string> classes = class_names(knowledge_);
  const auto check_class = [&](const std::string& name) {
    if (knowledge_.class_index(name) < 0) note(true, where, "there is no class '" + name + "'" + did_you_mean(name, classes));
  };
  check_class(row.object_class);
  if (row.other_class) check_class(*row.other_class);
  if (row.relation && std::find(relations_.begin(), relations_.end(), *row.relation) == relations_.end()) {
    note(true, where, "there is no relation '" + *row.relation + "'" + did_you_mean(*row.relation, relations_));
  }
  if (row.weight && !(*row.weight >= 0 && std::isfinite(*row.weight))) {
    note(true, where, "the weight must be 0 or more, or NULL for a hard constraint");
  }
  const bool counts = row.quantifier == Quantifier::at_most || row.quantifier == Quantifier::at_least;
  if (counts) check_count(row, where);
  if (!counts && row.count) note(false, where, "count is not looked at: the quantifier counts nothing");
}

/// Hard rows that leave a class no place, and rows that say the same twice.
void Checker::check_rows_against_each_other() {
  using Key = std::tuple<std::string, std::string, std::string>;
  std::map<Key, std::map<Quantifier, const kb::ClassConstraint*>> hard;
  std::map<std::tuple<Key, Quantifier, int>, const kb::ClassConstraint*> seen;
  std::map<std::string, std::map<Quantifier, const kb::ClassConstraint*>> scene_counts;
  for (const kb::ClassConstraint& row : knowledge_.constraints) {
    if (!row.enabled) continue;
    const Key key{row.object_class, row.relation.value_or(""), row.other_class.value_or("")};
    const auto [twin, fresh] = seen.try_emplace({key, row.quantifier, row.count.value_or(-1)}, &row);
    if (!fresh) note(false, where_of(row), "says the same as " + where_of(*twin->second) + "; both are paid");
    if (!row.relation && row.count) scene_counts[row.object_class][row.quantifier] = &row;
    if (!row.weight) hard[key][row.quantifier] = &row;
  }
  for (const auto& [key, rows] : hard) {
    const auto no = rows.find(Quantifier::no), some = rows.find(Quantifier::some);
    if (no == rows.end() || some == rows.end()) continue;
    note(false, where_of(*some->second), "can never hold: " + where_of(*no->second) + " forbids what it asks for, so nothing is '" +
                                             some->second->object_class + "'");
  }
  for (const auto& [name, rows] : scene_counts) {
    const auto least = rows.find(Quantifier::at_least), most = rows.find(Quantifier::at_most);
    if (least == rows.end() || most == rows.end() || *least->second->count <= *most->second->count) continue;
    note(false, where_of(*least->second), "can never hold: " + where_of(*most->second) + " allows at most " +
                                              std::to_string(*most->second->count));
  }
}

void Checker::check_asking(const RelationInfo& relation) {
  const int planes = static_cast<int>(scene_.planes.size());
  bool told = false;
  for (int a = 0; a < planes; ++a) {
    for (int b = 0; b < planes; ++b) {
      if (a == b) continue;
      const double forth = rules_.degree(relation.name, scene_, a, b);
      if (!relation.symmetric || b < a || told) continue;
      const double back = rules_.degree(relation.name, scene_, b, a);
      if (std::abs(forth - back) < 1e-6) continue;
      told = true;
      note(true, relation.file, "relation '" + relation.name + "' is declared symmetric, but is " + std::to_string(forth) +
                                    " from one plane to another and " + std::to_string(back) +
                                    " the other way; drop 'symmetric = true'");
    }
  }
}

/// A converse with tolerances of its own may answer otherwise than the relation that it claims to mirror.
void Checker::check_converse(const RelationInfo& relation) {
  const int planes = static_cast<int>(scene_.planes.size());
  for (int a = 0; a < planes; ++a) {
    for (int b = 0; b < planes; ++b) {
      if (a == b) continue;
      const double own = rules_.degree(relation.name, scene_, a, b), other = rules_.degree(relation.converse, scene_, b, a);
      if (std::abs(own - other) < 1e-6) continue;
      return note(false, relation.file, "relation '" + relation.name + "' is the converse of '" + relation.converse + "', but is " +
                                            number(own, 3) + " where that is " + number(other, 3) + ", since it has tolerances of its own; set them for '" +
                                            relation.converse + "', or write 'extends' in place of 'converse'");
    }
  }
}

/// Relations may ask for the features of Lua files, which the room therefore has; those that fail speak for themselves.
void Checker::check_features() {
  try {
    rules_.compute_features(scene_, scene_.features);
  } catch (const Error& error) {
    note(true, "rules", error.what());
    scene_ = sample_scene();
  }
}

void Checker::check_relations() {
  for (const RelationInfo& relation : rules_.relations()) {
    try {
      check_asking(relation);
      if (!relation.converse.empty()) check_converse(relation);
    } catch (const Error& error) {
      note_at_line(relation.file, error.what());
    }
    const auto uses = [&](const kb::ClassConstraint& row) { return row.enabled && row.relation == relation.name; };
    const bool built_in = relation.file.starts_with("rules/relations/");
    if (!built_in && std::none_of(knowledge_.constraints.begin(), knowledge_.constraints.end(), uses)) {
      note(false, relation.file, "no enabled row of class_constraint uses relation '" + relation.name + "'");
    }
  }
}

/// The constraints of Lua files: what they speak of, and whether they answer at all.
void Checker::check_tuple_constraints() {
  const std::vector<std::string> classes = class_names(knowledge_);
  bool speaks = true;
  for (const TupleConstraint& c : rules_.declared_constraints()) {
    const std::string who = "constraint '" + c.name + "'";
    for (const std::string& name : c.classes) {
      const int index = knowledge_.class_index(name);
      if (index < 0) note(true, c.file, who + ": there is no class '" + name + "'" + did_you_mean(name, classes));
      if (index >= 0 && index == knowledge_.fallback_index()) {
        note(false, c.file, who + " never matters: '" + name + "' is the fallback class, which has no constraints");
      }
      speaks = speaks && index >= 0;
    }
    const auto has_name = [&](const kb::ClassConstraint& row) { return row.name == c.name; };
    const auto twin = std::find_if(knowledge_.constraints.begin(), knowledge_.constraints.end(), has_name);
    if (twin == knowledge_.constraints.end()) continue;
    speaks = false;
    note(true, c.file, who + ": the name is taken by " + where_of(*twin));
  }
  if (!speaks) return;
  try {
    for (const TupleConstraint& c : rules_.constraints(scene_, knowledge_)) {
      if (c.tuples.empty()) {
        note(false, c.file, "constraint '" + c.name + "' says nothing about any planes of a sample room (a desk with a screen and a "
                            "keyboard, chairs, walls): is 'applies' or 'within' too strict?");
      }
    }
  } catch (const Error& error) {
    note(true, "rules", error.what());
  }
}

void Checker::check_settings() {
  const auto check = [&](const std::string& key, auto&& read) {
    try {
      read();
    } catch (const Error& error) {
      note(true, "setting '" + key + "'", error.what());
    }
  };
  check("hold_degree", [&] { (void)hold_degree(knowledge_); });
  check("floor_threshold", [&] { (void)number_setting(knowledge_, "floor_threshold", 0.4, 0, 1); });
  const std::string floor = knowledge_.setting("floor", "ranked");
  if (floor != "ranked" && floor != "threshold") {
    note(true, "setting 'floor'", "is '" + floor + "'; it must be 'ranked' or 'threshold'");
  }
  if (floor == "threshold" && knowledge_.class_index("floor") < 0) {
    note(true, "setting 'floor'", "is 'threshold', but there is no class 'floor'");
  }
}

}  // namespace

std::vector<Finding> check(const kb::Knowledge& knowledge, const RuleSet& rules) {
  Checker checker(knowledge, rules);
  if (knowledge.fallback_index() < 0) checker.findings.push_back({true, "object_class", "there is no fallback class"});
  for (const kb::ClassConstraint& row : knowledge.constraints) {
    if (row.enabled) checker.check_row(row);
  }
  std::vector<std::string> valued = kb::built_in_features({}, {}).names;
  for (const kb::Feature& feature : rules.features()) valued.push_back(feature.name);
  for (Finding& finding : idle_rows(knowledge, valued)) checker.findings.push_back(std::move(finding));
  checker.check_rows_against_each_other();
  checker.check_settings();
  checker.check_features();
  checker.check_relations();
  checker.check_tuple_constraints();
  return std::move(checker.findings);
}

}  // namespace scenelore::rules
