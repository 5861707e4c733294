// Relations and features written in Lua, loaded at run time (docs/rules.md).
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenelore/kb/evidence.hpp"
#include "scenelore/kb/inference.hpp"
#include "scenelore/kb/knowledge.hpp"
#include "scenelore/rules/scene.hpp"

namespace scenelore::rules {

/// Limits of one call into a rule file of a user's; exceeding one is an Error that names file and line. Of built-in files, memory alone.
struct Budget {
  std::int64_t instructions = 10'000'000;
  std::chrono::milliseconds time{2000};
  std::size_t memory_bytes = 16u << 20;
  std::chrono::milliseconds total{60'000};  ///< for all calls of one relation (or feature) on one scene
};

struct RelationInfo {
  std::string name, summary, file;
  double within = 0;       ///< metres between the boxes; infinite = no limit
  double within_plan = 0;  ///< the same seen from above
  bool symmetric = false;
  std::string converse;    ///< of which relation this is the other way round; empty = of none
  bool plain_converse = false;  ///< its file has nothing of its own, so that its facts are the other's
  std::map<std::string, double> tolerances;  ///< named fields, as they are in force; booleans as 0 and 1
};

/// What the relations cost and found.
struct RelationCount {
  std::string relation;
  std::int64_t asked = 0, held = 0;  ///< ordered pairs; held = with a degree above 0
  double milliseconds = 0;           ///< of all threads together
};

/// How far a relation reaches: planes whose boxes are further apart than this are none of its business.
struct Reach {
  double within = std::numeric_limits<double>::infinity();
  double within_plan = std::numeric_limits<double>::infinity();
};

/// A constraint written in Lua, over two to four planes at once, and what it found in a scene.
struct TupleConstraint {
  std::string name, summary, file;
  std::vector<std::string> classes;  ///< of the planes, that of the first first
  /// `no`: each tuple pays weight · degree; `every`: weight · (1 − degree); `some`: each first plane pays weight · (1 − degree
  /// of its best tuple), all of it without one.
  kb::Quantifier quantifier = kb::Quantifier::no;
  std::optional<double> weight;      ///< nats; nothing = hard
  double within = 0;                 ///< metres between the box of the first plane and those of the others
  struct Tuple {
    std::vector<kb::PlaneId> planes;
    double degree = 0;
  };
  std::vector<Tuple> tuples;         ///< by planes; those that change nothing are left out
};

struct Facts {
  std::vector<kb::RelationFact> facts;  ///< by relation, a, b
  std::vector<RelationCount> counts;
  std::map<std::string, Reach> reach;  ///< by relation; one without an entry reaches everywhere
  std::vector<TupleConstraint> constraints;  ///< of Lua files, by name
  std::map<std::string, kb::RelationAsked> asked;  ///< by relation; what the knowledge base keeps beside the facts
  kb::StoredGeometry geometry;                     ///< for the next run; empty = nothing new
  std::map<std::string, kb::StoredAnswer> answers;  ///< of Lua features and constraints, for the next run
};

/// What the knowledge base keeps from the last run over a scan. All of it is checked against what it was found from.
struct KnownAnswers {
  std::map<std::string, kb::StoredFacts> facts;  ///< by relation
  kb::StoredGeometry geometry;
  std::map<std::string, kb::StoredAnswer> rules;  ///< by "feature NAME" or "constraint NAME"
};

/// Answers of the run before, and those to keep for the next one.
struct KeptAnswers {
  const std::map<std::string, kb::StoredAnswer>& before;
  std::map<std::string, kb::StoredAnswer> now = {};
};

class LoadedRules;

/// The built-in files plus all *.lua below `directories` (but *_test.lua), in name order; a user's relation or feature
/// replaces a built-in one of the same name. Each file of a user's runs in a sandboxed state of its own. Not safe for concurrent use.
class RuleSet {
 public:
  /// `settings` named `relation.tolerance` (say `above.reach` = `0.4`) replace tolerances of relations; the others are
  /// not looked at. Throws Error naming file, line and field for a broken file, and for a setting that fits nothing.
  static RuleSet load(const std::vector<std::filesystem::path>& directories = {}, Budget budget = {},
                      const std::map<std::string, std::string>& settings = {});
  RuleSet(RuleSet&&) noexcept;
  RuleSet& operator=(RuleSet&&) noexcept;
  ~RuleSet();

  [[nodiscard]] std::vector<std::string> relation_names() const;  ///< rising
  [[nodiscard]] std::vector<RelationInfo> relations() const;      ///< by name
  [[nodiscard]] std::string text(const std::string& relation) const;  ///< of its file; throws Error with "did you mean"
  [[nodiscard]] std::vector<kb::Feature> features() const;    ///< of Lua feature files; weight 1
  /// Those among them that the knowledge lacks; files of others need not be run to know.
  [[nodiscard]] std::vector<kb::Feature> new_features(const kb::Knowledge& knowledge) const;
  [[nodiscard]] std::string hash() const;                     ///< SHA-256 over names and texts

  /// Appends the Lua features' values to `table`; NaN where a feature does not know.
  /// `kept`, when given, spares asking those whose file and planes are as they were.
  void compute_features(const Scene& scene, kb::FeatureTable& table, KeptAnswers* kept = nullptr) const;
  /// Which of the named relations hold between which planes; only pairs within reach are asked. A relation whose rule and
  /// planes are those of an entry of `known` is not asked at all; one that is asked finds the geometry there. The result does not depend
  /// on `threads`; a user's files are asked by one.
  Facts relate(const Scene& scene, const std::vector<std::string>& relations, const KnownAnswers& known = {}, int threads = 2);
  /// The constraints of Lua files with the tuples of planes that change something. Throws Error for a class that is not there,
  /// and for a name that a row has too. `geometry`, when given, is used and brought up to date; `kept` spares asking those whose file and
  /// planes are as they were.
  std::vector<TupleConstraint> constraints(const Scene& scene, const kb::Knowledge& knowledge, kb::StoredGeometry* geometry = nullptr,
                                           KeptAnswers* kept = nullptr) const;
  /// Their names, without asking them anything.
  [[nodiscard]] std::vector<TupleConstraint> declared_constraints() const;
  /// The degree of one relation between two planes by index, wherever they are; for checks and tests.
  [[nodiscard]] double degree(const std::string& relation, const Scene& scene, int a, int b) const;

 private:
  explicit RuleSet(std::unique_ptr<LoadedRules> loaded);
  std::unique_ptr<LoadedRules> loaded_;
};

}  // namespace scenelore::rules
