#include "voxelise.hpp"

#include <algorithm>

#include "scenelore/perception/memory.hpp"
#include "scenelore/perception/parallel.hpp"

namespace scenelore::perception {
namespace {

/// A run of points with voxels of its own.
struct Piece {
  std::size_t begin = 0, end = 0;
  BlockTable table;
  std::vector<FixedMoments> sums;
  std::vector<std::uint32_t> number;  // of its voxels in the whole
};

void take(const Cloud& cloud, const FixedScale& scale, Piece& piece) {
  std::uint64_t last_key = ~std::uint64_t{0};
  BlockTable::Cells* cells = nullptr;
  for (std::size_t i = piece.begin; i < piece.end; ++i) {
    FixedPlace at;
    if (!scale.locate(cloud.x[i], cloud.y[i], cloud.z[i], at)) continue;
    const std::uint64_t key = BlockTable::block_key(at.voxel);
    if (key != last_key) {
      last_key = key;
      cells = &piece.table.cells(piece.table.insert(key));
    }
    std::uint32_t& voxel = (*cells)[BlockTable::cell(at.voxel)];
    if (voxel == kNoVoxel) {
      voxel = static_cast<std::uint32_t>(piece.sums.size());
      piece.sums.emplace_back();
    }
    piece.sums[voxel].add(at.within[0], at.within[1], at.within[2]);
  }
}

/// One table with the voxels of all pieces; `number` of each piece refers to it.
std::size_t unite(std::vector<Piece>& pieces, BlockTable& table) {
  std::uint32_t voxels = 0;
  for (Piece& piece : pieces) {
    piece.number.resize(piece.sums.size());
    for (std::size_t b = 0; b < piece.table.size(); ++b) {
      BlockTable::Cells& whole = table.cells(table.insert(piece.table.key(b)));
      const BlockTable::Cells& part = piece.table.cells(b);
      for (std::size_t c = 0; c < BlockTable::kCells; ++c) {
        if (part[c] == kNoVoxel) continue;
        if (whole[c] == kNoVoxel) whole[c] = voxels++;
        piece.number[part[c]] = whole[c];
      }
    }
    piece.table = BlockTable();
  }
  return voxels;
}

}  // namespace

VoxelisedCloud voxelise(const Cloud& cloud, double voxel, int threads) {
  VoxelisedCloud result;
  constexpr std::size_t kSmallest = 1 << 14;
  const std::size_t wanted = std::clamp<std::size_t>(cloud.size() / kSmallest, 1, static_cast<std::size_t>(std::max(1, threads)));
  const std::size_t length = (cloud.size() + wanted - 1) / wanted;
  std::vector<Piece> pieces(wanted);
  const FixedScale scale(voxel);
  parallel_pieces(wanted, 1, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      pieces[p].begin = std::min(cloud.size(), p * length);
      pieces[p].end = std::min(cloud.size(), (p + 1) * length);
      take(cloud, scale, pieces[p]);
    }
  });
  BlockTable table;
  const std::size_t voxels = unite(pieces, table);
  result.grid.size = voxel;
  const std::vector<std::uint32_t> number = number_voxels(std::move(table), voxels, threads, result.grid);
  result.fixed.resize(voxels);
  for (Piece& piece : pieces) {
    for (std::size_t v = 0; v < piece.sums.size(); ++v) {
      piece.number[v] = number[piece.number[v]];
      result.fixed[piece.number[v]] += piece.sums[v];
    }
    release(piece.sums);
  }
  result.grid.moments = moments_of_voxels(result.grid, result.fixed, threads);
  return result;
}

std::vector<Moments> moments_of_voxels(const VoxelGrid& grid, const std::vector<FixedMoments>& fixed, int threads) {
  std::vector<Moments> moments(grid.count());
  const double step = grid.size / kFixedSteps;
  parallel_pieces(grid.count(), 4096, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) moments[v] = to_moments(fixed[v], grid.corner(v), step);
  });
  return moments;
}

}  // namespace scenelore::perception
