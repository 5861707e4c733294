#include "scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "voxel_grid.hpp"

namespace scenelore::perception {
namespace {

constexpr double kFinestVoxel = 0.05;       // metres; thinner things are found above their support
constexpr std::size_t kWantedPoints = 5;    // in the voxel of the median point
constexpr int kMostDoublings = 24;          // 5 cm to 800 km
constexpr std::size_t kSamples = 2000;
constexpr std::size_t kMostComparisons = 20'000'000;

/// Number of points in the voxel of the median point.
std::size_t typical_occupancy(const CellIndex& cells) {
  std::vector<std::size_t> counts(cells.size());
  std::size_t points = 0;
  for (std::size_t c = 0; c < cells.size(); ++c) points += counts[c] = cells.items(c).size();
  std::sort(counts.begin(), counts.end());
  std::size_t seen = 0;
  for (const std::size_t count : counts) {
    seen += count;
    if (2 * seen >= points) return count;
  }
  return 0;
}

/// Distance to the nearest other place within the surrounding voxels; infinite when they hold none.
double nearest(const Cloud& cloud, const CellIndex& cells, std::size_t cell, std::uint32_t point, std::size_t& comparisons) {
  float best = std::numeric_limits<float>::infinity();
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        const std::int32_t other = cells.find(moved(cells.key(cell), dx, dy, dz));
        if (other < 0) continue;
        for (const std::uint32_t i : cells.items(static_cast<std::size_t>(other))) {
          const float d = (cloud.offset(i) - cloud.offset(point)).squaredNorm();
          if (d > 0 && d < best) best = d;
        }
        comparisons += cells.items(static_cast<std::size_t>(other)).size();
      }
    }
  }
  return std::sqrt(static_cast<double>(best));
}

double median_spacing(const Cloud& cloud, const CellIndex& cells, double voxel) {
  std::vector<double> distances;
  std::size_t comparisons = 0;
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / kSamples);
  for (std::size_t i = 0; i < cloud.size() && comparisons < kMostComparisons; i += step) {
    const std::int32_t cell = cells.cell_of(i);
    if (cell < 0) continue;
    const double d = nearest(cloud, cells, static_cast<std::size_t>(cell), static_cast<std::uint32_t>(i), comparisons);
    if (std::isfinite(d)) distances.push_back(d);
  }
  if (distances.empty()) return voxel;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

}  // namespace

Scale estimate_scale(const Cloud& cloud, int threads) {
  Scale scale{.voxel = kFinestVoxel};
  const std::size_t valid = cloud.size() - cloud.invalid;
  CellIndex cells = make_cells(cloud, scale.voxel, {}, threads);
  for (int i = 0; i < kMostDoublings && typical_occupancy(cells) < std::min(kWantedPoints, valid); ++i) {
    // A cloud far from this scale (millimetres, a town) gets there in large steps, one near to it in small ones.
    scale.voxel *= typical_occupancy(cells) <= 1 ? 2 : 1.4;
    cells = make_cells(cloud, scale.voxel, {}, threads);
  }
  scale.spacing = median_spacing(cloud, cells, scale.voxel);
  return scale;
}

}  // namespace scenelore::perception
