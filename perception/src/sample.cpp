#include "sample.hpp"

#include "parallel.hpp"
#include "point_hash.hpp"

namespace scenelore::perception {

PointSample take_sample(const Cloud& cloud, const VoxelisedCloud& voxels, std::int64_t most, int threads) {
  // Points with a hash of at most this are taken.
  std::vector<std::uint32_t> limit(voxels.grid.count());
  for (std::size_t v = 0; v < limit.size(); ++v) {
    const std::int64_t n = voxels.fixed[v].n;
    limit[v] = n <= most ? ~std::uint32_t{0} : static_cast<std::uint32_t>((static_cast<std::uint64_t>(most) << 32) / static_cast<std::uint64_t>(n));
  }
  constexpr std::size_t kPiece = 1 << 18;
  std::vector<std::vector<std::uint32_t>> chosen(cloud.size() / kPiece + 1);
  parallel_pieces(cloud.size(), kPiece, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t v = voxels.of_point[i];
      if (v == kNoVoxel || point_hash(cloud.x[i], cloud.y[i], cloud.z[i]) > limit[v]) continue;
      chosen[i / kPiece].push_back(static_cast<std::uint32_t>(i));
    }
  });
  PointSample sample;
  std::size_t count = 0;
  for (const auto& some : chosen) count += some.size();
  sample.points.reserve(count);
  for (const auto& some : chosen) sample.points.insert(sample.points.end(), some.begin(), some.end());
  sample.cloud.origin = cloud.origin;
  sample.cloud.sensors = cloud.sensors.of_points(sample.points);
  sample.voxels.of_point.resize(count);
  for (auto* axis : {&sample.cloud.x, &sample.cloud.y, &sample.cloud.z}) axis->resize(count);
  parallel_pieces(count, kPiece, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t i = sample.points[k];
      sample.cloud.x[k] = cloud.x[i], sample.cloud.y[k] = cloud.y[i], sample.cloud.z[k] = cloud.z[i];
      sample.voxels.of_point[k] = voxels.of_point[i];
    }
  });
  if (count == cloud.size()) {
    sample.voxels.fixed = voxels.fixed;
    return sample;
  }
  sample.voxels.fixed.resize(voxels.grid.count());
  const FixedScale scale(voxels.grid.size);
  for (std::size_t k = 0; k < count; ++k) {
    const auto [x, y, z] = scale.within_voxel(sample.cloud.x[k], sample.cloud.y[k], sample.cloud.z[k]);
    sample.voxels.fixed[sample.voxels.of_point[k]].add(x, y, z);
  }
  return sample;
}

}  // namespace scenelore::perception
