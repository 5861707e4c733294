#include "scenelore/rules/rule_set.hpp"

#include <algorithm>
#include <charconv>

#include "loaded_rules.hpp"
#include "rule_sources.hpp"
#include "scenelore/rules/error.hpp"

namespace scenelore::rules {

namespace {

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

RuleSet::RuleSet(std::unique_ptr<LoadedRules> loaded) : loaded_(std::move(loaded)) {}
RuleSet::RuleSet(RuleSet&&) noexcept = default;
RuleSet& RuleSet::operator=(RuleSet&&) noexcept = default;
RuleSet::~RuleSet() = default;

RuleSet RuleSet::load(const std::vector<std::filesystem::path>& directories, Budget budget,
                      const std::map<std::string, std::string>& settings) {
  auto rules = std::make_unique<LoadedRules>(budget, overrides_in(settings));
  for (RuleSource& source : built_in_sources()) rules->add_built_in(std::move(source));
  for (const std::filesystem::path& directory : directories) {
    for (RuleSource& source : sources_below(directory)) rules->add(std::move(source));
  }
  rules->check_overrides();
  return RuleSet(std::move(rules));
}

std::vector<std::string> RuleSet::relation_names() const { return loaded_->relation_names(); }

std::vector<RelationInfo> RuleSet::relations() const {
  std::vector<RelationInfo> out;
  for (auto& [name, entry] : loaded_->relations()) out.push_back(loaded_->file(entry).relation());
  return out;
}

std::string RuleSet::text(const std::string& relation) const { return loaded_->relation_entry(relation).source.text; }

std::vector<kb::Feature> RuleSet::features() const {
  std::vector<kb::Feature> out;
  for (auto& [name, entry] : loaded_->features()) out.push_back(loaded_->file(entry).feature());
  return out;
}

std::vector<kb::Feature> RuleSet::new_features(const kb::Knowledge& knowledge) const {
  std::vector<kb::Feature> out;
  for (auto& [name, entry] : loaded_->features()) {
    const std::string& wanted = name;
    const bool known = std::any_of(knowledge.features.begin(), knowledge.features.end(), [&](const kb::Feature& f) { return f.name == wanted; });
    if (!known) out.push_back(loaded_->file(entry).feature());
  }
  return out;
}

std::vector<TupleConstraint> RuleSet::declared_constraints() const {
  std::vector<TupleConstraint> out;
  for (auto& [name, entry] : loaded_->tuple_constraints()) out.push_back(loaded_->file(entry).constraint());
  return out;
}

std::string RuleSet::hash() const { return loaded_->hash(); }

}  // namespace scenelore::rules
