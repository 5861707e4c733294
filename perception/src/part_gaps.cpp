#include "part_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>

#include "gap.hpp"
#include "scenelore/perception/parallel.hpp"

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

/// The part of each point of a region; empty = it is one.
std::vector<std::int32_t> parts_of_points(const Cloud& cloud, const PlaneFit& plane, const std::vector<std::uint32_t>& points, double fewest) {
  const auto count = static_cast<double>(points.size());
  const double area = plane.spread_area();
  if (count < 2 * fewest || area > kLargest) return {};
  PlaneView view = view_of(cloud, plane, points, gap_cell(area, count));
  const Pieces pieces = pieces_of(view);
  if (std::count_if(pieces.points.begin(), pieces.points.end(), [&](double n) { return n >= fewest; }) < 2) return {};
  look_past(cloud, plane, std::max(kDeviations * plane.rmse(), kLeastBehind), view);
  if (view.empty.empty()) return {};
  const std::vector<std::int32_t> part = parts_of(Gap(view, pieces.cells), pieces, fewest);
  std::vector<std::int32_t> out;
  out.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) out.push_back(part[static_cast<std::size_t>(pieces.of_cell[view.cell_of[k]])]);
  return out;
}

/// Gives each part but the first, in the order of the parts' numbers, a region of its own.
void renumber(const std::vector<std::int32_t>& part, const std::vector<std::uint32_t>& points, std::size_t region, Regions& regions) {
  std::map<std::int32_t, std::int32_t> number;
  for (const std::int32_t p : part) number[p] = static_cast<std::int32_t>(region);
  for (auto it = std::next(number.begin()); it != number.end(); ++it) {
    it->second = static_cast<std::int32_t>(regions.planes.size());
    regions.planes.emplace_back();
  }
  for (std::size_t k = 0; k < points.size(); ++k) regions.of_point[points[k]] = number[part[k]];
}

}  // namespace

void part_at_gaps(const Cloud& cloud, const Limits& limits, Regions& regions, int threads) {
  if (!cloud.sensors.known()) return;
  const std::size_t before = regions.planes.size();
  const auto points = points_of_regions(regions.of_point, before);
  std::vector<std::vector<std::int32_t>> parts(before);
  parallel_pieces(before, 1, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) parts[r] = parts_of_points(cloud, regions.planes[r], points[r], limits.min_points);
  });
  for (std::size_t r = 0; r < before; ++r) {
    if (!parts[r].empty()) renumber(parts[r], points[r], r, regions);
  }
  if (regions.planes.size() > before) refit(cloud, regions);
}

}  // namespace scenelore::perception
