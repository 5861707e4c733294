#include "sample.hpp"

#include "point_hash.hpp"
#include "scenelore/perception/memory.hpp"
#include "scenelore/perception/parallel.hpp"

namespace scenelore::perception {
namespace {

/// `of_point`: the voxel of each.
PointsByVoxel sorted_by_voxel(const VoxelGrid& grid, const Cloud& cloud, const std::vector<std::uint32_t>& of_point) {
  PointsByVoxel sorted;
  sorted.first.assign(grid.count() + 1, 0);
  for (const std::uint32_t v : of_point) ++sorted.first[v + 1];
  for (std::size_t v = 0; v < grid.count(); ++v) sorted.first[v + 1] += sorted.first[v];
  std::vector<std::uint32_t> next(sorted.first.begin(), sorted.first.end() - 1);
  sorted.point.resize(of_point.size());
  sorted.at.resize(of_point.size());
  const FixedScale scale(grid.size);
  for (std::size_t k = 0; k < of_point.size(); ++k) {
    const std::uint32_t place = next[of_point[k]]++;
    const auto [x, y, z] = scale.within_voxel(cloud.x[k], cloud.y[k], cloud.z[k]);
    sorted.point[place] = static_cast<std::uint32_t>(k);
    sorted.at[place] = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(z)};
  }
  return sorted;
}

}  // namespace

PointSample take_sample(const Cloud& cloud, const VoxelisedCloud& voxels, std::int64_t most, int threads) {
  // Points with a hash of at most this are taken.
  std::vector<std::uint32_t> limit(voxels.grid.count());
  for (std::size_t v = 0; v < limit.size(); ++v) {
    const std::int64_t n = voxels.fixed[v].n;
    limit[v] = n <= most ? ~std::uint32_t{0} : static_cast<std::uint32_t>((static_cast<std::uint64_t>(most) << 32) / static_cast<std::uint64_t>(n));
  }
  constexpr std::size_t kPiece = 1 << 18;
  struct Chosen {
    std::uint32_t point, voxel;
  };
  std::vector<std::vector<Chosen>> chosen(cloud.size() / kPiece + 1);
  parallel_pieces(cloud.size(), kPiece, threads, [&](std::size_t begin, std::size_t end) {
    PointLocator locator(voxels.grid);
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t v = locator.locate(cloud, i);
      if (v == kNoVoxel || point_hash(cloud.x[i], cloud.y[i], cloud.z[i]) > limit[v]) continue;
      chosen[i / kPiece].push_back({static_cast<std::uint32_t>(i), v});
    }
  });
  PointSample sample;
  std::size_t count = 0;
  for (const auto& some : chosen) count += some.size();
  std::vector<std::uint32_t> voxel_of_point;
  sample.points.reserve(count), voxel_of_point.reserve(count);
  for (const auto& some : chosen) {
    for (const Chosen& c : some) sample.points.push_back(c.point), voxel_of_point.push_back(c.voxel);
  }
  release(chosen);
  sample.cloud.origin = cloud.origin;
  sample.cloud.sensors = cloud.sensors.of_points(sample.points);
  for (auto* axis : {&sample.cloud.x, &sample.cloud.y, &sample.cloud.z}) axis->resize(count);
  parallel_pieces(count, kPiece, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t i = sample.points[k];
      sample.cloud.x[k] = cloud.x[i], sample.cloud.y[k] = cloud.y[i], sample.cloud.z[k] = cloud.z[i];
    }
  });
  sample.by_voxel = sorted_by_voxel(voxels.grid, sample.cloud, voxel_of_point);
  return sample;
}

}  // namespace scenelore::perception
