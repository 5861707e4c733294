#include "merge.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace scenelore::perception {
namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;

/// Pairs of regions, smaller number first, that hold points in the same or in adjacent coarse cells.
std::vector<Pair> neighbouring_pairs(const CellIndex& cells, int reach, const Regions& regions) {
  std::vector<std::pair<CellKey, std::int32_t>> present;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto [x, y, z] = coordinates(cells.key(c));
    const auto floor_div = [reach](std::int64_t a) { return a >= 0 ? a / reach : -((-a + reach - 1) / reach); };
    const CellKey coarse = cell_key(floor_div(x), floor_div(y), floor_div(z));
    std::int32_t last = -1;
    for (const std::uint32_t i : cells.items(c)) {
      const std::int32_t r = regions.of_point[i];
      if (r < 0 || r == last) continue;
      present.emplace_back(coarse, last = r);
    }
  }
  std::sort(present.begin(), present.end());
  present.erase(std::unique(present.begin(), present.end()), present.end());
  std::vector<CellKey> keys(present.size());
  for (std::size_t i = 0; i < present.size(); ++i) keys[i] = present[i].first;
  const CellIndex index(keys);
  std::vector<Pair> pairs;
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

/// How much worse the joint plane is for the part that suffers more, in that part's own deviations; 1 = not worse.
double joint_deviation(const Moments& a, const Moments& b, double noise) {
  Moments both = a;
  both += b;
  const PlaneFit joint = fit_plane_fast(both);
  const auto worse = [&](const Moments& part) {
    const double own = std::max(fit_plane_fast(part).variances[0], 0.25 * noise * noise);
    // A small region's own deviation is uncertain; its limit widens with √(2/n) as in growing.
    return std::sqrt(part.mean_squared_distance(joint) / (own * (1 + 2 * std::sqrt(2 / part.n))));
  };
  return std::max(worse(a), worse(b));
}

constexpr double kMostDeviation = 1.25;

}  // namespace

void merge_regions(const Cloud& cloud, const CellIndex& cells, int reach, double noise, Regions& regions) {
  const std::size_t count = regions.planes.size();
  std::vector<Moments> moments(count);
  for (std::size_t i = 0; i < regions.of_point.size(); ++i) {
    if (regions.of_point[i] >= 0) moments[static_cast<std::size_t>(regions.of_point[i])].add(cloud.x[i], cloud.y[i], cloud.z[i]);
  }
  std::vector<std::int32_t> parent(count);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::int32_t r) {
    while (parent[r] != r) r = parent[r] = parent[parent[r]];
    return r;
  };
  std::vector<Pair> pairs = neighbouring_pairs(cells, reach, regions);
  for (bool changed = true; changed;) {
    changed = false;
    // The best joins first: a wrong one spoils the plane that later ones are judged by.
    std::vector<std::pair<double, Pair>> scored;
    for (const Pair& pair : pairs) {
      const std::int32_t a = root(pair.first), b = root(pair.second);
      if (a == b || moments[a].n < 3 || moments[b].n < 3) continue;
      const double deviation = joint_deviation(moments[a], moments[b], noise);
      if (deviation < kMostDeviation) scored.emplace_back(deviation, Pair{std::min(a, b), std::max(a, b)});
    }
    std::sort(scored.begin(), scored.end());
    std::vector<bool> touched(count, false);
    for (const auto& [deviation, pair] : scored) {
      const auto [a, b] = pair;
      // One join a region and round; the rest is scored again with the joined planes.
      if (touched[a] || touched[b]) continue;
      touched[a] = touched[b] = true;
      parent[b] = a;
      moments[a] += moments[b];
      changed = true;
    }
  }
  for (std::int32_t& r : regions.of_point) {
    if (r >= 0) r = root(r);
  }
  for (std::size_t r = 0; r < count; ++r) regions.planes[r] = fit_plane(parent[r] == static_cast<std::int32_t>(r) ? moments[r] : Moments());
}

}  // namespace scenelore::perception
