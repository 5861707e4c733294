#include "scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>
#include <utility>

#include "scenelore/perception/parallel.hpp"

namespace scenelore::perception {
namespace {

constexpr double kFinestVoxel = 0.05;     // metres; thinner things are found above their support
constexpr std::size_t kWantedPoints = 5;  // in the voxel of the median point
constexpr int kMostDoublings = 24;        // 5 cm to 800 km
constexpr double kFewestInBlock = 16;     // points; a block of 8³ voxels that a surface crosses holds 64 voxels and more

/// About how many points a block of voxels holds, from a few points: those that hit the same block tell how many blocks
/// there are. Keeps clouds in millimetres or of whole towns from being cut into billions of voxels.
double points_per_block(const Cloud& cloud, double voxel) {
  constexpr std::size_t kLooks = 20'000;
  const FixedScale scale(voxel);
  std::unordered_set<std::uint64_t> seen;
  double looks = 0;
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / kLooks);
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    const double x = scale.fixed(cloud.x[i]), y = scale.fixed(cloud.y[i]), z = scale.fixed(cloud.z[i]);
    if (!(FixedScale::inside(x) && FixedScale::inside(y) && FixedScale::inside(z))) continue;
    const auto place = [](double fixed) { return static_cast<std::uint32_t>(static_cast<std::int64_t>(fixed) >> kFixedBits); };
    seen.insert(BlockTable::block_key({place(x), place(y), place(z)}));
    looks += 1;
  }
  const auto hit = static_cast<double>(seen.size());
  // D blocks are expected to show D (1 − e^(−n/D)) of themselves to n looks; bisection for D.
  double low = hit, high = 1e4 * std::max(1.0, hit);
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (middle * (1 - std::exp(-looks / middle)) < hit ? low : high) = middle;
  }
  return low > 0 ? static_cast<double>(cloud.size()) / low : 0;
}

/// Number of points in the voxel of the median point.
std::size_t typical_occupancy(const VoxelisedCloud& voxels) {
  constexpr std::size_t kMost = 64;
  std::vector<std::size_t> points_in(kMost + 1, 0);  // voxels of k points
  std::size_t points = 0;
  for (const FixedMoments& m : voxels.fixed) {
    const auto n = static_cast<std::size_t>(m.n);
    points_in[std::min(n, kMost)] += n;
    points += n;
  }
  std::size_t seen = 0;
  for (std::size_t n = 1; n <= kMost; ++n) {
    seen += points_in[n];
    if (2 * seen >= points && points > 0) return n;
  }
  return 0;
}

/// A few points look for their nearest neighbours within the surrounding voxels.
double median_spacing(const Cloud& cloud, const ScaledCloud& voxels, int threads) {
  constexpr std::size_t kSamples = 200, kMostCompared = 4000;
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / kSamples);
  // Room for the points of the voxels that are asked about, and nothing for those of the others.
  std::vector<std::uint32_t> room(voxels.grid.count() + 1, 0);
  PointLocator locator(voxels.grid);
  std::vector<std::pair<std::size_t, std::uint32_t>> asked;  // points and their voxels
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    const std::uint32_t v = locator.locate(cloud, i);
    if (v == kNoVoxel) continue;
    asked.emplace_back(i, v);
    for (const std::int32_t n : voxels.grid.neighbours[v]) {
      if (n >= 0) room[static_cast<std::size_t>(n) + 1] = static_cast<std::uint32_t>(voxels.fixed[static_cast<std::size_t>(n)].n);
    }
  }
  for (std::size_t v = 0; v + 1 < room.size(); ++v) room[v + 1] += room[v];
  constexpr std::size_t kPiece = 1 << 18;
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> held(cloud.size() / kPiece + 1);  // voxels and points
  parallel_pieces(cloud.size(), kPiece, threads, [&](std::size_t begin, std::size_t end) {
    PointLocator own(voxels.grid);
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t v = own.locate(cloud, i);
      if (v != kNoVoxel && room[v] < room[v + 1]) held[i / kPiece].emplace_back(v, static_cast<std::uint32_t>(i));
    }
  });
  std::vector<std::uint32_t> next(room.begin(), room.end() - 1), points(room.back());
  for (const auto& some : held) {
    for (const auto& [v, i] : some) points[next[v]++] = i;
  }
  std::vector<double> distances;
  for (const auto& [i, v] : asked) {
    float best = std::numeric_limits<float>::infinity();
    std::size_t compared = 0;
    const auto& around = voxels.grid.neighbours[v];
    for (std::size_t k = 0; k < kNeighbours && compared < kMostCompared; ++k) {
      const std::int32_t n = around[(k + kSelf) % kNeighbours];  // its own voxel first
      if (n < 0) continue;
      for (std::uint32_t at = room[static_cast<std::size_t>(n)]; at < room[static_cast<std::size_t>(n) + 1]; ++at, ++compared) {
        const float d = (cloud.offset(points[at]) - cloud.offset(i)).squaredNorm();
        if (d > 0 && d < best) best = d;
      }
    }
    if (std::isfinite(best)) distances.push_back(std::sqrt(static_cast<double>(best)));
  }
  if (distances.empty()) return voxels.scale.voxel;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

}  // namespace

ScaledCloud voxelise_to_scale(const Cloud& cloud, int threads) {
  double size = kFinestVoxel;
  const std::size_t valid = cloud.size() - cloud.invalid;
  int doublings = 0;
  if (valid > 1000) {
    while (doublings < kMostDoublings && points_per_block(cloud, size) < kFewestInBlock) size *= 2, ++doublings;
  }
  ScaledCloud result{voxelise(cloud, size, threads), {}};
  for (; doublings < kMostDoublings; ++doublings) {
    const std::size_t typical = typical_occupancy(result);
    if (typical == 0 || typical >= std::min(kWantedPoints, valid)) break;
    // A cloud far from this scale (millimetres, a town) gets there in large steps, one near to it in small ones.
    size *= typical <= 1 ? 2 : 1.4;
    result = {voxelise(cloud, size, threads), {}};
  }
  result.scale.voxel = size;
  result.scale.spacing = median_spacing(cloud, result, threads);
  return result;
}

}  // namespace scenelore::perception
