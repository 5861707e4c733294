// Relations and features written in Lua, loaded at run time (docs/rules.md).
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scenelore/kb/evidence.hpp"
#include "scenelore/kb/inference.hpp"
#include "scenelore/kb/knowledge.hpp"
#include "scenelore/rules/scene.hpp"

namespace scenelore::rules {

/// Limits of one call into a rule file; exceeding one is an Error that names file and line.
struct Budget {
  std::int64_t instructions = 10'000'000;
  std::chrono::milliseconds time{2000};
  std::size_t memory_bytes = 16u << 20;
};

struct RelationInfo {
  std::string name, summary, file;
  double within = 0;  ///< metres
  bool symmetric = false;
};

/// What the relations cost and found.
struct RelationCount {
  std::string relation;
  std::int64_t asked = 0, held = 0;
  double milliseconds = 0;
};

struct Facts {
  std::vector<kb::RelationFact> facts;  ///< by relation, a, b
  std::vector<RelationCount> counts;
};

/// The built-in files plus all *.lua below `directories` (but *_test.lua), in name order; a user's relation or feature
/// replaces a built-in one of the same name. Each file runs in a sandboxed state of its own.
class RuleSet {
 public:
  static RuleSet load(const std::vector<std::filesystem::path>& directories = {}, Budget budget = {});
  RuleSet(RuleSet&&) noexcept;
  RuleSet& operator=(RuleSet&&) noexcept;
  ~RuleSet();

  [[nodiscard]] std::vector<RelationInfo> relations() const;  ///< by name
  [[nodiscard]] std::vector<kb::Feature> features() const;    ///< of Lua feature files; weight 1
  [[nodiscard]] std::string hash() const;                     ///< SHA-256 over names and texts

  /// Appends the Lua features' values to `table`.
  void compute_features(const Scene& scene, kb::FeatureTable& table);
  /// Which of the named relations hold between which planes; only pairs within reach are asked.
  Facts relate(const Scene& scene, const std::vector<std::string>& relations);

 private:
  struct Implementation;
  explicit RuleSet(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace scenelore::rules
