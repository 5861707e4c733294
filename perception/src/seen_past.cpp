#include "seen_past.hpp"

#include <algorithm>
#include <cmath>

#include "cell_index.hpp"

namespace scenelore::perception {
namespace {

/// Column and row; still in floating point, since a ray may cross the plane anywhere.
Eigen::Array2d cell_at(const PlaneFit& plane, double edge, const Eigen::Vector3d& p) {
  const Eigen::Vector3d d = p - plane.centroid;
  return {std::floor(plane.axes.col(1).dot(d) / edge), std::floor(plane.axes.col(2).dot(d) / edge)};
}

/// A place where the sensor stood, in the cloud's offsets.
struct Eye {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  double before = 0;  ///< metres to the plane
  double away = 0;    ///< the side of the plane that it looks to, as distances from the plane tell sides; 0 = sees nothing past it
};

/// By number of the position; at last the one that is not known.
std::vector<Eye> eyes_of(const Cloud& cloud, const PlaneFit& plane, double behind) {
  std::vector<Eye> eyes;
  for (const Eigen::Vector3d& position : cloud.sensors.positions()) {
    const Eigen::Vector3d at = position - cloud.origin;
    const double over = plane.distance(at);
    eyes.push_back({at, std::abs(over), std::abs(over) < 2 * behind ? 0.0 : over > 0 ? -1.0 : 1.0});
  }
  eyes.emplace_back();
  return eyes;
}

Eigen::Vector2d middle_of(const Eigen::Vector2i& cell, double edge) { return (cell.cast<double>().array() + 0.5) * edge; }

}  // namespace

PlaneView view_of(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& points, double edge) {
  std::vector<CellKey> keys;
  keys.reserve(points.size());
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
  view.cell_of.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) view.cell_of.push_back(static_cast<std::uint32_t>(index.cell_of(k)));
  return view;
}

void look_past(const Cloud& cloud, const PlaneFit& plane, double behind, PlaneView& view) {
  const std::vector<Eye> eyes = eyes_of(cloud, plane, behind);
  if (view.held.empty() || std::none_of(eyes.begin(), eyes.end(), [](const Eye& eye) { return eye.away != 0; })) return;
  Eigen::Array2d low = view.held.front(), high = low;
  for (const Eigen::Vector2d& cell : view.held) low = low.min(cell.array()), high = high.max(cell.array());
  const Eigen::Array2i first = (low / view.edge).floor().cast<int>(), size = (high / view.edge).floor().cast<int>() - first + 1;
  const auto index = [&](const Eigen::Array2i& c) { return static_cast<std::size_t>(c.y()) * static_cast<std::size_t>(size.x()) + static_cast<std::size_t>(c.x()); };
  std::vector<int> own(static_cast<std::size_t>(size.prod()), 0), passed = own;
  for (std::size_t c = 0; c < view.held.size(); ++c) own[index((view.held[c].array() / view.edge).floor().cast<int>() - first)] = view.points[c];
  const Eigen::Vector3d across = plane.axes.col(1), along = plane.axes.col(2);
  const Eigen::Array2d begin = first.cast<double>(), end = (first + size).cast<double>();
  const bool single = cloud.sensors.single();
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.offset(i).cast<double>();
    const double over = plane.distance(p);
    if (!(std::abs(over) > behind)) continue;  // nor is a point without coordinates
    const Eye& eye = eyes[single ? 0 : cloud.sensors.of_point(i)];
    const double d = eye.away * over;
    if (!(d > behind)) continue;
    // The cell of cell_at(), rounded only where it lies among the held ones: few rays cross there.
    const Eigen::Vector3d crossing = eye.at + eye.before / (eye.before + d) * (p - eye.at) - plane.centroid;
    const double column = across.dot(crossing) / view.edge;
    if (!(column >= begin.x() && column < end.x())) continue;
    const double row = along.dot(crossing) / view.edge;
    if (!(row >= begin.y() && row < end.y())) continue;
    ++passed[index(Eigen::Array2d(std::floor(column), std::floor(row)).cast<int>() - first)];
  }
  for (std::size_t k = 0; k < passed.size(); ++k) {
    const Eigen::Array2i c(static_cast<int>(k % static_cast<std::size_t>(size.x())), static_cast<int>(k / static_cast<std::size_t>(size.x())));
    if (passed[k] > 2 * own[k]) view.empty.push_back(middle_of((first + c).matrix(), view.edge));
  }
}

}  // namespace scenelore::perception
