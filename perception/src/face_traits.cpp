#include "face_traits.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "curvature.hpp"
#include "scenelore/perception/parallel.hpp"
#include "seen_from.hpp"

namespace scenelore::perception {
namespace {

constexpr double kAgreeing = 0.9;       // cosine of 26 degrees
constexpr double kParallel = 0.94;      // cosine of 20 degrees
constexpr double kFlatterThan = 0.997;  // cosine of 4.5 degrees: neighbours this parallel are layers, not facets
constexpr double kSteeperThan = 0.64;   // cosine of 50 degrees: an edge
constexpr double kSquare = 0.26;        // cosine of 75 degrees
constexpr double kStep = 0.4;           // voxels
constexpr double kFar = 8;              // deviations; of things, centimetres
constexpr double kThingUnit = 0.01;     // metres
constexpr double kBefore = 0.8;         // voxels along the normal: what lies beside is no layer

// What is thinner, smoother or more even than this is no less a face. In simulated scans hardly anything is, but slivers of rounded
// distances, which must not speak against an exact cloud.
constexpr double kThin = 0.04, kSmooth = 0.9, kEven = 0.3;
constexpr double kLeastDeviation = 0.0001;  // metres

/// Sums over the voxels of a region.
struct Tally {
  double voxels = 0, agreeing = 0, judged = 0, uneven = 0, left = 0, foreign = 0;
  double border = 0, contact = 0, square = 0;
  double nearer = 0;  // by how much the nearest layer of each voxel is nearer than kFar
  BentSurface bent;

  explicit Tally(const PlaneFit& plane) : bent(plane) {}
};

/// Radians of a horizontal direction about up, in some frame.
double heading(const Eigen::Vector3d& direction, const Eigen::Vector3d& up) {
  const Eigen::Vector3d x = up.unitOrthogonal();
  return std::atan2(direction.dot(up.cross(x)), direction.dot(x));
}

/// Of most walls, up to quarter turns: the mean of four times the angle, by area (Mardia & Jupp 2000, directional statistics).
double heading_of_walls(const std::vector<PlaneFit>& planes, const Eigen::Vector3d& up) {
  constexpr double kUpright = 0.2, kSmallest = 0.5;  // cosine, m²
  double sine = 0, cosine = 0;
  for (const PlaneFit& plane : planes) {
    const double area = plane.spread_area();
    if (plane.count <= 0 || std::abs(plane.normal.dot(up)) > kUpright || area < kSmallest) continue;
    const double angle = 4 * heading(plane.normal, up);
    sine += area * std::sin(angle), cosine += area * std::cos(angle);
  }
  return std::atan2(sine, cosine) / 4;
}

/// The region with most of a voxel's points, and the slot of these.
struct Owner {
  std::int32_t region = -1;
  std::uint32_t slot = ~std::uint32_t{0};  // none
};

class Measure {
 public:
  Measure(const VoxelGrid& grid, const std::vector<LocalSurface>& surfaces, const std::vector<double>& noise, const Slots& slots,
          const std::vector<PlaneFit>& planes, const View& view, const RegionRange& things)
      : grid_(grid), surfaces_(surfaces), noise_(noise), slots_(slots), planes_(planes), view_(view), things_(things),
        walls_(heading_of_walls(planes, view.up)), owner_(grid.count()) {}

  std::vector<FaceTraits> run(std::size_t first, int threads) {
    parallel_pieces(grid_.count(), 4096, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) choose_owner(v);
    });
    const std::vector<std::vector<std::uint32_t>> members = slots_of_regions(slots_, planes_.size(), first);
    std::vector<FaceTraits> result(planes_.size());
    parallel_pieces(planes_.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = std::max(begin, first); r < end; ++r) {
        if (planes_[r].count > 0) result[r] = traits(r, members[r]);
      }
    });
    return result;
  }

 private:
  /// Deviations between a region's points at `middle` and another region, where that is a larger one and almost parallel; else kFar. Of things, which
  /// lie as high on a desk in a noisy scan as in others, centimetres.
  [[nodiscard]] double layer(std::int32_t region, std::int32_t other, const Eigen::Vector3d& middle) const {
    const PlaneFit &plane = planes_[region], &larger = planes_[other];
    if (larger.count <= plane.count || std::abs(plane.normal.dot(larger.normal)) < kParallel) return kFar;
    const double unit = things_.hold(static_cast<std::size_t>(region)) ? kThingUnit : std::max(noise_[other], larger.rmse());
    return std::min(kFar, std::abs(larger.distance(middle)) / unit);
  }
  void within(std::uint32_t slot, Tally& t) const;
  [[nodiscard]] double nearest_layer(std::size_t v, std::int32_t region, const Eigen::Vector3d& middle) const;
  void around(std::size_t v, Tally& t) const;
  void choose_owner(std::size_t v);
  [[nodiscard]] double distance(const PlaneFit& plane, const Owner& owner) const { return slots_.moments[owner.slot].mean_distance(plane); }
  [[nodiscard]] double degrees_turned(const PlaneFit& plane) const;
  [[nodiscard]] FaceTraits traits(std::size_t r, const std::vector<std::uint32_t>& members) const;

  const VoxelGrid& grid_;
  const std::vector<LocalSurface>& surfaces_;
  const std::vector<double>& noise_;
  const Slots& slots_;
  const std::vector<PlaneFit>& planes_;
  const View& view_;
  RegionRange things_;
  double walls_;  // heading, radians
  std::vector<Owner> owner_;
};

void Measure::choose_owner(std::size_t v) {
  double most = 0;
  for (std::uint32_t s = slots_.first[v]; s < slots_.first[v + 1]; ++s) {
    const double n = slots_.moments[s].n;
    if (slots_.region[s] >= 0 && n > most) most = n, owner_[v] = {slots_.region[s], s};
  }
}

void Measure::within(std::uint32_t slot, Tally& t) const {
  const std::uint32_t v = slots_.voxel[slot];
  double all = 0, left = 0;
  for (std::uint32_t s = slots_.first[v]; s < slots_.first[v + 1]; ++s) {
    all += slots_.moments[s].n;
    if (slots_.region[s] < 0) left += slots_.moments[s].n;
  }
  const std::int32_t r = slots_.region[slot];
  const Moments& m = slots_.moments[slot];
  const PlaneFit& plane = planes_[r];
  t.voxels += 1, t.left += left, t.foreign += all - left - m.n;
  const LocalSurface& near = surfaces_[v];
  if (!near.normal.isZero()) {
    t.judged += m.n;
    if (std::abs(near.normal.cast<double>().dot(plane.normal)) > kAgreeing) t.agreeing += m.n;
  }
  const double d = m.mean_distance(plane);
  t.uneven += m.n * d * d;
  const Eigen::Vector3d at = m.mean() - plane.centroid;
  t.bent.add({plane.axes.col(1).dot(at), plane.axes.col(2).dot(at), d, m.n});
  t.nearer += kFar - nearest_layer(v, r, m.mean());
}

/// In the same voxel, or with most of the points of one before or behind it.
double Measure::nearest_layer(std::size_t v, std::int32_t region, const Eigen::Vector3d& middle) const {
  double nearest = kFar;
  for (std::uint32_t s = slots_.first[v]; s < slots_.first[v + 1]; ++s) {
    const std::int32_t other = slots_.region[s];
    if (other >= 0 && other != region && slots_.moments[s].n > 0) nearest = std::min(nearest, layer(region, other, middle));
  }
  const Eigen::Vector3d center = grid_.center(v);
  for (const std::int32_t n : grid_.neighbours[v]) {
    if (n < 0 || owner_[n].region < 0 || owner_[n].region == region) continue;
    if (std::abs(planes_[region].normal.dot(grid_.center(static_cast<std::size_t>(n)) - center)) < kBefore * grid_.size) continue;
    nearest = std::min(nearest, layer(region, owner_[n].region, middle));
  }
  return nearest;
}

void Measure::around(std::size_t v, Tally& t) const {
  const std::int32_t r = owner_[v].region;
  const PlaneFit& plane = planes_[r];
  int own = 0;
  bool goes_on = false, square = false;
  for (const std::int32_t n : grid_.neighbours[v]) {
    if (n < 0 || owner_[n].region < 0) continue;
    const std::int32_t other = owner_[n].region;
    if (other == r) {
      ++own;
      continue;
    }
    const double cosine = std::abs(plane.normal.dot(planes_[other].normal));
    square = square || (cosine < kSquare && std::abs(distance(plane, owner_[n])) < grid_.size);
    if (cosine < kFlatterThan && cosine > kSteeperThan) goes_on = goes_on || std::abs(distance(plane, owner_[n])) < kStep * grid_.size;
  }
  if (own < 9) t.border += 1, t.square += square;
  t.contact += goes_on;
}

/// Between a plane and most walls. Of a level plane its length tells.
double Measure::degrees_turned(const PlaneFit& plane) const {
  constexpr double kLevel = 0.87;  // cosine of 30 degrees
  const bool level = std::abs(plane.normal.dot(view_.up)) > kLevel;
  const double angle = heading(level ? plane.axes.col(2) : plane.normal, view_.up) - walls_;
  return std::abs(std::remainder(angle, std::numbers::pi / 2)) * 180 / std::numbers::pi;
}

FaceTraits Measure::traits(std::size_t r, const std::vector<std::uint32_t>& members) const {
  const PlaneFit& plane = planes_[r];
  Tally t(plane);
  for (const std::uint32_t s : members) {
    within(s, t);
    if (owner_[slots_.voxel[s]].slot == s) around(slots_.voxel[s], t);
  }
  const double variance = std::max(plane.variances[0], 0.0), across = std::max(plane.variances[1], 1e-9), along = std::max(plane.variances[2], 1e-9);
  const double noise = std::max(noise_[r], 1e-5), area = std::max(plane.spread_area(), 1e-6);
  FaceTraits out{};
  const auto set = [&](Trait trait, double value) { out[static_cast<std::size_t>(trait)] = value; };
  const double all = plane.count + t.left + t.foreign;
  set(Trait::points, std::log10(plane.count));
  set(Trait::area, std::log10(area));
  set(Trait::length, 0.5 * std::log10(along / across));
  set(Trait::thickness, std::max(kThin, std::sqrt(variance / across)));
  set(Trait::roughness, std::max(kSmooth, std::sqrt(variance) / noise));
  set(Trait::agreeing, t.judged > 0 ? t.agreeing / t.judged : 0.5);
  set(Trait::unevenness, std::max(kEven, std::log10(1 + t.uneven / (std::max(1.0, t.voxels - 3) * noise * noise))));
  const double long_side = std::sqrt(12 * along) + grid_.size, short_side = std::sqrt(12 * across) + grid_.size;
  set(Trait::fill, std::min(4.0, t.voxels * grid_.size * grid_.size / (long_side * short_side)));
  set(Trait::layer, kFar - t.nearer / std::max(1.0, t.voxels));
  set(Trait::contact, std::min(1.0, t.contact / std::max(1.0, t.border)));
  set(Trait::left, t.left / all);
  set(Trait::foreign, t.foreign / all);
  set(Trait::tilt, std::acos(std::min(1.0, std::abs(plane.normal.dot(view_.up)))) * 180 / std::numbers::pi);
  const double slant = r < view_.slant.size() ? view_.slant[r] : std::numeric_limits<double>::quiet_NaN();
  set(Trait::slant, slant);
  const double across_view = std::max(noise_across(view_.noise, slant), kLeastDeviation);
  set(Trait::excess, std::isnan(slant) ? slant : std::log10(std::max(std::sqrt(variance), kLeastDeviation) / across_view));
  const std::optional<BentSurface::Bend> bend = t.bent.bend();
  set(Trait::bend, bend ? std::log10(1 + std::max(0.0, bend->gain) / (3 * noise * noise)) : 0);
  const double scatter = r < view_.scatter.size() ? view_.scatter[r] : std::sqrt(variance);
  set(Trait::tails, std::log10(std::max(std::sqrt(variance), kLeastDeviation) / std::max(scatter, kLeastDeviation)));
  set(Trait::square, t.square / std::max(1.0, t.border));
  set(Trait::turned, degrees_turned(plane));
  return out;
}

}  // namespace

std::vector<FaceTraits> face_traits(const VoxelGrid& grid, const std::vector<LocalSurface>& surfaces, const std::vector<double>& noise_of_region,
                                    const Slots& slots, const std::vector<PlaneFit>& planes, const View& view, const RegionRange& things,
                                    std::size_t first, int threads) {
  return Measure(grid, surfaces, noise_of_region, slots, planes, view, things).run(first, threads);
}

}  // namespace scenelore::perception
