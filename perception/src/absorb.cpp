#include "absorb.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scenelore::perception {
namespace {

constexpr double kShare = 0.7;
constexpr double kTurned = 16;  // deviations of a fragment

/// Share of a slot's points within reach of the plane, were they normally distributed about their mean.
double share_within(const Moments& slot, const PlaneFit& plane, double reach) {
  const double mean = slot.mean_distance(plane);
  const double variance = slot.mean_squared_distance(plane) - mean * mean;
  const double scale = 1 / std::sqrt(2 * std::max(variance, 1e-4 * reach * reach));
  return 0.5 * (std::erf((reach - mean) * scale) + std::erf((reach + mean) * scale));
}

/// Whether a plane through the middle of a fragment would leave it at its longer sides by far more than its points scatter: then the fragment
/// is a surface of its own, and the plane, though larger, perhaps one of sparse points of many things.
bool turned(const PlaneFit& fragment, const PlaneFit& plane) {
  const double c = std::min(1.0, std::abs(fragment.normal.dot(plane.normal)));
  return std::sqrt(1 - c * c) * std::sqrt(12 * fragment.variances[1]) > kTurned * fragment.rmse();
}

}  // namespace

void absorb_fragments(const VoxelGrid& grid, const Pyramid& pyramid, const Limits& limits, Slots& slots, std::vector<PlaneFit>& planes) {
  const std::size_t count = planes.size();
  std::vector<std::vector<std::int32_t>> larger(count);
  const auto before = [&](std::int32_t a, std::int32_t b) {  // a is the larger one
    return std::pair(-planes[a].count, a) < std::pair(-planes[b].count, b);
  };
  for (const auto& [a, b] : touching_regions(pyramid, slots, 1)) {
    if (before(a, b) ? turned(planes[b], planes[a]) : turned(planes[a], planes[b])) continue;
    if (before(a, b)) {
      larger[b].push_back(a);
    } else {
      larger[a].push_back(b);
    }
  }
  const std::vector<double> reach = tolerances(planes, limits);
  // Points of each region within reach of each larger neighbour.
  std::vector<std::vector<double>> inside(count);
  for (std::size_t r = 0; r < count; ++r) inside[r].assign(larger[r].size(), 0);
  for (std::size_t s = 0; s < slots.count(); ++s) {
    const std::int32_t r = slots.region[s];
    if (r < 0 || slots.moments[s].n <= 0) continue;
    const Eigen::Vector3d center = grid.center(slots.voxel[s]);
    for (std::size_t k = 0; k < larger[r].size(); ++k) {
      const std::int32_t other = larger[r][k];
      if (clearance(planes[other], center, grid.size / 2) > reach[other]) continue;
      inside[r][k] += slots.moments[s].n * share_within(slots.moments[s], planes[other], reach[other]);
    }
  }
  std::vector<std::int32_t> target(count);
  std::iota(target.begin(), target.end(), 0);
  for (std::size_t r = 0; r < count; ++r) {
    double best = kShare * planes[r].count;
    for (std::size_t k = 0; k < larger[r].size(); ++k) {
      if (inside[r][k] >= best) best = inside[r][k], target[r] = larger[r][k];
    }
  }
  // Chains end at a region that stays: each step goes to a larger one.
  const auto final_target = [&](std::int32_t r) {
    while (target[r] != r) r = target[r];
    return r;
  };
  // Only what the plane explains may move it: a few points far from it would turn it away from its own.
  for (std::size_t s = 0; s < slots.count(); ++s) {
    std::int32_t& r = slots.region[s];
    if (r < 0 || target[r] == r || slots.moments[s].n <= 0) continue;
    r = final_target(r);
    if (share_within(slots.moments[s], planes[r], reach[r]) < 0.5) r = -1;
  }
  refit(slots, planes);
}

}  // namespace scenelore::perception
