// What the engine found out about one scan, as values that the knowledge base stores.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scenelore::kb {

using ScanId = std::int64_t;
using PlaneId = std::int64_t;

struct RelationFact {
  std::string relation;
  PlaneId a = 0, b = 0;
  double degree = 1;  ///< in (0, 1]
};

/// How the facts of one relation about one scan were found.
struct RelationAsked {
  std::int64_t asked = 0, held = 0;  ///< ordered pairs of planes
  double within = std::numeric_limits<double>::infinity();       ///< metres between boxes: pairs further apart are not asked
  double within_plan = std::numeric_limits<double>::infinity();  ///< the same seen from above
  std::string inputs_sha256;         ///< names all that the facts depend on: the same again gives the same facts
  bool stored = false;               ///< the facts come from the knowledge base, which holds them
  std::string features;              ///< of the catalogue that the rule looked at: names, one a line
};

struct Run {
  std::string outcome;  ///< proved, feasible, infeasible, stopped
  double cost = 0, lower_bound = 0;
  std::int64_t nodes = 0;
  double seconds = 0;
  std::string knowledge_hash, rules_hash, engine_version;
};

struct Label {
  PlaneId plane = 0;
  std::string object_class;
  double probability = 0;  ///< adjusted: marginal over the consistent world models
  double margin = 0;       ///< extra cost of the best world where this plane is something else; may be infinite
  std::optional<std::string> runner_up;  ///< its class in that world
};

struct Alternative {
  int rank = 0;  ///< 2 = second best world
  PlaneId plane = 0;
  std::string object_class;
};

struct Reason {
  PlaneId plane = 0;
  std::string object_class;
  std::string kind;  ///< evidence, feature, support, violation, runner_up, truth, floor
  std::optional<std::string> constraint_name;
  std::optional<PlaneId> other_plane;
  double amount = 0;  ///< nats in favour (> 0) or against (< 0)
  std::string sentence;
  /// Of kind feature: one for each feature known of the plane, against the runner-up.
  struct Term {
    std::string feature;
    double value = 0;
    double mean = 0, sigma = 0;  ///< of the class, on the feature's scale; NaN without a class_feature row
    bool operator==(const Term&) const = default;
  };
  std::optional<Term> term = std::nullopt;
  std::optional<std::string> against = std::nullopt;  ///< class that a feature, evidence or runner_up reason compares with
};

/// Geometry between the planes of a scan, kept for the next run: what it was computed from, and entries as bytes that only
/// the module that wrote them reads.
struct StoredGeometry {
  std::string inputs_sha256;
  std::string answers;
};

/// What a Lua feature or constraint answered about the planes of a scan, kept for the next run: the features of the catalogue that it
/// looked at (names, one a line), what it was found from, and bytes that only the module that wrote them reads.
struct StoredAnswer {
  std::string features, inputs_sha256, answers;
  bool operator==(const StoredAnswer&) const = default;
};

/// Facts of one relation as the knowledge base holds them, by a and b.
struct StoredFacts {
  RelationAsked asked;
  std::vector<RelationFact> facts;
};

/// A thing of several surfaces: chair 2, with its seat and its back.
struct Object {
  std::string composite;
  int number = 1;
  std::vector<std::pair<PlaneId, std::string>> planes;  ///< with the part that each is; the anchor first
};

/// Everything of one labelling of one scan.
struct Inference {
  Run run;
  std::vector<std::string> classes;              ///< column names of `evidence`
  std::vector<PlaneId> planes;                   ///< row names of `evidence`
  std::vector<std::vector<double>> evidence;     ///< [plane][class]
  std::string evidence_inputs;                   ///< Evidence::inputs_sha256; empty = not known
  std::vector<RelationFact> facts;                ///< by relation
  std::map<std::string, RelationAsked> asked;    ///< by relation
  StoredGeometry geometry;
  std::map<std::string, StoredAnswer> rule_answers;  ///< by "feature NAME" or "constraint NAME"; empty leaves the stored ones
  std::vector<Label> labels;
  std::vector<Alternative> alternatives;
  std::vector<Reason> reasons;
  std::vector<Object> objects;
};

}  // namespace scenelore::kb
