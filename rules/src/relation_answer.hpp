// What one relation answers about a scene: its facts by planes.
#pragma once

#include <utility>
#include <vector>

#include "scenelore/rules/rule_set.hpp"

namespace scenelore::rules {

/// A fact of a relation that is known from the context.
struct Held {
  kb::PlaneId a, b;
  double degree;
};

/// Facts by a and b, those of a run before or found now.
struct RelationAnswer {
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

/// Facts by the places of a and b in `ids` from the degrees of rising pairs, one a pair or, where the relation is not symmetric, two:
/// forth and back.
[[nodiscard]] std::vector<Held> held_facts(const std::vector<kb::PlaneId>& ids, const std::vector<std::pair<int, int>>& pairs,
                                           const std::vector<double>& degrees);

void sort_by_planes(std::vector<Held>& facts);

}  // namespace scenelore::rules
