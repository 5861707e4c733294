#include "merge.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "adjacency.hpp"

namespace scenelore::perception {
namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;

/// How much worse the joint plane is for the part that suffers more, in that part's own deviations; 1 = not worse.
double joint_deviation(const Moments& a, const Moments& b, double noise) {
  Moments both = a;
  both += b;
  const PlaneFit joint = fit_plane_fast(both);
  const auto worse = [&](const Moments& part) {
    const double own = std::max(fit_plane_fast(part).variances[0], noise * noise);
    // A small region's own deviation is uncertain; its limit widens with √(2/n) as in growing.
    return std::sqrt(part.mean_squared_distance(joint) / (own * (1 + 2 * std::sqrt(2 / part.n))));
  };
  return std::max(worse(a), worse(b));
}

constexpr double kMostDeviation = 1.25;

template <typename Allowed>
void merge_where(const Cloud& cloud, const CellIndex& cells, int reach, double noise, Allowed allowed, Regions& regions) {
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
  const std::vector<Pair> pairs = touching_regions(cells, reach, regions.of_point);
  for (bool changed = true; changed;) {
    changed = false;
    // The best joins first: a wrong one spoils the plane that later ones are judged by.
    std::vector<std::pair<double, Pair>> scored;
    for (const Pair& pair : pairs) {
      const std::int32_t a = root(pair.first), b = root(pair.second);
      if (a == b || moments[a].n < 3 || moments[b].n < 3 || !allowed(moments[a], moments[b])) continue;
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

}  // namespace

void merge_regions(const Cloud& cloud, const CellIndex& cells, int reach, double noise, Regions& regions) {
  merge_where(cloud, cells, reach, noise, [](const Moments&, const Moments&) { return true; }, regions);
}

void bridge_shadows(const Cloud& cloud, const CellIndex& cells, int reach, double noise, double smallest, Regions& regions) {
  const auto in_line = [smallest](const Moments& a, const Moments& b) {
    const PlaneFit p = fit_plane_fast(a), q = fit_plane_fast(b);
    return std::max(p.spread_area(), q.spread_area()) >= smallest && std::abs(p.normal.dot(q.normal)) > 0.985;  // 10 degrees
  };
  merge_where(cloud, cells, reach, noise, in_line, regions);
}

void join_level_pieces(const Cloud& cloud, const CellIndex& cells, int reach, const Eigen::Vector3d& up, std::size_t count, Regions& regions) {
  constexpr double kSameHeight = 0.007;  // metres; what lies on a table is at least 9 mm higher
  constexpr double kKeyboard = 0.12;     // m²; thin things smaller than this stay what they are
  const auto level = [&](const PlaneFit& plane) { return plane.count > 0 && std::abs(plane.normal.dot(up)) > 0.9945; };
  std::vector<std::int32_t> parent(regions.planes.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::int32_t r) {
    while (parent[r] != r) r = parent[r] = parent[parent[r]];
    return r;
  };
  for (const auto& [first, second] : touching_regions(cells, reach, regions.of_point)) {
    const PlaneFit &a = regions.planes[first], &b = regions.planes[second];
    if (static_cast<std::size_t>(second) >= count && b.spread_area() < kKeyboard) continue;
    if (!level(a) || !level(b) || std::abs(up.dot(a.centroid - b.centroid)) > kSameHeight) continue;
    const std::int32_t p = root(first), q = root(second);
    parent[std::max(p, q)] = std::min(p, q);
  }
  for (std::int32_t& r : regions.of_point) {
    if (r >= 0) r = root(r);
  }
  refit(cloud, regions);
}

}  // namespace scenelore::perception
