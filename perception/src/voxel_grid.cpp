#include "voxel_grid.hpp"

#include <algorithm>
#include <numeric>

#include "scenelore/perception/parallel.hpp"

namespace scenelore::perception {
namespace {

constexpr int kEdge = BlockTable::kEdge, kPadded = kEdge + 2;

/// The voxels of one block and of the layer around it.
using Surroundings = std::array<std::uint32_t, kPadded * kPadded * kPadded>;

void look_around(const BlockTable& table, std::size_t block, Surroundings& around) {
  around.fill(kNoVoxel);
  for (int d = 0; d < 27; ++d) {
    const int dx = d / 9 - 1, dy = d / 3 % 3 - 1, dz = d % 3 - 1;
    const std::int64_t other = d == 13 ? static_cast<std::int64_t>(block) : table.find(BlockTable::moved(table.key(block), dx, dy, dz));
    if (other < 0) continue;
    const BlockTable::Cells& cells = table.cells(static_cast<std::size_t>(other));
    const auto low = [](int step) { return step < 0 ? kEdge - 1 : 0; };
    const auto high = [](int step) { return step > 0 ? 1 : kEdge; };
    for (int x = low(dx); x < high(dx); ++x) {
      for (int y = low(dy); y < high(dy); ++y) {
        for (int z = low(dz); z < high(dz); ++z) {
          const int at = ((x + dx * kEdge + 1) * kPadded + y + dy * kEdge + 1) * kPadded + z + dz * kEdge + 1;
          around[static_cast<std::size_t>(at)] = cells[static_cast<std::size_t>((x * kEdge + y) * kEdge + z)];
        }
      }
    }
  }
}

void find_neighbours(VoxelGrid& grid, std::size_t block) {
  Surroundings around;
  look_around(grid.table, block, around);
  for (std::size_t v = grid.block_start[block]; v < grid.block_start[block + 1]; ++v) {
    const VoxelPlace p = grid.places[v];
    const int x = static_cast<int>(p.x % kEdge), y = static_cast<int>(p.y % kEdge), z = static_cast<int>(p.z % kEdge);
    std::int32_t* next = grid.neighbours[v].data();
    for (int dx = 0; dx < 3; ++dx) {
      for (int dy = 0; dy < 3; ++dy, next += 3) {
        const std::uint32_t* const row = &around[static_cast<std::size_t>(((x + dx) * kPadded + y + dy) * kPadded + z)];
        for (int dz = 0; dz < 3; ++dz) next[dz] = static_cast<std::int32_t>(row[dz]);  // kNoVoxel becomes −1
      }
    }
  }
}

}  // namespace

std::vector<std::uint32_t> number_voxels(BlockTable table, std::size_t voxels, int threads, VoxelGrid& grid) {
  std::vector<std::uint32_t> order(table.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return table.key(a) < table.key(b); });
  std::vector<std::uint32_t> number(voxels, kNoVoxel);
  grid.places.reserve(voxels);
  grid.block_start.reserve(order.size() + 1);
  grid.table.reserve(order.size());
  for (const std::uint32_t b : order) {
    const auto block = grid.table.insert(table.key(b));
    grid.block_start.push_back(static_cast<std::uint32_t>(grid.places.size()));
    for (std::uint32_t c = 0; c < BlockTable::kCells; ++c) {
      const std::uint32_t old = table.cells(b)[c];
      if (old == kNoVoxel) continue;
      const auto v = static_cast<std::uint32_t>(grid.places.size());
      number[old] = v;
      grid.table.cells(block)[c] = v;
      grid.places.push_back(BlockTable::place(table.key(b), c));
    }
  }
  grid.block_start.push_back(static_cast<std::uint32_t>(grid.places.size()));
  grid.neighbours.resize(grid.count());
  parallel_pieces(grid.table.size(), 32, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) find_neighbours(grid, b);
  });
  return number;
}

Coarser coarsened(const VoxelGrid& fine, int threads) {
  return coarsened(fine, [&](std::size_t v) -> const Moments& { return fine.moments[v]; }, threads);
}

Coarser coarsened(const VoxelGrid& fine, const std::function<const Moments&(std::size_t)>& moments, int threads) {
  Coarser result;
  result.grid.size = 2 * fine.size;
  result.parent.assign(fine.count(), kNoVoxel);
  BlockTable table;
  std::uint32_t voxels = 0;
  std::uint64_t last_key = ~std::uint64_t{0};
  BlockTable::Cells* cells = nullptr;  // of the last block: voxels come block after block
  for (std::size_t v = 0; v < fine.count(); ++v) {
    if (moments(v).n <= 0) continue;
    const auto half = [](std::uint32_t c) { return (c + kPlaceOrigin) / 2; };  // coordinate 0 stays where it is
    const VoxelPlace p{half(fine.places[v].x), half(fine.places[v].y), half(fine.places[v].z)};
    const std::uint64_t key = BlockTable::block_key(p);
    if (key != last_key) cells = &table.cells(table.insert(last_key = key));
    std::uint32_t& cell = (*cells)[BlockTable::cell(p)];
    if (cell == kNoVoxel) cell = voxels++;
    result.parent[v] = cell;
  }
  const std::vector<std::uint32_t> number = number_voxels(std::move(table), voxels, threads, result.grid);
  result.grid.moments.resize(result.grid.count());
  for (std::size_t v = 0; v < fine.count(); ++v) {
    if (result.parent[v] == kNoVoxel) continue;
    result.parent[v] = number[result.parent[v]];
    result.grid.moments[result.parent[v]] += moments(v);
  }
  return result;
}

}  // namespace scenelore::perception
