#include "assign.hpp"

#include <algorithm>
#include <utility>

#include "parallel.hpp"

namespace scenelore::perception {
namespace {

/// Regions with points in each cell: distinct numbers, rising.
struct Present {
  std::vector<std::uint32_t> starts;
  std::vector<std::int32_t> regions;
};

Present regions_in_cells(const CellIndex& cells, const std::vector<std::int32_t>& of_point) {
  Present present;
  present.starts.push_back(0);
  std::vector<std::int32_t> here;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    here.clear();
    for (const std::uint32_t i : cells.items(c)) {
      const std::int32_t r = of_point[i];
      if (r >= 0 && std::find(here.begin(), here.end(), r) == here.end()) here.push_back(r);
    }
    std::sort(here.begin(), here.end());
    present.regions.insert(present.regions.end(), here.begin(), here.end());
    present.starts.push_back(static_cast<std::uint32_t>(present.regions.size()));
  }
  return present;
}

std::vector<std::int32_t> candidates(const CellIndex& cells, const Present& present, const Regions& regions, std::size_t cell) {
  std::vector<std::int32_t> result;
  for (int d = 0; d < 27; ++d) {
    const std::int32_t n = cells.find(moved(cells.key(cell), d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1));
    if (n < 0) continue;
    for (std::uint32_t k = present.starts[n]; k < present.starts[n + 1]; ++k) {
      if (std::find(result.begin(), result.end(), present.regions[k]) == result.end()) result.push_back(present.regions[k]);
    }
  }
  // Largest first.
  std::sort(result.begin(), result.end(), [&](std::int32_t a, std::int32_t b) {
    return std::pair(-regions.planes[a].count, a) < std::pair(-regions.planes[b].count, b);
  });
  return result;
}

constexpr double kExplained = 0.8;  // of the tolerance

bool parallel(const PlaneFit& a, const PlaneFit& b) { return std::abs(a.normal.dot(b.normal)) > 0.94; }  // 20 degrees

}  // namespace

void assign_points(const Cloud& cloud, const CellIndex& cells, const Limits& limits, bool only_free, int threads, Regions& regions) {
  const Present present = regions_in_cells(cells, regions.of_point);
  std::vector<double> per_tolerance(regions.planes.size());
  for (std::size_t r = 0; r < per_tolerance.size(); ++r) per_tolerance[r] = 1 / tolerance(regions.planes[r], limits);
  parallel_pieces(cells.size(), 512, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const std::vector<std::int32_t> near = candidates(cells, present, regions, c);
      for (const std::uint32_t i : cells.items(c)) {
        if (only_free && regions.of_point[i] >= 0) continue;
        const Eigen::Vector3d p = cloud.offset(i).cast<double>();
        double best = 1;
        std::int32_t owner = -1;
        for (const std::int32_t r : near) {
          const double d = std::abs(regions.planes[r].distance(p)) * per_tolerance[r];
          if (d >= best) continue;
          // A smaller plane almost parallel to a larger one gets what the larger one clearly does not explain.
          if (owner >= 0 && best < kExplained && parallel(regions.planes[r], regions.planes[owner])) continue;
          best = d, owner = r;
        }
        regions.of_point[i] = owner;
      }
    }
  });
}

}  // namespace scenelore::perception
