#include "promises.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "assign.hpp"
#include "cell_index.hpp"
#include "connect.hpp"
#include "scenelore/perception/parallel.hpp"
#include "voxel_parts.hpp"

namespace scenelore::perception {
namespace {

/// A plane of the result: whole slots of a region, or points where slots were not enough.
struct Part {
  std::vector<std::uint32_t> slots, points;
  PlaneFit plane;
  bool bridged = false;
  std::vector<std::uint32_t> sampled;
};

/// Leaves the points within the tolerance of the plane; true when that were all.
bool trim(const Cloud& cloud, const PlaneFit& plane, double limit, std::vector<std::uint32_t>& points) {
  const std::size_t before = points.size();
  std::erase_if(points, [&](std::uint32_t i) { return !(std::abs(plane.distance(cloud.offset(i).cast<double>())) <= limit); });
  return points.size() == before;
}

constexpr double kNarrowest = 0.08;  // metres; rims of boards are no planes of their own
constexpr double kThinnest = 0.12;   // rmse over width
constexpr double kFilled = 0.3;      // share of the rectangle of its spread that a plane must fill; a desk in the shadow of its screens fills little

double step_of(const PlaneFit& plane, bool bridged, const Limits& limits) {
  return plane.spread_area() < kLargePlane && !bridged ? limits.small_plane_step : limits.max_point_distance;
}

/// Legs, frames and leftovers: sets of points that are flat, but no surface. Measured in cells wide enough to hold four
/// points of an evenly seen surface, of which then 98 % are occupied.
bool is_scrap(const Cloud& cloud, std::span<const std::uint32_t> points, const PlaneFit& plane, bool bridged) {
  const double width = std::sqrt(12 * plane.variances[1]), area = plane.spread_area();
  if (width < kNarrowest || plane.rmse() > kThinnest * width) return true;
  if (area > kLargePlane || bridged) return false;
  const double cell = std::max(0.03, 2 * std::sqrt(area / static_cast<double>(points.size())));
  std::vector<CellKey> keys;
  keys.reserve(points.size());
  for (const std::uint32_t i : points) {
    const Eigen::Vector3d d = (plane.axes.transpose() * (cloud.offset(i).cast<double>() - plane.centroid)) / cell;
    keys.push_back(cell_key(static_cast<std::int64_t>(std::floor(d[1])), static_cast<std::int64_t>(std::floor(d[2])), 0));
  }
  return static_cast<double>(CellIndex(keys).size()) * cell * cell < kFilled * area;
}

/// Works off a stack of candidate sets of points; each step only ever removes or separates points, so it ends.
std::vector<Part> settle_points(const Cloud& cloud, const Limits& limits, bool bridged, std::vector<std::uint32_t> first) {
  std::vector<Part> done;
  std::vector<std::vector<std::uint32_t>> open;
  open.push_back(std::move(first));
  while (!open.empty()) {
    std::vector<std::uint32_t> points = std::move(open.back());
    open.pop_back();
    if (static_cast<double>(points.size()) < limits.min_points) continue;
    const PlaneFit plane = fit_plane(moments_of(cloud, points));
    double reach = tolerance(plane, limits);
    // Trimming at two deviations of what is allowed brings the mean squared error down.
    if (plane.variances[0] > limits.max_mse) reach = std::min({reach, 2 * std::sqrt(limits.max_mse), 2.5 * plane.rmse()});
    if (!trim(cloud, plane, reach, points)) {
      open.push_back(std::move(points));
      continue;
    }
    if (plane.variances[0] > limits.max_mse) continue;
    auto parts = connected_parts(cloud, points, plane, step_of(plane, bridged, limits), limits.max_neighbours);
    if (parts.size() == 1 && parts.front().size() == points.size()) {
      if (!is_scrap(cloud, points, plane, bridged)) done.push_back({{}, std::move(points), plane, bridged, {}});
    } else {
      for (auto& part : parts) open.push_back(std::move(part));
    }
  }
  return done;
}

constexpr double kExactness = 1e-3;  // slots prove a limit when they keep this share of it free, far beyond rounding

/// Whether no point of the slots can be further from the plane than allowed: they were measured with another plane, from
/// which this one differs by so much at the corners of their voxels.
bool surely_within(const VoxelGrid& grid, const Slots& slots, std::span<const std::uint32_t> members, const PlaneFit& plane, double limit) {
  for (const std::uint32_t s : members) {
    if (slots.ruler[s] < 0) return false;
    const PlaneEquation& ruler = slots.rulers[slots.ruler[s]];
    const double sign = ruler.normal.dot(plane.normal) < 0 ? -1 : 1;
    const Eigen::Vector3d turned = plane.normal - sign * ruler.normal, center = grid.center(slots.voxel[s]);
    const double moved = std::abs(plane.distance(center) - sign * ruler.distance(center)) + grid.size / 2 * turned.cwiseAbs().sum();
    if (slots.reach[slots.ruler[s]] + moved > limit) return false;
  }
  return true;
}

/// The work on one region.
struct Settling {
  std::vector<Part> parts;                             // of whole slots
  std::vector<std::vector<std::uint32_t>> to_points;   // sets of slots whose points must be looked at
};

/// Slots whose points must be looked at.
struct Unsettled {
  std::vector<std::uint32_t> slots;
  bool bridged;
};

Moments moments_of(const Slots& slots, std::span<const std::uint32_t> members) {
  Moments m;
  for (const std::uint32_t s : members) m += slots.moments[s];
  return m;
}

/// Connected parts of a set of slots of one region, each with enough points, and by the step that its own size asks for.
/// A part for which steps are too short to tell anything about voxels comes back whole, with `open` set.
struct Group {
  std::vector<std::uint32_t> members;
  PlaneFit plane;
  bool open = false;
};

std::vector<Group> groups_of(const VoxelGrid& grid, const Slots& slots, const Limits& limits, bool bridged, std::vector<std::uint32_t> first,
                             std::vector<std::uint32_t>& place) {
  std::vector<Group> done;
  std::vector<std::pair<std::vector<std::uint32_t>, double>> waiting;  // with the step that connects them
  waiting.emplace_back(std::move(first), 0.0);
  while (!waiting.empty()) {
    auto [members, connected_by] = std::move(waiting.back());
    waiting.pop_back();
    const PlaneFit plane = fit_plane(moments_of(slots, members));
    if (plane.count < limits.min_points) continue;
    const double step = step_of(plane, bridged, limits);
    const bool open = step < kShortestStepVoxels * grid.size;
    if (open || (connected_by > 0 && connected_by <= step)) {
      done.push_back({std::move(members), plane, open});
      continue;
    }
    for (std::vector<std::uint32_t>& part : connected_slots(grid, slots, members, step, place)) waiting.emplace_back(std::move(part), step);
  }
  return done;
}

/// Share of the points of its voxels that a set of slots holds: what is left over between the points of another plane has
/// little.
double share_of_voxels(const VoxelisedCloud& voxels, const Slots& slots, std::span<const std::uint32_t> members) {
  double own = 0, all = 0;
  for (const std::uint32_t s : members) {
    own += slots.moments[s].n;
    all += static_cast<double>(voxels.fixed[slots.voxel[s]].n);
  }
  return own / all;
}

Settling settle_slots(const VoxelisedCloud& voxels, const Slots& slots, const Limits& limits, bool bridged, std::vector<std::uint32_t> members,
                      std::vector<std::uint32_t>& place) {
  Settling result;
  for (Group& group : groups_of(voxels.grid, slots, limits, bridged, std::move(members), place)) {
    if (share_of_voxels(voxels, slots, group.members) < kOwnShare) continue;
    const bool kept = !group.open && group.plane.variances[0] <= limits.max_mse * (1 - kExactness) &&
                      surely_within(voxels.grid, slots, group.members, group.plane, limits.max_plane_distance * (1 - kExactness));
    if (kept) {
      result.parts.push_back({std::move(group.members), {}, group.plane, bridged, {}});
    } else {
      result.to_points.push_back(std::move(group.members));
    }
  }
  return result;
}

/// Settles by points what slots could not: one pass collects the points of all of them.
std::vector<Part> settle_rest(const Cloud& cloud, const Limits& limits, const std::vector<Unsettled>& sets, const Slots& slots,
                              const SlotOfPoint& slot_of_point, int threads) {
  std::vector<Part> result;
  if (sets.empty()) return result;
  std::vector<std::int32_t> set_of_slot(slots.count(), -1);
  for (std::size_t k = 0; k < sets.size(); ++k) {
    for (const std::uint32_t s : sets[k].slots) set_of_slot[s] = static_cast<std::int32_t>(k);
  }
  std::vector<std::vector<std::uint32_t>> points = points_of_sets(slots, slot_of_point, set_of_slot, sets.size());
  std::vector<std::vector<Part>> settled(sets.size());
  parallel_pieces(sets.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) settled[k] = settle_points(cloud, limits, sets[k].bridged, std::move(points[k]));
  });
  for (auto& some : settled) std::move(some.begin(), some.end(), std::back_inserter(result));
  return result;
}

}  // namespace

void separate_parts(const PointSample& sample, const VoxelGrid& grid, const Limits& limits, int threads,
                    SlotOfPoint& slot_of_point, Slots& slots, std::vector<PlaneFit>& planes, std::vector<bool>& bridged) {
  bridged.resize(planes.size(), false);
  std::vector<std::vector<std::uint32_t>> members = slots_of_regions(slots, planes.size());
  std::vector<std::vector<Group>> groups(planes.size());
  std::vector<std::uint32_t> place(slots.count());  // every slot is in one region, so that threads do not meet here
  parallel_pieces(planes.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) groups[r] = groups_of(grid, slots, limits, bridged[r], std::move(members[r]), place);
  });
  std::fill(slots.region.begin(), slots.region.end(), -1);
  planes.clear();
  std::vector<bool> anew(grid.count(), false);
  bool moved = false;
  std::vector<bool> whole_bridged;
  for (std::size_t r = 0; r < groups.size(); ++r) {
    for (const Group& group : groups[r]) {
      whole_bridged.push_back(bridged[r]);
      const bool kept = surely_within(grid, slots, group.members, group.plane, limits.max_plane_distance * (1 - kExactness));
      for (const std::uint32_t s : group.members) {
        slots.region[s] = static_cast<std::int32_t>(planes.size());
        if (!kept) anew[slots.voxel[s]] = moved = true;
      }
      planes.push_back(group.plane);
    }
  }
  bridged = std::move(whole_bridged);
  if (!moved) return;
  const std::vector<std::int32_t> region_of_point = regions_of_points(slots, slot_of_point);
  AssignRule rule;
  rule.reach = reaches(sample.cloud, region_of_point, planes, limits, threads);
  rule.unit = scatters(sample.cloud, region_of_point, planes, threads);
  rule.larger_first = false;
  const Candidates candidates = candidates_within(slots, rule.unit);
  assign_anew(sample.by_voxel, grid, anew, candidates, planes, rule, threads, slot_of_point, slots);
  refit(slots, planes);
}

Settled keep_promises(const Cloud& cloud, const VoxelisedCloud& voxels, const PointSample& sample, const Slots& slots, const std::vector<bool>& bridged,
                      const Limits& limits, int threads, SlotOfPoint slot_of_point) {
  const std::size_t regions = bridged.size();
  std::vector<std::vector<std::uint32_t>> members = slots_of_regions(slots, regions);
  std::vector<Settling> settled(regions);
  std::vector<std::uint32_t> place(slots.count());  // every slot is in one region, so that threads do not meet here
  parallel_pieces(regions, 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) settled[r] = settle_slots(voxels, slots, limits, bridged[r], std::move(members[r]), place);
  });
  std::vector<Part> parts;
  std::vector<Unsettled> to_points;
  for (std::size_t r = 0; r < regions; ++r) {
    std::move(settled[r].parts.begin(), settled[r].parts.end(), std::back_inserter(parts));
    for (auto& some : settled[r].to_points) to_points.push_back({std::move(some), bridged[r]});
  }
  // Points in the sample of each part of whole slots tell whether it is filled.
  std::vector<std::int32_t> part_of_slot(slots.count(), -1);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const std::uint32_t s : parts[p].slots) part_of_slot[s] = static_cast<std::int32_t>(p);
  }
  for (const std::uint32_t i : sample.points) {
    const std::int32_t p = part_of_slot[slot_of_point[i]];
    if (p >= 0) parts[static_cast<std::size_t>(p)].sampled.push_back(i);
  }
  std::vector<std::uint8_t> scrap(parts.size());
  parallel_pieces(parts.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) scrap[p] = is_scrap(cloud, parts[p].sampled, parts[p].plane, parts[p].bridged) ? 1 : 0;
  });
  for (std::size_t p = parts.size(); p-- > 0;) {
    if (scrap[p] != 0) parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(p));
  }
  for (Part& part : settle_rest(cloud, limits, to_points, slots, slot_of_point, threads)) parts.push_back(std::move(part));

  const auto rank = [](const Part& p) { return std::tuple(-p.plane.count, p.plane.centroid.x(), p.plane.centroid.y(), p.plane.centroid.z()); };
  std::stable_sort(parts.begin(), parts.end(), [&](const Part& a, const Part& b) { return rank(a) < rank(b); });
  Settled result;
  std::fill(part_of_slot.begin(), part_of_slot.end(), -1);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const std::uint32_t s : parts[p].slots) part_of_slot[s] = static_cast<std::int32_t>(p);
    result.regions.planes.push_back(parts[p].plane);
  }
  result.regions.of_point = std::move(slot_of_point);
  parallel_pieces(cloud.size(), 1 << 17, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::int32_t& number = result.regions.of_point[i];  // of its slot, then of its plane
      number = number < 0 ? -1 : part_of_slot[number];
    }
  });
  bool whole = true;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    whole = whole && parts[p].points.empty();
    for (const std::uint32_t i : parts[p].points) result.regions.of_point[i] = static_cast<std::int32_t>(p);
  }
  result.sampled.resize(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) result.sampled[p] = std::move(parts[p].sampled);
  if (!whole) {
    for (const std::uint32_t i : sample.points) {
      const std::int32_t p = result.regions.of_point[i];
      if (p >= 0 && !parts[static_cast<std::size_t>(p)].points.empty()) result.sampled[static_cast<std::size_t>(p)].push_back(i);
    }
  }
  return result;
}

}  // namespace scenelore::perception
