#include "sharp_faces.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "face_and_sides.hpp"
#include "scenelore/perception/parallel.hpp"
#include "seen_from.hpp"

namespace scenelore::perception {
namespace {

constexpr double kSlant = 0.5;        // cosine of 60 degrees, between ray and normal
constexpr std::size_t kFewest = 40;   // points
constexpr double kTooThick = 2;       // deviation across, of what the noise explains
constexpr int kTriples = 200;
constexpr double kWidestTriple = 0.1;  // of the plane's area, twice the triangle's, at least
constexpr double kReach = 2.5;        // deviations
constexpr double kSharpest = 0.1;     // deviation of the face, of what its noise explains, at least
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

/// The points of the face in a region that is thicker than its noise; all of them where no sharp face stands out.
std::vector<std::uint32_t> sharp_face(const Cloud& cloud, const PlaneFit& plane, double noise, double across, const std::vector<std::uint32_t>& members) {
  Points points;
  for (const std::uint32_t i : members) points.push_back(cloud.offset(i).cast<double>());
  const PlaneEquation start = densest(points, plane, kReach * across, kWidestTriple * plane.spread_area());
  const FaceAndSides told(cloud, plane, start, noise, kSharpest, members);
  std::vector<std::uint32_t> face;
  for (std::size_t k = 0; k < told.size(); ++k) {
    if (told.of_face(k) > 0.5) face.push_back(members[k]);
  }
  if (static_cast<double>(face.size()) < kShare * static_cast<double>(members.size())) return members;
  const PlaneFit fit = fit_plane(moments_of(cloud, face));
  return fit.rmse() <= kSharper * plane.rmse() && fit.spread_area() >= kExtent * plane.spread_area() ? face : members;
}

}  // namespace

void keep_sharp_faces(const Cloud& cloud, double noise, Regions& regions, int threads) {
  if (!cloud.sensors.known()) return;
  const auto points = points_of_regions(regions.of_point, regions.planes.size());
  std::atomic<bool> changed = false;
  const auto keep = [&](std::size_t r) {
    if (points[r].size() < kFewest) return;
    const PlaneFit plane = fit_plane(moments_of(cloud, points[r]));
    if (plane.spread_area() > kLargePlane) return;
    const double cosine = slant_of(cloud, plane.normal, points[r]).value_or(1), across = std::max(kFinestAcross, noise_across(noise, cosine));
    if (cosine > kSlant || plane.rmse() < kTooThick * across) return;
    const std::vector<std::uint32_t> face = sharp_face(cloud, plane, noise, across, points[r]);
    if (face.size() == points[r].size()) return;
    for (const std::uint32_t i : points[r]) regions.of_point[i] = -1;
    for (const std::uint32_t i : face) regions.of_point[i] = static_cast<std::int32_t>(r);
    changed = true;
  };
  parallel_pieces(points.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) keep(r);
  });
  if (changed) refit(cloud, regions);
}

}  // namespace scenelore::perception
