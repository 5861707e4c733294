// Asks relations which planes of a scene they hold between.
#include "scenelore/rules/rule_set.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <span>
#include <utility>

#include "deadline.hpp"
#include "kept_geometry.hpp"
#include "loaded_rules.hpp"
#include "relation_answer.hpp"
#include "shown_scene.hpp"

namespace scenelore::rules {

namespace {

using Clock = std::chrono::steady_clock;
using Pairs = std::vector<std::pair<int, int>>;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Of a file that has been shown the scene: one degree a pair or, where the relation is not symmetric, two: forth and back.
std::vector<double> degrees_of(RuleFile& file, const Pairs& pairs, const Deadline& deadline) {
  constexpr std::size_t kQuestions = 64;  // between two looks at the clock
  const bool symmetric = file.relation().symmetric;
  const std::size_t at_once = symmetric ? kQuestions : kQuestions / 2;
  std::vector<double> degrees;
  degrees.reserve(2 * pairs.size());
  Pairs both_ways;
  for (std::size_t begin = 0; begin < pairs.size(); begin += at_once) {
    deadline.check(static_cast<std::int64_t>(degrees.size()));
    std::span<const std::pair<int, int>> asked = std::span(pairs).subspan(begin, std::min(at_once, pairs.size() - begin));
    if (!symmetric) {
      both_ways.clear();
      for (const auto& [a, b] : asked) both_ways.insert(both_ways.end(), {{a, b}, {b, a}});
      asked = both_ways;
    }
    degrees.resize(degrees.size() + asked.size());
    file.degrees(asked, degrees.data() + degrees.size() - asked.size());
  }
  return degrees;
}

/// Asks relations about one scene, each once at most. All that it is given must live as long.
class Questions {
 public:
  Questions(LoadedRules& rules, const Scene& scene, const KnownAnswers& known)
      : rules_(rules), scene_(scene), known_(known), digest_(rules.digest_of(scene)), geometry_(scene, digest_), shown_(scene) {}

  /// Stays where it is as long as this lives.
  const RelationAnswer& answer(const std::string& name) {
    const auto [entry, fresh] = answers_.try_emplace(name);
    RelationAnswer& result = entry->second;
    if (!fresh || take_known(name, result)) return result;
    if (const std::optional<std::string> other = rules_.mirrored(name)) {
      mirror(name, *other, result);
    } else {
      ask(name, result);
    }
    result.asked.stored = false;
    result.asked.inputs_sha256 = rules_.inputs(name, digest_, result.asked.features);
    sort_by_planes(result.found);
    return result;
  }

  /// Of the relations that a run before had not answered, by name.
  [[nodiscard]] std::vector<RelationCount> counts() const {
    std::vector<RelationCount> out = counts_;
    std::sort(out.begin(), out.end(), [](const RelationCount& a, const RelationCount& b) { return a.relation < b.relation; });
    return out;
  }
  /// For the next run.
  [[nodiscard]] kb::StoredGeometry geometry() const { return geometry_.kept(known_.geometry); }

 private:
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
    counts_.push_back({.relation = name, .asked = there.asked.asked, .held = there.asked.held, .milliseconds = milliseconds_since(start)});
  }

  void ask(const std::string& name, RelationAnswer& result) {
    RuleFile& file = rules_.relation(name);
    const RelationInfo& info = file.relation();
    const Pairs& pairs = pairs_within(info.within, info.within_plan);
    shown_.show_to(file, geometry_.with(known_.geometry));
    const Clock::time_point start = Clock::now();
    const std::vector<double> degrees = degrees_of(file, pairs, Deadline(file, rules_.budget()));
    result.found = held_facts(scene_.ids, pairs, degrees);
    result.asked = {.asked = static_cast<std::int64_t>(degrees.size()), .held = static_cast<std::int64_t>(result.found.size()),
                    .within = info.within, .within_plan = info.within_plan, .features = file.features_read()};
    counts_.push_back({.relation = file.name(), .asked = result.asked.asked, .held = result.asked.held, .milliseconds = milliseconds_since(start)});
  }

  const Pairs& pairs_within(double within, double within_plan) {
    if (boxes_.empty()) boxes_ = boxes_of(scene_.planes);
    const auto [list, fresh] = pairs_.try_emplace({within, within_plan});
    if (fresh) list->second = pairs_in_reach(boxes_, within, within_plan);
    return list->second;
  }

  LoadedRules& rules_;
  const Scene& scene_;
  const KnownAnswers& known_;
  SceneDigest digest_;
  KeptGeometry geometry_;
  ShownScene shown_;
  std::vector<Box3> boxes_;                           // made when a relation is asked
  std::map<std::pair<double, double>, Pairs> pairs_;  // by reach, which many relations share
  std::map<std::string, RelationAnswer> answers_;     // by relation
  std::vector<RelationCount> counts_;
};

}  // namespace

Facts RuleSet::relate(const Scene& scene, const std::vector<std::string>& relations, const KnownAnswers& known) {
  Facts out;
  Questions questions(*loaded_, scene, known);
  const std::set<std::string> names(relations.begin(), relations.end());
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
