#include "voxel_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace scenelore::perception {
namespace {

class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Places of a part on a grid so coarse that few are left and still fine against the step.
struct Node {
  VoxelPlace place;
  std::uint32_t part;
};

std::vector<Node> nodes_of(const VoxelGrid& grid, const Slots& slots, std::span<const std::uint32_t> members,
                           const std::vector<std::uint32_t>& part, int shift) {
  std::vector<Node> nodes;
  for (std::size_t k = 0; k < members.size(); ++k) {
    const VoxelPlace p = grid.places[slots.voxel[members[k]]];
    nodes.push_back({{p.x >> shift, p.y >> shift, p.z >> shift}, part[k]});
  }
  const auto key = [](const Node& n) { return std::tuple(n.part, n.place.x, n.place.y, n.place.z); };
  std::sort(nodes.begin(), nodes.end(), [&](const Node& a, const Node& b) { return key(a) < key(b); });
  nodes.erase(std::unique(nodes.begin(), nodes.end(), [&](const Node& a, const Node& b) { return key(a) == key(b); }), nodes.end());
  return nodes;
}

double squared(const VoxelPlace& a, const VoxelPlace& b) {
  const auto d = [](std::uint32_t p, std::uint32_t q) { return static_cast<double>(p) - static_cast<double>(q); };
  return d(a.x, b.x) * d(a.x, b.x) + d(a.y, b.y) * d(a.y, b.y) + d(a.z, b.z) * d(a.z, b.z);
}

}  // namespace

std::vector<std::vector<std::uint32_t>> connected_slots(const VoxelGrid& grid, const Slots& slots, std::span<const std::uint32_t> members,
                                                        double step, std::vector<std::uint32_t>& place_of_slot) {
  if (members.empty()) return {};
  const std::int32_t region = slots.region[members.front()];
  Sets sets(members.size());
  for (std::size_t k = 0; k < members.size(); ++k) place_of_slot[members[k]] = static_cast<std::uint32_t>(k);
  std::size_t parts = members.size();
  for (std::size_t k = 0; k < members.size(); ++k) {
    const std::uint32_t v = slots.voxel[members[k]];
    for (std::size_t d = kSelf; d < kNeighbours; ++d) {
      const std::int32_t n = grid.neighbours[v][d];
      if (n < 0) continue;
      for (std::uint32_t s = slots.first[n]; s < slots.first[n + 1]; ++s) {
        if (slots.region[s] != region || slots.moments[s].n <= 0) continue;
        const std::uint32_t a = sets.root(static_cast<std::uint32_t>(k)), b = sets.root(place_of_slot[s]);
        if (a != b) sets.join(a, b), --parts;
      }
    }
  }
  std::vector<std::uint32_t> part(members.size());
  for (std::size_t k = 0; k < members.size(); ++k) part[k] = sets.root(static_cast<std::uint32_t>(k));
  if (parts > 1) {
    int shift = 0;
    while (2 * grid.size * (1 << shift) <= step / 10) ++shift;
    const double edge = grid.size * (1 << shift), reach = (step - std::sqrt(3.0) * edge) / edge;
    const std::vector<Node> nodes = nodes_of(grid, slots, members, part, shift);
    // The part with most nodes need not look for the others: they look for it.
    std::vector<std::size_t> sizes(members.size(), 0);
    for (const Node& node : nodes) ++sizes[node.part];
    const auto largest = static_cast<std::uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    for (const Node& a : nodes) {
      if (a.part == largest || !(reach > 0)) continue;
      for (const Node& b : nodes) {
        if (sets.root(a.part) != sets.root(b.part) && squared(a.place, b.place) <= reach * reach) sets.join(a.part, b.part);
      }
    }
    for (std::uint32_t& p : part) p = sets.root(p);
  }
  std::vector<std::vector<std::uint32_t>> result;
  std::vector<std::int32_t> place(members.size(), -1);
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (place[part[k]] < 0) {
      place[part[k]] = static_cast<std::int32_t>(result.size());
      result.emplace_back();
    }
    result[static_cast<std::size_t>(place[part[k]])].push_back(members[k]);
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return result;
}

}  // namespace scenelore::perception
