#include "regions.hpp"

#include <algorithm>

#include "scenelore/perception/parallel.hpp"
#include "seen_from.hpp"

namespace scenelore::perception {
namespace {

constexpr double kFinestScatter = 0.001;    // metres
constexpr double kMedianOfNormal = 0.6745;  // of the distance from the mean, in deviations
constexpr double kDeviations = 3;

}  // namespace

double tolerance(const PlaneFit& plane, const Limits& limits) {
  if (limits.plane_distance_given) return limits.max_plane_distance;
  // The noise of one plane varies with incidence: where most of it is seen squarely, its slanted parts scatter twice as
  // far. Points that are left out there would come back as layers before and behind the plane.
  return std::clamp(4 * plane.rmse(), 0.7 * limits.max_plane_distance, limits.max_plane_distance);
}

namespace {

std::vector<float> distances_of(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& points) {
  std::vector<float> distances;
  distances.reserve(points.size());
  for (const std::uint32_t i : points) distances.push_back(static_cast<float>(std::abs(plane.distance(cloud.offset(i).cast<double>()))));
  return distances;
}

double scatter_of(std::vector<float>& distances) {
  if (distances.empty()) return kFinestScatter;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return std::max(kFinestScatter, *middle / kMedianOfNormal);
}

/// Robust deviation of the part of a region that the sensor saw most squarely, metres: that of the ranges, as much of it as lies across there. Noise runs
/// along the ray, and a wall half a metre beside the scanner is seen at all slants at once. Where nobody knows of slants, that of all.
double largest_scatter(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& points, std::vector<float>& distances) {
  constexpr std::size_t kMostSquarely = 95;  // percent of the points are seen at more of a slant
  std::vector<double> across = slants_of(cloud, plane.normal, points);
  if (across.empty()) return scatter_of(distances);
  for (double& a : across) a = noise_across(1, a);
  for (std::size_t k = 0; k < across.size(); ++k) distances[k] /= static_cast<float>(across[k]);
  const auto squarely = across.begin() + static_cast<std::ptrdiff_t>(across.size() * kMostSquarely / 100);
  std::nth_element(across.begin(), squarely, across.end());
  return std::max(kFinestScatter, *squarely * scatter_of(distances));
}

}  // namespace

std::vector<double> scatters(const Cloud& cloud, std::span<const std::int32_t> of_point, const std::vector<PlaneFit>& planes, int threads) {
  const std::vector<std::vector<std::uint32_t>> points = points_of_regions(of_point, planes.size());
  std::vector<double> scatters(planes.size());
  parallel_pieces(planes.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      std::vector<float> distances = distances_of(cloud, planes[r], points[r]);
      scatters[r] = scatter_of(distances);
    }
  });
  return scatters;
}

std::vector<double> reaches(const Cloud& cloud, std::span<const std::int32_t> of_point, const std::vector<PlaneFit>& planes, const Limits& limits,
                            int threads) {
  constexpr double kRounding = 1e-5;  // metres, of single precision
  const std::vector<std::vector<std::uint32_t>> points = points_of_regions(of_point, planes.size());
  std::vector<double> reach(planes.size());
  parallel_pieces(planes.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      if (points[r].empty()) continue;
      std::vector<float> distances = distances_of(cloud, planes[r], points[r]);
      const double furthest = *std::max_element(distances.begin(), distances.end()) + kRounding;
      reach[r] = std::min(furthest, tolerance(planes[r], limits));
      if (!limits.plane_distance_given && planes[r].spread_area() < kLargePlane) {
        reach[r] = std::min(reach[r], kDeviations * largest_scatter(cloud, planes[r], points[r], distances));
      }
    }
  });
  return reach;
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
