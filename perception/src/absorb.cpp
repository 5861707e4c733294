#include "absorb.hpp"

#include <algorithm>
#include <numeric>

#include "adjacency.hpp"

namespace scenelore::perception {
namespace {

constexpr double kShare = 0.7;

double share_within(const Cloud& cloud, std::span<const std::uint32_t> points, const PlaneFit& plane, double reach) {
  std::size_t inside = 0;
  for (const std::uint32_t i : points) {
    if (std::abs(plane.distance(cloud.offset(i).cast<double>())) <= reach) ++inside;
  }
  return static_cast<double>(inside) / static_cast<double>(points.size());
}

}  // namespace

void absorb_fragments(const Cloud& cloud, const CellIndex& cells, const Limits& limits, Regions& regions) {
  const std::size_t count = regions.planes.size();
  std::vector<std::vector<std::int32_t>> larger(count);
  const auto before = [&](std::int32_t a, std::int32_t b) {  // a is the larger one
    return std::pair(-regions.planes[a].count, a) < std::pair(-regions.planes[b].count, b);
  };
  for (const auto& [a, b] : touching_regions(cells, 2, regions.of_point)) {
    if (before(a, b)) {
      larger[b].push_back(a);
    } else {
      larger[a].push_back(b);
    }
  }
  const auto points = points_of_regions(regions.of_point, count);
  std::vector<std::int32_t> target(count);
  std::iota(target.begin(), target.end(), 0);
  for (std::size_t r = 0; r < count; ++r) {
    if (points[r].empty()) continue;
    double best = kShare;
    for (const std::int32_t other : larger[r]) {
      const double share = share_within(cloud, points[r], regions.planes[other], tolerance(regions.planes[other], limits));
      if (share >= best) best = share, target[r] = other;
    }
  }
  // Chains end at a region that stays: each step goes to a larger one.
  const auto final_target = [&](std::int32_t r) {
    while (target[r] != r) r = target[r];
    return r;
  };
  // Only what the plane explains may move it: a few points far from it would turn it away from its own.
  for (std::size_t i = 0; i < regions.of_point.size(); ++i) {
    std::int32_t& r = regions.of_point[i];
    if (r < 0 || target[r] == r) continue;
    r = final_target(r);
    const PlaneFit& plane = regions.planes[r];
    if (std::abs(plane.distance(cloud.offset(i).cast<double>())) > tolerance(plane, limits)) r = -1;
  }
  refit(cloud, regions);
}

}  // namespace scenelore::perception
