#include "outline_edges.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "directions.hpp"
#include "point_hash.hpp"
#include "scenelore/perception/parallel.hpp"

namespace scenelore::perception {
namespace {

constexpr double kApart = 0.03;        // metres between places along an outline
constexpr double kBeyond = 0.05;       // metres off it, at least
constexpr double kBeyondSteps = 3;     // of the sensor, at least: cells beside one as near as two hold points of the plane itself
constexpr double kThick = 0.04;        // metres, half: thicker than a keyboard over its desk, and a board's edge
constexpr double kDeviations = 3;      // of the plane's own points, at least
constexpr double kEnough = 0.25;       // of an outline must have been looked at
constexpr double kAround = 0.25;       // metres from an outline to what lies around its edge, seen from where both are visible
constexpr double kTurn = 0.5;          // two planes that turn into one another do so by 60 to 120 degrees
constexpr double kUprightEdge = 0.9;   // within 26 degrees
constexpr double kShortestTurn = 0.3;  // metres of outline
constexpr double kUpper = 0.5;         // the upper edge faces up within 60 degrees
constexpr double kShortestTop = 0.1;   // metres
constexpr std::size_t kMostViews = 16;
constexpr std::size_t kMostPoints = 250'000;  // of a view; with that of a laser scanner they are 0.3 degrees apart

/// What was measured beyond a place of an outline. Of several poses the one that saw most decides: what hid the rest from
/// one hides nothing from the other, and a ray goes past an edge whose other side is not seen.
enum class Seen : std::uint8_t { not_looked_at, nothing, something_before, same_surface, past, around_the_edge };

struct Place {
  Eigen::Vector3d at;    // on the outline, in the cloud's offsets
  Eigen::Vector3d out;   // unit, in the plane
  double length = 0;     // metres of outline that it stands for
  Seen seen = Seen::not_looked_at;
  std::int32_t turn = -1;  // the plane around the edge
};

std::vector<Place> places_of(const Plane& plane, const Eigen::Vector3d& origin) {
  std::vector<Place> places;
  const Ring& ring = plane.hull.outer;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Eigen::Vector3d from = ring[k] - origin, along = ring[(k + 1) % ring.size()] - ring[k];
    const double length = along.norm();
    if (!(length > 0)) continue;
    const Eigen::Vector3d out = along.cross(plane.normal).normalized();  // the ring runs counter-clockwise
    const int parts = std::max(1, static_cast<int>(std::lround(length / kApart)));
    for (int part = 0; part < parts; ++part) places.push_back({from + (part + 0.5) / parts * along, out, length / parts, Seen::not_looked_at, -1});
  }
  return places;
}

/// The plane as one position of the sensor sees it: its distance from there counts as positive.
struct Facing {
  Eigen::Vector3d normal, centroid;
  double thick = 0;

  Facing(const Plane& plane, const Eigen::Vector3d& origin, const Eigen::Vector3d& eye)
      : normal(plane.normal), centroid(plane.centroid - origin), thick(std::max(kThick, kDeviations * plane.rmse)) {
    if (over(eye) < 0) normal = -normal;
  }
  [[nodiscard]] double over(const Eigen::Vector3d& p) const { return normal.dot(p - centroid); }
};

/// The planes of a scan from one position of the sensor.
struct Sight {
  const Cloud& cloud;
  Eigen::Vector3d up;  // in the scan's frame
  std::span<const std::int32_t> plane_of_point;
  const std::vector<Plane>& planes;
  const Eigen::Vector3d& eye;

  [[nodiscard]] Facing facing(std::size_t plane) const { return {planes[plane], cloud.origin, eye}; }

  /// Whether `plane` turns into `other` at a place of its outline: the other one starts there and leads back from an edge that
  /// points at the sensor, so that each lies behind the other.
  [[nodiscard]] bool turns(const Facing& plane, std::int32_t other, const Eigen::Vector3d& at) const {
    const Facing around = facing(static_cast<std::size_t>(other));
    if (std::abs(around.over(at)) > around.thick || std::abs(around.normal.dot(plane.normal)) > kTurn) return false;
    if (around.over(plane.centroid) > 0 || plane.over(around.centroid) > 0) return false;
    return std::abs(around.normal.cross(plane.normal).normalized().dot(up)) > kUprightEdge;
  }

  /// Sets what was seen beyond a place, where this position tells more than those before.
  void judge(const std::vector<std::uint32_t>& measured, const Facing& plane, Place& place) const;
};

void Sight::judge(const std::vector<std::uint32_t>& measured, const Facing& plane, Place& place) const {
  int before = 0, same = 0, past = 0, turned = 0;
  std::int32_t turn = -1;
  for (const std::uint32_t i : measured) {
    const Eigen::Vector3d p = cloud.offset(i).cast<double>();
    const double over = plane.over(p);
    ++(over > plane.thick ? before : over < -plane.thick ? past : same);
    if (over >= -plane.thick || plane_of_point.empty() || (p - place.at).squaredNorm() > kAround * kAround) continue;
    const std::int32_t other = plane_of_point[i];
    if (other < 0 || (other != turn && !turns(plane, other, place.at))) continue;
    turn = other, ++turned;
  }
  Seen seen = before + same + past == 0 ? Seen::nothing : same >= before ? Seen::same_surface : Seen::something_before;
  if (past > 0 && past >= std::max(same, before)) seen = 2 * turned > past ? Seen::around_the_edge : Seen::past;
  if (seen <= place.seen) return;
  place.seen = seen;
  if (seen == Seen::around_the_edge) place.turn = turn;
}

void look(const Directions& directions, const Sight& sight, std::size_t number, std::vector<Place>& places) {
  const Facing facing = sight.facing(number);
  if (facing.over(sight.eye) < 2 * facing.thick) return;  // seen edge-on
  std::vector<std::uint32_t> measured;
  for (Place& place : places) {
    const double beyond = std::max(kBeyond, kBeyondSteps * directions.step() * (place.at - sight.eye).norm());
    directions.measured_towards(place.at + beyond * place.out, measured);
    sight.judge(measured, facing, place);
  }
}

/// A position of the sensor and the points that were measured from it.
struct View {
  Eigen::Vector3d eye;  ///< in the cloud's offsets
  std::vector<std::uint32_t> points;
};

/// The positions with most points, a sensor on the move has seen little from any one; of their points kMostPoints or so.
std::vector<View> views_of(const Cloud& cloud) {
  const std::size_t positions = cloud.sensors.positions().size();
  const auto position_of = [&](std::size_t i) { return cloud.valid(i) ? cloud.sensors.of_point(i) : positions; };
  std::vector<std::size_t> counts(positions + 1, 0), order(positions);
  if (cloud.sensors.single()) {
    counts[0] = cloud.size() - cloud.invalid;
  } else {
    for (std::size_t i = 0; i < cloud.size(); ++i) ++counts[position_of(i)];
  }
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return counts[a] > counts[b]; });
  order.resize(std::min(order.size(), kMostViews));

  std::vector<View> views;
  std::vector<std::uint32_t> limit(positions + 1, 0);  // points with a hash below are taken
  std::vector<std::size_t> number(positions + 1, 0);
  for (const std::size_t position : order) {
    constexpr std::uint64_t all = ~std::uint32_t{0};
    limit[position] = static_cast<std::uint32_t>(counts[position] > kMostPoints ? all * kMostPoints / counts[position] : all);
    number[position] = views.size();
    views.push_back({cloud.sensors.positions()[position] - cloud.origin, {}});
    views.back().points.reserve(std::min(counts[position], kMostPoints + kMostPoints / 50));
  }
  const bool single = cloud.sensors.single();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::size_t position = single && cloud.valid(i) ? 0 : position_of(i);
    if (limit[position] > 0 && point_hash(cloud.x[i], cloud.y[i], cloud.z[i]) < limit[position]) views[number[position]].points.push_back(static_cast<std::uint32_t>(i));
  }
  return views;
}

/// Length by what was seen.
struct Lengths {
  double all = 0, looked_at = 0, seen = 0, free = 0, joined = 0;

  void add(const Place& place) {
    all += place.length;
    if (place.seen == Seen::not_looked_at) return;
    looked_at += place.length;
    if (place.seen == Seen::nothing) return;
    seen += place.length;
    if (place.seen == Seen::past) free += place.length;
    if (place.seen == Seen::same_surface) joined += place.length;
  }
  [[nodiscard]] bool enough() const { return seen > 0 && seen >= kEnough * all; }
};

void conclude(const std::vector<Place>& places, const Eigen::Vector3d& up, Plane& plane) {
  Lengths whole, top;
  for (const Place& place : places) {
    whole.add(place);
    if (up.dot(place.out) > kUpper) top.add(place);
  }
  if (whole.looked_at > 0) plane.edge_unseen = 1 - whole.seen / whole.looked_at;
  if (!whole.enough()) return;
  plane.edge_free = whole.free / whole.seen;
  plane.edge_joined = whole.joined / whole.seen;
  if (top.enough() && top.seen >= kShortestTop) plane.edge_free_top = top.free / top.seen;
}

/// The planes that one turns into along more than a scrap of its outline.
std::vector<std::uint32_t> turns_of(const std::vector<Place>& places) {
  std::map<std::int32_t, double> metres;
  for (const Place& place : places) {
    if (place.seen == Seen::around_the_edge) metres[place.turn] += place.length;
  }
  std::vector<std::uint32_t> turns;
  for (const auto& [plane, length] : metres) {
    if (length >= kShortestTurn) turns.push_back(static_cast<std::uint32_t>(plane));
  }
  return turns;
}

}  // namespace

Turns look_beyond_outlines(const Cloud& cloud, const Eigen::Quaterniond& upright, std::span<const std::int32_t> plane_of_point,
                           std::vector<Plane>& planes, int threads) {
  Turns turns(planes.size());
  if (!cloud.sensors.known()) return turns;
  const Eigen::Vector3d up = upright.inverse() * Eigen::Vector3d::UnitZ();
  std::vector<std::vector<Place>> places(planes.size());
  for (std::size_t p = 0; p < planes.size(); ++p) places[p] = places_of(planes[p], cloud.origin);
  for (View& view : views_of(cloud)) {
    const Directions directions(cloud, std::move(view.points), view.eye, threads);
    const Sight sight{cloud, up, plane_of_point, planes, view.eye};
    parallel_pieces(planes.size(), 1, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) look(directions, sight, p, places[p]);
    });
  }
  for (std::size_t p = 0; p < planes.size(); ++p) {
    conclude(places[p], up, planes[p]);
    turns[p] = turns_of(places[p]);
  }
  return turns;
}

}  // namespace scenelore::perception
