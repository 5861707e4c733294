#include "merge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "disjoint_sets.hpp"

namespace scenelore::perception {

double joint_deviation(const Moments& a, double noise_a, const Moments& b, double noise_b) {
  Moments both = a;
  both += b;
  const PlaneFit joint = fit_plane_fast(both);
  const auto worse = [&](const Moments& part, double noise) {
    // A surface seen at a slant scatters less than what lies around it: four fifths of the noise will do.
    const double own = std::max(fit_plane_fast(part).variances[0], 0.64 * noise * noise);
    // A small region's own deviation is uncertain; its limit widens with √(2/n) as in growing.
    return std::sqrt(part.mean_squared_distance(joint) / (own * (1 + 2 * std::sqrt(2 / part.n))));
  };
  return std::max(worse(a, noise_a), worse(b, noise_b));
}

namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;

/// Regions that have become one get the smallest of their numbers.
void rename(DisjointSets& joined, Slots& slots) {
  for (std::int32_t& r : slots.region) {
    if (r >= 0) r = joined.root(r);
  }
}

template <typename Allowed>
void merge_where(const std::vector<Pair>& pairs, std::vector<double> noise, Allowed allowed, Slots& slots, std::vector<PlaneFit>& planes) {
  const std::size_t count = planes.size();
  std::vector<Moments> moments = moments_of_regions(slots, count);
  DisjointSets joined(count);
  for (bool changed = true; changed;) {
    changed = false;
    // The best joins first: a wrong one spoils the plane that later ones are judged by.
    std::vector<std::pair<double, Pair>> scored;
    for (const Pair& pair : pairs) {
      const auto a = static_cast<std::int32_t>(joined.root(pair.first)), b = static_cast<std::int32_t>(joined.root(pair.second));
      if (a == b || moments[a].n < 3 || moments[b].n < 3 || !allowed(moments[a], moments[b])) continue;
      const double deviation = joint_deviation(moments[a], noise[a], moments[b], noise[b]);
      if (deviation < kMostDeviation) scored.emplace_back(deviation, Pair{std::min(a, b), std::max(a, b)});
    }
    std::sort(scored.begin(), scored.end());
    std::vector<bool> touched(count, false);
    for (const auto& [deviation, pair] : scored) {
      const auto [a, b] = pair;
      // One join a region and round; the rest is scored again with the joined planes.
      if (touched[a] || touched[b]) continue;
      touched[a] = touched[b] = true;
      joined.join(a, b);
      noise[a] = std::sqrt((moments[a].n * noise[a] * noise[a] + moments[b].n * noise[b] * noise[b]) / (moments[a].n + moments[b].n));
      moments[a] += moments[b];
      changed = true;
    }
  }
  rename(joined, slots);
  for (std::size_t r = 0; r < count; ++r) planes[r] = fit_plane(joined.root(static_cast<std::uint32_t>(r)) == r ? moments[r] : Moments());
}

}  // namespace

std::vector<double> noise_of_regions(const Slots& slots, const std::vector<float>& noise_of_voxel, double least, std::size_t count) {
  std::vector<double> squares(count, 0), points(count, 0);
  for (std::size_t s = 0; s < slots.count(); ++s) {
    const std::int32_t r = slots.region[s];
    if (r < 0) continue;
    const double noise = noise_of_voxel[slots.voxel[s]];
    squares[r] += slots.moments[s].n * noise * noise;
    points[r] += slots.moments[s].n;
  }
  for (std::size_t r = 0; r < count; ++r) squares[r] = points[r] > 0 ? std::max(least, std::sqrt(squares[r] / points[r])) : least;
  return squares;
}

void merge_regions(const Pyramid& pyramid, std::vector<double> noise, Slots& slots, std::vector<PlaneFit>& planes) {
  merge_where(touching_regions(pyramid, slots, 1), std::move(noise), [](const Moments&, const Moments&) { return true; }, slots, planes);
}

void bridge_shadows(double noise, double smallest, double voxel, Slots& slots, std::vector<PlaneFit>& planes) {
  std::vector<double> covered(planes.size(), 0);
  for (std::size_t s = 0; s < slots.count(); ++s) {
    if (slots.region[s] >= 0 && slots.moments[s].n > 0) covered[slots.region[s]] += voxel * voxel;
  }
  constexpr double kInLine = 0.985;      // cosine of 10 degrees
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < planes.size(); ++a) {
    if (planes[a].count <= 0 || std::min(planes[a].spread_area(), covered[a]) < smallest) continue;
    for (std::size_t b = 0; b < planes.size(); ++b) {
      if (a == b || planes[b].count <= 0 || std::abs(planes[a].normal.dot(planes[b].normal)) < kInLine) continue;
      // The larger plane goes on past the smaller one's middle.
      if (std::abs(planes[a].distance(planes[b].centroid)) > 4 * std::max(noise, planes[a].rmse())) continue;
      pairs.emplace_back(static_cast<std::int32_t>(std::min(a, b)), static_cast<std::int32_t>(std::max(a, b)));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  const auto in_line = [](const Moments& a, const Moments& b) {
    return std::abs(fit_plane_fast(a).normal.dot(fit_plane_fast(b).normal)) > kInLine;
  };
  merge_where(pairs, std::vector<double>(planes.size(), noise), in_line, slots, planes);
}

void join_level_pieces(const Pyramid& pyramid, const Eigen::Vector3d& up, std::size_t flush, std::size_t count, const std::vector<double>& noise,
                       Slots& slots, std::vector<PlaneFit>& planes) {
  constexpr double kSameHeight = 0.007;  // metres; what lies on a table is at least 9 mm higher
  constexpr double kKeyboard = 0.12;     // m²; thin things smaller than this stay what they are
  constexpr double kClearly = 1.25;      // deviations; a joint plane so much worse is none, however low the step
  const auto level = [&](const PlaneFit& plane) { return plane.count > 0 && std::abs(plane.normal.dot(up)) > 0.9945; };
  const auto parted = [&](std::int32_t r) { return flush <= static_cast<std::size_t>(r) && static_cast<std::size_t>(r) < count; };
  const std::vector<Moments> moments = moments_of_regions(slots, planes.size());
  DisjointSets joined(planes.size());
  for (const auto& [first, second] : touching_regions(pyramid, slots, 2)) {
    if (parted(first) != parted(second)) continue;
    const PlaneFit &a = planes[first], &b = planes[second];
    if (static_cast<std::size_t>(second) >= count && b.spread_area() < kKeyboard) continue;
    if (!level(a) || !level(b) || std::abs(up.dot(a.centroid - b.centroid)) > kSameHeight) continue;
    if (joint_deviation(moments[first], noise[first], moments[second], noise[second]) > kClearly) continue;
    joined.join(first, second);
  }
  rename(joined, slots);
  refit(slots, planes);
}

}  // namespace scenelore::perception
