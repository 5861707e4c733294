#include "scenelore/rules/rule_set.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <sstream>

#include "fact_inputs.hpp"
#include "kept_geometry.hpp"
#include "lua_files.hpp"
#include "names.hpp"
#include "rule_file.hpp"
#include "rule_sources.hpp"
#include "scenelore/kb/sha256.hpp"
#include "scenelore/rules/error.hpp"
#include "suggestion.hpp"

namespace scenelore::rules {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Settings named relation.tolerance, by relation.
std::map<std::string, Overrides> overrides_in(const std::map<std::string, std::string>& settings) {
  std::map<std::string, Overrides> out;
  for (const auto& [key, value] : settings) {
    const std::size_t dot = key.find('.');
    if (dot == std::string::npos) continue;
    double number = value == "true" ? 1 : 0;
    if (value != "true" && value != "false") {
      const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
      if (error != std::errc() || end != value.data() + value.size()) {
        throw Error("setting '" + key + "': '" + value + "' is no number");
      }
    }
    out[key.substr(0, dot)][key.substr(dot + 1)] = number;
  }
  return out;
}

/// The X of `converse = "X"` in a built-in file, empty for none.
std::string converse_in(const std::string& text) {
  constexpr std::string_view kField = "  converse = \"";
  const std::size_t begin = text.find(kField);
  if (begin == text.npos) return "";
  const std::size_t name = begin + kField.size();
  return text.substr(name, text.find('"', name) - name);
}

/// A fact of a relation that is known from the context.
struct Held {
  kb::PlaneId a, b;
  double degree;
};

/// Facts by a and b from the degrees of rising pairs, one a pair or, where the relation is not symmetric, two: forth and back.
std::vector<Held> by_planes(const std::vector<kb::PlaneId>& ids, const std::vector<std::pair<int, int>>& pairs, const std::vector<double>& degrees) {
  const std::size_t step = degrees.size() > pairs.size() ? 2 : 1;
  const auto for_each = [&](auto visit) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto [a, b] = pairs[i];
      const double forth = degrees[i * step], back = degrees[i * step + step - 1];
      if (forth > 0) visit(static_cast<std::size_t>(a), static_cast<std::size_t>(b), forth);
      if (back > 0) visit(static_cast<std::size_t>(b), static_cast<std::size_t>(a), back);
    }
  };
  // Of one a, those b that come before it are seen first, and all are seen rising: counting sorts them.
  std::vector<std::size_t> place(ids.size() + 1);
  for_each([&](std::size_t a, std::size_t, double) { ++place[a + 1]; });
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<Held> facts(place.back());
  for_each([&](std::size_t a, std::size_t b, double degree) { facts[place[a]++] = {ids[a], ids[b], degree}; });
  return facts;
}

}  // namespace

/// Built-in files run in one state, each when it is first asked; a user's file in a state of its own, at once, to see whether it is in
/// order.
struct RuleSet::Implementation {
  struct Entry {
    RuleSource source;
    std::unique_ptr<RuleFile> file;  // nullptr: a built-in one that was not needed yet
  };
  using Entries = std::map<std::string, Entry>;  // by name

  Budget budget;
  std::map<std::string, Overrides> overrides;  // by relation
  Entries relations, features, tuple_constraints;
  std::shared_ptr<RuleHost> built_in;  // made when a file needs it
  SceneDigest::Last last_planes;
  std::string hash;  // once it was asked for; what is loaded does not change

  [[nodiscard]] RuleFile& file(Entry& entry) {
    if (entry.file) return *entry.file;
    if (!built_in) built_in = std::make_shared<RuleHost>(budget, overrides, Trust::program);
    entry.file = std::make_unique<RuleFile>(entry.source, built_in);
    return *entry.file;
  }

  /// Shows rule files a scene as long as it lives, so that its planes are made for Lua once for all built-in files.
  class Show {
   public:
    explicit Show(const Scene& scene) : scene_(scene) {}
    Show(const Show&) = delete;
    Show& operator=(const Show&) = delete;
    ~Show() {
      for (RuleFile* file : files_) file->look_at(nullptr, nullptr);
    }
    /// The same geometry for all.
    void to(RuleFile& file, PairGeometry& geometry) {
      files_.insert(&file);
      file.look_at(&scene_, &geometry);
    }

   private:
    const Scene& scene_;
    std::set<RuleFile*> files_;
  };

  /// Built-in files are named after what they define (a test sees to it).
  void add_built_in(RuleSource source) {
    const std::size_t slash = source.shown.find_last_of('/');
    const std::string name = source.shown.substr(slash + 1, source.shown.size() - slash - 5);
    auto& entries = source.shown.starts_with("rules/relations/") ? relations : features;
    entries[name] = {std::move(source), nullptr};
  }

  void add(RuleSource source) {
    auto file = std::make_unique<RuleFile>(source, budget, overrides);
    Entries& entries = file->kind() == RuleFile::Kind::relation  ? relations
                       : file->kind() == RuleFile::Kind::feature ? features
                                                                 : tuple_constraints;
    const auto before = entries.find(file->name());
    if (before != entries.end() && !is_built_in(before->second.source)) {
      throw Error(source.shown + ": the name '" + file->name() + "' is taken by " + before->second.source.shown);
    }
    const std::string name = file->name();
    entries[name] = {std::move(source), std::move(file)};
  }

  [[nodiscard]] std::vector<std::string> relation_names() const {
    std::vector<std::string> names;
    for (const auto& [name, entry] : relations) names.push_back(name);
    return names;
  }

  [[nodiscard]] Entry& relation_entry(const std::string& name) {
    const auto found = relations.find(name);
    if (found != relations.end()) return found->second;
    throw Error("there is no relation '" + name + "'" + did_you_mean(name, relation_names()));
  }
  [[nodiscard]] RuleFile& relation(const std::string& name) { return file(relation_entry(name)); }

  /// The relation whose facts, the other way round, are those of this one; nothing where it answers for itself. Settings of its own
  /// make it do so.
  [[nodiscard]] std::optional<std::string> mirrored(const std::string& name) {
    const Entry& entry = relation_entry(name);
    const std::string other = converse_of(entry);
    const bool plain = !entry.file || entry.file->relation().plain_converse;
    if (other.empty() || !plain || overrides.contains(name)) return std::nullopt;
    const auto found = relations.find(other);
    const bool answers = found != relations.end() && converse_of(found->second).empty();  // else two could mirror each other
    return answers ? std::optional(other) : std::nullopt;
  }
  /// A built-in file need not be run to know.
  static std::string converse_of(const Entry& entry) {
    return entry.file ? entry.file->relation().converse : converse_in(entry.source.text);
  }

  /// Names all that a relation's facts depend on, when it looked at these features.
  [[nodiscard]] std::string inputs(const std::string& name, const SceneDigest& scene, const std::string& looked_at) {
    const auto found = overrides.find(name);
    const std::string own =
        fact_inputs(relation_entry(name).source, found == overrides.end() ? Overrides{} : found->second, scene.with(looked_at));
    const std::optional<std::string> other = mirrored(name);
    return other ? kb::sha256_of(own + inputs(*other, scene, looked_at)) : own;
  }

  void check_total(const RuleFile& file, Clock::time_point start, std::int64_t asked) const {
    if (Clock::now() - start <= budget.total) return;
    throw Error(file.source().shown + ": stopped after " + std::to_string(budget.total.count()) + " ms and " +
                std::to_string(asked) + " questions; '" + file.name() +
                "' is too slow for this scene: give it a smaller 'within' or a cheap 'applies'");
  }

  /// A file that has been shown the scene.
  RelationCount ask(RuleFile& file, const Scene& scene, const std::vector<std::pair<int, int>>& pairs, std::vector<Held>& facts) const {
    const Clock::time_point start = Clock::now();
    RelationCount count{.relation = file.name()};
    const RelationInfo& info = file.relation();
    constexpr std::size_t kQuestions = 64;  // between two looks at the clock
    const std::size_t at_once = info.symmetric ? kQuestions : kQuestions / 2;
    std::vector<double> degrees;
    degrees.reserve(2 * pairs.size());
    std::vector<std::pair<int, int>> both_ways;
    for (std::size_t begin = 0; begin < pairs.size(); begin += at_once) {
      check_total(file, start, static_cast<std::int64_t>(degrees.size()));
      std::span<const std::pair<int, int>> asked = std::span(pairs).subspan(begin, std::min(at_once, pairs.size() - begin));
      if (!info.symmetric) {
        both_ways.clear();
        for (const auto& [a, b] : asked) both_ways.insert(both_ways.end(), {{a, b}, {b, a}});
        asked = both_ways;
      }
      degrees.resize(degrees.size() + asked.size());
      file.degrees(asked, degrees.data() + degrees.size() - asked.size());
    }
    count.asked = static_cast<std::int64_t>(degrees.size());
    facts = by_planes(scene.ids, pairs, degrees);
    count.held = static_cast<std::int64_t>(facts.size());
    count.milliseconds = milliseconds_since(start);
    return count;
  }
};

RuleSet::RuleSet(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}
RuleSet::RuleSet(RuleSet&&) noexcept = default;
RuleSet& RuleSet::operator=(RuleSet&&) noexcept = default;
RuleSet::~RuleSet() = default;

RuleSet RuleSet::load(const std::vector<std::filesystem::path>& directories, Budget budget,
                      const std::map<std::string, std::string>& settings) {
  auto rules = std::make_unique<Implementation>();
  rules->budget = budget;
  rules->overrides = overrides_in(settings);
  for (RuleSource& source : built_in_sources()) rules->add_built_in(std::move(source));
  for (const std::filesystem::path& directory : directories) {
    for (RuleSource& source : sources_below(directory)) rules->add(std::move(source));
  }
  for (const auto& [relation, values] : rules->overrides) {
    if (!rules->relations.contains(relation)) {
      throw Error("setting '" + relation + "." + values.begin()->first + "': there is no relation '" + relation + "'" +
                  did_you_mean(relation, rules->relation_names()));
    }
    (void)rules->relation(relation);  // refuses a tolerance that it lacks
  }
  return RuleSet(std::move(rules));
}

std::vector<std::string> RuleSet::relation_names() const { return implementation_->relation_names(); }

std::vector<RelationInfo> RuleSet::relations() const {
  std::vector<RelationInfo> out;
  for (auto& [name, entry] : implementation_->relations) out.push_back(implementation_->file(entry).relation());
  return out;
}

std::string RuleSet::text(const std::string& relation) const { return implementation_->relation_entry(relation).source.text; }

std::vector<kb::Feature> RuleSet::features() const {
  std::vector<kb::Feature> out;
  for (auto& [name, entry] : implementation_->features) out.push_back(implementation_->file(entry).feature());
  return out;
}

std::vector<kb::Feature> RuleSet::new_features(const kb::Knowledge& knowledge) const {
  std::vector<kb::Feature> out;
  for (auto& [name, entry] : implementation_->features) {
    const std::string& wanted = name;
    const bool known = std::any_of(knowledge.features.begin(), knowledge.features.end(), [&](const kb::Feature& f) { return f.name == wanted; });
    if (!known) out.push_back(implementation_->file(entry).feature());
  }
  return out;
}

std::string RuleSet::hash() const {
  if (!implementation_->hash.empty()) return implementation_->hash;
  kb::Sha256 hash;
  const auto add = [&](std::string_view text) {
    hash.add(std::to_string(text.size()) + ":");
    hash.add(text);
  };
  add(embedded("rules/lua/prelude.lua"));
  for (const auto* entries : {&implementation_->relations, &implementation_->features, &implementation_->tuple_constraints}) {
    for (const auto& [name, entry] : *entries) {
      add(name);
      add(entry.source.text);
    }
  }
  for (const auto& [relation, values] : implementation_->overrides) {
    for (const auto& [field, value] : values) add(relation + "." + field + "=" + std::to_string(value));
  }
  return implementation_->hash = hash.hex();
}

namespace {

template <typename T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Takes a value from the front; the bytes must be enough.
template <typename T>
T take(std::string_view& bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return value;
}

/// The answers of the run before to a rule, if it was the same rule about the same planes; they are kept on. Else nullptr.
const kb::StoredAnswer* kept_answer(KeptAnswers* kept, const std::string& rule, const RuleSource& source, const SceneDigest& scene) {
  if (kept == nullptr) return nullptr;
  const auto found = kept->before.find(rule);
  if (found == kept->before.end() || found->second.inputs_sha256 != fact_inputs(source, {}, scene.with(found->second.features))) return nullptr;
  return &(kept->now[rule] = found->second);
}

void keep(KeptAnswers* kept, const std::string& rule, const RuleFile& file, const SceneDigest& scene, std::string answers) {
  if (kept == nullptr) return;
  const std::string features = file.features_read();
  kept->now[rule] = {features, fact_inputs(file.source(), {}, scene.with(features)), std::move(answers)};
}

}  // namespace

void RuleSet::compute_features(const Scene& scene, kb::FeatureTable& table, KeptAnswers* kept) const {
  PairGeometry geometry(scene.planes);
  Implementation::Show show(scene);
  const SceneDigest digest(scene, implementation_->last_planes);  // `table` is often the scene's own: a feature may look at those before it
  table.values.resize(scene.planes.size(), std::vector<double>(table.names.size()));
  for (auto& [name, entry] : implementation_->features) {
    if (std::find(table.names.begin(), table.names.end(), name) != table.names.end()) {
      throw Error(entry.source.shown + ": the feature '" + name + "' exists already; choose another name");
    }
    const std::string rule = "feature " + name;
    const kb::StoredAnswer* known = kept_answer(kept, rule, entry.source, digest);
    if (known != nullptr && known->answers.size() == scene.planes.size() * sizeof(double)) {
      std::string_view bytes = known->answers;
      for (std::vector<double>& row : table.values) row.push_back(take<double>(bytes));
      table.names.push_back(name);
      continue;
    }
    RuleFile* const file = &implementation_->file(entry);
    const Clock::time_point start = Clock::now();
    table.names.push_back(name);
    show.to(*file, geometry);
    std::string answers;
    for (std::size_t i = 0; i < scene.planes.size(); ++i) {
      implementation_->check_total(*file, start, static_cast<std::int64_t>(i));
      table.values[i].push_back(file->value(static_cast<int>(i)));
      put(answers, table.values[i].back());
    }
    keep(kept, rule, *file, digest, std::move(answers));
  }
}

namespace {

/// Facts by a and b, those of a run before or found now.
struct Answer {
  const std::vector<kb::RelationFact>* known = nullptr;
  std::vector<Held> found;
  kb::RelationAsked asked;

  [[nodiscard]] std::size_t size() const { return known != nullptr ? known->size() : found.size(); }
  template <typename Visit>
  void for_each(Visit visit) const {
    for (const Held& fact : found) visit(fact.a, fact.b, fact.degree);
    if (known == nullptr) return;
    for (const kb::RelationFact& fact : *known) visit(fact.a, fact.b, fact.degree);
  }
};

void sort_by_planes(std::vector<Held>& facts) {
  const auto before = [](const Held& f, const Held& g) { return std::pair(f.a, f.b) < std::pair(g.a, g.b); };
  if (!std::is_sorted(facts.begin(), facts.end(), before)) std::sort(facts.begin(), facts.end(), before);
}

}  // namespace

Facts RuleSet::relate(const Scene& scene, const std::vector<std::string>& relations, const KnownAnswers& known) {
  Facts out;
  const SceneDigest digest(scene, implementation_->last_planes);
  KeptGeometry geometry(scene, digest);
  Implementation::Show show(scene);
  std::vector<Box3> boxes;
  std::map<std::pair<double, double>, std::vector<std::pair<int, int>>> pairs;  // by reach, which many relations share
  std::map<std::string, Answer> answers;
  const auto answer = [&](const auto& self, const std::string& name) -> const Answer& {
    const auto [entry, fresh] = answers.try_emplace(name);
    Answer& result = entry->second;
    if (!fresh) return result;
    const auto found = known.facts.find(name);
    const auto is_answered = [&](const kb::RelationAsked& asked) {
      return asked.inputs_sha256 == implementation_->inputs(name, digest, asked.features);
    };
    if (found != known.facts.end() && is_answered(found->second.asked)) {
      result.known = &found->second.facts;
      result.asked = found->second.asked;
      return result;
    }
    if (const std::optional<std::string> other = implementation_->mirrored(name)) {
      const Clock::time_point start = Clock::now();
      const Answer& there = self(self, *other);
      there.for_each([&](kb::PlaneId a, kb::PlaneId b, double degree) { result.found.push_back({b, a, degree}); });
      result.asked = there.asked;
      out.counts.push_back({.relation = name, .asked = there.asked.asked, .held = there.asked.held, .milliseconds = milliseconds_since(start)});
    } else {
      if (boxes.empty()) boxes = boxes_of(scene.planes);
      RuleFile& file = implementation_->relation(name);
      const RelationInfo& info = file.relation();
      const auto [list, new_reach] = pairs.try_emplace({info.within, info.within_plan});
      if (new_reach) list->second = pairs_in_reach(boxes, info.within, info.within_plan);
      show.to(file, geometry.with(known.geometry));
      out.counts.push_back(implementation_->ask(file, scene, list->second, result.found));
      result.asked = {.asked = out.counts.back().asked, .held = out.counts.back().held, .within = info.within,
                      .within_plan = info.within_plan, .features = file.features_read()};
    }
    result.asked.stored = false;
    result.asked.inputs_sha256 = implementation_->inputs(name, digest, result.asked.features);
    sort_by_planes(result.found);
    return result;
  };
  const std::set<std::string> names(relations.begin(), relations.end());
  std::size_t facts = 0;
  for (const std::string& name : names) facts += answer(answer, name).size();
  out.facts.reserve(facts);
  for (const std::string& name : names) {
    const Answer& result = answers.at(name);
    result.for_each([&](kb::PlaneId a, kb::PlaneId b, double degree) { out.facts.push_back({name, a, b, degree}); });
    out.asked[name] = result.asked;
    out.reach[name] = {result.asked.within, result.asked.within_plan};
  }
  std::sort(out.counts.begin(), out.counts.end(), [](const RelationCount& a, const RelationCount& b) { return a.relation < b.relation; });
  out.geometry = geometry.kept(known.geometry);
  return out;
}

std::vector<TupleConstraint> RuleSet::declared_constraints() const {
  std::vector<TupleConstraint> out;
  for (auto& [name, entry] : implementation_->tuple_constraints) out.push_back(implementation_->file(entry).constraint());
  return out;
}

namespace {

std::string encoded(const std::vector<TupleConstraint::Tuple>& tuples) {
  std::string bytes;
  for (const TupleConstraint::Tuple& tuple : tuples) {
    for (const kb::PlaneId plane : tuple.planes) put(bytes, plane);
    put(bytes, tuple.degree);
  }
  return bytes;
}

/// Tuples of so many planes; nothing for bytes that are none.
std::optional<std::vector<TupleConstraint::Tuple>> decoded(std::string_view bytes, std::size_t planes) {
  if (bytes.size() % (8 * (planes + 1)) != 0) return std::nullopt;
  std::vector<TupleConstraint::Tuple> out;
  while (!bytes.empty()) {
    TupleConstraint::Tuple& tuple = out.emplace_back();
    for (std::size_t i = 0; i < planes; ++i) tuple.planes.push_back(take<kb::PlaneId>(bytes));
    tuple.degree = take<double>(bytes);
  }
  return out;
}

}  // namespace

std::vector<TupleConstraint> RuleSet::constraints(const Scene& scene, const kb::Knowledge& knowledge, kb::StoredGeometry* known,
                                                  KeptAnswers* answers) const {
  std::vector<TupleConstraint> out;
  if (implementation_->tuple_constraints.empty()) return out;
  const SceneDigest digest(scene, implementation_->last_planes);
  KeptGeometry kept(scene, digest);
  PairGeometry& geometry = kept.with(known == nullptr ? kb::StoredGeometry{} : *known);
  Implementation::Show show(scene);
  const std::vector<Box3> boxes = boxes_of(scene.planes);
  for (auto& [name, entry] : implementation_->tuple_constraints) {
    RuleFile& file = implementation_->file(entry);
    TupleConstraint constraint = file.constraint();
    for (const std::string& object_class : constraint.classes) (void)require_class(knowledge, object_class, file.source().shown);
    for (const kb::ClassConstraint& row : knowledge.constraints) {
      if (row.name == name) throw Error(file.source().shown + ": the name '" + name + "' is taken by a row of class_constraint");
    }
    const std::string rule = "constraint " + name;
    const kb::StoredAnswer* const before = kept_answer(answers, rule, entry.source, digest);
    if (auto tuples = before == nullptr ? std::nullopt : decoded(before->answers, constraint.classes.size())) {
      constraint.tuples = std::move(*tuples);
      out.push_back(std::move(constraint));
      continue;
    }
    const Clock::time_point start = Clock::now();
    std::int64_t asked = 0;
    std::vector<std::vector<int>> neighbours(scene.planes.size());
    for (const auto& [a, b] : pairs_in_reach(boxes, constraint.within, constraint.within)) {
      neighbours[static_cast<std::size_t>(a)].push_back(b);
      neighbours[static_cast<std::size_t>(b)].push_back(a);
    }
    show.to(file, geometry);
    for (int a = 0; a < geometry.size(); ++a) {
      std::vector<int>& near = neighbours[static_cast<std::size_t>(a)];
      std::sort(near.begin(), near.end());
      std::vector<int> tuple{a};
      const auto extend = [&](const auto& self) -> void {
        if (tuple.size() == constraint.classes.size()) {
          if (asked++ % 64 == 0) implementation_->check_total(file, start, asked);
          const std::optional<double> degree = file.degree(tuple);
          if (!degree || (constraint.quantifier == kb::Quantifier::every ? *degree >= 1 : *degree <= 0)) return;
          std::vector<kb::PlaneId> ids;
          for (const int plane : tuple) ids.push_back(scene.ids[static_cast<std::size_t>(plane)]);
          constraint.tuples.push_back({std::move(ids), *degree});
          return;
        }
        for (const int b : near) {
          if (std::find(tuple.begin(), tuple.end(), b) != tuple.end()) continue;
          tuple.push_back(b);
          self(self);
          tuple.pop_back();
        }
      };
      extend(extend);
    }
    keep(answers, rule, file, digest, encoded(constraint.tuples));
    out.push_back(std::move(constraint));
  }
  if (known != nullptr) *known = kept.kept(*known);
  return out;
}

double RuleSet::degree(const std::string& relation, const Scene& scene, int a, int b) const {
  if (const std::optional<std::string> other = implementation_->mirrored(relation)) return degree(*other, scene, b, a);
  PairGeometry geometry(scene.planes);
  Implementation::Show show(scene);
  RuleFile& file = implementation_->relation(relation);
  show.to(file, geometry);
  return file.degree(a, b);
}

}  // namespace scenelore::rules
