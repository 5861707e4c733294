#include "scenelore/perception/upright.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scenelore/perception/error.hpp"
#include "words.hpp"

namespace scenelore::perception {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kMostTilt = 35 * kDegree;     // of the file's z; a camera's own frame needs --up
constexpr double kGate = 3 * kDegree;          // planes that agree with a direction
constexpr double kTrusted = 0.8;               // of the best direction's support: the file's z is kept
constexpr double kWallWeight = 0.5;            // walls bind one angle of two
constexpr double kSmallest = 0.05;             // m², planes smaller than this say little about up
constexpr double kFullSay = 1;                 // m², from about here on a plane's own accuracy matters less than its neighbours' bends
constexpr double kSlanted = 10 * kDegree;      // neither level nor upright, in any scan
constexpr double kFinest = 0.3 * kDegree, kCoarsest = 2 * kDegree;  // how much planes of a scan differ, at least and at most

double weight_of(const PlaneFit& plane) { return std::min(plane.spread_area(), 20.0); }

/// The sum that a direction is judged by: area of the planes across it and along it.
double support(std::span<const PlaneFit> planes, const Eigen::Vector3d& up) {
  double sum = 0;
  for (const PlaneFit& plane : planes) {
    if (plane.spread_area() < kSmallest) continue;
    const double c = std::abs(plane.normal.dot(up));
    if (c > std::cos(kGate)) sum += weight_of(plane);
    if (c < std::sin(kGate)) sum += kWallWeight * weight_of(plane);
  }
  return sum;
}

/// Directions worth judging: normals near z, and what is at right angles to two walls.
std::vector<Eigen::Vector3d> candidates(std::span<const PlaneFit> planes) {
  std::vector<Eigen::Vector3d> result{Eigen::Vector3d::UnitZ()};
  std::vector<Eigen::Vector3d> walls;
  const auto consider = [&](Eigen::Vector3d direction) {
    if (direction.z() < 0) direction = -direction;
    if (direction.z() > std::cos(kMostTilt)) result.push_back(direction);
  };
  for (const PlaneFit& plane : planes.first(std::min<std::size_t>(planes.size(), 60))) {
    if (plane.spread_area() < 4 * kSmallest) continue;
    consider(plane.normal);
    if (std::abs(plane.normal.z()) < std::sin(kMostTilt) && walls.size() < 12) walls.push_back(plane.normal);
  }
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::Vector3d cross = walls[i].cross(walls[j]);
      if (cross.norm() > 0.5) consider(cross.normalized());
    }
  }
  return result;
}

struct Estimate {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  double uncertainty = 0;  ///< radians
  int level = 0, walls = 0;
  double share = 0;        ///< of the area of all planes that agrees
};

/// A plane held against a direction.
struct Vote {
  const PlaneFit* plane = nullptr;
  bool level = false;  ///< nearer to level than to upright
  double angle = 0;    ///< radians off level, or off upright
  double weight = 0;   ///< 0 for what is neither
};

/// What a plane's word is worth: sizes count up to a square metre or so. The walls of a room differ from each other by how they
/// were built and by how the sensor bends space, in which a large one is as wrong as a small one (the weights of a random
/// effects model, DerSimonian & Laird 1986, with a plane's own variance as the inverse of its area).
double say_of(const PlaneFit& plane) { return plane.spread_area() / (plane.spread_area() + kFullSay); }

std::vector<Vote> votes(std::span<const PlaneFit> planes, const Eigen::Vector3d& up) {
  std::vector<Vote> result;
  for (const PlaneFit& plane : planes) {
    if (plane.spread_area() < kSmallest) continue;
    const double c = std::min(1.0, std::abs(plane.normal.dot(up)));
    const bool level = c > std::numbers::sqrt2 / 2;
    const double angle = level ? std::acos(c) : std::asin(c);
    result.push_back({&plane, level, angle, angle > kSlanted ? 0 : (level ? 1 : kWallWeight) * say_of(plane)});
  }
  return result;
}

/// Half of the votes lie within this angle. 0 without votes.
double median_angle(std::vector<Vote> votes) {
  std::sort(votes.begin(), votes.end(), [](const Vote& a, const Vote& b) { return a.angle < b.angle; });
  double whole = 0, sum = 0;
  for (const Vote& vote : votes) whole += vote.weight;
  for (const Vote& vote : votes) {
    sum += vote.weight;
    if (whole > 0 && sum >= whole / 2) return vote.angle;
  }
  return 0;
}

/// up maximises Σ w (n·up)² over level planes and minimises it over walls, with w of Cauchy's M-estimator: a plane that is off
/// by more than planes of this scan mostly are counts little, but in a scan bent by degrees no one plane decides alone.
/// Iteratively reweighted least squares (Holland & Welsch 1977: 2.385 for 95 % efficiency, scale from the median).
Eigen::Vector3d reweighted(std::span<const PlaneFit> planes, Eigen::Vector3d up) {
  for (int round = 0; round < 50; ++round) {
    const std::vector<Vote> all = votes(planes, up);
    const double scale = std::clamp(2.385 * 1.4826 * median_angle(all), kFinest, kCoarsest);
    Eigen::Matrix3d cost = Eigen::Matrix3d::Zero();
    for (const Vote& vote : all) {
      const double w = vote.weight / (1 + vote.angle * vote.angle / (scale * scale));
      const Eigen::Matrix3d along = vote.plane->normal * vote.plane->normal.transpose();
      cost += w * (vote.level ? Eigen::Matrix3d(Eigen::Matrix3d::Identity() - along) : along);
    }
    if (cost.isZero(0)) return up;
    Eigen::Vector3d next = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(cost).eigenvectors().col(0);
    if (next.dot(up) < 0) next = -next;
    const bool settled = (next - up).norm() < 1e-7;
    up = next;
    if (settled) break;
  }
  return up.z() < 0 ? Eigen::Vector3d(-up) : up;
}

Estimate refined(std::span<const PlaneFit> planes, const Eigen::Vector3d& up) {
  Estimate result{.up = reweighted(planes, up)};
  double squares = 0, weights = 0, weight_squares = 0, all = 0, agreeing = 0;
  for (const Vote& vote : votes(planes, result.up)) {
    const double area = weight_of(*vote.plane);
    all += area;
    if (vote.angle > kGate) continue;
    squares += vote.weight * vote.angle * vote.angle;
    weights += vote.weight;
    weight_squares += vote.weight * vote.weight;
    agreeing += area;
    ++(vote.level ? result.level : result.walls);
  }
  if (weights <= 0) return result;
  const double effective = weights * weights / weight_squares;  // number of planes that count
  result.uncertainty = std::sqrt(squares / weights / effective) + 0.1 * kDegree;
  result.share = agreeing / all;
  return result;
}

/// How far above a hidden floor the lowest points can lie: a view of a table top from above shows nothing below it.
constexpr double kTallestFurniture = 1.2;

struct Floor {
  double level = 0;
  bool found = false;
  double area = 0;
};

/// Of several positions the middle one, by points: some may be wrong, or on another storey.
std::optional<double> sensor_height(const Cloud& cloud, const Eigen::Vector3d& up) {
  const SensorPositions& sensors = cloud.sensors;
  if (sensors.single()) return up.dot(sensors.positions().front());
  if (!sensors.known()) return std::nullopt;
  std::vector<std::size_t> points(sensors.positions().size() + 1, 0);
  for (std::size_t i = 0; i < cloud.size(); ++i) points[sensors.of_point(i)] += cloud.valid(i);
  std::vector<std::pair<double, std::size_t>> heights;
  std::size_t all = 0, lower = 0;
  for (std::size_t s = 0; s < sensors.positions().size(); ++s) heights.emplace_back(up.dot(sensors.positions()[s]), points[s]), all += points[s];
  std::sort(heights.begin(), heights.end());
  for (const auto& [height, count] : heights) {
    lower += count;
    if (2 * lower > all) return height;
  }
  return std::nullopt;
}

/// The lowest large level plane that the cloud does not go on below. With several levels the lowest counts that has at
/// least 15 % of the area of the largest.
Floor find_floor(const Cloud& cloud, std::span<const PlaneFit> planes, const Eigen::Quaterniond& rotation) {
  const Eigen::Vector3d up = rotation.inverse() * Eigen::Vector3d::UnitZ();
  std::vector<double> heights;
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / 20000);
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    if (cloud.valid(i)) heights.push_back(up.dot(cloud.position(i)));
  }
  if (heights.empty()) return {};
  std::sort(heights.begin(), heights.end());
  const std::optional<double> sensor = sensor_height(cloud, up);
  const auto below = [&](double z) {
    return static_cast<double>(std::lower_bound(heights.begin(), heights.end(), z) - heights.begin()) / static_cast<double>(heights.size());
  };
  std::vector<std::pair<double, double>> levels;  // height, area
  double largest = 0;
  for (const PlaneFit& plane : planes) {
    if (std::abs(plane.normal.dot(up)) < std::cos(kSlanted) || plane.spread_area() < 0.3) continue;
    const double z = up.dot(cloud.origin + plane.centroid);
    // Under a floor there are stray points at most; under a ceiling there is the room.
    if (below(z - 0.25) > 0.05 || below(z + 0.25) > 0.9) continue;
    if (sensor && *sensor < z) continue;
    levels.emplace_back(z, plane.spread_area());
    largest = std::max(largest, plane.spread_area());
  }
  std::sort(levels.begin(), levels.end());
  for (const auto& [z, area] : levels) {
    if (area >= 0.15 * largest) return {z, true, area};
  }
  return {heights[heights.size() / 1000], false, 0};
}

}  // namespace

Upright estimate_upright(const Cloud& cloud, std::span<const PlaneFit> planes, const std::optional<Eigen::Vector3d>& up,
                         const std::optional<double>& floor_z) {
  Upright result;
  Estimate estimate;
  if (up) {
    if (!up->allFinite() || up->norm() < 1e-9) throw Error("the up direction has no length; give three numbers such as 0 0 1");
    estimate.up = up->normalized();
    result.explanation = "Up was given";
    result.confidence = 1;
  } else {
    std::vector<Eigen::Vector3d> directions = candidates(planes);
    double best = -1;
    for (const Eigen::Vector3d& direction : directions) {
      const double sum = support(planes, direction);
      if (sum > best) best = sum, estimate.up = direction;
    }
    // Most files are levelled, and depth cameras bend walls by degrees: only clearly better evidence overrules the file.
    if (support(planes, Eigen::Vector3d::UnitZ()) >= kTrusted * best) estimate.up = Eigen::Vector3d::UnitZ();
    estimate = refined(planes, estimate.up);
    const double tilt = std::acos(std::min(1.0, estimate.up.z()));
    result.confidence = estimate.level + estimate.walls == 0 ? 0.1 : std::min(1.0, estimate.share) * (1 - 0.5 / (estimate.level + estimate.walls));
    if (estimate.level + estimate.walls == 0) {
      result.explanation = "No plane tells which way is up; the file's z axis was taken";
    } else {
      result.explanation = "Up follows from " + count_of(estimate.level, "level plane") + " and " + count_of(estimate.walls, "upright plane");
      // Rotating a well-levelled scan by less than the estimate is worth would only blur its coordinates.
      const bool as_is = tilt <= std::min(2 * estimate.uncertainty + 0.1 * kDegree, 1.0 * kDegree);
      if (as_is) estimate.up = Eigen::Vector3d::UnitZ();
      result.explanation += as_is ? "; the file's z axis is level within " + fixed(std::max(tilt, estimate.uncertainty) / kDegree, 1) + " degrees"
                                  : "; the file's z axis is " + fixed(tilt / kDegree, 1) + " degrees off and was put right";
    }
  }
  result.rotation = estimate.up.z() < -0.999999 ? Eigen::Quaterniond(0, 1, 0, 0)
                                                : Eigen::Quaterniond::FromTwoVectors(estimate.up, Eigen::Vector3d::UnitZ());
  if (estimate.up == Eigen::Vector3d::UnitZ()) result.rotation = Eigen::Quaterniond::Identity();
  if (floor_z) {
    if (!std::isfinite(*floor_z)) throw Error("the floor level is not a number");
    result.floor_z = *floor_z;
    result.floor_found = true;
    result.explanation += "; the floor level was given.";
    return result;
  }
  const Floor floor = find_floor(cloud, planes, result.rotation);
  result.floor_z = floor.level;
  result.floor_found = floor.found;
  if (floor.found) {
    result.explanation += "; the floor is a plane of " + fixed(floor.area, 1) + " m² at z = " + fixed(floor.level, 2) + ".";
    return result;
  }
  result.confidence *= 0.7;
  // A scan that somebody has levelled mostly has the floor at zero, seen or not; a sensor's own frame has it far below zero.
  const bool levelled = estimate.up == Eigen::Vector3d::UnitZ() && floor.level > -0.1 && floor.level < kTallestFurniture;
  if (levelled) {
    result.floor_z = 0;
    result.explanation += "; no floor is visible, the file's zero level, " + fixed(std::max(0.0, floor.level), 2) +
                          " m below the lowest points, was taken for it.";
  } else {
    result.explanation += "; no floor is visible, heights count from the lowest points at z = " + fixed(floor.level, 2) + ".";
  }
  return result;
}

}  // namespace scenelore::perception
