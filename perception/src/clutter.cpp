#include "clutter.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "curvature.hpp"

namespace scenelore::perception {
namespace {

constexpr double kAgreeing = 0.9;        // cosine of 26 degrees
constexpr double kSupport = 0.45;        // share of the judged points whose surroundings must agree
constexpr double kFlatterThan = 0.997;   // cosine of 4.5 degrees: neighbours this parallel are layers, not facets
constexpr double kSteeperThan = 0.64;    // cosine of 50 degrees: an edge
constexpr double kStep = 0.4;            // voxels, 2 cm
constexpr double kContact = 0.2;         // share of a region's border cells that must continue into the neighbour

/// Points whose 15 cm surroundings lie like the region, be they flat or noisy, and all points with surroundings to judge.
struct Support {
  double agreeing = 0, judged = 0;
};

struct Judge {
  const Cloud& cloud;
  const CellIndex& cells;
  const std::vector<LocalSurface>& surfaces;
  double voxel;
  Regions& regions;

  std::vector<Support> support() const {
    std::vector<Support> result(regions.planes.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const LocalSurface& s = surfaces[c];
      if (s.normal.isZero()) continue;  // too few points to say anything
      for (const std::uint32_t i : cells.items(c)) {
        const std::int32_t r = regions.of_point[i];
        if (r < 0) continue;
        result[r].judged += 1;
        if (std::abs(s.normal.dot(regions.planes[r].normal)) > kAgreeing) result[r].agreeing += 1;
      }
    }
    return result;
  }

  bool bent(std::span<const std::uint32_t> points, const PlaneFit& plane) const {
    std::vector<CellKey> keys(points.size());
    std::vector<Eigen::Vector3d> local(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      local[k] = plane.axes.transpose() * (cloud.offset(points[k]).cast<double>() - plane.centroid);
      keys[k] = cell_key(static_cast<std::int64_t>(std::floor(local[k][1] / voxel)), static_cast<std::int64_t>(std::floor(local[k][2] / voxel)), 0);
    }
    const CellIndex patch(keys);
    std::vector<HeightSample> samples(patch.size());
    for (std::size_t c = 0; c < patch.size(); ++c) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const std::uint32_t k : patch.items(c)) sum += local[k];
      const auto n = static_cast<double>(patch.items(c).size());
      samples[c] = {sum[1] / n, sum[2] / n, sum[0] / n, n};
    }
    return is_curved(samples, plane);
  }

  /// For each pair of regions with a slope between them, in how many cells of the first one the second one goes on.
  std::map<std::pair<std::int32_t, std::int32_t>, int> contacts(std::vector<int>& border) const {
    std::map<std::pair<std::int32_t, std::int32_t>, int> result;
    border.assign(regions.planes.size(), 0);
    std::vector<std::int32_t> owner(cells.size(), -1);
    std::vector<Eigen::Vector3d> middle(cells.size(), Eigen::Vector3d::Zero());  // of the owner's points in the cell
    for (std::size_t c = 0; c < cells.size(); ++c) {
      std::vector<std::int32_t> labels;
      for (const std::uint32_t i : cells.items(c)) labels.push_back(regions.of_point[i]);
      std::sort(labels.begin(), labels.end());
      std::ptrdiff_t most = 0;
      for (auto from = labels.begin(); from != labels.end();) {
        const auto to = std::upper_bound(from, labels.end(), *from);
        if (to - from > most) most = to - from, owner[c] = *from;
        from = to;
      }
      for (const std::uint32_t i : cells.items(c)) {
        if (regions.of_point[i] == owner[c]) middle[c] += cloud.offset(i).cast<double>() / static_cast<double>(most);
      }
    }
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (owner[c] < 0) continue;
      std::vector<std::int32_t> others;
      int own = 0;
      for (int d = 0; d < 27; ++d) {
        const std::int32_t n = cells.find(moved(cells.key(c), d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1));
        if (n < 0) continue;
        const std::int32_t other = owner[n];
        if (other == owner[c]) ++own;
        if (other < 0 || other == owner[c] || std::find(others.begin(), others.end(), other) != others.end()) continue;
        // Going on means: where the neighbour begins, this plane has not ended yet. A screen before a wall does not.
        if (std::abs(regions.planes[owner[c]].distance(middle[n])) < kStep * voxel) others.push_back(other);
      }
      if (own < 8) ++border[owner[c]];  // not surrounded by its own region
      for (const std::int32_t other : others) {
        const double cosine = std::abs(regions.planes[owner[c]].normal.dot(regions.planes[other].normal));
        if (cosine > kSteeperThan && cosine < kFlatterThan) ++result[{owner[c], other}];
      }
    }
    return result;
  }
};

}  // namespace

void drop_clutter(const Cloud& cloud, const CellIndex& cells, const std::vector<LocalSurface>& surfaces, double voxel, Regions& regions) {
  const Judge judge{cloud, cells, surfaces, voxel, regions};
  const std::size_t count = regions.planes.size();
  const std::vector<Support> support = judge.support();
  const auto points = points_of_regions(regions.of_point, count);
  std::vector<bool> dropped(count, false);
  for (std::size_t r = 0; r < count; ++r) {
    const PlaneFit& plane = regions.planes[r];
    if (plane.count == 0) continue;
    const bool narrow = plane.variances[1] < 9 * plane.variances[0];
    const bool unlike = support[r].judged > 10 && support[r].agreeing < kSupport * support[r].judged;
    dropped[r] = narrow || unlike || (plane.spread_area() < 2.0 && judge.bent(points[r], plane));
  }
  std::vector<int> border;
  const auto contacts = judge.contacts(border);
  for (const auto& [pair, cells_in_contact] : contacts) {
    const auto [r, other] = pair;
    // The largest facet stays, as the best plane that can be given; large planes do not become doubtful by their neighbours.
    if (regions.planes[r].spread_area() > 0.35 || regions.planes[r].count > regions.planes[other].count) continue;
    if (cells_in_contact > kContact * border[r]) dropped[r] = true;
  }
  for (std::int32_t& r : regions.of_point) {
    if (r >= 0 && dropped[r]) r = -1;
  }
  for (std::size_t r = 0; r < count; ++r) {
    if (dropped[r]) regions.planes[r] = PlaneFit();
  }
}

}  // namespace scenelore::perception
