#include "candidates.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scenelore/perception/parallel.hpp"

namespace scenelore::perception {
namespace {

/// What a voxel's slots hold: one region, none, or several.
constexpr std::int32_t kNone = -1, kSeveral = -2;

std::vector<std::int32_t> regions_of_voxels(const Slots& slots, std::size_t voxels) {
  std::vector<std::int32_t> result(voxels, kNone);
  for (std::size_t s = 0; s < slots.count(); ++s) {
    const std::int32_t r = slots.region[s];
    if (r < 0 || slots.moments[s].n <= 0) continue;
    std::int32_t& here = result[slots.voxel[s]];
    here = here == kNone || here == r ? r : kSeveral;
  }
  return result;
}

void add_candidates(const VoxelGrid& grid, const Slots& slots, const std::vector<std::int32_t>& of_voxel, const std::vector<PlaneFit>& planes,
                    const std::vector<double>& reach, std::size_t most, std::size_t v, std::vector<std::int32_t>& out) {
  const std::size_t start = out.size();
  std::int32_t last = kNone;
  const auto add = [&](std::int32_t r) {
    if (r == last) return;
    last = r;
    if (std::find(out.begin() + static_cast<std::ptrdiff_t>(start), out.end(), r) == out.end()) out.push_back(r);
  };
  for (const std::int32_t n : grid.neighbours[v]) {
    if (n < 0 || of_voxel[n] == kNone) continue;
    if (of_voxel[n] != kSeveral) {
      add(of_voxel[n]);
      continue;
    }
    for (std::uint32_t s = slots.first[n]; s < slots.first[n + 1]; ++s) {
      if (slots.region[s] >= 0 && slots.moments[s].n > 0) add(slots.region[s]);
    }
  }
  if (out.size() == start) return;
  const Eigen::Vector3d center = grid.center(v);
  const auto begin = out.begin() + static_cast<std::ptrdiff_t>(start);
  out.erase(std::remove_if(begin, out.end(), [&](std::int32_t r) { return clearance(planes[r], center, grid.size / 2) > reach[r]; }), out.end());
  std::sort(begin, out.end(), [&](std::int32_t a, std::int32_t b) {
    return std::pair(-planes[a].count, a) < std::pair(-planes[b].count, b);
  });
  if (out.size() > start + most) out.resize(start + most);
}

}  // namespace

Candidates candidates_within(const Slots& slots, const std::vector<double>& sigma) {
  Candidates candidates;
  std::vector<double> held;  // points, by entry
  for (std::size_t v = 0; v + 1 < slots.first.size(); ++v) {
    const std::size_t row = candidates.regions.size();
    candidates.first.push_back(static_cast<std::uint32_t>(row));
    for (std::uint32_t s = slots.first[v]; s < slots.first[v + 1]; ++s) {
      const std::int32_t r = slots.region[s];
      if (r < 0 || slots.moments[s].n <= 0) continue;
      std::size_t at = row;
      while (at < candidates.regions.size() && candidates.regions[at] != r) ++at;
      if (at == candidates.regions.size()) candidates.regions.push_back(r), held.push_back(0);
      held[at] += slots.moments[s].n;
    }
  }
  candidates.first.push_back(static_cast<std::uint32_t>(candidates.regions.size()));
  for (std::size_t k = 0; k < held.size(); ++k) {
    candidates.handicap.push_back(static_cast<float>(std::log(sigma[static_cast<std::size_t>(candidates.regions[k])] / held[k])));
  }
  return candidates;
}

Candidates candidates_around(const VoxelGrid& grid, const Slots& slots, const std::vector<PlaneFit>& planes,
                             const std::vector<double>& reach, std::size_t most, int threads) {
  constexpr std::size_t kPiece = 4096;
  Candidates result;
  result.first.resize(grid.count() + 1, 0);
  std::vector<std::vector<std::int32_t>> rows(grid.count() / kPiece + 1);
  const std::vector<std::int32_t> of_voxel = regions_of_voxels(slots, grid.count());
  parallel_pieces(grid.count(), kPiece, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      std::vector<std::int32_t>& row = rows[v / kPiece];
      const std::size_t before = row.size();
      add_candidates(grid, slots, of_voxel, planes, reach, most, v, row);
      result.first[v + 1] = static_cast<std::uint32_t>(row.size() - before);
    }
  });
  for (std::size_t v = 0; v < grid.count(); ++v) result.first[v + 1] += result.first[v];
  result.regions.reserve(result.first.back());
  for (const auto& row : rows) result.regions.insert(result.regions.end(), row.begin(), row.end());
  return result;
}

}  // namespace scenelore::perception
