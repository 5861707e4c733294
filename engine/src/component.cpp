#include "component.hpp"

#include <algorithm>
#include <numeric>

#include "reduction.hpp"

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

Component::Component() = default;
Component::Component(Component&&) noexcept = default;
Component& Component::operator=(Component&&) noexcept = default;
Component::~Component() = default;

Parts::Parts(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

int Parts::find(int v) {
  while (parent_[index(v)] != v) v = parent_[index(v)] = parent_[index(parent_[index(v)])];
  return v;
}

void Parts::join(int a, int b) {
  a = find(a);
  b = find(b);
  parent_[index(std::max(a, b))] = std::min(a, b);
}

namespace {

/// The cheapest labels, whatever the constraints say.
Cost least_sum(const Component& component) {
  Cost sum = 0;
  for (int v = 0; v < component.network.variables(); ++v) {
    Cost least = kTop;
    for (int label = 0; label < component.network.labels(v); ++label)
      least = std::min(least, component.network.original(v, label));
    sum = std::min(sum + least, kTop);
  }
  return sum;
}

void propagate_roots(Decomposition& parts, Bound bound, Cost cutoff, Budget* budget, std::span<const int> world) {
  Cost sum = parts.constant;
  for (const Component& component : parts.components) sum = std::min(sum + least_sum(component), kTop);
  for (Component& component : parts.components) {
    const Cost others = sum - least_sum(component);
    component.network.set_shifting(bound == Bound::soft_consistency);
    component.network.close();
    if (!world.empty()) component.network.set_met(component.network.evaluate(part_of(parts, component, world)));
    component.network.set_limit(is_forbidden(cutoff) ? kTop / 2 : std::max<Cost>(0, cutoff - others));
    component.network.set_budget(budget);
    component.feasible = component.network.strengthen();
    component.network.set_budget(nullptr);
  }
}

}  // namespace

std::vector<int> part_of(const Decomposition& parts, const Component& component, std::span<const int> assignment) {
  std::vector<int> labels;
  for (const int v : component.variables) labels.push_back(parts.label_in[index(v)][index(assignment[index(v)])]);
  return labels;
}

Decomposition decompose(const Outline& outline, Bound bound, const Selection& selection, Cost cutoff, Budget* budget,
                        std::span<const int> world) {
  Decomposition result = build_parts(outline, selection, budget);
  if (!result.built) return result;
  propagate_roots(result, bound, cutoff, budget, world);
  result.cut = budget != nullptr && budget->out_of_time();
  return result;
}

}  // namespace scenelore::engine
