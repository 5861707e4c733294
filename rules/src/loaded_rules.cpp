#include "loaded_rules.hpp"

#include <cassert>
#include <utility>

#include "lua_files.hpp"
#include "rule_sources.hpp"
#include "scenelore/kb/sha256.hpp"
#include "scenelore/rules/error.hpp"
#include "suggestion.hpp"

namespace scenelore::rules {

namespace {

/// The X of `converse = "X"` in a built-in file, empty for none.
std::string converse_in(const std::string& text) {
  constexpr std::string_view kField = "  converse = \"";
  const std::size_t begin = text.find(kField);
  if (begin == text.npos) return "";
  const std::size_t name = begin + kField.size();
  return text.substr(name, text.find('"', name) - name);
}

/// A built-in file need not be run to know.
std::string converse_of(const LoadedRules::Entry& entry) {
  return entry.file ? entry.file->relation().converse : converse_in(entry.source.text);
}

}  // namespace

void LoadedRules::add_built_in(RuleSource source) {
  const std::size_t slash = source.shown.find_last_of('/');
  const std::string name = source.shown.substr(slash + 1, source.shown.size() - slash - 5);
  auto& entries = source.shown.starts_with("rules/relations/") ? relations_ : features_;
  entries[name] = {std::move(source), nullptr, true};
}

void LoadedRules::add(RuleSource source) {
  auto file = std::make_unique<RuleFile>(source, budget_, overrides_);
  Entries& entries = file->kind() == RuleFile::Kind::relation  ? relations_
                     : file->kind() == RuleFile::Kind::feature ? features_
                                                               : tuple_constraints_;
  const auto before = entries.find(file->name());
  if (before != entries.end() && !is_built_in(before->second.source)) {
    throw Error(source.shown + ": the name '" + file->name() + "' is taken by " + before->second.source.shown);
  }
  const std::string name = file->name();
  entries[name] = {std::move(source), std::move(file)};
}

void LoadedRules::check_overrides() {
  for (const auto& [name, values] : overrides_) {
    if (!relations_.contains(name)) throw Error("setting '" + name + "." + values.begin()->first + "': " + no_such_relation(name));
    (void)relation(name);  // refuses a tolerance that it lacks
  }
}

RuleFile& LoadedRules::file(Entry& entry) {
  if (entry.file) return *entry.file;
  if (!built_in_) built_in_ = std::make_shared<RuleHost>(budget_, overrides_, Trust::program);
  entry.file = std::make_unique<RuleFile>(entry.source, built_in_);
  return *entry.file;
}

RuleFile& LoadedRules::relation(const std::string& name, std::size_t state) {
  Entry& entry = relation_entry(name);
  if (state == 0) return file(entry);
  assert(entry.built_in);  // its state trusts it
  BuiltIn& further = further_[state - 1];
  std::unique_ptr<RuleFile>& copy = further.files[name];
  if (copy) return *copy;
  if (!further.host) further.host = std::make_shared<RuleHost>(budget_, overrides_, Trust::program);
  copy = std::make_unique<RuleFile>(entry.source, further.host);
  return *copy;
}

std::vector<std::string> LoadedRules::relation_names() const {
  std::vector<std::string> names;
  for (const auto& [name, entry] : relations_) names.push_back(name);
  return names;
}

std::string LoadedRules::no_such_relation(const std::string& name) const {
  return "there is no relation '" + name + "'" + did_you_mean(name, relation_names());
}

LoadedRules::Entry& LoadedRules::relation_entry(const std::string& name) {
  const auto found = relations_.find(name);
  if (found != relations_.end()) return found->second;
  throw Error(no_such_relation(name));
}

std::optional<std::string> LoadedRules::mirrored(const std::string& name) {
  const Entry& entry = relation_entry(name);
  const std::string other = converse_of(entry);
  const bool plain = !entry.file || entry.file->relation().plain_converse;
  if (other.empty() || !plain || overrides_.contains(name)) return std::nullopt;
  const auto found = relations_.find(other);
  const bool answers = found != relations_.end() && converse_of(found->second).empty();  // else two could mirror each other
  return answers ? std::optional(other) : std::nullopt;
}

std::string LoadedRules::inputs(const std::string& name, const SceneDigest& scene, const std::string& looked_at) {
  const auto found = overrides_.find(name);
  const std::string own =
      fact_inputs(relation_entry(name).source, found == overrides_.end() ? Overrides{} : found->second, scene.with(looked_at));
  const std::optional<std::string> other = mirrored(name);
  return other ? kb::sha256_of(own + inputs(*other, scene, looked_at)) : own;
}

const std::string& LoadedRules::hash() {
  if (!hash_.empty()) return hash_;
  kb::Sha256 hash;
  const auto add = [&](std::string_view text) {
    hash.add(std::to_string(text.size()) + ":");
    hash.add(text);
  };
  add(embedded("rules/lua/prelude.lua"));
  for (const auto* entries : {&relations_, &features_, &tuple_constraints_}) {
    for (const auto& [name, entry] : *entries) {
      add(name);
      add(entry.source.text);
    }
  }
  for (const auto& [relation, values] : overrides_) {
    for (const auto& [field, value] : values) add(relation + "." + field + "=" + std::to_string(value));
  }
  return hash_ = hash.hex();
}

}  // namespace scenelore::rules
