#include "thin_objects.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "cell_index.hpp"

namespace scenelore::perception {
namespace {

constexpr double kSmallestSupport = 0.1;   // m²
constexpr double kLevel = 0.9945;          // cosine of 6 degrees
constexpr double kCell = 0.04;             // metres
constexpr double kHighest = 0.08;          // metres above the support
constexpr double kLowest = 0.009;          // metres; papers and warped boards stay with their support
constexpr double kLowerLevel = 0.3;        // of the points of the main level
constexpr double kCertain = 4.5;           // deviations of a cell's mean
constexpr double kCovering = 0.6;          // mean of all points of a patch's cells in units of its level
constexpr double kSmallestPatch = 0.007;   // m², half a paperback

struct Sample {
  std::uint32_t point;
  Eigen::Vector2d at;  // along the support
  double height;       // over the support, towards the room
};

/// A support with the direction in which things lie on it.
struct Support {
  Eigen::Vector3d normal, centroid;
  Eigen::Vector3d u, v;
  double noise = 0;  // metres, of its own points
  bool level = false;

  [[nodiscard]] Sample sample(const Cloud& cloud, std::uint32_t i) const {
    const Eigen::Vector3d d = cloud.offset(i).cast<double>() - centroid;
    return {i, {u.dot(d), v.dot(d)}, normal.dot(d)};
  }
};

CellKey key_at(const Eigen::Vector2d& p) {
  return cell_key(static_cast<std::int64_t>(std::floor(p.x() / kCell)), static_cast<std::int64_t>(std::floor(p.y() / kCell)), 0);
}

/// The height of the support itself: the middle of the fullest window of 6 mm. With `lowest`, that of the lowest peak with
/// 30 % as many points, where a valley lies between: of two desks that stand side by side the lower one carries.
double main_level(std::vector<double> heights, bool lowest) {
  constexpr double window = 0.006;
  std::sort(heights.begin(), heights.end());
  std::vector<std::size_t> held(heights.size());  // samples in the window that ends at each one
  std::size_t best = 0;
  for (std::size_t from = 0, to = 0; to < heights.size(); ++to) {
    while (heights[to] - heights[from] > window) ++from;
    held[to] = to - from + 1;
    if (held[to] > held[best]) best = to;
  }
  std::size_t peak = 0;
  for (std::size_t to = 0; lowest && to < best; ++to) {
    if (held[to] > held[peak]) peak = to;
    const bool valley = 2 * held[to] < held[peak] && held[peak] >= 20;
    if (valley && static_cast<double>(held[peak]) > kLowerLevel * static_cast<double>(held[best])) return heights[peak] - window / 2;
  }
  return heights[best] - window / 2;
}

/// Scatter below the level, where nothing lies: its mirror image is what the support would scatter without things on it.
/// By the quantile that is one deviation of a Gaussian, which edges and what stands behind hardly move.
double noise_below(const std::vector<Sample>& samples, double level) {
  std::vector<double> below;
  for (const Sample& s : samples) {
    if (s.height < level && s.height > level - 0.05) below.push_back(level - s.height);
  }
  if (below.size() < 5) return 0.003;
  const auto at = below.begin() + static_cast<std::ptrdiff_t>(0.683 * static_cast<double>(below.size()));
  std::nth_element(below.begin(), at, below.end());
  return *at;
}

class Splitter {
 public:
  Splitter(const Cloud& cloud, const Limits& limits, Regions& regions) : cloud_(cloud), limits_(limits), regions_(regions) {}

  /// `samples` are the support's own points and the free ones near it.
  void split(const Support& support, const std::vector<Sample>& samples);

 private:
  void make_region(const CellIndex& cells, const std::vector<Sample>& samples, const std::vector<std::int32_t>& patch, double noise);

  const Cloud& cloud_;
  const Limits& limits_;
  Regions& regions_;
};

struct CellMean {
  double n = 0, sum = 0;
};

/// What does not average out: warped tops, distortion of the camera. Things lie on one side only, so the places below the
/// middle tell how far the means over 3×3 cells scatter beyond what the noise of their points explains.
double waviness(const std::vector<CellMean>& wide, double noise) {
  std::vector<double> means;
  double noise_squares = 0;
  for (const CellMean& m : wide) {
    if (m.n < 15) continue;
    means.push_back(m.sum / m.n);
    noise_squares += noise * noise / m.n;
  }
  if (means.size() < 20) return 0;
  std::sort(means.begin(), means.end());
  const double scatter = means[means.size() * 2 / 5] - means[means.size() / 10];  // one deviation of a Gaussian
  return std::sqrt(std::max(0.0, scatter * scatter - noise_squares / static_cast<double>(means.size())));
}

void Splitter::split(const Support& support, const std::vector<Sample>& samples) {
  std::vector<CellKey> keys(samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) keys[k] = key_at(samples[k].at);
  const CellIndex cells(keys);
  std::vector<CellMean> means(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (const std::uint32_t k : cells.items(c)) means[c].n += 1, means[c].sum += samples[k].height;
  }
  std::vector<CellMean> wide(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (int d = 0; d < 9; ++d) {
      const std::int32_t n = cells.find(moved(cells.key(c), d / 3 - 1, d % 3 - 1, 0));
      if (n >= 0) wide[c].n += means[n].n, wide[c].sum += means[n].sum;
    }
  }
  const double lowest = std::max(kLowest, 3 * waviness(wide, support.noise));
  // A cell counts as raised when the mean of its points and of those around it is.
  std::vector<bool> raised(cells.size(), false);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const CellMean& around = wide[c];
    const double own = means[c].sum / means[c].n, mean = around.sum / around.n;
    const double limit = std::max(lowest, kCertain * support.noise / std::sqrt(around.n));
    raised[c] = mean > limit * 0.7 && own > std::max(lowest, 2 * support.noise / std::sqrt(means[c].n)) && around.n >= 5;
  }
  std::vector<bool> seen(cells.size(), false);
  for (std::size_t first = 0; first < cells.size(); ++first) {
    if (!raised[first] || seen[first]) continue;
    std::vector<std::int32_t> patch{static_cast<std::int32_t>(first)};
    seen[first] = true;
    for (std::size_t next = 0; next < patch.size(); ++next) {
      for (int d = 0; d < 9; ++d) {
        const std::int32_t n = cells.find(moved(cells.key(static_cast<std::size_t>(patch[next])), d / 3 - 1, d % 3 - 1, 0));
        if (n < 0 || !raised[n] || seen[n]) continue;
        seen[n] = true;
        patch.push_back(n);
      }
    }
    // What covers most of a wall is the wall; desks of two heights may stand side by side.
    if (support.level || 2 * patch.size() < cells.size()) make_region(cells, samples, patch, support.noise);
  }
}

void Splitter::make_region(const CellIndex& cells, const std::vector<Sample>& samples,
                           const std::vector<std::int32_t>& patch, double noise) {
  // Half way up belongs to the thing; the level itself is found from what lies above.
  std::vector<double> heights;
  CellMean everything;
  for (const std::int32_t c : patch) {
    for (const std::uint32_t k : cells.items(static_cast<std::size_t>(c))) {
      if (samples[k].height > kLowest) heights.push_back(samples[k].height);
      everything.n += 1, everything.sum += samples[k].height;
    }
  }
  if (static_cast<double>(heights.size()) < limits_.min_points) return;
  std::nth_element(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2), heights.end());
  const double level = heights[heights.size() / 2];
  // Picking the high points out of noise gives a level too; then there are as many low ones in the same place.
  if (everything.sum < kCovering * level * everything.n) return;
  Moments moments;
  std::vector<std::uint32_t> points;
  double squares = 0, sum = 0;
  const auto take = [&](std::uint32_t k) {
    const Sample& s = samples[k];
    if (s.height < level / 2 || s.height > level + std::max(3 * noise, 0.015)) return;
    points.push_back(s.point);
    moments.add(cloud_.offset(s.point).cast<double>());
    squares += (s.height - level) * (s.height - level);
    sum += s.height;
  };
  // Cells at the rim hold points of both; those half way up are the thing's.
  std::vector<bool> in_patch(cells.size(), false);
  std::vector<std::int32_t> all = patch;
  for (const std::int32_t c : patch) in_patch[c] = true;
  for (const std::int32_t c : patch) {
    for (int d = 0; d < 9; ++d) {
      const std::int32_t n = cells.find(moved(cells.key(static_cast<std::size_t>(c)), d / 3 - 1, d % 3 - 1, 0));
      if (n >= 0 && !in_patch[n]) in_patch[n] = true, all.push_back(n);
    }
  }
  for (const std::int32_t c : all) {
    for (const std::uint32_t k : cells.items(static_cast<std::size_t>(c))) take(k);
  }
  const auto n = static_cast<double>(points.size());
  if (n < limits_.min_points) return;
  const PlaneFit plane = fit_plane(moments);
  const double offset = sum / n, scatter = std::sqrt(squares / n);
  const bool significant = offset > kCertain * std::max(noise, scatter) / std::sqrt(n) && offset > kLowest;
  const bool flat = plane.rmse() < std::max(0.008, 1.3 * noise) && plane.variances[1] > 4 * plane.variances[0];
  if (!significant || !flat || plane.spread_area() < kSmallestPatch) return;
  const auto number = static_cast<std::int32_t>(regions_.planes.size());
  for (const std::uint32_t i : points) regions_.of_point[i] = number;
  regions_.planes.push_back(plane);
}

/// Towards the room: up for level planes, else towards the sensor, else none.
std::optional<Eigen::Vector3d> front(const Cloud& cloud, const PlaneFit& plane, const Eigen::Vector3d& up) {
  const double c = plane.normal.dot(up);
  if (std::abs(c) > kLevel) return c > 0 ? plane.normal : Eigen::Vector3d(-plane.normal);
  if (!cloud.viewpoint) return std::nullopt;
  return plane.distance(*cloud.viewpoint - cloud.origin) > 0 ? plane.normal : Eigen::Vector3d(-plane.normal);
}

/// Free points by cells of 10 cm, so that those near a support are found without looking at all.
constexpr double kFreeCell = 0.1;

CellKey free_key(const Eigen::Vector3f& p) {
  return cell_key(static_cast<std::int64_t>(std::floor(p.x() / kFreeCell)), static_cast<std::int64_t>(std::floor(p.y() / kFreeCell)),
                  static_cast<std::int64_t>(std::floor(p.z() / kFreeCell)));
}

}  // namespace

void split_thin_objects(const Cloud& cloud, const Upright& upright, const Limits& limits, Regions& regions) {
  const Eigen::Vector3d up = upright.rotation.inverse() * Eigen::Vector3d::UnitZ();
  const std::size_t count = regions.planes.size();
  const auto points = points_of_regions(regions.of_point, count);
  std::vector<CellKey> keys(cloud.size(), kNoCell);
  constexpr float limit = static_cast<float>(kCellLimit) * static_cast<float>(kFreeCell);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (regions.of_point[i] < 0 && cloud.offset(i).cwiseAbs().maxCoeff() < limit) keys[i] = free_key(cloud.offset(i));
  }
  const CellIndex free(keys);
  std::vector<std::int32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return regions.planes[a].count > regions.planes[b].count; });
  Splitter splitter(cloud, limits, regions);
  for (const std::int32_t r : order) {
    const PlaneFit plane = regions.planes[r];
    if (plane.count == 0 || plane.spread_area() < kSmallestSupport) continue;
    const bool level = std::abs(plane.normal.dot(up)) > kLevel;
    const std::optional<Eigen::Vector3d> towards_room = front(cloud, plane, up);
    if (!towards_room) continue;
    Support support;
    support.level = level;
    support.normal = level ? up : *towards_room;
    support.centroid = plane.centroid;
    support.u = plane.axes.col(1) - support.normal * support.normal.dot(plane.axes.col(1));
    support.u.normalize();
    support.v = support.normal.cross(support.u);
    std::vector<Sample> own;
    std::vector<double> heights;
    for (const std::uint32_t i : points[r]) {
      own.push_back(support.sample(cloud, i));
      heights.push_back(own.back().height);
    }
    const double main = main_level(heights, level);
    support.noise = std::max(0.0015, noise_below(own, main));
    support.centroid += main * support.normal;
    std::vector<CellKey> near;
    for (Sample& s : own) {
      s.height -= main;
      const CellKey key = free_key(cloud.offset(s.point));
      if (near.empty() || near.back() != key) near.push_back(key);
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::vector<std::int32_t> around;
    for (const CellKey key : near) {
      for (int d = 0; d < 27; ++d) {
        const std::int32_t c = free.find(moved(key, d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1));
        if (c >= 0) around.push_back(c);
      }
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    for (const std::int32_t c : around) {
      for (const std::uint32_t i : free.items(static_cast<std::size_t>(c))) {
        if (regions.of_point[i] >= 0) continue;  // taken by a patch on a larger support
        const Sample s = support.sample(cloud, i);
        if (s.height > -2 * support.noise && s.height < kHighest) own.push_back(s);
      }
    }
    splitter.split(support, own);
    if (!level) continue;
    // Rays graze tops, whose noise is far below that of a single range: edges and feet need not come along.
    const double reach = std::max(kLowest, 4 * support.noise);
    for (const Sample& s : own) {
      if (regions.of_point[s.point] == r && std::abs(s.height) > reach) regions.of_point[s.point] = -1;
    }
  }
  refit(cloud, regions);
}

}  // namespace scenelore::perception
