#include "rings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "cell_index.hpp"
#include "scenelore/perception/hull.hpp"

namespace scenelore::perception {

std::vector<std::vector<int>> simple_loops(std::vector<std::pair<int, int>> edges) {
  std::sort(edges.begin(), edges.end());
  std::vector<bool> used(edges.size(), false);
  // The next unused edge that leaves a vertex.
  const auto leaving = [&](int vertex) {
    auto e = std::lower_bound(edges.begin(), edges.end(), std::pair(vertex, -1));
    while (used[static_cast<std::size_t>(e - edges.begin())]) ++e;
    return static_cast<std::size_t>(e - edges.begin());
  };
  std::vector<std::vector<int>> loops;
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (used[first]) continue;
    std::vector<int> path{edges[first].first};
    std::map<int, std::size_t> place{{path.front(), 0}};
    for (std::size_t e = first;; e = leaving(path.back())) {
      used[e] = true;
      const int vertex = edges[e].second;
      const auto seen = place.find(vertex);
      if (seen == place.end()) {
        place[vertex] = path.size();
        path.push_back(vertex);
        continue;
      }
      const std::size_t start = seen->second;
      loops.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(start), path.end());
      for (std::size_t i = start + 1; i < path.size(); ++i) place.erase(path[i]);
      path.resize(start + 1);
      if (start == 0) break;
    }
  }
  return loops;
}

double signed_area(const Ring2& ring) {
  double twice = 0;
  if (ring.empty()) return 0;
  // Relative to the first corner: coordinates far from zero would cost digits.
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i] - ring[0], b = ring[i + 1] - ring[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

std::vector<Eigen::Vector2d> thinned(std::span<const Eigen::Vector2d> points, double cell) {
  std::vector<CellKey> keys(points.size());
  constexpr auto limit = static_cast<double>(kCellLimit);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = std::floor(points[i].x() / cell), y = std::floor(points[i].y() / cell);
    const bool inside = std::abs(x) < limit && std::abs(y) < limit;
    keys[i] = inside ? cell_key(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y), 0) : kNoCell;
  }
  const CellIndex cells(keys);
  std::vector<Eigen::Vector2d> kept;
  kept.reserve(cells.size());
  const auto least = [&](std::span<const std::uint32_t> items, auto rank) {
    return points[*std::min_element(items.begin(), items.end(), [&](auto a, auto b) { return rank(a) < rank(b); })];
  };
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto items = cells.items(c);
    const bool inner = cells.find(moved(cells.key(c), 1, 0, 0)) >= 0 && cells.find(moved(cells.key(c), -1, 0, 0)) >= 0 &&
                       cells.find(moved(cells.key(c), 0, 1, 0)) >= 0 && cells.find(moved(cells.key(c), 0, -1, 0)) >= 0;
    const auto [x, y, z] = coordinates(cells.key(c));
    const Eigen::Vector2d center = cell * Eigen::Vector2d(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
    if (inner || items.size() == 1) {
      kept.push_back(least(items, [&](std::uint32_t i) { return std::tuple((points[i] - center).squaredNorm(), points[i].x(), points[i].y()); }));
      continue;
    }
    for (int direction = 0; direction < 8; ++direction) {
      const double angle = direction * std::numbers::pi / 4;
      const Eigen::Vector2d inwards(-std::cos(angle), -std::sin(angle));
      kept.push_back(least(items, [&](std::uint32_t i) { return std::tuple(inwards.dot(points[i]), points[i].x(), points[i].y()); }));
    }
  }
  return kept;
}

}  // namespace scenelore::perception
