#include <algorithm>
#include <array>
#include <cmath>

#include "parallel.hpp"
#include "slots.hpp"

namespace scenelore::perception {
namespace {

constexpr double kExplained = 0.8;  // of the tolerance

bool parallel(const PlaneFit& a, const PlaneFit& b) { return std::abs(a.normal.dot(b.normal)) > 0.94; }  // 20 degrees

/// A candidate's distance in its units, as a function of the fixed coordinates in the voxel. Single precision is good to
/// 10 nm there.
struct Ruler {
  float a = 0, b = 0, c = 0, e = 0;
  float reach = 0;  // in units

  [[nodiscard]] float distance(float x, float y, float z) const { return std::abs(a * x + b * y + c * z + e); }
};

Ruler make_ruler(const PlaneFit& plane, const Eigen::Vector3d& corner, double step, double unit, double reach) {
  const Eigen::Vector3d n = plane.normal * (step / unit);
  const double e = plane.distance(corner + Eigen::Vector3d::Constant(step / 2)) / unit;
  return {static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z()), static_cast<float>(e), static_cast<float>(reach / unit)};
}

/// The slots of all voxels, without their points.
Slots layout(const VoxelGrid& grid, const Candidates& candidates, const std::vector<bool>& only, std::size_t planes, const Slots* before) {
  Slots slots;
  slots.first.reserve(grid.count() + 1);
  const auto add = [&](std::size_t v, std::int32_t region, std::int32_t ruler) {
    slots.voxel.push_back(static_cast<std::uint32_t>(v));
    slots.region.push_back(region);
    slots.ruler.push_back(ruler);
  };
  for (std::size_t v = 0; v < grid.count(); ++v) {
    slots.first.push_back(static_cast<std::uint32_t>(slots.voxel.size()));
    if (only.empty() || only[v]) {
      for (std::uint32_t k = candidates.first[v]; k < candidates.first[v + 1]; ++k) add(v, candidates.regions[k], candidates.regions[k]);
      add(v, -1, -1);
    } else {
      for (std::uint32_t s = before->first[v]; s < before->first[v + 1]; ++s) {
        add(v, before->region[s], before->ruler[s] < 0 ? -1 : static_cast<std::int32_t>(planes) + before->ruler[s]);
      }
    }
  }
  slots.first.push_back(static_cast<std::uint32_t>(slots.voxel.size()));
  slots.moments.resize(slots.count());
  return slots;
}

class Assigner {
 public:
  Assigner(const Cloud& cloud, const VoxelGrid& grid, const VoxelPoints& voxels, const std::vector<PlaneFit>& planes, const AssignRule& rule,
           Slots& slots)
      : cloud_(cloud), grid_(grid), voxels_(voxels), planes_(planes), rule_(rule), slots_(slots), scale_(grid.size) {}

  void prepare(int threads) {
    rulers_.resize(slots_.count());
    const double step = grid_.size / kFixedSteps;
    parallel_pieces(slots_.count(), 8192, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t s = begin; s < end; ++s) {
        const std::int32_t r = slots_.region[s];
        if (r >= 0) rulers_[s] = make_ruler(planes_[r], grid_.corner(slots_.voxel[s]), step, rule_.unit[r], rule_.reach[r]);
      }
    });
  }

  /// Slot of a point of this voxel.
  std::uint32_t choose(std::uint32_t first, std::uint32_t none, float x, float y, float z) const {
    std::uint32_t owner = none;
    float best = 0;
    for (std::uint32_t s = first; s < none; ++s) {
      const Ruler& ruler = rulers_[s];
      const float d = ruler.distance(x, y, z);
      if (!(d < ruler.reach)) continue;
      if (owner != none) {
        if (d >= best) continue;
        // A smaller plane almost parallel to a larger one gets what the larger one clearly does not explain.
        if (rule_.larger_first && best < kExplained && parallel(planes_[slots_.region[s]], planes_[slots_.region[owner]])) continue;
      }
      best = d, owner = s;
    }
    return owner;
  }

  /// The first slot of a voxel mostly holds most of its points: it is found as what the others leave.
  void run(std::size_t begin, std::size_t end, std::vector<std::uint32_t>& slot_of_point, std::vector<FixedMoments>& sums,
           const Slots* before) const {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t v = voxels_.of_point[i];
      if (v == kNoVoxel) {
        slot_of_point[i] = kNoVoxel;
        continue;
      }
      const std::uint32_t first = slots_.first[v], none = slots_.first[v + 1] - 1;
      if (before != nullptr && !rule_.only[v]) {
        slot_of_point[i] = first + (slot_of_point[i] - before->first[v]);
        continue;
      }
      if (first == none) {
        slot_of_point[i] = none;
        continue;
      }
      const auto [x, y, z] = scale_.within_voxel(cloud_.x[i], cloud_.y[i], cloud_.z[i]);
      const std::uint32_t s = choose(first, none, static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
      slot_of_point[i] = s;
      if (s != first) sums[s].add(x, y, z);
    }
  }

 private:
  const Cloud& cloud_;
  const VoxelGrid& grid_;
  const VoxelPoints& voxels_;
  const std::vector<PlaneFit>& planes_;
  const AssignRule& rule_;
  Slots& slots_;
  FixedScale scale_;
  std::vector<Ruler> rulers_;
};

}  // namespace

Slots assign_points(const Cloud& cloud, const VoxelGrid& grid, const VoxelPoints& voxels, const Candidates& candidates,
                    const std::vector<PlaneFit>& planes, const AssignRule& rule, int threads, std::vector<std::uint32_t>& slot_of_point, const Slots* before) {
  if (rule.only.empty()) before = nullptr;
  Slots slots = layout(grid, candidates, rule.only, planes.size(), before);
  slots.rulers.assign(planes.begin(), planes.end());
  slots.reach = rule.reach;
  if (before != nullptr) {
    slots.rulers.insert(slots.rulers.end(), before->rulers.begin(), before->rulers.end());
    slots.reach.insert(slots.reach.end(), before->reach.begin(), before->reach.end());
  }
  slot_of_point.resize(cloud.size());
  Assigner assigner(cloud, grid, voxels, planes, rule, slots);
  assigner.prepare(threads);
  constexpr std::size_t kSmallest = 1 << 15;
  const std::size_t pieces = std::clamp<std::size_t>(cloud.size() / kSmallest, 1, static_cast<std::size_t>(std::max(1, threads)));
  const std::size_t length = (cloud.size() + pieces - 1) / pieces;
  std::vector<std::vector<FixedMoments>> sums(pieces);
  parallel_pieces(pieces, 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      sums[p].resize(slots.count());
      assigner.run(std::min(cloud.size(), p * length), std::min(cloud.size(), (p + 1) * length), slot_of_point, sums[p], before);
    }
  });
  const double step = grid.size / kFixedSteps;
  parallel_pieces(grid.count(), 2048, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (before != nullptr && !rule.only[v]) {
        for (std::uint32_t k = 0; k < slots.first[v + 1] - slots.first[v]; ++k) slots.moments[slots.first[v] + k] = before->moments[before->first[v] + k];
        continue;
      }
      const Eigen::Vector3d corner = grid.corner(v);
      FixedMoments left = voxels.fixed[v];
      for (std::uint32_t s = slots.first[v] + 1; s < slots.first[v + 1]; ++s) {
        FixedMoments own;
        for (const auto& part : sums) own += part[s];
        left -= own;
        slots.moments[s] = to_moments(own, corner, step);
      }
      slots.moments[slots.first[v]] = to_moments(left, corner, step);
    }
  });
  return slots;
}

}  // namespace scenelore::perception
