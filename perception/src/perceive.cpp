#include "scenelore/perception/perceive.hpp"

#include <algorithm>
#include <cmath>

#include "find_regions.hpp"
#include "limits.hpp"
#include "outline_edges.hpp"
#include "scenelore/perception/error.hpp"
#include "scenelore/perception/features.hpp"
#include "scenelore/perception/parallel.hpp"
#include "surroundings.hpp"
#include "words.hpp"

namespace scenelore::perception {
namespace {

constexpr double kRoomExtent = 200;  // metres; a wider scan of one room is not in metres

/// Middle 98 % of the coordinates along each axis: stray points must not decide about units.
Eigen::Vector3d extent(const Cloud& cloud) {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  const std::vector<float>* axes[] = {&cloud.x, &cloud.y, &cloud.z};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> values;
    const std::size_t step = std::max<std::size_t>(1, cloud.size() / 5000);
    for (std::size_t i = 0; i < cloud.size(); i += step) {
      if (cloud.valid(i)) values.push_back((*axes[axis])[i]);
    }
    if (values.empty()) continue;
    std::sort(values.begin(), values.end());
    size[axis] = static_cast<double>(values[values.size() * 99 / 100]) - static_cast<double>(values[values.size() / 100]);
  }
  return size;
}

void warn(const Cloud& cloud, Perception& result) {
  const Eigen::Vector3d size = extent(cloud);
  const double widest = size.maxCoeff(), middle = size.sum() - widest - size.minCoeff();
  if (widest > kRoomExtent && result.spacing > 0.5 && middle > 20) {
    result.warnings.push_back("The coordinates look like millimetres (the scan is " + fixed(widest, 0) + " wide and its points are " +
                              fixed(result.spacing, 1) + " apart); scale them by 0.001, all sizes here are in metres.");
  } else if (widest > 0 && widest < 0.3 && result.spacing < 0.0005) {
    result.warnings.push_back("The coordinates span only " + fixed(widest, 3) + " m; all sizes here are in metres.");
  }
  if (cloud.invalid > 0) {
    result.warnings.push_back(count_of(static_cast<long long>(cloud.invalid), "point") + " of " + std::to_string(cloud.size()) +
                              " without valid coordinates: on no plane.");
  }
  if (result.planes.empty()) {
    result.warnings.push_back("No plane was found in " + count_of(static_cast<long long>(cloud.size()), "point") + ".");
  } else if (!result.upright.floor_found) {
    result.warnings.push_back("No floor is visible; heights count from the lowest points.");
  }
}

/// Φ from the points in the sample; what counts points counts them all.
Plane describe_sampled(const Cloud& cloud, std::span<const std::uint32_t> sampled, const PlaneFit& fit, const Upright& upright,
                       const DescribeOptions& options) {
  Plane plane = describe(cloud, sampled, fit, upright, options);
  const double whole = fit.count / std::max(1.0, static_cast<double>(sampled.size()));
  plane.point_count = static_cast<std::size_t>(std::llround(fit.count));
  plane.point_density *= whole;
  return plane;
}

}  // namespace

Perception perceive(const Cloud& cloud, const PerceptionOptions& options) {
  if (options.threads < 1) throw Error("the number of threads is " + std::to_string(options.threads) + "; it must be at least 1");
  FoundRegions found = find_regions(cloud, options);
  Perception result;
  result.parameters = to_parameters(found.limits);
  result.spacing = found.spacing;
  result.noise = found.noise;
  result.upright = found.upright;
  if (options.on_stage) options.on_stage("features");
  const auto& points = found.sampled;
  result.planes.resize(points.size());
  const DescribeOptions describing{.hull_radius = std::max(0.05, found.limits.small_plane_step / 2)};
  parallel_pieces(points.size(), 1, options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      result.planes[p] = describe_sampled(cloud, points[p], found.regions.planes[p], result.upright, describing);
    }
  });
  result.plane_of_point = std::move(found.regions.of_point);
  const Turns turns = look_beyond_outlines(cloud, result.upright.rotation, result.plane_of_point, result.planes, options.threads);
  const Surroundings surroundings(found.voxels, found.voxel);
  parallel_pieces(points.size(), 1, options.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      std::vector<const Plane*> around;
      for (const std::uint32_t turn : turns[p]) around.push_back(&result.planes[turn]);
      result.planes[p].behind = surroundings.behind(result.planes[p], cloud.origin, around);
    }
  });
  warn(cloud, result);
  return result;
}

}  // namespace scenelore::perception
