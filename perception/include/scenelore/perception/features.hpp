// The feature vector Φ of one plane.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "scenelore/perception/cloud.hpp"
#include "scenelore/perception/plane.hpp"
#include "scenelore/perception/plane_fit.hpp"
#include "scenelore/perception/upright.hpp"

namespace scenelore::perception {

struct DescribeOptions {
  double hull_cell = 0.02;    ///< metres; big planes are thinned to one point a cell (wider, so that 200,000 cells suffice)
  double hull_radius = 0.1;   ///< metres, of the alpha hull
  double seen_cell = 0.05;    ///< metres, cells of `seen_share`
};

/// Φ of the plane that these points of the cloud lie on; `fit` is the plane fitted to them, in the cloud's offsets.
/// Degenerate planes (fewer than three points, points on a line) have an empty hull, no area and no rectangularity.
[[nodiscard]] Plane describe(const Cloud& cloud, std::span<const std::uint32_t> points, const PlaneFit& fit, const Upright& upright,
                             const DescribeOptions& options = {});

}  // namespace scenelore::perception
