// One labelling of the scene, taken apart: what each plane and each row adds to its cost.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fact_index.hpp"
#include "names.hpp"
#include "scenelore/engine/solver.hpp"
#include "scenelore/rules/labelling.hpp"

namespace scenelore::rules {

/// What a labelling is about. The values referred to outlive it.
struct Case {
  const kb::Knowledge& knowledge;
  const Scene& scene;
  const std::vector<std::vector<double>>& evidence;
  const FactIndex& facts;
  const LabellingProblem& compiled;

  [[nodiscard]] int planes() const { return static_cast<int>(scene.planes.size()); }
  [[nodiscard]] kb::PlaneId id(int plane) const { return scene.ids[static_cast<std::size_t>(plane)]; }
  [[nodiscard]] const std::string& class_name(int object_class) const {
    return knowledge.classes[static_cast<std::size_t>(object_class)].name;
  }
  [[nodiscard]] const kb::ClassConstraint& row(int constraint) const;
  /// The row's message, or its name, in quotes.
  [[nodiscard]] std::string quoted(const kb::ClassConstraint& row) const;
  [[nodiscard]] double unary(int plane, int object_class) const;
};

class World {
 public:
  World(const Case& about, const engine::Solution& solution);

  [[nodiscard]] double cost() const { return cost_; }
  [[nodiscard]] int class_of(int plane) const { return classes_[static_cast<std::size_t>(plane)]; }
  [[nodiscard]] bool holds(engine::Literal literal) const {
    return assignment_[static_cast<std::size_t>(literal.variable)] == literal.label;
  }
  [[nodiscard]] const std::vector<engine::Violation>& violations() const { return violations_; }
  /// "table 5"
  [[nodiscard]] std::string named(int plane) const;

 private:
  const Case& about_;
  double cost_;
  std::vector<int> assignment_, classes_;
  std::vector<engine::Violation> violations_;
};

/// Where a world differs in cost from another, largest first, equal ones in order; amounts below `least` are left out.
struct Difference {
  double amount = 0;         ///< > 0: it is dearer there
  int plane = -1;            ///< the evidence of this plane
  int row = -1;              ///< or this row of the knowledge
};
[[nodiscard]] std::vector<Difference> differences(const Case& about, const World& from, const World& to,
                                                  double least = 0.005);

}  // namespace scenelore::rules
