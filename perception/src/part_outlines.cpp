#include "part_outlines.hpp"

#include <algorithm>
#include <cmath>

#include "cell_index.hpp"
#include "outline_cut.hpp"

namespace scenelore::perception {
namespace {

constexpr double kSmallest = 0.5, kLargest = 4;  // m²
constexpr double kWanted = 5;                     // points in a cell
constexpr double kFinest = 0.05, kCoarsest = 0.08;  // metres
constexpr std::size_t kFewest = 40;               // points

/// Places of the occupied cells of a plane, with the points in each.
struct Cells {
  CellIndex index;  // items count the plane's points
  std::vector<Eigen::Vector2d> places;
};

Cells cells_of(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& points, double edge) {
  std::vector<CellKey> keys;
  for (const std::uint32_t i : points) {
    const Eigen::Vector3d d = plane.axes.transpose() * (cloud.offset(i).cast<double>() - plane.centroid) / edge;
    keys.push_back(cell_key(static_cast<std::int64_t>(std::floor(d[1])), static_cast<std::int64_t>(std::floor(d[2])), 0));
  }
  Cells cells{.index = CellIndex(keys), .places = {}};
  for (std::size_t c = 0; c < cells.index.size(); ++c) {
    const CellCoordinates at = coordinates(cells.index.key(c));
    cells.places.emplace_back((static_cast<double>(at.x) + 0.5) * edge, (static_cast<double>(at.y) + 0.5) * edge);
  }
  return cells;
}

}  // namespace

void part_outlines(const Cloud& cloud, Regions& regions) {
  const auto points = points_of_regions(regions.of_point, regions.planes.size());
  for (std::size_t r = 0; r < points.size(); ++r) {
    const PlaneFit plane = regions.planes[r];
    const double area = plane.spread_area();
    if (points[r].size() < kFewest || area < kSmallest || area > kLargest) continue;
    const double edge = std::clamp(std::sqrt(kWanted * area / static_cast<double>(points[r].size())), kFinest, kCoarsest);
    const Cells cells = cells_of(cloud, plane, points[r], edge);
    const auto parts = cut_outline(cells.places, edge, {.clearly = 0.8, .fill = 0.62, .smallest_part = 0.1, .largest = kLargest});
    for (std::size_t p = 1; p < parts.size(); ++p) {
      const auto number = static_cast<std::int32_t>(regions.planes.size());
      for (const std::size_t c : parts[p]) {
        for (const std::uint32_t k : cells.index.items(c)) regions.of_point[points[r][k]] = number;
      }
      regions.planes.emplace_back();
    }
  }
  refit(cloud, regions);
}

}  // namespace scenelore::perception
