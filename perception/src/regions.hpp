// The planes while they are being found: a number per point and the plane behind each number.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "moments.hpp"
#include "scenelore/perception/cloud.hpp"

namespace scenelore::perception {

/// Limits that hold for the planes of the result, all set.
struct Limits {
  double max_point_distance = 0;
  double max_plane_distance = 0;
  double max_mse = 0;
  double min_points = 0;
  std::size_t max_neighbours = 0;
  bool plane_distance_given = false;  ///< by the user: then it alone decides, whatever the noise of a plane
  double small_plane_step = 0;        ///< what connects the points of planes of less than kLargePlane; ≤ max_point_distance
};

/// m²; walls, floors and ceilings: their pieces are joined across shadows, those of tables are not.
inline constexpr double kLargePlane = 2.5;

/// Metres; no ranging sensor is that good. What deviates less is part of an exact cloud, or a step of rounded distances.
inline constexpr double kExactDeviation = 0.0002;

struct Regions {
  std::vector<std::int32_t> of_point;  ///< −1 = none
  std::vector<PlaneFit> planes;        ///< in the cloud's offsets
};

/// How far from its plane a point may lie: four deviations of the plane's own points, between 0.7 times the limit and the limit.
[[nodiscard]] double tolerance(const PlaneFit& plane, const Limits& limits);

/// How far the points of each region are from its plane, metres: at most its tolerance, and three robust deviations of planes smaller than
/// kLargePlane (where the user set no distance), as the part scatters that was seen most squarely; what lies further from those is the side of a board, not its face. Whoever looks at points anew must not give a plane what was
/// taken from it.
[[nodiscard]] std::vector<double> reaches(const Cloud& cloud, std::span<const std::int32_t> of_point, const std::vector<PlaneFit>& planes,
                                          const Limits& limits, int threads = 1);

/// Robust deviation of the points of each region from its plane, metres: 1.48 times the median distance (Rousseeuw & Croux 1993).
[[nodiscard]] std::vector<double> scatters(const Cloud& cloud, std::span<const std::int32_t> of_point, const std::vector<PlaneFit>& planes,
                                           int threads = 1);

/// The points of each region, in order. `count` regions.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> points_of_regions(std::span<const std::int32_t> of_point, std::size_t count);

[[nodiscard]] Moments moments_of(const Cloud& cloud, std::span<const std::uint32_t> points);

/// Fits every plane anew to its points; planes without points keep count 0.
void refit(const Cloud& cloud, Regions& regions);

}  // namespace scenelore::perception
