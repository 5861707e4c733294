#include "adjacency.hpp"

#include <algorithm>
#include <array>

#include "scenelore/perception/memory.hpp"

namespace scenelore::perception {

Pyramid make_pyramid(const VoxelGrid& grid, int threads) {
  Pyramid pyramid;
  pyramid.levels.reserve(Pyramid::kLevels);
  const VoxelGrid* finer = &grid;
  for (int level = 0; level < Pyramid::kLevels; ++level) {
    pyramid.levels.push_back(coarsened(*finer, threads));
    finer = &pyramid.levels.back().grid;
  }
  for (Coarser& level : pyramid.levels) release(level.grid.moments);  // which regions touch is a matter of places
  return pyramid;
}

std::vector<std::pair<std::int32_t, std::int32_t>> touching_regions(const Pyramid& pyramid, const Slots& slots, int level) {
  const VoxelGrid& grid = pyramid.levels[static_cast<std::size_t>(level - 1)].grid;
  // Regions by cube as linked lists: most cubes have one.
  struct Entry {
    std::int32_t region, next;
  };
  std::vector<std::int32_t> head(grid.count(), -1);
  std::vector<Entry> entries;
  for (std::size_t s = 0; s < slots.count(); ++s) {
    if (slots.region[s] < 0 || slots.moments[s].n <= 0) continue;
    std::uint32_t cube = slots.voxel[s];
    for (int l = 0; l < level; ++l) cube = pyramid.levels[static_cast<std::size_t>(l)].parent[cube];
    std::int32_t e = head[cube];
    while (e >= 0 && entries[e].region != slots.region[s]) e = entries[e].next;
    if (e >= 0) continue;
    entries.push_back({slots.region[s], head[cube]});
    head[cube] = static_cast<std::int32_t>(entries.size()) - 1;
  }
  using Pair = std::pair<std::int32_t, std::int32_t>;
  std::vector<Pair> pairs;
  // Regions that touch do so in many cubes: most repetitions are caught here, all of them by the sorting below.
  std::array<Pair, 4096> recent;
  recent.fill({-1, -1});
  for (std::size_t c = 0; c < grid.count(); ++c) {
    if (head[c] < 0) continue;
    for (std::size_t k = kSelf; k < kNeighbours; ++k) {  // the other half meets this cube from its own side
      const std::int32_t other = grid.neighbours[c][k];
      if (other < 0) continue;
      for (std::int32_t a = head[c]; a >= 0; a = entries[a].next) {
        for (std::int32_t b = head[other]; b >= 0; b = entries[b].next) {
          const std::int32_t p = entries[a].region, q = entries[b].region;
          if (p == q) continue;
          const Pair pair(std::min(p, q), std::max(p, q));
          Pair& last = recent[(static_cast<std::size_t>(pair.first) * 61 + static_cast<std::size_t>(pair.second)) % recent.size()];
          if (last != pair) pairs.push_back(last = pair);
        }
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace scenelore::perception
