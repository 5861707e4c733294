#include "surface_voxels.hpp"

#include <algorithm>
#include <cmath>

#include "scenelore/perception/parallel.hpp"

namespace scenelore::perception {
namespace {

constexpr double kFewestPoints = 8;       // three unknowns, and some to judge the fit by
constexpr double kThinness = 0.15;        // variance across / along; a cube of noise has 1, 1 cm of noise on 15 cm 0.05
constexpr double kSpread = 0.08;          // variance along the plane in voxel edges², a full neighbourhood has 0.75
constexpr double kNoiseFloor = 1.0 / 50;  // voxel edges; exact planes must not lead to tolerances of zero

LocalSurface surface_of(const Moments& sum, double size) {
  LocalSurface surface;
  if (sum.n < kFewestPoints) return surface;
  const FlatFit fit = fit_flat(sum);
  // n − 3 degrees of freedom: few points lie closer to a plane fitted to them than to the true one.
  const double variance = fit.across * sum.n / (sum.n - 3);
  surface.normal = fit.normal.cast<float>();
  surface.rmse = static_cast<float>(std::sqrt(variance));
  surface.planar = fit.along > kSpread * size * size && variance < kThinness * fit.along;
  return surface;
}

LocalSurface surface_at(const VoxelGrid& grid, std::size_t v) {
  Moments sum;
  for (const std::int32_t n : grid.neighbours[v]) {
    if (n >= 0) sum += grid.moments[static_cast<std::size_t>(n)];
  }
  return surface_of(sum, grid.size);
}

double quantile(std::vector<float>& values, double q) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

std::vector<LocalSurface> local_surfaces(const VoxelGrid& grid, int threads) {
  std::vector<LocalSurface> result(grid.count());
  parallel_pieces(grid.count(), 1024, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) result[v] = surface_at(grid, v);
  });
  return result;
}

namespace {

constexpr double kExact = 1.0 / 250;     // voxel edges: 0.2 mm; no ranging sensor is that good over 15 cm
constexpr double kRoundedDeviation = 1.7;  // a voxel within one step lies up to half a step off, 1.7 of the steps' deviations

/// Deviations of neighbourhoods four times as wide, by voxel; −1 where those are not flat.
std::vector<float> wide_deviations(const VoxelGrid& grid, int threads) {
  const Coarser twice = coarsened(grid, threads);
  const Coarser four = coarsened(twice.grid, threads);
  const std::vector<LocalSurface> surfaces = local_surfaces(four.grid, threads);
  std::vector<float> result(grid.count());
  for (std::size_t v = 0; v < grid.count(); ++v) {
    const LocalSurface& surface = surfaces[four.parent[twice.parent[v]]];
    result[v] = surface.planar ? surface.rmse : -1.0F;
  }
  return result;
}

/// A block of neighbourhoods: flat ones, how many of them are exact, and the flat wider ones.
struct Block {
  std::vector<float> deviations, wide;
  std::size_t exact = 0;
};

}  // namespace

NoiseMap estimate_noise(const VoxelGrid& grid, const std::vector<LocalSurface>& surfaces, int threads) {
  const double floor = grid.size * kNoiseFloor, exact = grid.size * kExact;
  NoiseMap map;
  map.of_voxel.assign(grid.count(), static_cast<float>(floor));
  map.rounded.assign(grid.count(), false);
  std::vector<float> all;
  bool any_exact = false;
  for (std::size_t v = 0; v < grid.count(); ++v) {
    if (!surfaces[v].planar) continue;
    any_exact = any_exact || surfaces[v].rmse < exact;
    all.push_back(surfaces[v].rmse);
  }
  if (all.empty()) return map;
  const std::vector<float> wide = any_exact ? wide_deviations(grid, threads) : std::vector<float>();
  map.typical = quantile(all, 0.4);
  for (std::size_t b = 0; b + 1 < grid.block_start.size(); ++b) {
    Block block;
    for (std::size_t v = grid.block_start[b]; v < grid.block_start[b + 1]; ++v) {
      if (surfaces[v].planar) block.deviations.push_back(surfaces[v].rmse);
      if (surfaces[v].planar && surfaces[v].rmse < exact) ++block.exact;
      if (any_exact && wide[v] >= 0) block.wide.push_back(wide[v]);
    }
    // Few flat voxels say little: the typical value counts as ten of them.
    const auto known = static_cast<double>(block.deviations.size());
    const double here = known == 0 ? map.typical : (quantile(block.deviations, 0.25) * known + map.typical * 10) / (known + 10);
    double noise = std::clamp(here, std::max(floor, 0.3 * map.typical), std::max(floor, 3 * map.typical));
    const double wider = block.wide.empty() ? 0 : quantile(block.wide, 0.35);
    const bool rounded = static_cast<double>(block.exact) > 0.2 * known && wider > 5 * exact;
    if (rounded) noise = std::min(std::max(noise, kRoundedDeviation * wider), 3 * map.typical);
    for (std::size_t v = grid.block_start[b]; v < grid.block_start[b + 1]; ++v) {
      map.of_voxel[v] = static_cast<float>(noise);
      map.rounded[v] = rounded;
    }
  }
  std::vector<float> sorted = map.of_voxel;
  map.high = std::max<double>(quantile(all, 0.9), quantile(sorted, 0.9));
  return map;
}

}  // namespace scenelore::perception
