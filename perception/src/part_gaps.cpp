#include "part_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "gap.hpp"

namespace scenelore::perception {
namespace {

constexpr double kLargest = 12;                     // m²
constexpr double kDeviations = 2.5;                 // of a plane's points: what is further behind it is not on it
constexpr double kLeastBehind = 0.01;               // metres

/// The pieces of a view: held cells that touch.
struct Pieces {
  std::vector<std::int32_t> of_cell;
  PieceCells cells;
  std::vector<double> points;
};

Pieces pieces_of(const PlaneView& view) {
  const CellIndex index = index_of(view, view.held);
  Pieces pieces;
  pieces.of_cell.assign(view.held.size(), -1);
  for (std::size_t first = 0; first < view.held.size(); ++first) {
    if (pieces.of_cell[first] >= 0) continue;
    const auto number = static_cast<std::int32_t>(pieces.cells.size());
    std::vector<std::size_t> members{first};
    double points = 0;
    pieces.of_cell[first] = number;
    for (std::size_t next = 0; next < members.size(); ++next) {
      points += view.points[members[next]];
      for (int d = 0; d < 9; ++d) {
        const std::int32_t n = index.find(moved(key_of(view, view.held[members[next]]), d / 3 - 1, d % 3 - 1, 0));
        if (n < 0) continue;
        const std::size_t other = index.items(static_cast<std::size_t>(n)).front();
        if (pieces.of_cell[other] >= 0) continue;
        pieces.of_cell[other] = number;
        members.push_back(other);
      }
    }
    pieces.cells.push_back(std::move(members));
    pieces.points.push_back(points);
  }
  return pieces;
}

/// By piece: the first piece of its part, one of `fewest` points at least. Pieces belong together unless their gap was
/// seen through.
std::vector<std::int32_t> parts_of(const Gap& gap, const Pieces& pieces, double fewest) {
  std::vector<std::int32_t> root(pieces.cells.size());
  std::iota(root.begin(), root.end(), 0);
  const auto top = [&](std::size_t p) {
    auto r = static_cast<std::int32_t>(p);
    while (root[static_cast<std::size_t>(r)] != r) r = root[static_cast<std::size_t>(r)];
    return r;
  };
  const auto real = [&](std::size_t p) { return pieces.points[p] >= fewest; };
  for (std::size_t a = 0; a < root.size(); ++a) {
    for (std::size_t b = a + 1; b < root.size(); ++b) {
      if (!real(a) || !real(b) || top(a) == top(b) || gap.seen_through(a, b)) continue;
      root[static_cast<std::size_t>(std::max(top(a), top(b)))] = std::min(top(a), top(b));
    }
  }
  // Strays go with what is nearest.
  for (std::size_t a = 0; a < root.size(); ++a) {
    if (real(a)) continue;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < root.size(); ++b) {
      if (!real(b)) continue;
      const double d = gap.width(a, b);
      if (d < best) best = d, root[a] = top(b);
    }
  }
  std::vector<std::int32_t> part(root.size());
  for (std::size_t p = 0; p < root.size(); ++p) part[p] = top(p);
  return part;
}

/// Gives each part but the first a region of its own.
void renumber(const PlaneView& view, const Pieces& pieces, const std::vector<std::int32_t>& part, const std::vector<std::uint32_t>& points,
              Regions& regions) {
  std::vector<std::int32_t> region(part.size(), -1);
  bool first = true;
  for (std::size_t p = 0; p < part.size(); ++p) {
    std::int32_t& number = region[static_cast<std::size_t>(part[p])];
    if (number >= 0) continue;
    number = first ? regions.of_point[points.front()] : static_cast<std::int32_t>(regions.planes.size());
    if (!first) regions.planes.emplace_back();
    first = false;
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    regions.of_point[points[k]] = region[static_cast<std::size_t>(part[static_cast<std::size_t>(pieces.of_cell[view.cell_of[k]])])];
  }
}

}  // namespace

void part_at_gaps(const Cloud& cloud, const Limits& limits, Regions& regions) {
  if (!cloud.sensors.known()) return;
  const std::size_t before = regions.planes.size();
  const auto points = points_of_regions(regions.of_point, before);
  for (std::size_t r = 0; r < points.size(); ++r) {
    const PlaneFit plane = regions.planes[r];
    const auto count = static_cast<double>(points[r].size());
    const double area = plane.spread_area();
    if (count < 2 * limits.min_points || area > kLargest) continue;
    PlaneView view = view_of(cloud, plane, points[r], gap_cell(area, count));
    const Pieces pieces = pieces_of(view);
    if (std::count_if(pieces.points.begin(), pieces.points.end(), [&](double n) { return n >= limits.min_points; }) < 2) continue;
    look_past(cloud, plane, std::max(kDeviations * plane.rmse(), kLeastBehind), view);
    if (view.empty.empty()) continue;
    renumber(view, pieces, parts_of(Gap(view, pieces.cells), pieces, limits.min_points), points[r], regions);
  }
  if (regions.planes.size() > before) refit(cloud, regions);
}

}  // namespace scenelore::perception
