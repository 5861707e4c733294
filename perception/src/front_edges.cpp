#include "front_edges.hpp"

#include <algorithm>
#include <cmath>

#include "face_and_sides.hpp"
#include "promises.hpp"
#include "scenelore/perception/parallel.hpp"
#include "seen_from.hpp"

namespace scenelore::perception {
namespace {

constexpr double kSlant = 0.7;       // cosine of 45 degrees, between ray and normal
constexpr std::size_t kFewest = 40;  // points
constexpr double kFace = 0.4;        // of a region's points, at least
constexpr double kWorthIt = 0.03;    // of the points, at least

/// Those points of a region that are rather not of its face.
std::vector<std::uint32_t> beside_face(const Cloud& cloud, const PlaneFit& plane, double noise, const std::vector<std::uint32_t>& members) {
  const FaceAndSides told(cloud, plane, plane, noise, 1, members);
  if (told.share() < kFace) return {};
  std::vector<std::uint32_t> out;
  for (std::size_t k = 0; k < told.size(); ++k) {
    if (told.at_front(k) && told.of_face(k) < 0.5) out.push_back(members[k]);
  }
  return static_cast<double>(out.size()) < kWorthIt * static_cast<double>(members.size()) ? std::vector<std::uint32_t>{} : out;
}

/// The points of each region that is small enough to be looked at; most points of a room are of large ones.
std::vector<std::vector<std::uint32_t>> points_of_small(const SlotOfPoint& slot_of_point, const Slots& slots, const std::vector<PlaneFit>& planes) {
  std::vector<std::int32_t> small = slots.region;
  for (std::int32_t& r : small) {
    if (r >= 0 && planes[r].spread_area() > kLargePlane) r = -1;
  }
  return points_of_sets(slots, slot_of_point, small, planes.size());
}

/// Points that the voxels of each region hold, and those of them that are the region's.
struct Held {
  double own = 0, all = 0;
};

std::vector<Held> held_by_regions(const Slots& slots, const std::vector<double>& of_voxel, std::size_t regions) {
  std::vector<Held> out(regions);
  for (std::size_t s = 0; s < slots.count(); ++s) {
    if (slots.region[s] < 0 || slots.moments[s].n <= 0) continue;
    Held& held = out[static_cast<std::size_t>(slots.region[s])];
    held.own += slots.moments[s].n;
    held.all += of_voxel[slots.voxel[s]];
  }
  return out;
}

void move_to_none(const Eigen::Vector3d& point, std::int32_t& slot, Slots& slots) {
  Moments own;
  own.add(point);
  Moments& left = slots.moments[slot];
  left -= own;
  if (left.n <= 0) left = {};  // points count in whole steps there, which leaves micrometres
  slot = static_cast<std::int32_t>(slots.first[slots.voxel[slot] + 1] - 1);
  slots.moments[slot] += own;
}

}  // namespace

void free_front_edges(const Cloud& cloud, double noise, int threads, SlotOfPoint& slot_of_point, Slots& slots, std::vector<PlaneFit>& planes) {
  if (!cloud.sensors.known()) return;
  const auto members = points_of_small(slot_of_point, slots, planes);
  std::vector<std::vector<std::uint32_t>> freed(members.size());
  parallel_pieces(members.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      if (members[r].size() < kFewest) continue;
      if (slant_of(cloud, planes[r].normal, members[r]).value_or(1) > kSlant) continue;
      freed[r] = beside_face(cloud, planes[r], noise, members[r]);
    }
  });
  std::vector<double> of_voxel(slots.first.size(), 0);
  for (std::size_t s = 0; s < slots.count(); ++s) of_voxel[slots.voxel[s]] += slots.moments[s].n;
  const std::vector<Held> held = held_by_regions(slots, of_voxel, planes.size());
  for (std::size_t r = 0; r < freed.size(); ++r) {
    // Its promises are yet to be kept: what holds too little of its voxels is dropped.
    if (held[r].own - static_cast<double>(freed[r].size()) < kOwnShare * held[r].all) continue;
    for (const std::uint32_t i : freed[r]) move_to_none(cloud.offset(i).cast<double>(), slot_of_point[i], slots);
  }
  refit(slots, planes);
}

}  // namespace scenelore::perception
