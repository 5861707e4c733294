#include "scenelore/perception/arrangement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace scenelore::perception {
namespace {

constexpr double kLevel = 15, kNotSteep = 30, kSteep = 60;  // degrees from level
constexpr double kLeastLevel = 0.02, kLeastMeeting = 0.01;  // m², of a plane that something lies on or meets
constexpr double kBeneath = 0.003;                          // metres: less is two pieces of one surface
constexpr double kFloor = 0.1;                              // metres above the floor up to which a level plane is floor itself
constexpr double kSink = 0.1;                               // metres by which a steep plane's lower edge may lie below what it stands on
constexpr double kAbove = 0.05;                             // metres
constexpr double kLessThanRoof = 0.5, kRoof = 0.3;          // what lies above has this share of the plane's area, or of so many m²
constexpr double kBesideLevel = 0.02, kBesideSteep = 0.15, kBesideRoof = 0.05;  // metres from the middle in plan
constexpr double kParallel = 0.97, kLarger = 1.5, kFarthest = 1.5, kPane = 0.05;  // of what a plane stands before
constexpr double kOverlap = 0.1, kOverlapShare = 0.5;       // its outline may miss the middle by this, and this share of the distance
constexpr double kUpright = 75, kWall = 2;                  // degrees and m², of what counts as a wall
constexpr double kAlong = 0.9, kSquare = 0.3;               // cosines between a wall's normal and the plane's
constexpr double kMeets = 0.08;                             // metres from an edge: outlines end a few centimetres before it
constexpr double kAcross = 0.6;                             // cosine of 53 degrees
constexpr double kForward = 0.08, kBack = 0.05;             // metres that a surface must go on
constexpr std::size_t kSites = 32;                          // on an outline

using Flat = std::vector<Eigen::Vector2d>;

/// 0 inside the ring, else the distance to it.
double distance_to(const Flat& ring, const Eigen::Vector2d& p) {
  bool inside = false;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Eigen::Vector2d &a = ring[j], &b = ring[i];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    const Eigen::Vector2d along = b - a;
    const double length2 = along.squaredNorm(), t = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0;
    nearest = std::min(nearest, (a + t * along - p).squaredNorm());
  }
  return inside ? 0 : std::sqrt(nearest);
}

/// An outline in a plane of its own, and a box to tell at once what is far from it. Holes do not count: what stands on a plane makes them.
struct Outline2 {
  Flat ring;
  Eigen::AlignedBox2d box;

  void add(const Eigen::Vector2d& corner) {
    ring.push_back(corner);
    box.extend(corner);
  }
  [[nodiscard]] bool within(double reach, const Eigen::Vector2d& p) const {
    return box.squaredExteriorDistance(p) <= reach * reach && distance_to(ring, p) <= reach;
  }
};

struct Shape {
  const Plane* plane;
  Eigen::Matrix3d to_plane;  // into its own frame, from the centroid
  Eigen::AlignedBox3d box;
  Outline2 own, plan;
  Eigen::Vector2d middle;    // in plan
  std::array<Eigen::Vector3d, kSites> sites;

  Shape(const Plane& given, const Eigen::Quaterniond& upright, const Eigen::Vector3d& origin) : plane(&given) {
    const Eigen::Vector3d across = given.normal.unitOrthogonal();
    to_plane << across.transpose(), given.normal.cross(across).transpose(), given.normal.transpose();
    middle = (upright * (given.centroid - origin)).head<2>();
    const Ring& ring = given.hull.outer;
    double length = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      box.extend(ring[i]);
      own.add((to_plane * (ring[i] - given.centroid)).head<2>());
      plan.add((upright * (ring[i] - origin)).head<2>());
      length += (ring[(i + 1) % ring.size()] - ring[i]).norm();
    }
    double before = 0;
    for (std::size_t i = 0, site = 0; i < ring.size() && site < kSites; ++i) {
      const Eigen::Vector3d &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const double edge = (b - a).norm();
      for (; site < kSites; ++site) {
        const double at = length * (static_cast<double>(site) + 0.5) / kSites - before;
        if (at > edge && i + 1 < ring.size()) break;
        sites[site] = a + (b - a) * (edge > 0 ? std::min(at / edge, 1.0) : 0.0);
      }
      before += edge;
    }
  }

  [[nodiscard]] bool level() const { return plane->tilt_deg < kLevel && plane->area_m2 > kLeastLevel; }
  [[nodiscard]] bool not_steep() const { return plane->tilt_deg < kNotSteep; }
  /// Whether the normal points to the sensor, or at least up, as it does on most of what is level.
  [[nodiscard]] bool has_side() const { return plane->edge_unseen >= 0 || not_steep(); }
  [[nodiscard]] Eigen::Vector3d seen_from(const Eigen::Vector3d& point) const { return to_plane * (point - plane->centroid); }
};

double lift(const Shape& shape, std::span<const Shape* const> levels) {
  const Plane& plane = *shape.plane;
  const double lower = shape.not_steep() ? plane.height : plane.z_min;
  double highest = kFloor;
  for (const Shape* other : levels) {
    const Plane& beneath = *other->plane;
    if (other == &shape || beneath.height <= highest) continue;
    if (shape.not_steep() ? beneath.height > plane.height - kBeneath || beneath.area_m2 < plane.area_m2
                          : beneath.height > std::min(plane.height, plane.z_min + kSink)) continue;
    if (!other->plan.within(shape.not_steep() ? kBesideLevel : kBesideSteep, shape.middle)) continue;
    highest = beneath.height;
  }
  return highest > kFloor ? lower - highest : std::numeric_limits<double>::quiet_NaN();
}

double headroom(const Shape& shape, std::span<const Shape* const> levels) {
  const Plane& plane = *shape.plane;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Shape* other : levels) {
    const Plane& above = *other->plane;
    if (other == &shape || above.height <= plane.height + kAbove || above.height >= lowest) continue;
    if (above.area_m2 <= kLessThanRoof * std::min(plane.area_m2, kRoof)) continue;
    if (other->plan.within(kBesideRoof, shape.middle)) lowest = above.height;
  }
  return std::isfinite(lowest) ? lowest - (shape.not_steep() ? plane.height : plane.z_max) : std::numeric_limits<double>::quiet_NaN();
}

double standoff(const Shape& shape, std::span<const Shape> shapes) {
  const Plane& plane = *shape.plane;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Shape& other : shapes) {
    const Plane& larger = *other.plane;
    const double cosine = larger.normal.dot(plane.normal);
    if (&other == &shape || larger.tilt_deg <= kSteep || std::abs(cosine) < kParallel || larger.area_m2 < kLarger * plane.area_m2) continue;
    const Eigen::Vector3d place = other.seen_from(plane.centroid);
    const double before = cosine > 0 ? place.z() : -place.z();
    if (before <= -kPane || before >= kFarthest || before >= nearest) continue;
    if (other.own.within(kOverlap + kOverlapShare * std::max(before, 0.0), place.head<2>())) nearest = before;
  }
  return std::isfinite(nearest) ? nearest : std::numeric_limits<double>::quiet_NaN();
}

void measure_walls(const Shape& shape, std::span<const Shape> shapes, Arrangement& result) {
  const auto nearer = [](double distance, double& nearest) {
    if (!(std::abs(distance) >= std::abs(nearest))) nearest = distance;  // anything is nearer than NaN
  };
  for (const Shape& other : shapes) {
    const Plane& wall = *other.plane;
    if (&other == &shape || wall.tilt_deg <= kUpright || wall.area_m2 <= kWall) continue;
    const double before = other.seen_from(shape.plane->centroid).z(), distance = other.has_side() ? before : std::abs(before);
    const double cosine = std::abs(wall.normal.dot(shape.plane->normal));
    if (cosine > kAlong) nearer(distance, result.wall_offset);
    if (cosine < kSquare) nearer(distance, result.corner_offset);
  }
}

void meet_edges(const Shape& shape, std::span<const Shape> shapes, Arrangement& result) {
  const Plane& plane = *shape.plane;
  std::array<bool, kSites> concave{}, convex{};
  Eigen::AlignedBox3d reach = shape.box;
  reach.min().array() -= kMeets;
  reach.max().array() += kMeets;
  for (const Shape& other : shapes) {
    const Plane& meeting = *other.plane;
    if (&other == &shape || meeting.area_m2 < kLeastMeeting || std::abs(meeting.normal.dot(plane.normal)) > kAcross || !reach.intersects(other.box)) continue;
    double forward = 0, back = 0;
    for (const Eigen::Vector3d& corner : meeting.hull.outer) {
      const double before = plane.normal.dot(corner - plane.centroid);
      forward = std::max(forward, before);
      back = std::max(back, -before);
    }
    if (forward <= kForward && back <= kBack) continue;
    for (std::size_t s = 0; s < kSites; ++s) {
      const Eigen::Vector3d place = other.seen_from(shape.sites[s]);
      const double left = kMeets * kMeets - place.z() * place.z();
      if (left > 0 && other.own.within(std::sqrt(left), place.head<2>())) (forward > kForward ? concave : convex)[s] = true;
    }
  }
  std::size_t comes = 0, goes = 0;
  for (std::size_t s = 0; s < kSites; ++s) comes += concave[s] ? 1 : 0, goes += convex[s] && !concave[s] ? 1 : 0;
  result.edge_concave = static_cast<double>(comes) / kSites;
  result.edge_convex = static_cast<double>(goes) / kSites;
}

}  // namespace

std::vector<Arrangement> arrangements(std::span<const Plane* const> planes, const Eigen::Quaterniond& upright) {
  std::vector<Shape> shapes;
  std::vector<std::size_t> of;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (planes[p]->hull.outer.size() < 3) continue;
    shapes.emplace_back(*planes[p], upright, planes[0]->centroid);
    of.push_back(p);
  }
  std::vector<const Shape*> levels;
  for (const Shape& shape : shapes) {
    if (shape.level()) levels.push_back(&shape);
  }
  std::vector<Arrangement> result(planes.size());
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    const Shape& shape = shapes[s];
    Arrangement& own = result[of[s]];
    own.lift = lift(shape, levels);
    own.headroom = headroom(shape, levels);
    measure_walls(shape, shapes, own);
    if (!shape.has_side()) continue;
    if (shape.plane->tilt_deg > kSteep) own.standoff = standoff(shape, shapes);
    meet_edges(shape, shapes, own);
  }
  return result;
}

}  // namespace scenelore::perception
