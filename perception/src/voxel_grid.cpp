#include "voxel_grid.hpp"

#include <algorithm>
#include <cmath>

#include "parallel.hpp"

namespace scenelore::perception {
namespace {

CellKey key_of(double x, double y, double z, double per_metre) {
  const double cx = std::floor(x * per_metre), cy = std::floor(y * per_metre), cz = std::floor(z * per_metre);
  constexpr auto limit = static_cast<double>(kCellLimit);
  // Written so that NaN fails the test as well.
  if (!(std::abs(cx) < limit && std::abs(cy) < limit && std::abs(cz) < limit)) return kNoCell;
  return cell_key(static_cast<std::int64_t>(cx), static_cast<std::int64_t>(cy), static_cast<std::int64_t>(cz));
}

void sum_moments(const Cloud& cloud, VoxelGrid& grid, std::size_t begin, std::size_t end) {
  for (std::size_t v = begin; v < end; ++v) {
    Moments m;
    for (const std::uint32_t i : grid.cells.items(v)) m.add(cloud.x[i], cloud.y[i], cloud.z[i]);
    grid.moments[v] = m;
  }
}

void find_neighbours(VoxelGrid& grid, std::size_t begin, std::size_t end) {
  for (std::size_t v = begin; v < end; ++v) {
    std::size_t k = 0;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz, ++k) {
          grid.neighbours[v][k] = k == kSelf ? static_cast<std::int32_t>(v) : grid.cells.find(moved(grid.cells.key(v), dx, dy, dz));
        }
      }
    }
  }
}

}  // namespace

CellIndex make_cells(const Cloud& cloud, double size, std::span<const std::int32_t> taken, int threads) {
  std::vector<CellKey> keys(cloud.size());
  parallel_pieces(cloud.size(), 1 << 16, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      keys[i] = !taken.empty() && taken[i] >= 0 ? kNoCell : key_of(cloud.x[i], cloud.y[i], cloud.z[i], 1 / size);
    }
  });
  return CellIndex(keys);
}

VoxelGrid make_voxel_grid(const Cloud& cloud, double size, std::span<const std::int32_t> taken, int threads) {
  VoxelGrid grid;
  grid.size = size;
  grid.cells = make_cells(cloud, size, taken, threads);
  grid.moments.resize(grid.count());
  grid.neighbours.resize(grid.count());
  parallel_pieces(grid.count(), 2048, threads, [&](std::size_t begin, std::size_t end) {
    sum_moments(cloud, grid, begin, end);
    find_neighbours(grid, begin, end);
  });
  return grid;
}

}  // namespace scenelore::perception
