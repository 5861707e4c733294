#include "sharp_faces.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "seen_from.hpp"

namespace scenelore::perception {
namespace {

constexpr double kSlant = 0.5;        // cosine of 60 degrees, between ray and normal
constexpr std::size_t kFewest = 40;   // points
constexpr double kTooThick = 2;       // deviation across, of what the noise explains
constexpr int kTriples = 200;
constexpr double kWidestTriple = 0.1;  // of the plane's area, twice the triangle's, at least
constexpr double kReach = 2.5;        // deviations
constexpr double kFinest = 0.001;     // metres
constexpr int kSteps = 20;
constexpr double kSettled = 0.01;     // of the deviation
constexpr double kSharper = 0.8;      // deviation of the face, of the region's, at most
constexpr double kShare = 0.25;       // of the points, at least
constexpr double kExtent = 0.4;       // of the region's area, at least

using Points = std::vector<Eigen::Vector3d>;

/// The plane through three of the points that has most of them within `reach` (Fischler & Bolles 1981); `own` where none has more.
PlaneEquation densest(const Points& points, const PlaneEquation& own, double reach, double least_area) {
  const auto held = [&](const PlaneEquation& plane) {
    return std::count_if(points.begin(), points.end(), [&](const Eigen::Vector3d& p) { return std::abs(plane.distance(p)) <= reach; });
  };
  std::uint32_t state = 1;  // of a linear congruential generator: the same triples in every run
  const auto any = [&]() -> const Eigen::Vector3d& {
    state = state * 1664525U + 1013904223U;
    return points[(static_cast<std::uint64_t>(state) * points.size()) >> 32];
  };
  PlaneEquation best = own;
  auto most = held(own);
  for (int i = 0; i < kTriples; ++i) {
    const Eigen::Vector3d a = any(), b = any(), c = any(), across = (b - a).cross(c - a);
    if (across.norm() < least_area) continue;
    PlaneEquation plane;
    plane.normal = across.normalized();
    plane.offset = plane.normal.dot(a);
    const auto count = held(plane);
    if (count > most) most = count, best = plane;
  }
  return best;
}

/// Points that are spread evenly over a slab but for a share of them, which scatters normally about a plane.
struct SheetInSlab {
  PlaneFit sheet;
  double sigma = 0;               ///< metres
  double share = 0.5;
  std::vector<double> of_sheet;  ///< probability of each point
};

/// Expectation maximisation (Banfield & Raftery 1993, section 2.3: a Poisson background) from a first guess of the plane.
SheetInSlab fit_sheet(const Points& points, const PlaneEquation& start, double sigma) {
  SheetInSlab model;
  static_cast<PlaneEquation&>(model.sheet) = start;
  model.sigma = sigma;
  model.of_sheet.resize(points.size());
  double low = 0, high = 0;
  for (const Eigen::Vector3d& p : points) low = std::min(low, start.distance(p)), high = std::max(high, start.distance(p));
  const double peak = 1 / std::sqrt(2 * std::numbers::pi);
  for (int step = 0; step < kSteps; ++step) {
    Moments held;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double d = model.sheet.distance(points[k]) / model.sigma, near = model.share * peak / model.sigma * std::exp(-0.5 * d * d);
      model.of_sheet[k] = near / (near + (1 - model.share) / (high - low));
      Moments one;
      one.add(points[k]);
      one *= model.of_sheet[k];
      held += one;
    }
    const double before = model.sigma;
    model.sheet = fit_plane(held);
    model.sigma = std::max(model.sheet.rmse(), kFinest);
    model.share = std::min(held.n / static_cast<double>(points.size()), 0.999);
    if (std::abs(model.sigma - before) < kSettled * before) break;
  }
  return model;
}

/// The points of the face in a region that is thicker than its noise; all of them where no sharp face stands out.
std::vector<std::uint32_t> sharp_face(const Cloud& cloud, const PlaneFit& plane, double across, const std::vector<std::uint32_t>& members) {
  Points points;
  for (const std::uint32_t i : members) points.push_back(cloud.offset(i).cast<double>());
  const SheetInSlab model = fit_sheet(points, densest(points, plane, kReach * across, kWidestTriple * plane.spread_area()), across);
  if (model.sigma > kSharper * plane.rmse() || model.share < kShare) return members;
  std::vector<std::uint32_t> face;
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (model.of_sheet[k] > 0.5) face.push_back(members[k]);
  }
  const bool as_wide = fit_plane(moments_of(cloud, face)).spread_area() >= kExtent * plane.spread_area();
  return as_wide ? face : members;
}

}  // namespace

void keep_sharp_faces(const Cloud& cloud, double noise, Regions& regions) {
  if (!cloud.sensors.known()) return;
  const auto points = points_of_regions(regions.of_point, regions.planes.size());
  bool changed = false;
  for (std::size_t r = 0; r < points.size(); ++r) {
    if (points[r].size() < kFewest) continue;
    const PlaneFit plane = fit_plane(moments_of(cloud, points[r]));
    if (plane.spread_area() > kLargePlane) continue;
    const double cosine = slant_of(cloud, plane.normal, points[r]).value_or(1), across = std::max(kFinest, noise_across(noise, cosine));
    if (cosine > kSlant || plane.rmse() < kTooThick * across) continue;
    const std::vector<std::uint32_t> face = sharp_face(cloud, plane, across, points[r]);
    if (face.size() == points[r].size()) continue;
    for (const std::uint32_t i : points[r]) regions.of_point[i] = -1;
    for (const std::uint32_t i : face) regions.of_point[i] = static_cast<std::int32_t>(r);
    changed = true;
  }
  if (changed) refit(cloud, regions);
}

}  // namespace scenelore::perception
