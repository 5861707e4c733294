#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "scenelore/perception/parallel.hpp"
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
  float handicap = 0;

  [[nodiscard]] float distance(float x, float y, float z) const { return std::abs(a * x + b * y + c * z + e); }
};

Ruler make_ruler(const PlaneFit& plane, const Eigen::Vector3d& corner, double step, double unit, double reach, float handicap) {
  const Eigen::Vector3d n = plane.normal * (step / unit);
  const double e = plane.distance(corner + Eigen::Vector3d::Constant(step / 2)) / unit;
  return {static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z()), static_cast<float>(e), static_cast<float>(reach / unit), handicap};
}

/// The slots of all voxels, without their points.
Slots layout(const VoxelGrid& grid, const Candidates& candidates, const std::vector<bool>& only, std::size_t planes, const Slots* before) {
  Slots slots;
  slots.first.resize(grid.count() + 1);
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < grid.count(); ++v) {
    slots.first[v] = count;
    count += only.empty() || only[v] ? candidates.first[v + 1] - candidates.first[v] + 1 : before->first[v + 1] - before->first[v];
  }
  slots.first[grid.count()] = count;
  slots.voxel.resize(count);
  slots.region.resize(count);
  slots.ruler.resize(count);
  slots.moments.resize(count);
  for (std::size_t v = 0; v < grid.count(); ++v) {
    std::uint32_t s = slots.first[v];
    const auto add = [&](std::int32_t region, std::int32_t ruler) {
      slots.voxel[s] = static_cast<std::uint32_t>(v), slots.region[s] = region, slots.ruler[s] = ruler;
      ++s;
    };
    if (only.empty() || only[v]) {
      for (std::uint32_t k = candidates.first[v]; k < candidates.first[v + 1]; ++k) add(candidates.regions[k], candidates.regions[k]);
      add(-1, -1);
    } else {
      for (std::uint32_t k = before->first[v]; k < before->first[v + 1]; ++k) {
        add(before->region[k], before->ruler[k] < 0 ? -1 : static_cast<std::int32_t>(planes) + before->ruler[k]);
      }
    }
  }
  return slots;
}

class Assigner {
 public:
  Assigner(const Cloud& cloud, const VoxelGrid& grid, const VoxelPoints& voxels, const Candidates& candidates, const std::vector<PlaneFit>& planes, const AssignRule& rule,
           Slots& slots, const Slots* before, std::vector<std::uint32_t>& slot_of_point)
      : cloud_(cloud), grid_(grid), voxels_(voxels), candidates_(candidates), planes_(planes), rule_(rule), slots_(slots), before_(before), slot_of_point_(slot_of_point),
        step_(grid.size / kFixedSteps) {}

  void run(int threads) {
    if (voxels_.sorted.first.empty()) {
      by_points(threads);
    } else {
      parallel_pieces(grid_.count(), 2048, threads, [&](std::size_t begin, std::size_t end) { by_voxels(begin, end); });
    }
  }

 private:
  [[nodiscard]] bool stays(std::size_t v) const { return before_ != nullptr && !rule_.only[v]; }

  [[nodiscard]] Ruler ruler_of(std::uint32_t slot, const Eigen::Vector3d& corner) const {
    const std::int32_t r = slots_.region[slot];
    const std::uint32_t v = slots_.voxel[slot];
    const float handicap = candidates_.handicap.empty() ? 0.0F : candidates_.handicap[candidates_.first[v] + (slot - slots_.first[v])];
    return make_ruler(planes_[r], corner, step_, rule_.unit[r], rule_.reach[r], handicap);
  }

  /// Which of a voxel's slots, the first of which is `first`, has a point; `rulers` are those of all but the last one.
  [[nodiscard]] std::uint32_t choose(std::span<const Ruler> rulers, std::uint32_t first, float x, float y, float z) const {
    const auto none = static_cast<std::uint32_t>(rulers.size());
    std::uint32_t owner = none;
    float best = 0;
    const bool weighed = !candidates_.handicap.empty();
    for (std::uint32_t k = 0; k < none; ++k) {
      const float d = rulers[k].distance(x, y, z);
      if (!(d < rulers[k].reach)) continue;
      const float cost = weighed ? 0.5F * d * d + rulers[k].handicap : d;
      if (owner != none) {
        if (cost >= best) continue;
        // A smaller plane almost parallel to a larger one gets what the larger one clearly does not explain.
        if (rule_.larger_first && best < kExplained && parallel(planes_[slots_.region[first + k]], planes_[slots_.region[first + owner]])) continue;
      }
      best = cost, owner = k;
    }
    return owner;
  }

  void keep_moments(std::size_t v) {
    for (std::uint32_t k = 0; k < slots_.first[v + 1] - slots_.first[v]; ++k) slots_.moments[slots_.first[v] + k] = before_->moments[before_->first[v] + k];
  }

  void by_voxels(std::size_t begin, std::size_t end);
  void by_points(int threads);
  void take_points(std::span<const Ruler> rulers, std::size_t begin, std::size_t end, std::vector<FixedMoments>& sums) const;

  const Cloud& cloud_;
  const VoxelGrid& grid_;
  const VoxelPoints& voxels_;
  const Candidates& candidates_;
  const std::vector<PlaneFit>& planes_;
  const AssignRule& rule_;
  Slots& slots_;
  const Slots* before_;
  std::vector<std::uint32_t>& slot_of_point_;
  double step_;  ///< metres
};

/// Sorted points are taken voxel by voxel: rulers and sums of one voxel are all there is at a time. The first slot of a voxel mostly
/// holds most of its points: it is found as what the others leave.
void Assigner::by_voxels(std::size_t begin, std::size_t end) {
  const PointsByVoxel& sorted = voxels_.sorted;
  std::vector<Ruler> rulers;
  std::vector<FixedMoments> sums;
  for (std::size_t v = begin; v < end; ++v) {
    const std::uint32_t first = slots_.first[v];
    if (stays(v)) {
      keep_moments(v);
      const std::uint32_t moved = first - before_->first[v];
      for (std::uint32_t k = sorted.first[v]; moved != 0 && k < sorted.first[v + 1]; ++k) slot_of_point_[sorted.point[k]] += moved;
      continue;
    }
    const Eigen::Vector3d corner = grid_.corner(v);
    const std::uint32_t none = slots_.first[v + 1] - 1 - first;
    rulers.clear();
    for (std::uint32_t k = 0; k < none; ++k) rulers.push_back(ruler_of(first + k, corner));
    if (none == 1) {  // most voxels
      const Ruler ruler = rulers.front();
      FixedMoments left;
      for (std::uint32_t k = sorted.first[v]; k < sorted.first[v + 1]; ++k) {
        const auto [x, y, z] = sorted.at[k];
        const bool held = ruler.distance(x, y, z) < ruler.reach;
        slot_of_point_[sorted.point[k]] = held ? first : first + 1;
        if (!held) left.add(x, y, z);
      }
      slots_.moments[first + 1] = to_moments(left, corner, step_);
      FixedMoments own = voxels_.fixed[v];
      own -= left;
      slots_.moments[first] = to_moments(own, corner, step_);
      continue;
    }
    sums.assign(none + 1, FixedMoments());
    for (std::uint32_t k = sorted.first[v]; k < sorted.first[v + 1]; ++k) {
      const auto [x, y, z] = sorted.at[k];
      const std::uint32_t s = choose(rulers, first, x, y, z);
      slot_of_point_[sorted.point[k]] = first + s;
      if (s != 0) sums[s].add(x, y, z);
    }
    sums[0] = voxels_.fixed[v];
    for (std::uint32_t k = 1; k <= none; ++k) {
      sums[0] -= sums[k];
      slots_.moments[first + k] = to_moments(sums[k], corner, step_);
    }
    slots_.moments[first] = to_moments(sums[0], corner, step_);
  }
}

void Assigner::take_points(std::span<const Ruler> rulers, std::size_t begin, std::size_t end, std::vector<FixedMoments>& sums) const {
  const FixedScale scale(grid_.size);
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t v = voxels_.of_point[i];
    if (v == kNoVoxel) {
      slot_of_point_[i] = kNoVoxel;
      continue;
    }
    const std::uint32_t first = slots_.first[v], none = slots_.first[v + 1] - 1;
    if (stays(v)) {
      slot_of_point_[i] = first + (slot_of_point_[i] - before_->first[v]);
      continue;
    }
    if (first == none) {
      slot_of_point_[i] = none;
      continue;
    }
    const auto [x, y, z] = scale.within_voxel(cloud_.x[i], cloud_.y[i], cloud_.z[i]);
    const std::uint32_t s = first + choose(rulers.subspan(first, none - first), first, static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    slot_of_point_[i] = s;
    if (s != first) sums[s].add(x, y, z);
  }
}

/// Points in the order of the cloud, each thread with sums of its own.
void Assigner::by_points(int threads) {
  std::vector<Ruler> rulers(slots_.count());
  parallel_pieces(slots_.count(), 8192, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      if (slots_.region[s] >= 0 && !stays(slots_.voxel[s])) rulers[s] = ruler_of(static_cast<std::uint32_t>(s), grid_.corner(slots_.voxel[s]));
    }
  });
  constexpr std::size_t kSmallest = 1 << 15;
  const std::size_t pieces = std::clamp<std::size_t>(cloud_.size() / kSmallest, 1, static_cast<std::size_t>(std::max(1, threads)));
  const std::size_t length = (cloud_.size() + pieces - 1) / pieces;
  std::vector<std::vector<FixedMoments>> sums(pieces);
  parallel_pieces(pieces, 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      sums[p].resize(slots_.count());
      take_points(rulers, std::min(cloud_.size(), p * length), std::min(cloud_.size(), (p + 1) * length), sums[p]);
    }
  });
  parallel_pieces(grid_.count(), 2048, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (stays(v)) {
        keep_moments(v);
        continue;
      }
      const Eigen::Vector3d corner = grid_.corner(v);
      FixedMoments left = voxels_.fixed[v];
      for (std::uint32_t s = slots_.first[v] + 1; s < slots_.first[v + 1]; ++s) {
        FixedMoments own;
        for (const auto& part : sums) own += part[s];
        left -= own;
        slots_.moments[s] = to_moments(own, corner, step_);
      }
      slots_.moments[slots_.first[v]] = to_moments(left, corner, step_);
    }
  });
}

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
  Assigner(cloud, grid, voxels, candidates, planes, rule, slots, before, slot_of_point).run(threads);
  return slots;
}

}  // namespace scenelore::perception
