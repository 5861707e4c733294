#include "rejoin.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scenelore::perception {
namespace {

constexpr double kScatter = 1.2, kOff = 0.5;  // deviations of the plane's points
constexpr double kSmallest = 0.02;            // m²

/// Mean squared distance of the points of a region to another plane, m².
double mean_squared_distance(const PlaneFit& region, const PlaneEquation& plane) {
  const double off = plane.distance(region.centroid);
  const Eigen::Vector3d along = region.axes.transpose() * plane.normal;
  return off * off + region.variances.dot(along.cwiseAbs2());
}

bool explains(const PlaneFit& plane, const PlaneFit& region, double noise) {
  const double deviation = std::max(plane.rmse(), noise);
  return std::abs(plane.distance(region.centroid)) <= kOff * deviation &&
         mean_squared_distance(region, plane) <= kScatter * kScatter * deviation * deviation;
}

}  // namespace

std::vector<std::int32_t> planes_to_rejoin(const Pyramid& pyramid, const Slots& slots, const std::vector<PlaneFit>& planes,
                                           const std::vector<bool>& given_up, double noise) {
  std::vector<std::int32_t> into(planes.size(), -1);
  const auto look = [&](std::int32_t region, std::int32_t other) {
    const auto r = static_cast<std::size_t>(region), p = static_cast<std::size_t>(other);
    if (!given_up[r] || given_up[p] || planes[p].count <= planes[r].count || planes[r].spread_area() < kSmallest) return;
    if (into[r] >= 0 && planes[static_cast<std::size_t>(into[r])].count >= planes[p].count) return;
    if (explains(planes[p], planes[r], noise)) into[r] = other;
  };
  if (std::find(given_up.begin(), given_up.end(), true) == given_up.end()) return into;
  for (const auto& [a, b] : touching_regions(pyramid, slots, 1)) {
    look(a, b);
    look(b, a);
  }
  return into;
}

}  // namespace scenelore::perception
