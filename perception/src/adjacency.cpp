#include "adjacency.hpp"

#include <algorithm>

namespace scenelore::perception {

std::vector<std::pair<std::int32_t, std::int32_t>> touching_regions(const CellIndex& cells, int reach, std::span<const std::int32_t> of_point) {
  std::vector<std::pair<CellKey, std::int32_t>> present;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto [x, y, z] = coordinates(cells.key(c));
    const auto floor_div = [reach](std::int64_t a) { return a >= 0 ? a / reach : -((-a + reach - 1) / reach); };
    const CellKey coarse = cell_key(floor_div(x), floor_div(y), floor_div(z));
    std::int32_t last = -1;
    for (const std::uint32_t i : cells.items(c)) {
      const std::int32_t r = of_point[i];
      if (r < 0 || r == last) continue;
      present.emplace_back(coarse, last = r);
    }
  }
  std::sort(present.begin(), present.end());
  present.erase(std::unique(present.begin(), present.end()), present.end());
  std::vector<CellKey> keys(present.size());
  for (std::size_t i = 0; i < present.size(); ++i) keys[i] = present[i].first;
  const CellIndex index(keys);
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  for (std::size_t c = 0; c < index.size(); ++c) {
    for (int d = 0; d < 27; ++d) {
      const std::int32_t other = d == 13 ? static_cast<std::int32_t>(c) : index.find(moved(index.key(c), d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1));
      if (other < static_cast<std::int32_t>(c)) continue;
      for (const std::uint32_t a : index.items(c)) {
        for (const std::uint32_t b : index.items(static_cast<std::size_t>(other))) {
          const std::int32_t p = present[a].second, q = present[b].second;
          if (p != q) pairs.emplace_back(std::min(p, q), std::max(p, q));
        }
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace scenelore::perception
