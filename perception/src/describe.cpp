#include <algorithm>
#include <cmath>
#include <numbers>

#include "cell_index.hpp"
#include "scenelore/perception/features.hpp"
#include "scenelore/perception/hull.hpp"
#include "seen_from.hpp"

namespace scenelore::perception {
namespace {

/// The plane's own frame: columns intermediate axis, largest axis, normal; origin at the centroid.
struct Frame {
  Eigen::Vector3d centroid;  // in the cloud's offsets
  Eigen::Matrix3d axes;

  [[nodiscard]] Eigen::Vector2d flat(const Eigen::Vector3d& p) const { return (axes.transpose() * (p - centroid)).head<2>(); }
  [[nodiscard]] Eigen::Vector3d lifted(const Eigen::Vector2d& q) const { return centroid + axes.leftCols<2>() * q; }
};

/// Towards the sensor where that is known; else to the upper half space, of vertical planes towards +x, then +y.
Eigen::Vector3d oriented(const PlaneFit& fit, std::span<const std::uint32_t> points, const Cloud& cloud, const Upright& upright) {
  const Eigen::Vector3d& normal = fit.normal;
  if (const std::optional<bool> front = seen_from_front(cloud, fit, points)) return *front ? normal : Eigen::Vector3d(-normal);
  const Eigen::Vector3d up = upright.rotation * normal;
  for (const int axis : {2, 0, 1}) {
    if (std::abs(up[axis]) > 1e-3) return up[axis] > 0 ? normal : Eigen::Vector3d(-normal);
  }
  return normal;
}

/// The sign rule of the orientation: the component of the largest axis that is largest in size is positive.
Frame make_frame(const PlaneFit& fit, const Eigen::Vector3d& normal) {
  Eigen::Vector3d largest = fit.axes.col(2);
  int which = 0;
  largest.cwiseAbs().maxCoeff(&which);
  if (largest[which] < 0) largest = -largest;
  Frame frame{fit.centroid, {}};
  frame.axes.col(0) = largest.cross(normal).normalized();
  frame.axes.col(1) = largest;
  frame.axes.col(2) = normal;
  return frame;
}

Ring lifted(const Ring2& ring, const Frame& frame, const Eigen::Vector3d& origin) {
  Ring result;
  result.reserve(ring.size());
  for (const Eigen::Vector2d& p : ring) result.push_back(origin + frame.lifted(p));
  return result;
}

/// Cells with their centre inside the outline, row by row.
double seen_share(const Outline& outline, std::span<const Eigen::Vector2d> points, double cell) {
  if (outline.outer.empty()) return 0;
  cell = std::max(cell, std::sqrt(outline.area) / 1000);
  std::vector<CellKey> keys(points.size());
  constexpr auto limit = static_cast<double>(kCellLimit);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = std::floor(points[i].x() / cell), y = std::floor(points[i].y() / cell);
    const bool inside = std::abs(x) < limit && std::abs(y) < limit;
    keys[i] = inside ? cell_key(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y), 0) : kNoCell;
  }
  const CellIndex occupied(keys);
  double low = outline.outer[0].y(), high = low;
  for (const Eigen::Vector2d& p : outline.outer) low = std::min(low, p.y()), high = std::max(high, p.y());
  std::size_t cells = 0, seen = 0;
  std::vector<double> crossings;
  const auto crossed = [&](const Ring2& ring, double y) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y() <= y) != (b.y() <= y)) crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  };
  for (auto row = static_cast<std::int64_t>(std::floor(low / cell)); static_cast<double>(row) * cell <= high; ++row) {
    crossings.clear();
    const double y = (static_cast<double>(row) + 0.5) * cell;
    crossed(outline.outer, y);
    for (const Ring2& hole : outline.holes) crossed(hole, y);
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const auto first = static_cast<std::int64_t>(std::ceil(crossings[k] / cell - 0.5));
      const auto last = static_cast<std::int64_t>(std::ceil(crossings[k + 1] / cell - 0.5));
      for (std::int64_t column = first; column < last; ++column) {
        ++cells;
        if (occupied.find(cell_key(column, row, 0)) >= 0) ++seen;
      }
    }
  }
  return cells == 0 ? 1.0 : static_cast<double>(seen) / static_cast<double>(cells);
}

/// Cells so wide that even the whole rectangle of the points' spread needs no more than 200,000 of them, and that an evenly
/// seen surface leaves next to none empty; those of sparse planes need not be wider than the outline can tell.
double thinning_cell(const PlaneFit& fit, std::size_t points, const DescribeOptions& options) {
  const double area = fit.spread_area(), holding_four = 2 * std::sqrt(area / static_cast<double>(std::max<std::size_t>(points, 1)));
  return std::max({options.hull_cell, std::sqrt(area / 200'000), std::min(holding_four, options.hull_radius / 3)});
}

}  // namespace

Plane describe(const Cloud& cloud, std::span<const std::uint32_t> points, const PlaneFit& fit, const Upright& upright,
               const DescribeOptions& options) {
  Plane plane;
  plane.point_count = points.size();
  plane.rmse = fit.rmse();
  plane.normal = oriented(fit, points, cloud, upright);
  const Frame frame = make_frame(fit, plane.normal);
  plane.centroid = cloud.origin + fit.centroid;
  plane.orientation = Eigen::Quaterniond(frame.axes).normalized();
  std::vector<Eigen::Vector2d> flat(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) flat[k] = frame.flat(cloud.offset(points[k]).cast<double>());
  const double cell = thinning_cell(fit, points.size(), options);
  const double radius = std::max(options.hull_radius, 3 * cell);
  const OutlineSites sites = points.size() < 300 ? OutlineSites{flat, {}} : outline_sites(flat, cell, radius);
  const Outline outline = alpha_hull(sites.points, radius, sites.weights);
  const Rectangle rectangle = minimum_rectangle(outline.outer.empty() ? std::span<const Eigen::Vector2d>(sites.points) : std::span<const Eigen::Vector2d>(outline.outer));
  plane.hull.outer = lifted(outline.outer, frame, cloud.origin);
  for (const Ring2& hole : outline.holes) plane.hull.holes.push_back(lifted(hole, frame, cloud.origin));
  plane.area_m2 = outline.area;
  plane.length = rectangle.length;
  plane.width = rectangle.width;
  plane.rectangularity = rectangularity(outline, rectangle);
  plane.spread_length = std::sqrt(12 * std::max(0.0, fit.variances[2]));
  plane.spread_width = std::sqrt(12 * std::max(0.0, fit.variances[1]));
  plane.point_density = outline.area > 0 ? static_cast<double>(points.size()) / outline.area : 0;
  plane.seen_share = seen_share(outline, flat, options.seen_cell);
  const double up = (upright.rotation * plane.normal).z();
  plane.tilt_deg = std::acos(std::min(1.0, std::abs(up))) * 180 / std::numbers::pi;
  plane.facing_up = up;
  const auto height = [&](const Eigen::Vector3d& p) { return (upright.rotation * p).z() - upright.floor_z; };
  plane.height = plane.z_min = plane.z_max = height(plane.centroid);
  const auto stretch = [&](const Eigen::Vector3d& p) {
    plane.z_min = std::min(plane.z_min, height(p));
    plane.z_max = std::max(plane.z_max, height(p));
  };
  for (const Eigen::Vector3d& p : plane.hull.outer) stretch(p);
  if (plane.hull.outer.empty()) {
    for (const std::uint32_t i : points) stretch(cloud.position(i));
  }
  return plane;
}

}  // namespace scenelore::perception
