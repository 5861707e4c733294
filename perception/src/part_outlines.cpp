#include "part_outlines.hpp"

#include <algorithm>
#include <cmath>

#include "outline_cut.hpp"
#include "rectangle_pair.hpp"
#include "support.hpp"

namespace scenelore::perception {
namespace {

constexpr double kSmallest = 0.5, kLargest = 4;  // m²
constexpr double kLargestSeenPast = 12;          // m², where rays tell: desks that touch in a U across a room
constexpr double kWanted = 5;                     // points in a cell
constexpr double kFinest = 0.05, kCoarsest = 0.08;  // metres
constexpr std::size_t kFewest = 40;               // points
constexpr double kBehind = 0.05;                  // metres, thicker than the edge of a desk and than noise

/// The cells of a plane's parts. What the sensor saw past the plane is stronger evidence than how well rectangles are
/// filled, since it does not take shadows for notches.
std::vector<std::vector<std::size_t>> parts_of(const Cloud& cloud, const PlaneFit& plane, PlaneView& view) {
  if (cloud.sensors.known()) {
    look_past(cloud, plane, kBehind, view);
    auto parts = part_into_rectangles(view);
    if (parts.size() > 1 || plane.spread_area() > kLargest) return parts;
  }
  return cut_outline(view.held, view.edge, {.clearly = 0.8, .fill = 0.62, .smallest_part = 0.1, .largest = kLargest});
}

}  // namespace

std::vector<bool> part_outlines(const Cloud& cloud, const Eigen::Vector3d& up, Regions& regions) {
  std::vector<bool> is_part(regions.planes.size(), false);
  const auto points = points_of_regions(regions.of_point, regions.planes.size());
  for (std::size_t r = 0; r < points.size(); ++r) {
    const PlaneFit plane = regions.planes[r];
    const double area = plane.spread_area();
    if (points[r].size() < kFewest || area < kSmallest || area > (cloud.sensors.known() ? kLargestSeenPast : kLargest)) continue;
    // Walls and fronts are not seen past on all sides, and are seldom what one rectangle is not but for shadows.
    if (cloud.sensors.known() && std::abs(plane.normal.dot(up)) <= kLevel) continue;
    const double edge = std::clamp(std::sqrt(kWanted * area / static_cast<double>(points[r].size())), kFinest, kCoarsest);
    PlaneView view = view_of(cloud, plane, points[r], edge);
    const auto parts = parts_of(cloud, plane, view);
    if (parts.size() < 2) continue;
    is_part[r] = true;
    std::vector<std::int32_t> number(view.held.size(), static_cast<std::int32_t>(r));
    for (std::size_t p = 1; p < parts.size(); ++p) {
      for (const std::size_t c : parts[p]) number[c] = static_cast<std::int32_t>(regions.planes.size());
      regions.planes.emplace_back();
    }
    for (std::size_t k = 0; k < points[r].size(); ++k) regions.of_point[points[r][k]] = number[view.cell_of[k]];
  }
  if (regions.planes.size() > is_part.size()) refit(cloud, regions);
  is_part.resize(regions.planes.size(), true);
  return is_part;
}

}  // namespace scenelore::perception
