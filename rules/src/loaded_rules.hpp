// The rule files of a RuleSet: texts by name, each run when it is first needed.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fact_inputs.hpp"
#include "rule_file.hpp"

namespace scenelore::rules {

/// Built-in files run in one state, each when it is first asked; a user's file in a state of its own, at once, to see whether it is in
/// order.
class LoadedRules {
 public:
  struct Entry {
    RuleSource source;
    std::unique_ptr<RuleFile> file;  // nullptr: a built-in one that was not needed yet
    bool built_in = false;           // whatever its source is called
  };
  using Entries = std::map<std::string, Entry>;  // by name

  /// Overrides by relation.
  LoadedRules(const Budget& budget, std::map<std::string, Overrides> overrides) : budget_(budget), overrides_(std::move(overrides)) {}

  /// Built-in files are named after what they define (a test sees to it).
  void add_built_in(RuleSource source);
  /// Replaces a built-in one of the same name. Throws Error for a broken file, and for a name that another one of the user's has.
  void add(RuleSource source);
  /// To be called when all are loaded. Throws Error for an override that fits nothing.
  void check_overrides();

  [[nodiscard]] const Budget& budget() const { return budget_; }
  [[nodiscard]] Entries& relations() { return relations_; }
  [[nodiscard]] Entries& features() { return features_; }
  [[nodiscard]] Entries& tuple_constraints() { return tuple_constraints_; }
  [[nodiscard]] RuleFile& file(Entry& entry);

  [[nodiscard]] std::vector<std::string> relation_names() const;
  /// Throws Error with "did you mean" for one that is not there.
  [[nodiscard]] Entry& relation_entry(const std::string& name);
  [[nodiscard]] RuleFile& relation(const std::string& name) { return file(relation_entry(name)); }
  /// The relation in state number `state`, for one of several threads: 0 is the state that all others use, further ones have built-in files
  /// only. Each state may be used by one thread at a time, after so many have been announced.
  [[nodiscard]] RuleFile& relation(const std::string& name, std::size_t state);
  void announce_states(std::size_t count) { further_.resize(std::max(count - 1, further_.size())); }
  /// The relation whose facts, the other way round, are those of this one; nothing where it answers for itself. Settings of its own
  /// make it do so.
  [[nodiscard]] std::optional<std::string> mirrored(const std::string& name);

  /// Of what the files can see of a scene, which must live as long.
  [[nodiscard]] SceneDigest digest_of(const Scene& scene) { return SceneDigest(scene, last_planes_); }
  /// Names all that a relation's facts depend on, when it looked at these features.
  [[nodiscard]] std::string inputs(const std::string& name, const SceneDigest& scene, const std::string& looked_at);
  /// SHA-256 over names and texts; what is loaded must not change afterwards.
  [[nodiscard]] const std::string& hash();

 private:
  struct BuiltIn {
    std::shared_ptr<RuleHost> host;
    std::map<std::string, std::unique_ptr<RuleFile>> files{};  // by name
  };

  [[nodiscard]] std::string no_such_relation(const std::string& name) const;

  Budget budget_;
  std::map<std::string, Overrides> overrides_;  // by relation
  Entries relations_, features_, tuple_constraints_;
  std::shared_ptr<RuleHost> built_in_;  // made when a file needs it
  std::vector<BuiltIn> further_;        // states for other threads
  SceneDigest::Last last_planes_;
  std::string hash_;  // once it was asked for
};

}  // namespace scenelore::rules
