#include "regions.hpp"

#include <algorithm>

namespace scenelore::perception {

double tolerance(const PlaneFit& plane, const Limits& limits) {
  if (limits.plane_distance_given) return limits.max_plane_distance;
  // The noise of one plane varies with incidence: where most of it is seen squarely, its slanted parts scatter twice as
  // far. Points that are left out there would come back as layers before and behind the plane.
  return std::clamp(4 * plane.rmse(), 0.7 * limits.max_plane_distance, limits.max_plane_distance);
}

std::vector<std::vector<std::uint32_t>> points_of_regions(std::span<const std::int32_t> of_point, std::size_t count) {
  std::vector<std::size_t> sizes(count, 0);
  for (const std::int32_t r : of_point) {
    if (r >= 0) ++sizes[static_cast<std::size_t>(r)];
  }
  std::vector<std::vector<std::uint32_t>> points(count);
  for (std::size_t r = 0; r < count; ++r) points[r].reserve(sizes[r]);
  for (std::size_t i = 0; i < of_point.size(); ++i) {
    if (of_point[i] >= 0) points[static_cast<std::size_t>(of_point[i])].push_back(static_cast<std::uint32_t>(i));
  }
  return points;
}

Moments moments_of(const Cloud& cloud, std::span<const std::uint32_t> points) {
  Moments m;
  for (const std::uint32_t i : points) m.add(cloud.x[i], cloud.y[i], cloud.z[i]);
  return m;
}

void refit(const Cloud& cloud, Regions& regions) {
  std::vector<Moments> moments(regions.planes.size());
  for (std::size_t i = 0; i < regions.of_point.size(); ++i) {
    if (regions.of_point[i] >= 0) moments[static_cast<std::size_t>(regions.of_point[i])].add(cloud.x[i], cloud.y[i], cloud.z[i]);
  }
  for (std::size_t r = 0; r < moments.size(); ++r) regions.planes[r] = fit_plane(moments[r]);
}

}  // namespace scenelore::perception
