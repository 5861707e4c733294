#include "bridge_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gap.hpp"
#include "merge.hpp"
#include "rectangle_pair.hpp"
#include "scenelore/perception/hull.hpp"
#include "support.hpp"

namespace scenelore::perception {
namespace {

constexpr double kLargest = 4;                      // m²
constexpr double kLongest = 2.4;                    // metres; longer tables are rarer than two in a row
constexpr double kWidest = 1;                       // metres, of a shadow
constexpr double kSameHeight = 0.007;               // metres
constexpr double kInLine = 0.985;                   // cosine of 10 degrees
constexpr double kSameFace = 0.0015;                // metres, and kOffByChance deviations
constexpr double kOffByChance = 3;
constexpr double kDeviations = 2.5;                 // of a plane's points: what is further behind it is not on it
constexpr double kLeastBehind = 0.01;               // metres
constexpr double kEdge = 0.05;                      // metres, thicker than the edge of a desk and than noise
constexpr double kLeastEmpty = 0.08;                // m² of the rectangle that may have been looked through,
constexpr double kEmptyShare = 0.1;                 // or this share of what is held

struct Piece {
  std::size_t region;
  std::vector<std::uint32_t> points;
  Moments moments;
  PlaneFit plane;  ///< of the moments
  double noise;    ///< metres
};

/// By how much two planes are off each other by chance, metres squared: the variance of the larger one's height at the middle of the smaller.
double variance_of_offset(const PlaneFit& larger, const PlaneFit& smaller) {
  const double away = (smaller.centroid - larger.centroid).squaredNorm() / std::max(larger.variances[1], 1e-6);
  const auto of_mean = [](const PlaneFit& plane) { return std::max(plane.variances[0], 1e-8) / plane.count; };
  return of_mean(larger) * (1 + away) + of_mean(smaller);
}

class Bridge {
 public:
  Bridge(const Cloud& cloud, const Eigen::Vector3d& up, const Limits& limits)
      : cloud_(cloud), up_(up), widest_(std::min(kWidest, limits.max_point_distance)) {}

  [[nodiscard]] bool level(const PlaneFit& plane) const { return std::abs(plane.normal.dot(up_)) > kLevel; }
  /// The one with more points first.
  [[nodiscard]] bool joins(const Piece& larger, const Piece& smaller) const;

 private:
  [[nodiscard]] bool in_one_top(const Piece& a, const Piece& b) const;
  [[nodiscard]] bool in_one_face(const Piece& larger, const Piece& smaller) const;
  [[nodiscard]] bool fit_one_table(const PlaneView& view) const;
  [[nodiscard]] bool only_shadow_between(const PlaneFit& plane, PlaneView view, std::size_t of_first) const;
  [[nodiscard]] bool in_one_rectangle(const PlaneFit& plane, PlaneView view) const;

  const Cloud& cloud_;
  Eigen::Vector3d up_;
  double widest_;
};

bool Bridge::in_one_top(const Piece& a, const Piece& b) const {
  const Eigen::Vector3d apart = a.moments.mean() - b.moments.mean();
  return std::abs(up_.dot(apart)) < kSameHeight && apart.norm() < kLongest;
}

bool Bridge::in_one_face(const Piece& larger, const Piece& smaller) const {
  if (std::abs(larger.plane.normal.dot(smaller.plane.normal)) < kInLine) return false;
  const double by_chance = kOffByChance * std::sqrt(variance_of_offset(larger.plane, smaller.plane));
  return std::abs(larger.plane.distance(smaller.plane.centroid)) < kSameFace + by_chance;
}

bool Bridge::fit_one_table(const PlaneView& view) const {
  const Rectangle around = minimum_rectangle(view.held);
  const double length = around.length + view.edge, width = around.width + view.edge;
  return length < kLongest && length * width < kLargest;
}

/// The first points of the view, so many, are those of one piece.
bool Bridge::only_shadow_between(const PlaneFit& plane, PlaneView view, std::size_t of_first) const {
  std::vector<bool> first(view.held.size(), false);
  for (std::size_t k = 0; k < of_first; ++k) first[view.cell_of[k]] = true;
  PieceCells cells(2);
  for (std::size_t c = 0; c < first.size(); ++c) cells[first[c] ? 0 : 1].push_back(c);
  if (cells[1].empty()) return false;
  look_past(cloud_, plane, std::max(kDeviations * plane.rmse(), kLeastBehind), view);
  const Gap gap(view, cells);
  return gap.width(0, 1) < widest_ && !gap.seen_through(0, 1);
}

bool Bridge::in_one_rectangle(const PlaneFit& plane, PlaneView view) const {
  look_past(cloud_, plane, kEdge, view);
  std::vector<std::size_t> all(view.held.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::optional<RectanglePair> rectangle = best_rectangle_pair(view, all);
  const double held = static_cast<double>(all.size()) * view.edge * view.edge;
  return !rectangle || rectangle->empty_one < std::max(kLeastEmpty, kEmptyShare * held);
}

bool Bridge::joins(const Piece& larger, const Piece& smaller) const {
  const bool tops = level(larger.plane);
  if (tops != level(smaller.plane) || !(tops ? in_one_top(larger, smaller) : in_one_face(larger, smaller))) return false;
  if (joint_deviation(larger.moments, larger.noise, smaller.moments, smaller.noise) >= kMostDeviation) return false;
  Moments moments = larger.moments;
  moments += smaller.moments;
  const PlaneFit plane = fit_plane(moments);
  if (tops != level(plane)) return false;
  std::vector<std::uint32_t> points = larger.points;
  points.insert(points.end(), smaller.points.begin(), smaller.points.end());
  const PlaneView view = view_of(cloud_, plane, points, gap_cell(plane.spread_area(), static_cast<double>(points.size())));
  if (tops && !fit_one_table(view)) return false;
  const bool wall = !tops && std::max(larger.plane.spread_area(), smaller.plane.spread_area()) >= kLargePlane;
  return only_shadow_between(plane, view, larger.points.size()) && (wall || in_one_rectangle(plane, view));
}

/// Largest first.
std::vector<Piece> pieces_of(const Cloud& cloud, const Bridge& bridge, const Limits& limits, const std::vector<double>& noise, const Regions& regions) {
  std::vector<std::vector<std::uint32_t>> points = points_of_regions(regions.of_point, regions.planes.size());
  std::vector<Piece> pieces;
  for (std::size_t r = 0; r < points.size(); ++r) {
    const PlaneFit& plane = regions.planes[r];
    if (plane.count <= 0 || static_cast<double>(points[r].size()) < limits.min_points || (bridge.level(plane) && plane.spread_area() > kLargest)) continue;
    const Moments moments = moments_of(cloud, points[r]);
    pieces.push_back({r, std::move(points[r]), moments, fit_plane(moments), noise[r]});
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.points.size() > b.points.size(); });
  return pieces;
}

}  // namespace

std::vector<std::int32_t> bridge_pieces(const Cloud& cloud, const Eigen::Vector3d& up, const Limits& limits, const std::vector<double>& noise,
                                        const Regions& regions) {
  std::vector<std::int32_t> into(regions.planes.size());
  std::iota(into.begin(), into.end(), 0);
  if (!cloud.sensors.known()) return into;
  const Bridge bridge(cloud, up, limits);
  std::vector<Piece> pieces = pieces_of(cloud, bridge, limits, noise, regions);
  for (std::size_t a = 0; a < pieces.size(); ++a) {
    for (std::size_t b = a + 1; b < pieces.size();) {
      if (!bridge.joins(pieces[a], pieces[b])) {
        ++b;
        continue;
      }
      into[pieces[b].region] = static_cast<std::int32_t>(pieces[a].region);
      pieces[a].points.insert(pieces[a].points.end(), pieces[b].points.begin(), pieces[b].points.end());
      pieces[a].moments += pieces[b].moments;
      pieces[a].plane = fit_plane(pieces[a].moments);
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(b));
      b = a + 1;  // the piece has grown
    }
  }
  return into;
}

}  // namespace scenelore::perception
