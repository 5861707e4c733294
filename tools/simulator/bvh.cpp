#include "simulator/bvh.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace scenelore::simulator {

namespace {

constexpr int kCutByArea = 40;  // levels; below, halving bounds the depth and with it the stack of a cast

double half_area(const Eigen::AlignedBox3d& box) {
  const Vector3d size = box.sizes();
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

struct Split {
  double cost = kMiss;
  Eigen::Index axis = 0;
  std::uint32_t middle = 0;
};

void sort_along(std::span<Shape> shapes, Eigen::Index axis) {
  std::ranges::stable_sort(shapes, {}, [axis](const Shape& shape) { return shape.bounds.center()[axis]; });
}

// The cheapest place to cut the shapes sorted along an axis, by the surface area heuristic: a ray enters a box with a
// probability proportional to its area (MacDonald and Booth 1990).
Split cheapest_cut(std::span<Shape> shapes, Eigen::Index axis) {
  sort_along(shapes, axis);
  const std::size_t n = shapes.size();
  std::vector<double> right(n);
  Eigen::AlignedBox3d box;
  for (std::size_t i = n; i-- > 1;) right[i] = half_area(box.extend(shapes[i].bounds)) * static_cast<double>(n - i);
  box.setEmpty();
  Split best;
  for (std::size_t i = 1; i < n; ++i) {
    const double cost = half_area(box.extend(shapes[i - 1].bounds)) * static_cast<double>(i) + right[i];
    if (cost < best.cost) best = {cost, axis, static_cast<std::uint32_t>(i)};
  }
  return best;
}

}  // namespace

Bvh::Bvh(std::vector<Shape> shapes) : shapes_(std::move(shapes)) {
  if (shapes_.empty()) return;
  nodes_.resize(1);
  build(0, 0, static_cast<std::uint32_t>(shapes_.size()), 0);
}

void Bvh::build(std::size_t node, std::uint32_t first, std::uint32_t last, int depth) {
  Eigen::AlignedBox3d box;
  for (std::uint32_t i = first; i < last; ++i) box.extend(shapes_[i].bounds);
  // A flat box stays hittable in spite of rounding.
  nodes_[node].low = box.min().array() - 1e-6;
  nodes_[node].high = box.max().array() + 1e-6;
  constexpr std::uint32_t leaf_size = 2;
  if (last - first <= leaf_size) {
    nodes_[node].first = first;
    nodes_[node].count = last - first;
    return;
  }
  const std::span<Shape> here(shapes_.data() + first, last - first);
  Split split{0, 0, (last - first) / 2};
  if (depth < kCutByArea) {
    split = cheapest_cut(here, 0);
    for (const Eigen::Index axis : {1, 2}) {
      if (const Split other = cheapest_cut(here, axis); other.cost < split.cost) split = other;
    }
  }
  sort_along(here, split.axis);
  const std::size_t children = nodes_.size();
  nodes_[node].first = static_cast<std::uint32_t>(children);
  nodes_.resize(children + 2);
  build(children, first, first + split.middle, depth + 1);
  build(children + 1, first + split.middle, last, depth + 1);
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
  std::array<Pending, kCutByArea + 40> stack;
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
