#include "promises.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "cell_index.hpp"
#include "connect.hpp"
#include "parallel.hpp"

namespace scenelore::perception {
namespace {

struct Part {
  std::vector<std::uint32_t> points;
  PlaneFit plane;
};

/// Leaves the points within the tolerance of the plane; true when that were all.
bool trim(const Cloud& cloud, const PlaneFit& plane, double limit, std::vector<std::uint32_t>& points) {
  const std::size_t before = points.size();
  std::erase_if(points, [&](std::uint32_t i) { return !(std::abs(plane.distance(cloud.offset(i).cast<double>())) <= limit); });
  return points.size() == before;
}

constexpr double kNarrowest = 0.08;  // metres; edges of tables and door frames are no planes of their own
constexpr double kThinnest = 0.12;   // rmse over width
constexpr double kFilled = 0.5;      // share of the rectangle of its spread that a plane must fill

/// Legs, frames and leftovers: sets of points that are flat, but no surface. Measured in cells wide enough to hold four
/// points of an evenly seen surface, of which then 98 % are occupied.
bool is_scrap(const Cloud& cloud, std::span<const std::uint32_t> points, const PlaneFit& plane) {
  const double width = std::sqrt(12 * plane.variances[1]), area = plane.spread_area();
  if (width < kNarrowest || plane.rmse() > kThinnest * width) return true;
  if (area > kLargePlane) return false;
  const double cell = std::max(0.03, 2 * std::sqrt(area / static_cast<double>(points.size())));
  std::vector<CellKey> keys;
  for (const std::uint32_t i : points) {
    const Eigen::Vector3d d = (plane.axes.transpose() * (cloud.offset(i).cast<double>() - plane.centroid)) / cell;
    keys.push_back(cell_key(static_cast<std::int64_t>(std::floor(d[1])), static_cast<std::int64_t>(std::floor(d[2])), 0));
  }
  return static_cast<double>(CellIndex(keys).size()) * cell * cell < kFilled * area;
}

/// Works off a stack of candidate sets; each step only ever removes or separates points, so it ends.
std::vector<Part> settle(const Cloud& cloud, const Limits& limits, std::vector<std::uint32_t> first) {
  std::vector<Part> done;
  std::vector<std::vector<std::uint32_t>> open;
  open.push_back(std::move(first));
  while (!open.empty()) {
    std::vector<std::uint32_t> points = std::move(open.back());
    open.pop_back();
    if (static_cast<double>(points.size()) < limits.min_points) continue;
    const PlaneFit plane = fit_plane(moments_of(cloud, points));
    double reach = tolerance(plane, limits);
    // Trimming at two deviations of what is allowed brings the mean squared error down.
    if (plane.variances[0] > limits.max_mse) reach = std::min({reach, 2 * std::sqrt(limits.max_mse), 2.5 * plane.rmse()});
    if (!trim(cloud, plane, reach, points)) {
      open.push_back(std::move(points));
      continue;
    }
    if (plane.variances[0] > limits.max_mse) continue;
    const double step = plane.spread_area() < kLargePlane ? limits.small_plane_step : limits.max_point_distance;
    auto parts = connected_parts(cloud, points, plane, step, limits.max_neighbours);
    if (parts.size() == 1 && parts.front().size() == points.size()) {
      if (!is_scrap(cloud, points, plane)) done.push_back({std::move(points), plane});
    } else {
      for (auto& part : parts) open.push_back(std::move(part));
    }
  }
  return done;
}

}  // namespace

void keep_promises(const Cloud& cloud, const Limits& limits, int threads, Regions& regions) {
  auto points = points_of_regions(regions.of_point, regions.planes.size());
  std::vector<std::vector<Part>> settled(points.size());
  parallel_pieces(points.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) settled[r] = settle(cloud, limits, std::move(points[r]));
  });
  std::vector<Part> parts;
  for (auto& some : settled) std::move(some.begin(), some.end(), std::back_inserter(parts));
  const auto rank = [](const Part& p) {
    return std::tuple(-static_cast<double>(p.points.size()), p.plane.centroid.x(), p.plane.centroid.y(), p.plane.centroid.z());
  };
  std::stable_sort(parts.begin(), parts.end(), [&](const Part& a, const Part& b) { return rank(a) < rank(b); });
  std::fill(regions.of_point.begin(), regions.of_point.end(), -1);
  regions.planes.clear();
  for (const Part& part : parts) {
    for (const std::uint32_t i : part.points) regions.of_point[i] = static_cast<std::int32_t>(regions.planes.size());
    regions.planes.push_back(part.plane);
  }
}

}  // namespace scenelore::perception
