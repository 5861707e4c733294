#include "grow.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "curvature.hpp"

namespace scenelore::perception {
namespace {

constexpr double kSeedDeviation = 1.6;   // of the local noise: a seed must be clearly flat
constexpr double kSameDirection = 0.88;  // cosine of 28 degrees, the spread of normals of 15 cm patches at 2 cm noise
constexpr double kRefitGrowth = 1.1;     // the plane is fitted anew whenever the region has grown by a tenth
constexpr std::size_t kFewestVoxels = 3;

class Grower {
 public:
  Grower(const VoxelGrid& grid, const std::vector<LocalSurface>& surfaces, const NoiseMap& noise)
      : grid_(grid), surfaces_(surfaces), noise_(noise), region_(grid.count(), -1) {}

  Growth run(double fewest_points);

 private:
  std::vector<std::uint32_t> seeds() const;
  bool start(std::size_t seed);
  bool fits(std::size_t v) const;
  void spread(std::int32_t number);
  void drop_misfits();
  void refit();

  const VoxelGrid& grid_;
  const std::vector<LocalSurface>& surfaces_;
  const NoiseMap& noise_;
  std::vector<std::int32_t> region_;
  // The region that grows now.
  std::vector<std::uint32_t> members_;
  Moments start_, sum_;
  PlaneFit plane_;
  double seed_noise_ = 0;
  double deviation_ = 0;      // of its points, between once and 1.5 times the noise at its seed
  double fitted_at_ = 0;      // number of points at the last fit
};

/// Flattest first: deviation in units of the noise there. Ties by position.
std::vector<std::uint32_t> Grower::seeds() const {
  std::vector<std::uint32_t> order;
  for (std::size_t v = 0; v < grid_.count(); ++v) {
    const bool believed = !noise_.rounded[v] || surfaces_[v].rmse > 0.3 * noise_.of_voxel[v];
    if (believed && surfaces_[v].planar && surfaces_[v].rmse < kSeedDeviation * noise_.of_voxel[v]) order.push_back(static_cast<std::uint32_t>(v));
  }
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return surfaces_[a].rmse * noise_.of_voxel[b] < surfaces_[b].rmse * noise_.of_voxel[a];
  });
  return order;
}

/// The first plane is that of the voxels around the seed which are still free.
bool Grower::start(std::size_t seed) {
  start_ = Moments();
  for (const std::int32_t n : grid_.neighbours[seed]) {
    if (n >= 0 && region_[static_cast<std::size_t>(n)] < 0) start_ += grid_.moments[static_cast<std::size_t>(n)];
  }
  if (start_.n < 8) return false;
  plane_ = fit_plane(start_);
  const double noise = noise_.of_voxel[seed];
  if (plane_.rmse() > kSeedDeviation * noise || plane_.variances[1] < 4 * plane_.variances[0]) return false;
  seed_noise_ = deviation_ = noise;
  sum_ = Moments();
  members_.clear();
  fitted_at_ = 0;
  return true;
}

bool Grower::fits(std::size_t v) const {
  const Moments& m = grid_.moments[v];
  const double sigma = std::max<double>(noise_.of_voxel[v], deviation_);
  // Mean square of n deviations: expectation σ², spread σ²√(2/n).
  const double limit = sigma * sigma * (1.3 + 3 * std::sqrt(2 / m.n));
  if (m.mean_squared_distance(plane_) > limit) return false;
  const double mean_limit = sigma * (0.7 + 2.5 / std::sqrt(m.n));
  if (std::abs(m.mean_distance(plane_)) > mean_limit) return false;
  const LocalSurface& s = surfaces_[v];
  // Next to an edge the neighbourhood holds two surfaces and its normal says nothing; it is then not flat.
  const bool trusted = s.planar && !noise_.rounded[v] && s.rmse < 2 * noise_.of_voxel[v];
  return !trusted || std::abs(s.normal.cast<double>().dot(plane_.normal)) > kSameDirection;
}

void Grower::refit() {
  const bool young = sum_.n < start_.n;
  plane_ = fit_plane(young ? start_ : sum_);
  fitted_at_ = sum_.n;
  deviation_ = std::clamp(plane_.rmse(), seed_noise_, 1.5 * seed_noise_);
}

void Grower::spread(std::int32_t number) {
  for (std::size_t next = 0; next < members_.size(); ++next) {
    for (const std::int32_t n : grid_.neighbours[members_[next]]) {
      if (n < 0) continue;
      const auto v = static_cast<std::size_t>(n);
      if (region_[v] >= 0 || !fits(v)) continue;
      region_[v] = number;
      members_.push_back(static_cast<std::uint32_t>(v));
      sum_ += grid_.moments[v];
      if (sum_.n > kRefitGrowth * fitted_at_) refit();
    }
  }
}

/// The plane has moved since the first voxels were taken.
void Grower::drop_misfits() {
  std::vector<std::uint32_t> kept;
  for (const std::uint32_t v : members_) {
    if (fits(v)) {
      kept.push_back(v);
    } else {
      sum_ -= grid_.moments[v];
      region_[v] = -1;
    }
  }
  members_ = std::move(kept);
}

Growth Grower::run(double fewest_points) {
  Growth growth;
  for (const std::uint32_t seed : seeds()) {
    if (region_[seed] >= 0 || !start(seed)) continue;
    const auto number = static_cast<std::int32_t>(growth.regions.size());
    region_[seed] = number;
    members_.push_back(seed);
    sum_ = grid_.moments[seed];
    for (int round = 0; round < 3 && !members_.empty(); ++round) {
      const double before = sum_.n;
      spread(number);
      if (sum_.n > 0) refit();
      drop_misfits();
      if (sum_.n < 1.02 * before) break;
    }
    if (sum_.n > 0) plane_ = fit_plane(sum_);
    const bool good = members_.size() >= kFewestVoxels && sum_.n >= fewest_points && !is_curved(grid_, members_, plane_);
    if (!good) {
      for (const std::uint32_t v : members_) region_[v] = -1;
      continue;
    }
    growth.regions.push_back(plane_);
    growth.noise.push_back(plane_.rmse());
  }
  growth.region_of_voxel = std::move(region_);
  return growth;
}

}  // namespace

Growth grow_regions(const VoxelGrid& grid, const std::vector<LocalSurface>& surfaces, const NoiseMap& noise, double fewest_points) {
  return Grower(grid, surfaces, noise).run(fewest_points);
}

}  // namespace scenelore::perception
