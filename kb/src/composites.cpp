// What the parts of composites need, as constraint rows: the engine then knows nothing of composites, and reasons, weights and
// checks speak of these rows as of any others.
#include "composites.hpp"

#include <fmt/format.h>

namespace scenelore::kb {

namespace {

const CompositePart* anchor_of(const Composite& composite) {
  for (const CompositePart& part : composite.parts) {
    if (!part.relation) return &part;
  }
  return nullptr;
}

}  // namespace

std::vector<ClassConstraint> composite_needs(const std::vector<Composite>& composites) {
  std::vector<ClassConstraint> rows;
  std::int64_t id = kFirstNeed;
  for (const Composite& composite : composites) {
    const CompositePart* anchor = anchor_of(composite);
    if (!anchor) continue;
    for (const CompositePart& part : composite.parts) {
      if (!part.relation || !part.weight || part.object_class == anchor->object_class) continue;
      rows.push_back({.id = id--, .name = composite.name + "." + part.part, .object_class = part.object_class, .quantifier = Quantifier::some,
                      .relation = part.relation, .other_class = anchor->object_class, .weight = part.weight,
                      .message = fmt::format("the {} of a {} has its {}", part.part, composite.name, anchor->part), .enabled = composite.enabled});
      if (part.fewest == 0) continue;
      ClassConstraint need{.id = id--, .name = composite.name + "." + anchor->part + "." + part.part, .object_class = anchor->object_class,
                           .quantifier = Quantifier::some, .relation = part.relation, .other_class = part.object_class, .weight = part.weight,
                           .message = fmt::format("a {} has {} {}", composite.name, part.fewest == 1 ? "a" : std::to_string(part.fewest), part.part),
                           .enabled = composite.enabled};
      if (part.fewest > 1) need.quantifier = Quantifier::at_least, need.count = part.fewest;
      rows.push_back(std::move(need));
    }
  }
  return rows;
}

}  // namespace scenelore::kb
