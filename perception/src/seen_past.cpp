#include "seen_past.hpp"

#include <cmath>

#include "cell_index.hpp"

namespace scenelore::perception {
namespace {

/// Column and row; still in floating point, since a ray may cross the plane anywhere.
Eigen::Array2d cell_at(const PlaneFit& plane, double edge, const Eigen::Vector3d& p) {
  const Eigen::Vector3d d = p - plane.centroid;
  return {std::floor(plane.axes.col(1).dot(d) / edge), std::floor(plane.axes.col(2).dot(d) / edge)};
}

Eigen::Vector2d middle_of(const Eigen::Vector2i& cell, double edge) { return (cell.cast<double>().array() + 0.5) * edge; }

}  // namespace

PlaneView view_of(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& points, double edge) {
  std::vector<CellKey> keys;
  for (const std::uint32_t i : points) {
    const Eigen::Array2d c = cell_at(plane, edge, cloud.offset(i).cast<double>());
    keys.push_back(cell_key(static_cast<std::int64_t>(c.x()), static_cast<std::int64_t>(c.y()), 0));
  }
  const CellIndex index(keys);
  PlaneView view;
  view.edge = edge;
  for (std::size_t c = 0; c < index.size(); ++c) {
    const CellCoordinates at = coordinates(index.key(c));
    view.held.push_back(middle_of({static_cast<int>(at.x), static_cast<int>(at.y)}, edge));
    view.points.push_back(static_cast<int>(index.items(c).size()));
  }
  for (std::size_t k = 0; k < points.size(); ++k) view.cell_of.push_back(static_cast<std::uint32_t>(index.cell_of(k)));
  return view;
}

void look_past(const Cloud& cloud, const PlaneFit& plane, double behind, PlaneView& view) {
  const Eigen::Vector3d sensor = *cloud.viewpoint - cloud.origin;
  const double side = plane.distance(sensor) > 0 ? 1 : -1, before = std::abs(plane.distance(sensor));
  if (before < 2 * behind || view.held.empty()) return;
  Eigen::Array2d low = view.held.front(), high = low;
  for (const Eigen::Vector2d& cell : view.held) low = low.min(cell.array()), high = high.max(cell.array());
  const Eigen::Array2i first = (low / view.edge).floor().cast<int>(), size = (high / view.edge).floor().cast<int>() - first + 1;
  const auto index = [&](const Eigen::Array2i& c) { return static_cast<std::size_t>(c.y()) * static_cast<std::size_t>(size.x()) + static_cast<std::size_t>(c.x()); };
  std::vector<int> own(static_cast<std::size_t>(size.prod()), 0), passed = own;
  for (std::size_t c = 0; c < view.held.size(); ++c) own[index((view.held[c].array() / view.edge).floor().cast<int>() - first)] = view.points[c];
  const Eigen::Vector3d normal = -side * plane.normal;
  const double offset = -side * plane.offset;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.offset(i).cast<double>();
    const double d = normal.dot(p) - offset;
    if (!(d > behind)) continue;  // nor is a point without coordinates
    const Eigen::Array2d c = cell_at(plane, view.edge, sensor + before / (before + d) * (p - sensor)) - first.cast<double>();
    if ((c >= 0).all() && (c < size.cast<double>()).all()) ++passed[index(c.cast<int>())];
  }
  for (std::size_t k = 0; k < passed.size(); ++k) {
    const Eigen::Array2i c(static_cast<int>(k % static_cast<std::size_t>(size.x())), static_cast<int>(k / static_cast<std::size_t>(size.x())));
    if (passed[k] > 2 * own[k]) view.empty.push_back(middle_of((first + c).matrix(), view.edge));
  }
}

}  // namespace scenelore::perception
