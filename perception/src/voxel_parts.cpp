#include "voxel_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "cell_index.hpp"
#include "disjoint_sets.hpp"

namespace scenelore::perception {
namespace {

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

/// Joins the parts of nodes at most `reach` apart, `parts` in number. Nodes are looked for in cubes of that edge.
void join_near(const std::vector<Node>& nodes, double reach, std::size_t parts, DisjointSets& sets) {
  const auto edge = static_cast<std::uint32_t>(std::ceil(reach));
  std::vector<CellKey> keys(nodes.size());
  std::map<std::uint32_t, std::size_t> sizes;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const VoxelPlace& p = nodes[k].place;
    keys[k] = cell_key(p.x / edge, p.y / edge, p.z / edge);
    ++sizes[nodes[k].part];
  }
  const CellIndex cubes(keys);
  // The part with most nodes need not look for the others: they look for it.
  const std::uint32_t largest = std::max_element(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first;
  for (std::size_t c = 0; c < cubes.size() && parts > 1; ++c) {
    const auto own = cubes.items(c);
    if (std::all_of(own.begin(), own.end(), [&](std::uint32_t k) { return nodes[k].part == largest; })) continue;
    for (int d = 0; d < 27; ++d) {
      const std::int32_t other = cubes.find(moved(cubes.key(c), d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1));
      if (other < 0) continue;
      for (const std::uint32_t a : own) {
        if (nodes[a].part == largest) continue;
        std::uint32_t root = sets.root(nodes[a].part);
        for (const std::uint32_t b : cubes.items(static_cast<std::size_t>(other))) {
          if (sets.root(nodes[b].part) == root || squared(nodes[a].place, nodes[b].place) > reach * reach) continue;
          sets.join(nodes[a].part, nodes[b].part);
          root = sets.root(nodes[a].part);
          --parts;
        }
      }
    }
  }
}

}  // namespace

std::vector<std::vector<std::uint32_t>> connected_slots(const VoxelGrid& grid, const Slots& slots, std::span<const std::uint32_t> members,
                                                        double step, std::vector<std::uint32_t>& place_of_slot) {
  if (members.empty()) return {};
  const std::int32_t region = slots.region[members.front()];
  DisjointSets sets(members.size());
  for (std::size_t k = 0; k < members.size(); ++k) place_of_slot[members[k]] = static_cast<std::uint32_t>(k);
  std::size_t parts = members.size();
  for (std::size_t k = 0; k < members.size(); ++k) {
    const std::uint32_t v = slots.voxel[members[k]];
    std::uint32_t own = sets.root(static_cast<std::uint32_t>(k));
    for (std::size_t d = kSelf; d < kNeighbours; ++d) {
      const std::int32_t n = grid.neighbours[v][d];
      if (n < 0) continue;
      for (std::uint32_t s = slots.first[n]; s < slots.first[n + 1]; ++s) {
        if (slots.region[s] != region || slots.moments[s].n <= 0) continue;
        const std::uint32_t other = sets.root(place_of_slot[s]);
        if (other == own) continue;
        sets.join(own, other);
        own = std::min(own, other);
        --parts;
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
    if (reach > 0) join_near(nodes, reach, parts, sets);
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
