#include "scenelore/rules/rule_set.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "lua_files.hpp"
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

}  // namespace

struct RuleSet::Implementation {
  Budget budget;
  std::map<std::string, std::unique_ptr<RuleFile>> relations, features;  // by name

  void add(RuleSource source, const std::map<std::string, Overrides>& overrides) {
    auto file = std::make_unique<RuleFile>(std::move(source), budget, overrides);
    auto& files = file->kind() == RuleFile::Kind::relation ? relations : features;
    const auto before = files.find(file->name());
    if (before != files.end() && !is_built_in(before->second->source())) {
      throw Error(file->source().shown + ": the name '" + file->name() + "' is taken by " +
                  before->second->source().shown);
    }
    files[file->name()] = std::move(file);
  }

  [[nodiscard]] std::vector<std::string> relation_names() const {
    std::vector<std::string> names;
    for (const auto& [name, file] : relations) names.push_back(name);
    return names;
  }

  [[nodiscard]] RuleFile& relation(const std::string& name) const {
    const auto found = relations.find(name);
    if (found != relations.end()) return *found->second;
    throw Error("there is no relation '" + name + "'" + did_you_mean(name, relation_names()));
  }

  void check_total(const RuleFile& file, Clock::time_point start, std::int64_t asked) const {
    if (Clock::now() - start <= budget.total) return;
    throw Error(file.source().shown + ": stopped after " + std::to_string(budget.total.count()) + " ms and " +
                std::to_string(asked) + " questions; '" + file.name() +
                "' is too slow for this scene: give it a smaller 'within' or a cheap 'applies'");
  }

  RelationCount ask(RuleFile& file, const Scene& scene, PairGeometry& geometry, const std::vector<Box3>& boxes,
                    std::vector<kb::RelationFact>& facts) const {
    const Clock::time_point start = Clock::now();
    RelationCount count{.relation = file.name()};
    file.look_at(&scene, &geometry);
    const RelationInfo& info = file.relation();
    const auto id = [&](int plane) { return scene.ids[static_cast<std::size_t>(plane)]; };
    const auto hold = [&](int a, int b, double degree) {
      if (degree <= 0) return;
      ++count.held;
      facts.push_back({info.name, id(a), id(b), degree});
    };
    for (const auto& [a, b] : pairs_in_reach(boxes, info.within, info.within_plan)) {
      if (count.asked % 64 == 0) check_total(file, start, count.asked);
      const double forth = file.degree(a, b);
      const double back = info.symmetric ? forth : file.degree(b, a);
      count.asked += info.symmetric ? 1 : 2;
      hold(a, b, forth);
      hold(b, a, back);
    }
    file.look_at(nullptr, nullptr);
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
  const std::map<std::string, Overrides> overrides = overrides_in(settings);
  for (RuleSource& source : built_in_sources()) rules->add(std::move(source), overrides);
  for (const std::filesystem::path& directory : directories) {
    for (RuleSource& source : sources_below(directory)) rules->add(std::move(source), overrides);
  }
  for (const auto& [relation, values] : overrides) {
    if (rules->relations.contains(relation)) continue;
    throw Error("setting '" + relation + "." + values.begin()->first + "': there is no relation '" + relation + "'" +
                did_you_mean(relation, rules->relation_names()));
  }
  return RuleSet(std::move(rules));
}

std::vector<RelationInfo> RuleSet::relations() const {
  std::vector<RelationInfo> out;
  for (const auto& [name, file] : implementation_->relations) out.push_back(file->relation());
  return out;
}

std::vector<kb::Feature> RuleSet::features() const {
  std::vector<kb::Feature> out;
  for (const auto& [name, file] : implementation_->features) out.push_back(file->feature());
  return out;
}

std::string RuleSet::hash() const {
  kb::Sha256 hash;
  const auto add = [&](std::string_view text) {
    hash.add(std::to_string(text.size()) + ":");
    hash.add(text);
  };
  add(embedded("rules/lua/prelude.lua"));
  for (const auto* files : {&implementation_->relations, &implementation_->features}) {
    for (const auto& [name, file] : *files) {
      add(name);
      add(file->source().text);
      for (const auto& [field, value] : file->relation().tolerances) add(field + "=" + std::to_string(value));
    }
  }
  return hash.hex();
}

void RuleSet::compute_features(const Scene& scene, kb::FeatureTable& table) {
  PairGeometry geometry(scene.planes);
  table.values.resize(scene.planes.size(), std::vector<double>(table.names.size()));
  for (auto& [name, file] : implementation_->features) {
    if (std::find(table.names.begin(), table.names.end(), name) != table.names.end()) {
      throw Error(file->source().shown + ": the feature '" + name + "' exists already; choose another name");
    }
    const Clock::time_point start = Clock::now();
    table.names.push_back(name);
    file->look_at(&scene, &geometry);
    for (std::size_t i = 0; i < scene.planes.size(); ++i) {
      implementation_->check_total(*file, start, static_cast<std::int64_t>(i));
      table.values[i].push_back(file->value(static_cast<int>(i)));
    }
    file->look_at(nullptr, nullptr);
  }
}

Facts RuleSet::relate(const Scene& scene, const std::vector<std::string>& relations) {
  Facts out;
  PairGeometry geometry(scene.planes);
  std::vector<Box3> boxes;
  for (int i = 0; i < geometry.size(); ++i) boxes.push_back(geometry.shape(i).box);
  for (const std::string& name : std::set<std::string>(relations.begin(), relations.end())) {
    RuleFile& file = implementation_->relation(name);
    const std::size_t first = out.facts.size();
    out.counts.push_back(implementation_->ask(file, scene, geometry, boxes, out.facts));
    out.reach[name] = {file.relation().within, file.relation().within_plan};
    std::sort(out.facts.begin() + static_cast<std::ptrdiff_t>(first), out.facts.end(),
              [](const auto& f, const auto& g) { return std::pair(f.a, f.b) < std::pair(g.a, g.b); });
  }
  return out;
}

double RuleSet::degree(const std::string& relation, const Scene& scene, int a, int b) const {
  PairGeometry geometry(scene.planes);
  RuleFile& file = implementation_->relation(relation);
  file.look_at(&scene, &geometry);
  const double degree = file.degree(a, b);
  file.look_at(nullptr, nullptr);
  return degree;
}

}  // namespace scenelore::rules
