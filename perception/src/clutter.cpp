#include "clutter.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "curvature.hpp"

namespace scenelore::perception {
namespace {

constexpr double kFlatterThan = 0.997;   // cosine of 4.5 degrees: neighbours this parallel are layers, not facets
constexpr double kSteeperThan = 0.64;    // cosine of 50 degrees: an edge
constexpr double kStep = 0.4;            // voxels, 2 cm
constexpr double kLargestBent = 2.0;     // m²
constexpr double kLargestFacet = 0.35;   // m²
constexpr double kContact = 0.2;         // share of a region's border cells that must continue into the neighbour

struct Judge {
  const VoxelGrid& grid;
  const Slots& slots;
  const std::vector<PlaneFit>& planes;

  /// Slots of regions small enough to be bent, as heights over their planes.
  std::vector<bool> bent() const {
    std::vector<std::vector<HeightSample>> samples(planes.size());
    for (std::size_t s = 0; s < slots.count(); ++s) {
      const std::int32_t r = slots.region[s];
      if (r < 0 || slots.moments[s].n <= 0 || planes[r].spread_area() > kLargestBent) continue;
      const Eigen::Vector3d d = planes[r].axes.transpose() * (slots.moments[s].mean() - planes[r].centroid);
      samples[r].push_back({d[1], d[2], d[0], slots.moments[s].n});
    }
    std::vector<bool> result(planes.size());
    for (std::size_t r = 0; r < planes.size(); ++r) result[r] = is_curved(samples[r], planes[r]);
    return result;
  }

  /// For each pair of regions with a slope between them, in how many voxels of the first one the second one goes on.
  std::map<std::pair<std::int32_t, std::int32_t>, int> contacts(std::vector<int>& border) const {
    std::map<std::pair<std::int32_t, std::int32_t>, int> result;
    border.assign(planes.size(), 0);
    std::vector<std::int32_t> owner(grid.count(), -1);
    std::vector<Eigen::Vector3d> middle(grid.count(), Eigen::Vector3d::Zero());  // of the owner's points in the voxel
    for (std::size_t v = 0; v < grid.count(); ++v) {
      double most = 0;
      for (std::uint32_t s = slots.first[v]; s < slots.first[v + 1]; ++s) {
        if (slots.moments[s].n > most) most = slots.moments[s].n, owner[v] = slots.region[s], middle[v] = slots.moments[s].mean();
      }
    }
    std::vector<std::int32_t> others;
    for (std::size_t v = 0; v < grid.count(); ++v) {
      if (owner[v] < 0) continue;
      const PlaneFit& plane = planes[owner[v]];
      others.clear();
      int own = 0;
      for (const std::int32_t n : grid.neighbours[v]) {
        if (n < 0) continue;
        const std::int32_t other = owner[n];
        if (other == owner[v]) ++own;
        if (other < 0 || other == owner[v] || std::find(others.begin(), others.end(), other) != others.end()) continue;
        // Going on means: where the neighbour begins, this plane has not ended yet. A screen before a wall does not.
        if (std::abs(plane.distance(middle[n])) < kStep * grid.size) others.push_back(other);
      }
      if (own < 8) ++border[owner[v]];  // not surrounded by its own region
      for (const std::int32_t other : others) {
        const double cosine = std::abs(plane.normal.dot(planes[other].normal));
        if (cosine > kSteeperThan && cosine < kFlatterThan) ++result[{owner[v], other}];
      }
    }
    return result;
  }
};

}  // namespace

void drop_clutter(const VoxelGrid& grid, Slots& slots, std::vector<PlaneFit>& planes) {
  const Judge judge{grid, slots, planes};
  const std::size_t count = planes.size();
  std::vector<bool> dropped = judge.bent();
  std::vector<int> border;
  const auto contacts = judge.contacts(border);
  for (const auto& [pair, voxels_in_contact] : contacts) {
    const auto [r, other] = pair;
    // The largest facet stays, as the best plane that can be given; large planes do not become doubtful by their neighbours.
    if (planes[r].spread_area() > kLargestFacet || planes[r].count > planes[other].count) continue;
    if (voxels_in_contact > kContact * border[r]) dropped[r] = true;
  }
  for (std::int32_t& r : slots.region) {
    if (r >= 0 && dropped[r]) r = -1;
  }
  for (std::size_t r = 0; r < count; ++r) {
    if (dropped[r]) planes[r] = PlaneFit();
  }
}

}  // namespace scenelore::perception
