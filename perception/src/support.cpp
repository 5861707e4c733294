#include "support.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "cell_index.hpp"
#include "seen_from.hpp"

namespace scenelore::perception {
namespace {

constexpr double kLeastNoise = 0.0015;  // metres
constexpr double kLowerLevel = 0.3;     // of the points of the main level
constexpr double kWindow = 0.006;       // metres, width of a peak of heights
constexpr double kMostSlope = 0.026;    // 1.5 degrees
constexpr std::size_t kMostHeights = 20'000;

/// The height of the support itself: the middle of the fullest window of 6 mm. With `lowest`, that of the lowest peak with
/// 30 % as many points, where a valley lies between: of two desks that stand side by side the lower one carries.
double main_level(std::vector<double> heights, bool lowest) {
  std::sort(heights.begin(), heights.end());
  std::vector<std::size_t> held(heights.size());  // samples in the window that ends at each one
  std::size_t best = 0;
  for (std::size_t from = 0, to = 0; to < heights.size(); ++to) {
    while (heights[to] - heights[from] > kWindow) ++from;
    held[to] = to - from + 1;
    if (held[to] > held[best]) best = to;
  }
  std::size_t peak = 0;
  for (std::size_t to = 0; lowest && to < best; ++to) {
    if (held[to] > held[peak]) peak = to;
    const bool valley = 2 * held[to] < held[peak] && held[peak] >= 20;
    if (valley && static_cast<double>(held[peak]) > kLowerLevel * static_cast<double>(held[best])) return heights[peak] - kWindow / 2;
  }
  return heights[best] - kWindow / 2;
}

/// Scatter below the level, where nothing lies: its mirror image is what the support would scatter without things on it.
/// By the quantile that is one deviation of a Gaussian, which edges and what stands behind hardly move.
double noise_below(const std::vector<Sample>& samples) {
  std::vector<double> below;
  for (const Sample& s : samples) {
    if (s.height < 0 && s.height > -0.05) below.push_back(-s.height);
  }
  if (below.size() < 5) return 0.003;
  const auto at = below.begin() + static_cast<std::ptrdiff_t>(0.683 * static_cast<double>(below.size()));
  std::nth_element(below.begin(), at, below.end());
  return std::max(kLeastNoise, *at);
}

/// At most kMostHeights points, evenly picked: level, slope and noise need no more.
std::vector<Sample> some_samples(const Cloud& cloud, const Support& support, const std::vector<std::uint32_t>& points) {
  std::vector<Sample> samples;
  const std::size_t step = 1 + points.size() / kMostHeights;
  samples.reserve(points.size() / step + 1);
  for (std::size_t k = 0; k < points.size(); k += step) samples.push_back(support.sample(cloud, points[k]));
  return samples;
}

/// Means of the samples in squares of 8 cm. A board hangs closer before its wall than single points scatter; means do not.
std::vector<Sample> means_by_square(const std::vector<Sample>& samples) {
  constexpr double kSquare = 0.08, kFewest = 8;
  std::vector<CellKey> keys;
  keys.reserve(samples.size());
  for (const Sample& s : samples) {
    keys.push_back(cell_key(static_cast<std::int64_t>(std::floor(s.at.x() / kSquare)), static_cast<std::int64_t>(std::floor(s.at.y() / kSquare)), 0));
  }
  const CellIndex squares(keys);
  std::vector<Sample> means;
  for (std::size_t c = 0; c < squares.size(); ++c) {
    const auto items = squares.items(c);
    const auto n = static_cast<double>(items.size());
    if (n < kFewest) continue;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    double height = 0;
    for (const std::uint32_t k : items) at += samples[k].at.cast<double>() / n, height += samples[k].height / n;
    means.push_back({samples[items.front()].point, at.cast<float>(), static_cast<float>(height)});
  }
  return means;
}

void find_level(Support& support, const std::vector<Sample>& samples) {
  std::vector<double> heights;
  heights.reserve(samples.size());
  for (const Sample& s : samples) heights.push_back(s.height);
  if (!heights.empty()) support.centroid += main_level(std::move(heights), support.level) * support.normal;
}

/// Whether the room lies on the side that a wall's normal points to; nothing where both sides hold much.
std::optional<bool> faces_the_room(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& points) {
  if (const std::optional<bool> front = seen_from_front(cloud, plane, points)) return front;
  constexpr std::size_t kLooks = 5000;
  constexpr double kClear = 0.1, kMost = 0.8;  // metres; share of the points off the plane
  double front = 0, back = 0;
  for (std::size_t i = 0; i < cloud.size(); i += 1 + cloud.size() / kLooks) {
    if (!cloud.valid(i)) continue;
    const double d = plane.distance(cloud.offset(i).cast<double>());
    front += d > kClear;
    back += d < -kClear;
  }
  if (std::max(front, back) < kMost * (front + back)) return std::nullopt;
  return front > back;
}

/// Tilts the frame to the least-squares plane of the samples near its level. A table that stands half a degree out of level
/// rises by a centimetre over its length, as much as what lies on it.
void follow_slope(Support& support, const std::vector<Sample>& samples) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const double near = support.level ? std::max(2.5 * support.noise, 0.006) : 0.006;
  for (const Sample& s : samples) {
    if (std::abs(s.height) > near) continue;
    const Eigen::Vector3d row(1, s.at.x(), s.at.y());
    normal += row * row.transpose();
    right += s.height * row;
  }
  if (normal(0, 0) < 30) return;
  // A pretended 30 points per square metre say that it is level.
  normal(1, 1) += 0.1 * normal(0, 0) * 0.01 + 0.3;
  normal(2, 2) += 0.1 * normal(0, 0) * 0.01 + 0.3;
  const Eigen::Vector3d fit = normal.ldlt().solve(right);
  Eigen::Vector2d slope(fit[1], fit[2]);
  if (slope.norm() > kMostSlope) slope *= kMostSlope / slope.norm();
  support.centroid += fit[0] * support.normal;
  const Eigen::Vector3d tilted = (support.normal - slope.x() * support.u - slope.y() * support.v).normalized();
  support.normal = tilted;
  support.u = (support.u - tilted * tilted.dot(support.u)).normalized();
  support.v = tilted.cross(support.u);
}

}  // namespace

std::optional<Support> make_support(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& points,
                                    const Eigen::Vector3d& up) {
  Support support;
  const double c = plane.normal.dot(up);
  support.level = std::abs(c) > kLevel;
  // Exact planes across the line of sight are steps of rounded distances; the next step is no board.
  if (!support.level && plane.rmse() < kExactDeviation) return std::nullopt;
  const std::optional<bool> faces = support.level ? c > 0 : faces_the_room(cloud, plane, points);
  if (!faces) return std::nullopt;
  // Things on a table tip the plane fitted to both; the table itself is level.
  support.normal = support.level ? up : *faces ? plane.normal : Eigen::Vector3d(-plane.normal);
  support.centroid = plane.centroid;
  support.u = (plane.axes.col(1) - support.normal * support.normal.dot(plane.axes.col(1))).normalized();
  support.v = support.normal.cross(support.u);
  for (int round = 0; round < 3; ++round) {
    std::vector<Sample> samples = some_samples(cloud, support, points);
    if (round == 0) {
      find_level(support, support.level ? samples : means_by_square(samples));
      samples = some_samples(cloud, support, points);
    }
    support.noise = noise_below(samples);
    follow_slope(support, support.level ? samples : means_by_square(samples));
  }
  support.noise = noise_below(some_samples(cloud, support, points));
  return support;
}

}  // namespace scenelore::perception
