#include "face_and_sides.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "seen_from.hpp"

namespace scenelore::perception {
namespace {

constexpr double kWindow = 0.04;     // metres along the front, in which the nearest point is the front
constexpr std::size_t kSteps = 12;   // of one deviation of ranges each; what is further behind the front is one more
constexpr std::size_t kFront = 6;    // steps
constexpr double kPretended = 4;     // points of each step that are as the region's are
constexpr int kPasses = 20;
constexpr std::size_t kEnough = 1500;  // points that the mixture is found with
constexpr double kSettled = 0.01;    // of the deviation

/// Of the face, of what lies on its far side as the sensor sees it, or of what lies before it.
enum Part : std::size_t { kFace, kBehind, kBefore, kParts };
using Shares = std::array<double, kParts>;

/// A point in the frame of the region's plane.
struct Seen {
  double u = 0, v = 0, d = 0;  ///< metres; d across the plane
  double towards = 1;          ///< the sign of d on the sensor's side
  double sigma = 0;            ///< of d, by noise
  std::size_t step = 0;        ///< how far behind the front
};

std::vector<Seen> seen_points(const Cloud& cloud, const PlaneFit& plane, double noise, const std::vector<std::uint32_t>& members) {
  struct Way {
    std::size_t sensor;
    double angle, length;  ///< along the plane
  };
  std::vector<Seen> out;
  std::vector<Way> ways;
  const Eigen::Vector3d along = plane.axes.col(1), across = plane.axes.col(2);
  double longest = 0;
  for (const std::uint32_t i : members) {
    const std::size_t position = cloud.sensors.of_point(i);
    if (position >= cloud.sensors.positions().size()) return {};
    const Eigen::Vector3d point = cloud.offset(i).cast<double>() - plane.centroid;
    const Eigen::Vector3d ray = point + plane.centroid - (cloud.sensors.positions()[position] - cloud.origin);
    const double towards = ray.dot(plane.normal) < 0 ? 1 : -1, slant = std::abs(ray.dot(plane.normal)) / ray.norm();
    out.push_back({point.dot(along), point.dot(across), point.dot(plane.normal), towards, std::max(kFinestAcross, noise_across(noise, slant)), 0});
    ways.push_back({position, std::atan2(ray.dot(across), ray.dot(along)), std::hypot(ray.dot(along), ray.dot(across))});
    longest = std::max(longest, ways.back().length);
  }
  std::map<std::pair<std::size_t, long>, double> fronts;
  const auto front_of = [&](const Way& way) -> double& {
    return fronts.try_emplace({way.sensor, std::lround(way.angle * longest / kWindow)}, way.length).first->second;
  };
  for (const Way& way : ways) {
    double& front = front_of(way);
    front = std::min(front, way.length);
  }
  const double step = std::max(noise, kFinestAcross);
  for (std::size_t k = 0; k < out.size(); ++k) out[k].step = std::min(static_cast<std::size_t>((ways[k].length - front_of(ways[k])) / step), kSteps);
  return out;
}

class Mixture {
 public:
  Mixture(const std::vector<Seen>& points, const Eigen::Vector3d& face) : face_(face) {
    for (const Seen& s : points) {
      behind_ = std::max({behind_, -before(s), 3 * s.sigma});
      before_ = std::max({before_, before(s), 3 * s.sigma});
    }
    shares_.fill({0.6, 0.2, 0.2});
  }

  /// How far before the face, metres.
  [[nodiscard]] double before(const Seen& s) const { return s.towards * (s.d - face_.dot(Eigen::Vector3d(1, s.u, s.v))); }

  [[nodiscard]] Shares parts(const Seen& s) const {
    const double sigma = scale_ * s.sigma, z = before(s) / sigma, beyond = 0.5 * std::erfc(z / std::numbers::sqrt2);
    const Shares& share = shares_[s.step];
    const double peak = 0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2 / sigma;
    Shares out{share[kFace] * peak * std::exp(-0.5 * z * z), share[kBehind] * beyond / behind_, share[kBefore] * (1 - beyond) / before_};
    const double sum = out[kFace] + out[kBehind] + out[kBefore];
    for (double& part : out) part /= sum;
    return out;
  }

  /// One pass of expectation and maximisation; by how much the deviation changed, as a share of it.
  double improve(const std::vector<Seen>& points, double least_scale) {
    Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    std::array<Shares, kSteps + 1> held{};
    double squares = 0, n = 0;
    for (const Seen& s : points) {
      const Shares part = parts(s);
      for (std::size_t p = 0; p < kParts; ++p) held[s.step][p] += part[p];
      const double weight = part[kFace] / (s.sigma * s.sigma), d = before(s);
      const Eigen::Vector3d x(1, s.u, s.v);
      left += weight * x * x.transpose();
      right += weight * s.d * x;
      squares += weight * d * d;
      n += part[kFace];
    }
    if (!(n > 3)) return 0;
    const double scale = std::max(least_scale, std::sqrt(squares / n)), change = std::abs(scale - scale_) / scale_;
    scale_ = scale;
    face_ = left.ldlt().solve(right);
    share_out(held, static_cast<double>(points.size()));
    return change;
  }

 private:
  /// Each step also counts its neighbours, by half, and some points as the whole region has them.
  void share_out(const std::array<Shares, kSteps + 1>& held, double points) {
    for (std::size_t step = 0; step <= kSteps; ++step) {
      double sum = 0;
      for (std::size_t p = 0; p < kParts; ++p) {
        double all = 0;
        for (const Shares& of : held) all += of[p];
        double& share = shares_[step][p] = kPretended * all / points + held[step][p];
        if (step < kSteps && step > 0) share += held[step - 1][p] / 2;
        if (step + 1 < kSteps) share += held[step + 1][p] / 2;
        sum += share;
      }
      for (double& share : shares_[step]) share /= sum;
    }
  }

  Eigen::Vector3d face_;             // d = face · (1, u, v)
  double scale_ = 1;                 // deviation of the face's points, of their noise
  double behind_ = 0, before_ = 0;   // how far the region reaches, metres
  std::array<Shares, kSteps + 1> shares_{};
};

/// About as many as are enough, from all over the region.
std::vector<Seen> some_of(const std::vector<Seen>& points) {
  if (points.size() <= kEnough) return points;
  const auto share = static_cast<std::uint32_t>(std::numeric_limits<std::uint32_t>::max() / static_cast<double>(points.size()) * kEnough);
  std::vector<Seen> out;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    if (k * 2654435761U < share) out.push_back(points[k]);  // Fibonacci hashing (Knuth 1973, section 6.4): no step that lines of a scan might share
  }
  return out;
}

/// The face as d over (1, u, v); the region's plane where it is turned against that by nearly a right angle.
Eigen::Vector3d in_frame(const PlaneFit& plane, const PlaneEquation& face) {
  const double steep = face.normal.dot(plane.normal);
  if (std::abs(steep) < 0.1) return Eigen::Vector3d::Zero();
  return -Eigen::Vector3d(face.distance(plane.centroid), face.normal.dot(plane.axes.col(1)), face.normal.dot(plane.axes.col(2))) / steep;
}

}  // namespace

std::vector<OfFace> points_of_face(const Cloud& cloud, const PlaneFit& plane, const PlaneEquation& start, double noise, double least_scale,
                                   const std::vector<std::uint32_t>& members) {
  const std::vector<Seen> points = seen_points(cloud, plane, noise, members);
  if (points.empty()) return {};
  Mixture mixture(points, in_frame(plane, start));
  const std::vector<Seen> some = some_of(points);
  for (int pass = 0; pass < kPasses; ++pass) {
    if (mixture.improve(some, least_scale) < kSettled && pass > 3) break;
  }
  std::vector<OfFace> out;
  for (const Seen& s : points) out.push_back({mixture.parts(s)[kFace], s.step < kFront});
  return out;
}

}  // namespace scenelore::perception
