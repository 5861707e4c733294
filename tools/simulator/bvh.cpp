#include "simulator/bvh.hpp"

#include <algorithm>
#include <array>

namespace scenelore::simulator {

Bvh::Bvh(std::vector<Shape> shapes) : shapes_(std::move(shapes)) {
  if (shapes_.empty()) return;
  nodes_.resize(1);
  build(0, 0, static_cast<std::uint32_t>(shapes_.size()));
}

void Bvh::build(std::size_t node, std::uint32_t first, std::uint32_t last) {
  Eigen::AlignedBox3d box, centres;
  for (std::uint32_t i = first; i < last; ++i) {
    box.extend(shapes_[i].bounds);
    centres.extend(shapes_[i].bounds.center());
  }
  // A flat box stays hittable in spite of rounding.
  nodes_[node].low = box.min().array() - 1e-6;
  nodes_[node].high = box.max().array() + 1e-6;
  constexpr std::uint32_t leaf_size = 2;
  if (last - first <= leaf_size) {
    nodes_[node].first = first;
    nodes_[node].count = last - first;
    return;
  }
  Eigen::Index axis = 0;
  centres.sizes().maxCoeff(&axis);
  const std::uint32_t middle = (first + last) / 2;
  std::nth_element(shapes_.begin() + first, shapes_.begin() + middle, shapes_.begin() + last,
                   [axis](const Shape& x, const Shape& y) { return x.bounds.center()[axis] < y.bounds.center()[axis]; });
  const std::size_t children = nodes_.size();
  nodes_[node].first = static_cast<std::uint32_t>(children);
  nodes_.resize(children + 2);
  build(children, first, middle);
  build(children + 1, middle, last);
}

Hit Bvh::cast(const Ray& ray, double nearest, double farthest) const {
  Hit hit{farthest, nullptr};
  if (nodes_.empty()) return {};
  const Eigen::Array3d origin = ray.origin.array(), inverse = ray.direction.array().inverse();
  // Entry distance of a box, kMiss when the ray does not cross it before the best hit so far.
  const auto entry = [&](const Node& node) {
    const Eigen::Array3d t0 = (node.low - origin) * inverse, t1 = (node.high - origin) * inverse;
    const double in = std::max(t0.min(t1).maxCoeff(), nearest), out = std::min(t0.max(t1).minCoeff(), hit.range);
    return in <= out ? in : kMiss;
  };
  struct Pending {
    std::uint32_t node;
    double entry;
  };
  std::array<Pending, 64> stack;
  std::size_t depth = 0;
  if (entry(nodes_[0]) != kMiss) stack[depth++] = {0, nearest};
  while (depth > 0) {
    const Pending next = stack[--depth];
    if (next.entry > hit.range) continue;
    const Node& node = nodes_[next.node];
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const double t = intersect(shapes_[i], ray, nearest);
      if (t < hit.range) hit = {t, &shapes_[i]};
    }
    if (node.count > 0) continue;
    Pending near{node.first, entry(nodes_[node.first])}, far{node.first + 1, entry(nodes_[node.first + 1])};
    if (far.entry < near.entry) std::swap(near, far);
    if (far.entry != kMiss) stack[depth++] = far;
    if (near.entry != kMiss) stack[depth++] = near;
  }
  if (hit.shape == nullptr) hit.range = kMiss;
  return hit;
}

}  // namespace scenelore::simulator
