#include "thin_objects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "height_map.hpp"
#include "support.hpp"

namespace scenelore::perception {
namespace {

constexpr double kSmallestSupport = 0.1;   // m²
constexpr double kSmallestPatch = 0.006;   // m², half a paperback
// Less than this over its support a small patch is more often the spill of an edge: mixed pixels at the legs of chairs, door
// frames, the rims of boards.
constexpr double kLowThing = 0.018;        // metres
constexpr double kSmallestLowPatch = 0.045;  // m²
constexpr double kFlat = 0.008;            // metres, or 1.3 times the support's noise
constexpr double kFreeCell = 0.1;          // metres
constexpr double kLayer = 0.85;            // of its points
constexpr double kWide = 1;                // m²
constexpr double kEven = 1.3;              // deviations of the support
constexpr double kLeastSlant = 0.985, kMostSlant = 0.5;  // cosines of 10 and 60 degrees

/// Free points by cells of 10 cm, so that those near a support are found without looking at all.
class FreePoints {
 public:
  FreePoints(const Cloud& cloud, const Regions& regions) : cloud_(cloud) {
    std::vector<CellKey> keys;
    constexpr float limit = static_cast<float>(kCellLimit) * static_cast<float>(kFreeCell);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (regions.of_point[i] >= 0 || !(cloud.offset(i).cwiseAbs().maxCoeff() < limit)) continue;
      points_.push_back(static_cast<std::uint32_t>(i));
      keys.push_back(key_of(i));
    }
    cells_ = CellIndex(keys);
  }

  /// Those in the cells of these points and around them.
  [[nodiscard]] std::vector<std::uint32_t> near(const std::vector<std::uint32_t>& points) const {
    std::vector<CellKey> near;
    for (const std::uint32_t i : points) {
      const CellKey key = key_of(i);
      if (near.empty() || near.back() != key) near.push_back(key);
    }
    sort_out(near);
    std::vector<std::int32_t> around;
    for (const CellKey key : near) {
      for (int d = 0; d < 27; ++d) {
        const std::int32_t c = cells_.find(moved(key, d / 9 - 1, d / 3 % 3 - 1, d % 3 - 1));
        if (c >= 0) around.push_back(c);
      }
    }
    sort_out(around);
    std::vector<std::uint32_t> found;
    for (const std::int32_t c : around) {
      for (const std::uint32_t k : cells_.items(static_cast<std::size_t>(c))) found.push_back(points_[k]);
    }
    return found;
  }

 private:
  [[nodiscard]] CellKey key_of(std::size_t i) const {
    const Eigen::Vector3f p = cloud_.offset(i) / static_cast<float>(kFreeCell);
    return cell_key(static_cast<std::int64_t>(std::floor(p.x())), static_cast<std::int64_t>(std::floor(p.y())),
                    static_cast<std::int64_t>(std::floor(p.z())));
  }
  static void sort_out(auto& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  const Cloud& cloud_;
  std::vector<std::uint32_t> points_;
  CellIndex cells_;  // items are among these
};

/// What a support carries, seen from above: the polygon of its extents in sixteen directions.
class Footprint {
 public:
  explicit Footprint(const std::vector<Sample>& samples) {
    extent_.fill(-std::numeric_limits<double>::infinity());
    for (const Sample& s : samples) {
      const double x = s.at.x(), y = s.at.y();
      for (std::size_t k = 0; k < kDirections; ++k) {
        const double out = kDirection.x[k] * x + kDirection.y[k] * y;
        extent_[k] = extent_[k] < out ? out : extent_[k];
      }
    }
  }
  [[nodiscard]] bool holds(const Eigen::Vector2d& p) const {
    for (std::size_t k = 0; k < kDirections; ++k) {
      if (kDirection.x[k] * p.x() + kDirection.y[k] * p.y() > extent_[k]) return false;
    }
    return true;
  }

 private:
  static constexpr std::size_t kDirections = 16;
  using Numbers = std::array<double, kDirections>;
  struct Directions {
    Numbers x, y;
  };
  static const Directions kDirection;
  Numbers extent_;
};

const Footprint::Directions Footprint::kDirection = [] {
  Directions directions;
  for (std::size_t k = 0; k < kDirections; ++k) {
    const double angle = static_cast<double>(k) * 2 * std::numbers::pi / kDirections;
    directions.x[k] = std::cos(angle), directions.y[k] = std::sin(angle);
  }
  return directions;
}();

/// Growing takes the tops of all that lies on a table for one plane a little above it. True when these points are such a
/// layer: nearly all of them over the footprint and no higher than thin things are.
bool is_layer_on(const Support& support, const Footprint& footprint, const Cloud& cloud, const std::vector<std::uint32_t>& points) {
  const std::size_t step = 1 + points.size() / 500;
  const auto all = static_cast<double>((points.size() + step - 1) / step);
  double over = all;
  for (std::size_t k = 0; k < points.size(); k += step) {
    const Sample s = support.sample(cloud, points[k]);
    if (s.height > -kLowest && s.height < kHighest && footprint.holds(s.at.cast<double>())) continue;
    over -= 1;
    if (over <= kLayer * all) return false;  // hardly any plane is a layer, which a few points tell
  }
  return over > kLayer * all;
}

/// Puts the things on one support into regions of their own.
class Splitter {
 public:
  Splitter(const Cloud& cloud, const Limits& limits, const Support& support, const std::vector<Sample>& samples, Regions& regions)
      : cloud_(cloud), limits_(limits), support_(support), samples_(samples), regions_(regions), taken_(samples.size(), false) {}

  /// Where points are dense, fine cells part things that lie close together; what they are too fine for is left to coarse ones.
  void split() {
    const double fine = fitting_edge(samples_), coarse = 0.04;
    split_at(fine);
    if (fine < 0.7 * coarse) split_at(coarse);
  }

 private:
  void split_at(double edge);

  const Cloud& cloud_;
  const Limits& limits_;
  const Support& support_;
  const std::vector<Sample>& samples_;
  Regions& regions_;
  std::vector<bool> taken_;
};

void Splitter::split_at(double edge) {
  const HeightMap map = make_height_map(samples_, edge, support_.noise, taken_);
  const std::vector<FlatThing> things = flat_things(map, support_.noise, limits_.min_points);
  std::vector<std::int32_t> thing_of_cell(map.cell.size(), -1);
  std::size_t covered = 0;
  for (std::size_t t = 0; t < things.size(); ++t) {
    for (const std::size_t c : things[t].cells) thing_of_cell[c] = static_cast<std::int32_t>(t);
    covered += things[t].cells.size();
  }
  // What covers most of a wall is the wall; desks of two heights may stand side by side.
  if (!support_.level && 4 * covered > 3 * map.cell.size()) return;
  for (std::size_t t = 0; t < things.size(); ++t) {
    std::vector<std::uint32_t> points;
    const FlatThing& thing = things[t];
    const double reach = std::max({3 * support_.noise, 0.006});
    double sum = 0, everything = 0, n = 0;
    Moments moments;
    const auto take = [&](std::uint32_t k) {
      const Sample& s = samples_[k];
      const double own = thing.height_at(s.at.cast<double>());
      if (taken_[k] || std::abs(s.height - own) > reach || s.height < own / 2) return;
      points.push_back(k);
      sum += s.height;
      moments.add(cloud_.offset(s.point).cast<double>());
    };
    std::vector<std::size_t> rim;
    for (const std::size_t c : thing.cells) {
      everything += map.cell[c].n * map.cell[c].height, n += map.cell[c].n;
      for (const std::uint32_t k : map.cells.items(c)) take(k);
      // Cells at the rim hold points of both.
      map.for_each_neighbour(c, [&](std::size_t around) {
        if (thing_of_cell[around] < 0) rim.push_back(around);
      });
    }
    std::sort(rim.begin(), rim.end());
    rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
    for (const std::size_t c : rim) {
      for (const std::uint32_t k : map.cells.items(c)) take(k);
    }
    const auto count = static_cast<double>(points.size());
    if (count < limits_.min_points) continue;
    const PlaneFit plane = fit_plane(moments);
    const double offset = sum / count;
    // Picking the high points out of noise gives a level too; then there are as many low ones in the same cells.
    const bool covering = everything > 0.6 * offset * n;
    const bool significant = offset > kCertain * std::max(support_.noise, plane.rmse()) / std::sqrt(count) && offset > kLowest;
    const bool flat = plane.rmse() < std::max(kFlat, 1.3 * support_.noise) && plane.variances[1] > 4 * plane.variances[0];
    if (!covering || !significant || !flat || plane.spread_area() < (offset < kLowThing ? kSmallestLowPatch : kSmallestPatch)) continue;
    const auto number = static_cast<std::int32_t>(regions_.planes.size());
    for (const std::uint32_t k : points) {
      taken_[k] = true;
      regions_.of_point[samples_[k].point] = number;
    }
    regions_.planes.push_back(plane);
  }
}

}  // namespace

void split_thin_objects(const Cloud& cloud, const Upright& upright, const Limits& limits, Regions& regions) {
  const Eigen::Vector3d up = upright.rotation.inverse() * Eigen::Vector3d::UnitZ();
  const std::size_t count = regions.planes.size();
  const auto points = points_of_regions(regions.of_point, count);
  const FreePoints free(cloud, regions);
  std::vector<bool> dissolved(count, false);
  // Planes at such angles are seldom furniture; where they cut through what lies on a table, the table's things come first.
  std::vector<bool> slanting(count, false);
  for (std::size_t q = 0; q < count; ++q) {
    const double c = std::abs(regions.planes[q].normal.dot(up));
    slanting[q] = regions.planes[q].count > 0 && c < kLeastSlant && c > kMostSlant;
  }
  std::vector<std::int32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return regions.planes[a].count > regions.planes[b].count; });
  for (const std::int32_t r : order) {
    const PlaneFit plane = regions.planes[r];
    if (dissolved[r] || plane.count == 0 || plane.spread_area() < kSmallestSupport) continue;
    const std::optional<Support> support = make_support(cloud, plane, points[r], up);
    if (!support) continue;
    const std::vector<std::uint32_t> around = free.near(points[r]);
    std::vector<Sample> samples;
    samples.reserve(points[r].size() + around.size());
    for (const std::uint32_t i : points[r]) samples.push_back(support->sample(cloud, i));
    const std::size_t own = samples.size();
    const auto add_free = [&](const std::vector<std::uint32_t>& some) {
      for (const std::uint32_t i : some) {
        const std::int32_t of = regions.of_point[i];
        if (of >= 0 && !(of < static_cast<std::int32_t>(count) && slanting[static_cast<std::size_t>(of)])) continue;
        const Sample s = support->sample(cloud, i);
        if (s.height > -2 * support->noise && s.height < kHighest) samples.push_back(s);
      }
    };
    add_free(around);
    const Footprint footprint(samples);
    std::vector<std::size_t> layers;
    // What hangs on a wall was parted as flush faces; cut up again, a board comes out in pieces.
    for (std::size_t q = 0; q < count && support->level; ++q) {
      if (dissolved[q] || regions.planes[q].count == 0 || regions.planes[q].count >= plane.count) continue;
      if (slanting[q] && regions.planes[q].spread_area() > kSmallestSupport) {
        add_free(points[q]);
        continue;
      }
      // A floor may have a step: what is as wide and even as that is no layer of tops.
      const bool step = regions.planes[q].spread_area() > kWide && regions.planes[q].rmse() < kEven * support->noise;
      if (step || !is_layer_on(*support, footprint, cloud, points[q])) continue;
      layers.push_back(q);
      for (const std::uint32_t i : points[q]) regions.of_point[i] = -1;
      add_free(points[q]);
    }
    Splitter(cloud, limits, *support, samples, regions).split();
    for (const std::size_t q : layers) dissolved[q] = true;
    if (!support->level) continue;
    // Rays graze tops, whose noise is far below that of a single range: edges and feet need not come along.
    const double reach = std::max(kLowest, 4 * support->noise);
    for (std::size_t k = 0; k < own; ++k) {
      const Sample& s = samples[k];
      if (regions.of_point[s.point] == r && std::abs(s.height) > reach) regions.of_point[s.point] = -1;
    }
  }
  refit(cloud, regions);
}

}  // namespace scenelore::perception
