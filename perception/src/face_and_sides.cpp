#include "face_and_sides.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "seen_from.hpp"

namespace scenelore::perception {
namespace {

constexpr double kWindow = 0.04;       // metres along the front, in which the nearest point is the front
constexpr double kMostWindows = 1 << 18;
constexpr double kPretended = 4;       // points of each step that are as the region's are
constexpr int kFewestPasses = 5, kPasses = 20;
constexpr double kSettled = 0.01;      // of the deviation
constexpr std::size_t kEnough = 1500;  // points that the mixture is found with

/// The face as d over (1, u, v); the region's plane where it is turned against that by nearly a right angle.
Eigen::Vector3d in_frame(const PlaneFit& plane, const PlaneEquation& face) {
  const double steep = face.normal.dot(plane.normal);
  if (std::abs(steep) < 0.1) return Eigen::Vector3d::Zero();
  return -Eigen::Vector3d(face.distance(plane.centroid), face.normal.dot(plane.axes.col(1)), face.normal.dot(plane.axes.col(2))) / steep;
}

}  // namespace

FaceAndSides::FaceAndSides(const Cloud& cloud, const PlaneFit& plane, const PlaneEquation& start, double noise, double least_scale,
                           const std::vector<std::uint32_t>& members)
    : face_(in_frame(plane, start)) {
  see(cloud, plane, noise, members);
  for (const Seen& s : points_) {
    behind_ = std::max({behind_, -before(s), 3 * s.sigma});
    before_ = std::max({before_, before(s), 3 * s.sigma});
  }
  shares_.fill({0.6, 0.2, 0.2});
  const std::vector<Seen> few = some();
  for (int pass = 1; pass <= kPasses; ++pass) {
    if (improve(few, least_scale) < kSettled && pass >= kFewestPasses) break;
  }
}

void FaceAndSides::see(const Cloud& cloud, const PlaneFit& plane, double noise, const std::vector<std::uint32_t>& members) {
  struct Way {
    std::size_t sensor;
    double angle, length;  ///< along the plane
  };
  std::vector<Way> ways;
  const Eigen::Vector3d along = plane.axes.col(1), across = plane.axes.col(2);
  double longest = 0;
  for (const std::uint32_t i : members) {
    const std::size_t position = cloud.sensors.of_point(i);
    if (position >= cloud.sensors.positions().size()) {
      points_.clear();
      return;
    }
    const Eigen::Vector3d point = cloud.offset(i).cast<double>() - plane.centroid;
    const Eigen::Vector3d ray = point + plane.centroid - (cloud.sensors.positions()[position] - cloud.origin);
    const double towards = ray.dot(plane.normal) < 0 ? 1 : -1, slant = std::abs(ray.dot(plane.normal)) / ray.norm();
    points_.push_back({point.dot(along), point.dot(across), point.dot(plane.normal), towards, std::max(kFinestAcross, noise_across(noise, slant)), 0});
    ways.push_back({position, std::atan2(ray.dot(across), ray.dot(along)), std::hypot(ray.dot(along), ray.dot(across))});
    longest = std::max(longest, ways.back().length);
  }
  const double windows = std::min(longest / kWindow, kMostWindows);  // a radian; few for sensors that are nowhere near
  const long most = std::lround(std::numbers::pi * windows) + 1;
  const auto direction = [&](const Way& way) {
    const double d = way.angle * windows;
    return std::abs(d) <= static_cast<double>(most) ? static_cast<std::size_t>(std::lround(d) + most) : 0;  // nor what is no number
  };
  std::map<std::size_t, std::vector<double>> fronts;  // by place of the sensor, by direction: the nearest point
  for (const Way& way : ways) {
    std::vector<double>& front = fronts[way.sensor];
    if (front.empty()) front.assign(static_cast<std::size_t>(2 * most + 1), std::numeric_limits<double>::infinity());
    double& nearest = front[direction(way)];
    nearest = std::min(nearest, way.length);
  }
  const double step = std::max(noise, kFinestAcross);
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const double behind = (ways[k].length - fronts.at(ways[k].sensor)[direction(ways[k])]) / step;
    points_[k].step = std::min(static_cast<std::size_t>(behind), kSteps);
  }
}

/// About as many points as are enough, from all over the region.
std::vector<FaceAndSides::Seen> FaceAndSides::some() const {
  if (points_.size() <= kEnough) return points_;
  const auto share = static_cast<std::uint32_t>(std::numeric_limits<std::uint32_t>::max() / static_cast<double>(points_.size()) * kEnough);
  std::vector<Seen> out;
  for (std::uint32_t k = 0; k < points_.size(); ++k) {
    if (k * 2654435761U < share) out.push_back(points_[k]);  // Fibonacci hashing (Knuth 1973, section 6.4): no step that lines of a scan might share
  }
  return out;
}

/// How far before the face, metres.
double FaceAndSides::before(const Seen& s) const { return s.towards * (s.d - face_.dot(Eigen::Vector3d(1, s.u, s.v))); }

/// Probabilities.
FaceAndSides::Shares FaceAndSides::parts(const Seen& s) const {
  const double sigma = scale_ * s.sigma, z = before(s) / sigma, beyond = 0.5 * std::erfc(z / std::numbers::sqrt2);
  const Shares& share = shares_[s.step];
  const double peak = 0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2 / sigma;
  Shares out{share[kFace] * peak * std::exp(-0.5 * z * z), share[kBehind] * beyond / behind_, share[kBefore] * (1 - beyond) / before_};
  const double sum = out[kFace] + out[kBehind] + out[kBefore];
  for (double& part : out) part /= sum;
  return out;
}

/// One pass of expectation and maximisation; by how much the deviation changed, as a share of it.
double FaceAndSides::improve(const std::vector<Seen>& points, double least_scale) {
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
  share_ = n / static_cast<double>(points.size());
  share_out(held, static_cast<double>(points.size()));
  return change;
}

/// Each step also counts its neighbours, by half, and some points as the whole region has them.
void FaceAndSides::share_out(const std::array<Shares, kSteps + 1>& held, double points) {
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

}  // namespace scenelore::perception
