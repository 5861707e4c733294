#include "voxelise.hpp"

#include <algorithm>

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

void take(const Cloud& cloud, const FixedScale& scale, Piece& piece, std::vector<std::uint32_t>& of_point) {
  std::uint64_t last_key = ~std::uint64_t{0};
  BlockTable::Cells* cells = nullptr;
  for (std::size_t i = piece.begin; i < piece.end; ++i) {
    const double fx = scale.fixed(cloud.x[i]), fy = scale.fixed(cloud.y[i]), fz = scale.fixed(cloud.z[i]);
    if (!(FixedScale::inside(fx) && FixedScale::inside(fy) && FixedScale::inside(fz))) {
      of_point[i] = kNoVoxel;
      continue;
    }
    const auto x = static_cast<std::int64_t>(fx), y = static_cast<std::int64_t>(fy), z = static_cast<std::int64_t>(fz);
    const VoxelPlace place{static_cast<std::uint32_t>(x >> kFixedBits), static_cast<std::uint32_t>(y >> kFixedBits),
                           static_cast<std::uint32_t>(z >> kFixedBits)};
    const std::uint64_t key = BlockTable::block_key(place);
    if (key != last_key) {
      last_key = key;
      cells = &piece.table.cells(piece.table.insert(key));
    }
    std::uint32_t& voxel = (*cells)[BlockTable::cell(place)];
    if (voxel == kNoVoxel) {
      voxel = static_cast<std::uint32_t>(piece.sums.size());
      piece.sums.emplace_back();
    }
    of_point[i] = voxel;
    constexpr std::int64_t mask = kFixedSteps - 1;
    piece.sums[voxel].add(static_cast<std::int32_t>(x & mask), static_cast<std::int32_t>(y & mask), static_cast<std::int32_t>(z & mask));
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
  result.of_point.resize(cloud.size());
  constexpr std::size_t kSmallest = 1 << 14;
  const std::size_t wanted = std::clamp<std::size_t>(cloud.size() / kSmallest, 1, static_cast<std::size_t>(std::max(1, threads)));
  const std::size_t length = (cloud.size() + wanted - 1) / wanted;
  std::vector<Piece> pieces(wanted);
  const FixedScale scale(voxel);
  parallel_pieces(wanted, 1, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      pieces[p].begin = std::min(cloud.size(), p * length);
      pieces[p].end = std::min(cloud.size(), (p + 1) * length);
      take(cloud, scale, pieces[p], result.of_point);
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
    piece.sums = {};
  }
  parallel_pieces(wanted, 1, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      for (std::size_t i = pieces[p].begin; i < pieces[p].end; ++i) {
        if (result.of_point[i] != kNoVoxel) result.of_point[i] = pieces[p].number[result.of_point[i]];
      }
    }
  });
  const double step = voxel / kFixedSteps;
  parallel_pieces(voxels, 4096, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) result.grid.moments[v] = to_moments(result.fixed[v], result.grid.corner(v), step);
  });
  return result;
}

}  // namespace scenelore::perception
