// What the knowledge base knows, as values: classes, features, priors, constraints. Rows of the tables of docs/schema.md.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace scenelore::kb {

struct ObjectClass {
  int id = 0;
  std::string name;
  double prior = 1;  ///< > 0; need not sum to one over the classes
  std::string description;
  std::string color;      ///< "#rrggbb"
  bool fallback = false;  ///< the unknown class: takes what fits nothing, has no constraints
};

enum class Scale { linear, log, circular };

struct Feature {
  std::string name;
  std::string unit;
  Scale scale = Scale::linear;
  double low = 0, high = 1;  ///< range; the fallback class is uniform over it unless it has a density
  double weight = 1;         ///< F_i of equation 1, exponent of the log-linear product; ≥ 0
  std::string description;
};

/// Gaussian of one feature of one class, on the feature's scale (of ln x for Scale::log).
struct ClassFeature {
  std::string object_class, feature;
  double mean = 0, sigma = 1;
};

/// One bin of a histogram density that replaces the Gaussian; bounds in the feature's unit, density per unit of the scale.
struct ClassDensity {
  std::string object_class, feature;
  double low = 0, high = 0, density = 0;
};

/// Gaussian of one feature of one kind, as ClassFeature.
struct KindFeature {
  std::string feature;
  double mean = 0, sigma = 1;
};

/// One of the things that a class looks like: all its Gaussians hold together.
struct ClassKind {
  std::string object_class;
  int number = 1;    ///< 1, 2, … within the class
  double share = 1;  ///< of the class's planes, in (0, 1]; what the kinds of a class leave over of 1 is judged by the class's own rows
  std::string description;
  std::vector<KindFeature> features;  ///< by name; the class's own rows judge those that are missing
};

enum class Quantifier { some, every, no, at_most, at_least };

struct ClassConstraint {
  std::int64_t id = 0;  ///< rowid
  std::string name;
  std::string object_class;
  Quantifier quantifier = Quantifier::some;
  std::optional<std::string> relation;
  std::optional<std::string> other_class;  ///< nullopt = any class but the fallback
  std::optional<int> count;
  std::optional<double> weight;  ///< nats; nullopt = hard
  std::string message;
  bool enabled = true;
};

enum class Orientation { any, level, upright };

/// A part of a thing of several surfaces; the one without a relation is the anchor, of which each thing has one.
struct CompositePart {
  std::string part, object_class;
  std::optional<std::string> relation;  ///< from the part to the anchor
  Orientation orientation = Orientation::any;
  int fewest = 0, most = 1;
  std::optional<double> weight;  ///< nats; nullopt = the part is no need of the world model
};

struct Composite {
  std::string name;
  std::vector<CompositePart> parts;  ///< in the order of their rows
  bool enabled = true;
};

/// How sure the model is against how sure it may be: logit p′ = slope · logit p + offset (Platt 1999).
struct ProbabilityScale {
  double slope = 1, offset = 0;
  /// 0 and 1 stay what they are.
  [[nodiscard]] double operator()(double probability) const;
};

struct Knowledge {
  std::vector<ObjectClass> classes;        ///< by id; exactly one fallback
  std::vector<Feature> features;           ///< by name
  std::vector<ClassFeature> class_features;
  std::vector<ClassDensity> class_densities;
  std::vector<ClassKind> kinds;              ///< by class (name), number
  std::vector<ClassConstraint> constraints;  ///< by id, disabled ones too; the needs of composites after them (ids below −999,999)
  std::vector<Composite> composites;         ///< by id
  std::map<std::string, std::string> settings;

  /// Index into `classes`, −1 when there is none of that name.
  [[nodiscard]] int class_index(const std::string& name) const;
  [[nodiscard]] int fallback_index() const;
  /// Settings `probability_slope` and `probability_offset`; 1 and 0 without them.
  [[nodiscard]] ProbabilityScale probability_scale() const;
  /// Value of a setting or `otherwise`.
  [[nodiscard]] std::string setting(const std::string& key, const std::string& otherwise) const;
};

}  // namespace scenelore::kb
