// Asks relations which planes of a scene they hold between.
#include "scenelore/rules/rule_set.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "ask_together.hpp"
#include "kept_geometry.hpp"
#include "loaded_rules.hpp"
#include "relation_answer.hpp"
#include "shown_scene.hpp"

namespace scenelore::rules {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Asks relations about one scene, each once at most. All that it is given must live as long.
class Questions {
 public:
  Questions(LoadedRules& rules, const Scene& scene, const KnownAnswers& known, int threads)
      : rules_(rules), scene_(scene), known_(known), threads_(threads), digest_(rules.digest_of(scene)), geometry_(scene, digest_), shown_(scene) {}

  void ask_all(const std::set<std::string>& names) {
    try {
      for (const std::string& name : names) plan(name);
    } catch (...) {
      ask_planned();  // what they have to complain about comes first
      throw;
    }
    ask_planned();
    for (const auto& [name, other] : mirrored_) mirror(name, other, answers_.at(name));
  }

  /// Of a relation that was asked, or named by one.
  [[nodiscard]] const RelationAnswer& answer(const std::string& name) const { return answers_.at(name); }
  /// Of the relations that a run before had not answered, by name.
  [[nodiscard]] std::vector<RelationCount> counts() const {
    std::vector<RelationCount> out = counts_;
    std::sort(out.begin(), out.end(), [](const RelationCount& a, const RelationCount& b) { return a.relation < b.relation; });
    return out;
  }
  /// For the next run.
  [[nodiscard]] kb::StoredGeometry geometry() const { return geometry_.kept(known_.geometry); }

 private:
  /// Sees to it that a relation is answered once the planned ones have been asked. A user's file is asked at once, in its turn: what it asked of the
  /// geometry, and what it may have to complain about, comes between that of the files before and after it.
  void plan(const std::string& name) {
    const auto [entry, fresh] = answers_.try_emplace(name);
    if (!fresh || take_known(name, entry->second)) return;
    if (const std::optional<std::string> other = rules_.mirrored(name)) {
      plan(*other);
      mirrored_.emplace_back(name, *other);
      return;
    }
    const bool alone = !rules_.relation_entry(name).built_in;
    if (alone) ask_planned();
    planned_.push_back({.name = name, .info = rules_.relation(name).relation()});
    if (alone) ask_alone();
  }

  /// The facts of a run before, where all that they depend on is as it was.
  bool take_known(const std::string& name, RelationAnswer& result) {
    const auto found = known_.facts.find(name);
    if (found == known_.facts.end()) return false;
    const kb::RelationAsked& asked = found->second.asked;
    if (asked.inputs_sha256 != rules_.inputs(name, digest_, asked.features)) return false;
    result.known = &found->second.facts;
    result.asked = asked;
    return true;
  }

  /// The facts of the other relation, the other way round.
  void mirror(const std::string& name, const std::string& other, RelationAnswer& result) {
    const Clock::time_point start = Clock::now();
    const RelationAnswer& there = answer(other);
    there.for_each([&](kb::PlaneId a, kb::PlaneId b, double degree) { result.found.push_back({b, a, degree}); });
    result.asked = there.asked;
    finish(name, result, milliseconds_since(start));
  }

  void ask_planned() {
    if (planned_.empty()) return;
    std::vector<AskedRelation> asked = taken_from_plan();
    ask_together(rules_, scene_, geometry_.with(known_.geometry), asked, threads_);
    for (const AskedRelation& relation : asked) take(relation);
  }

  /// Of the only one that is planned.
  void ask_alone() {
    AskedRelation relation = std::move(taken_from_plan().front());
    RuleFile& file = rules_.relation(relation.name);
    shown_.show_to(file, geometry_.with(known_.geometry));
    const Clock::time_point start = Clock::now();
    relation.degrees.resize(relation.pairs->size() * relation.degrees_a_pair());
    put_degrees(file, *relation.pairs, Deadline(file, rules_.budget()), 0, relation.degrees.data());
    relation.milliseconds = milliseconds_since(start);
    relation.features = file.host().features_read;
    take(relation);
  }

  void take(const AskedRelation& relation) {
    RelationAnswer& result = answers_.at(relation.name);
    result.found = held_facts(scene_.ids, *relation.pairs, relation.degrees);
    result.asked = {.asked = static_cast<std::int64_t>(relation.degrees.size()), .held = static_cast<std::int64_t>(result.found.size()),
                    .within = relation.info.within, .within_plan = relation.info.within_plan, .features = lines_of(relation.features)};
    finish(relation.name, result, relation.milliseconds);
  }

  void finish(const std::string& name, RelationAnswer& result, double milliseconds) {
    counts_.push_back({.relation = name, .asked = result.asked.asked, .held = result.asked.held, .milliseconds = milliseconds});
    result.asked.stored = false;
    result.asked.inputs_sha256 = rules_.inputs(name, digest_, result.asked.features);
    sort_by_planes(result.found);
  }

  /// With their pairs.
  std::vector<AskedRelation> taken_from_plan() {
    const auto of = [](const RelationInfo& info) { return std::pair(info.within, info.within_plan); };
    std::vector<Reach> missing;
    for (const AskedRelation& relation : planned_) {
      if (pairs_.try_emplace(of(relation.info)).second) missing.push_back({relation.info.within, relation.info.within_plan});
    }
    if (boxes_.empty()) boxes_ = boxes_of(scene_.planes);
    std::vector<Pairs> found = pairs_in_reach(boxes_, missing);
    for (std::size_t i = 0; i < missing.size(); ++i) pairs_.at({missing[i].within, missing[i].within_plan}) = std::move(found[i]);
    for (AskedRelation& relation : planned_) relation.pairs = &pairs_.at(of(relation.info));
    return std::exchange(planned_, {});
  }

  LoadedRules& rules_;
  const Scene& scene_;
  const KnownAnswers& known_;
  int threads_;
  SceneDigest digest_;
  KeptGeometry geometry_;
  ShownScene shown_;
  std::vector<Box3> boxes_;                           // made when a relation is asked
  std::map<std::pair<double, double>, Pairs> pairs_;  // by reach, which many relations share
  std::map<std::string, RelationAnswer> answers_;     // by relation; empty until it was asked
  std::vector<AskedRelation> planned_;                // built-in ones, in the order in which they are to be asked
  std::vector<std::pair<std::string, std::string>> mirrored_;  // relations and those whose facts theirs are
  std::vector<RelationCount> counts_;
};

}  // namespace

Facts RuleSet::relate(const Scene& scene, const std::vector<std::string>& relations, const KnownAnswers& known, int threads) {
  Facts out;
  Questions questions(*loaded_, scene, known, threads);
  const std::set<std::string> names(relations.begin(), relations.end());
  questions.ask_all(names);
  std::size_t facts = 0;
  for (const std::string& name : names) facts += questions.answer(name).size();
  out.facts.reserve(facts);
  for (const std::string& name : names) {
    const RelationAnswer& result = questions.answer(name);
    result.for_each([&](kb::PlaneId a, kb::PlaneId b, double degree) { out.facts.push_back({name, a, b, degree}); });
    out.asked[name] = result.asked;
    out.reach[name] = {result.asked.within, result.asked.within_plan};
  }
  out.counts = questions.counts();
  out.geometry = questions.geometry();
  return out;
}

double RuleSet::degree(const std::string& relation, const Scene& scene, int a, int b) const {
  if (const std::optional<std::string> other = loaded_->mirrored(relation)) return degree(*other, scene, b, a);
  PairGeometry geometry(scene.planes);
  ShownScene shown(scene);
  RuleFile& file = loaded_->relation(relation);
  shown.show_to(file, geometry);
  return file.degree(a, b);
}

}  // namespace scenelore::rules
