#include "assign.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "scenelore/perception/memory.hpp"
#include "scenelore/perception/parallel.hpp"
#include "slot_layout.hpp"

namespace scenelore::perception {
namespace {

constexpr double kExplained = 0.8;  // of the tolerance
constexpr std::size_t kVoxels = 2048;  // that a thread takes at a time

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

/// The choice between the slots of one voxel.
class Chooser {
 public:
  Chooser(const VoxelGrid& grid, const Candidates& candidates, const std::vector<PlaneFit>& planes, const AssignRule& rule, const Slots& slots)
      : grid_(grid), candidates_(candidates), planes_(planes), rule_(rule), slots_(slots), step_(grid.size / kFixedSteps) {}

  /// Metres a step.
  [[nodiscard]] double step() const { return step_; }

  /// Of a slot of a plane. `corner`: of its voxel.
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

 private:
  const VoxelGrid& grid_;
  const Candidates& candidates_;
  const std::vector<PlaneFit>& planes_;
  const AssignRule& rule_;
  const Slots& slots_;
  double step_;
};

/// Sorted points are taken voxel by voxel: rulers and sums of one voxel are all there is at a time.
class ByVoxels {
 public:
  ByVoxels(const PointsByVoxel& points, const VoxelGrid& grid, const Chooser& chooser, SlotOfPoint& slot_of_point, Slots& slots)
      : points_(points), grid_(grid), chooser_(chooser), slot_of_point_(slot_of_point), slots_(slots) {}

  void assign(std::size_t v);

 private:
  const PointsByVoxel& points_;
  const VoxelGrid& grid_;
  const Chooser& chooser_;
  SlotOfPoint& slot_of_point_;
  Slots& slots_;
  std::vector<Ruler> rulers_;
  std::vector<FixedMoments> sums_;
};

void ByVoxels::assign(std::size_t v) {
  const Eigen::Vector3d corner = grid_.corner(v);
  const std::uint32_t first = slots_.first[v], none = slots_.first[v + 1] - 1 - first;
  rulers_.clear();
  for (std::uint32_t k = 0; k < none; ++k) rulers_.push_back(chooser_.ruler_of(first + k, corner));
  sums_.assign(none + 1, FixedMoments());
  for (std::uint32_t k = points_.first[v]; k < points_.first[v + 1]; ++k) {
    const auto [x, y, z] = points_.at[k];
    // Most voxels have one candidate.
    const std::uint32_t s = none == 1 ? (rulers_[0].distance(x, y, z) < rulers_[0].reach ? 0 : 1) : chooser_.choose(rulers_, first, x, y, z);
    slot_of_point_[points_.point[k]] = static_cast<std::int32_t>(first + s);
    sums_[s].add(x, y, z);
  }
  for (std::uint32_t k = 0; k <= none; ++k) slots_.moments[first + k] = to_moments(sums_[k], corner, chooser_.step());
}

/// Sums of which a run of points, which is somewhere in the room, touches a part: pages of them, made when first asked for.
class PagedSums {
 public:
  explicit PagedSums(std::size_t count = 0) : pages_(count / kPage + 1) {}

  FixedMoments& operator[](std::size_t k) {
    std::vector<FixedMoments>& page = pages_[k / kPage];
    if (page.empty()) page.resize(kPage);
    return page[k % kPage];
  }
  void add_to(FixedMoments& sum, std::size_t k) const {
    if (const std::vector<FixedMoments>& page = pages_[k / kPage]; !page.empty()) sum += page[k % kPage];
  }

 private:
  static constexpr std::size_t kPage = 1024;
  std::vector<std::vector<FixedMoments>> pages_;
};

/// Points in the order of the cloud, each thread with sums of its own. A voxel's first slot mostly holds most of its points: it is found as
/// what the others leave, and has no sums; slot s of voxel v has number s − v − 1 among the others.
class ByPoints {
 public:
  ByPoints(const Cloud& cloud, const VoxelisedCloud& voxels, const Chooser& chooser, SlotOfPoint& slot_of_point, Slots& slots)
      : cloud_(cloud), voxels_(voxels), chooser_(chooser), slot_of_point_(slot_of_point), slots_(slots) {}

  void run(int threads);

 private:
  [[nodiscard]] std::vector<Ruler> rulers(int threads) const;
  void take(std::span<const Ruler> rulers, std::size_t begin, std::size_t end, PagedSums& sums) const;
  void set_moments(const std::vector<PagedSums>& sums, int threads);

  const Cloud& cloud_;
  const VoxelisedCloud& voxels_;
  const Chooser& chooser_;
  SlotOfPoint& slot_of_point_;
  Slots& slots_;
};

void ByPoints::take(std::span<const Ruler> rulers, std::size_t begin, std::size_t end, PagedSums& sums) const {
  PointLocator locator(voxels_.grid);
  for (std::size_t i = begin; i < end; ++i) {
    FixedPlace at;
    const std::uint32_t v = locator.locate(cloud_.x[i], cloud_.y[i], cloud_.z[i], at);
    if (v == kNoVoxel) {
      slot_of_point_[i] = -1;
      continue;
    }
    const std::uint32_t first = slots_.first[v], none = slots_.first[v + 1] - 1;
    if (first == none) {
      slot_of_point_[i] = static_cast<std::int32_t>(none);
      continue;
    }
    const auto [x, y, z] = at.within;
    const std::uint32_t s = first + chooser_.choose(rulers.subspan(first, none - first), first, static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    slot_of_point_[i] = static_cast<std::int32_t>(s);
    if (s != first) sums[s - v - 1].add(x, y, z);
  }
}

std::vector<Ruler> ByPoints::rulers(int threads) const {
  std::vector<Ruler> rulers(slots_.count());
  parallel_pieces(slots_.count(), 8192, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      if (slots_.region[s] >= 0) rulers[s] = chooser_.ruler_of(static_cast<std::uint32_t>(s), voxels_.grid.corner(slots_.voxel[s]));
    }
  });
  return rulers;
}

void ByPoints::run(int threads) {
  constexpr std::size_t kSmallest = 1 << 15;
  const std::size_t pieces = std::clamp<std::size_t>(cloud_.size() / kSmallest, 1, static_cast<std::size_t>(std::max(1, threads)));
  const std::size_t length = (cloud_.size() + pieces - 1) / pieces;
  std::vector<PagedSums> sums(pieces);
  std::vector<Ruler> all = rulers(threads);
  parallel_pieces(pieces, 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      sums[p] = PagedSums(slots_.count() - voxels_.grid.count());
      take(all, std::min(cloud_.size(), p * length), std::min(cloud_.size(), (p + 1) * length), sums[p]);
    }
  });
  release(all);
  set_moments(sums, threads);
}

void ByPoints::set_moments(const std::vector<PagedSums>& sums, int threads) {
  const VoxelGrid& grid = voxels_.grid;
  slots_.moments.resize(slots_.count());
  parallel_pieces(grid.count(), 2048, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Eigen::Vector3d corner = grid.corner(v);
      FixedMoments left = voxels_.fixed[v];
      for (std::uint32_t s = slots_.first[v] + 1; s < slots_.first[v + 1]; ++s) {
        FixedMoments own;
        for (const PagedSums& part : sums) part.add_to(own, s - v - 1);
        left -= own;
        slots_.moments[s] = to_moments(own, corner, chooser_.step());
      }
      slots_.moments[slots_.first[v]] = to_moments(left, corner, chooser_.step());
    }
  });
}

}  // namespace

Slots assign_points(const Cloud& cloud, const VoxelisedCloud& voxels, const Candidates& candidates, const std::vector<PlaneFit>& planes,
                    const AssignRule& rule, int threads, SlotOfPoint& slot_of_point) {
  slot_of_point.resize(cloud.size());
  Slots slots = slots_for(voxels.grid, candidates);
  slots.rulers.assign(planes.begin(), planes.end());
  slots.reach = rule.reach;
  const Chooser chooser(voxels.grid, candidates, planes, rule, slots);
  ByPoints(cloud, voxels, chooser, slot_of_point, slots).run(threads);
  return slots;
}

Slots assign_points(const PointsByVoxel& points, const VoxelGrid& grid, const Candidates& candidates, const std::vector<PlaneFit>& planes,
                    const AssignRule& rule, int threads, SlotOfPoint& slot_of_point) {
  Slots slots = slots_for(grid, candidates);
  slots.rulers.assign(planes.begin(), planes.end());
  slots.reach = rule.reach;
  slots.moments.resize(slots.count());
  slot_of_point.resize(points.point.size());
  const Chooser chooser(grid, candidates, planes, rule, slots);
  parallel_pieces(grid.count(), kVoxels, threads, [&](std::size_t begin, std::size_t end) {
    ByVoxels work(points, grid, chooser, slot_of_point, slots);
    for (std::size_t v = begin; v < end; ++v) work.assign(v);
  });
  return slots;
}

void assign_anew(const PointsByVoxel& points, const VoxelGrid& grid, const std::vector<bool>& anew, const Candidates& candidates,
                 const std::vector<PlaneFit>& planes, const AssignRule& rule, int threads, SlotOfPoint& slot_of_point, Slots& slots) {
  const std::vector<std::uint32_t> before = lay_out_anew(anew, candidates, slots);
  slots.rulers.insert(slots.rulers.end(), planes.begin(), planes.end());
  slots.reach.insert(slots.reach.end(), rule.reach.begin(), rule.reach.end());
  const Chooser chooser(grid, candidates, planes, rule, slots);
  parallel_pieces(grid.count(), kVoxels, threads, [&](std::size_t begin, std::size_t end) {
    ByVoxels work(points, grid, chooser, slot_of_point, slots);
    for (std::size_t v = begin; v < end; ++v) {
      if (anew[v]) {
        work.assign(v);
      } else if (const auto moved = static_cast<std::int32_t>(slots.first[v] - before[v]); moved != 0) {
        for (std::uint32_t k = points.first[v]; k < points.first[v + 1]; ++k) slot_of_point[points.point[k]] += moved;
      }
    }
  });
}

}  // namespace scenelore::perception
