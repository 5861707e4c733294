#include "rings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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
  int last = -1;
  for (const auto& [from, to] : edges) last = std::max({last, from, to});
  constexpr std::size_t kNowhere = ~std::size_t{0};
  std::vector<std::size_t> place(static_cast<std::size_t>(last + 1), kNowhere);  // of each vertex on the path
  const auto place_of = [&place](int vertex) -> std::size_t& { return place[static_cast<std::size_t>(vertex)]; };
  for (std::size_t first = 0; first < edges.size(); ++first) {
    if (used[first]) continue;
    std::vector<int> path{edges[first].first};
    place_of(path.front()) = 0;
    for (std::size_t e = first;; e = leaving(path.back())) {
      used[e] = true;
      const int vertex = edges[e].second;
      const std::size_t start = place_of(vertex);
      if (start == kNowhere) {
        place_of(vertex) = path.size();
        path.push_back(vertex);
        continue;
      }
      loops.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(start), path.end());
      for (std::size_t i = start + 1; i < path.size(); ++i) place_of(path[i]) = kNowhere;
      path.resize(start + 1);
      if (start == 0) break;
    }
    place_of(path.front()) = kNowhere;
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

namespace {

/// A rectangle of cells around points, row by row, with an empty margin.
struct Cells {
  Eigen::Vector2d low;
  double cell = 1;
  std::int64_t columns = 0, rows = 0;

  [[nodiscard]] std::size_t at(const Eigen::Vector2d& p) const {
    const auto x = static_cast<std::int64_t>((p.x() - low.x()) / cell) + 1, y = static_cast<std::int64_t>((p.y() - low.y()) / cell) + 1;
    return static_cast<std::size_t>(y * columns + x);
  }
};

/// Which of two points of a cell comes first, whatever order they were given in.
struct Ranked {
  double rank = std::numeric_limits<double>::infinity();
  Eigen::Vector2d point = Eigen::Vector2d::Zero();

  void offer(double r, const Eigen::Vector2d& p) {
    if (std::tuple(r, p.x(), p.y()) < std::tuple(rank, point.x(), point.y())) rank = r, point = p;
  }
};

}  // namespace

OutlineSites outline_sites(std::span<const Eigen::Vector2d> points, double cell, double radius) {
  OutlineSites kept;
  if (points.empty()) return kept;
  Cells cells{points[0], cell};
  Eigen::Vector2d high = points[0];
  for (const Eigen::Vector2d& p : points) cells.low = cells.low.cwiseMin(p), high = high.cwiseMax(p);
  // Cell borders at multiples of the cell: what is kept does not depend on where the set happens to end.
  cells.low = cell * (cells.low / cell).array().floor().matrix();
  const double most = 16e6;
  if (!((high - cells.low).prod() / (cell * cell) < most)) {
    kept.points = thinned(points, cell);
    kept.weights.assign(kept.points.size(), 1);
    return kept;
  }
  cells.columns = static_cast<std::int64_t>((high.x() - cells.low.x()) / cell) + 3;
  cells.rows = static_cast<std::int64_t>((high.y() - cells.low.y()) / cell) + 3;
  enum : std::int32_t { kEmpty = -1, kHeld = -2, kSkipped = -3 };
  std::vector<std::int32_t> state(static_cast<std::size_t>(cells.columns * cells.rows), kEmpty);
  for (const Eigen::Vector2d& p : points) state[cells.at(p)] = kHeld;
  const auto lattice = static_cast<std::int64_t>(std::max(1.0, std::floor(0.6 * radius / cell)));
  const auto first_column = static_cast<std::int64_t>(std::llround(cells.low.x() / cell)), first_row = static_cast<std::int64_t>(std::llround(cells.low.y() / cell));
  const auto on_lattice = [lattice](std::int64_t c) { return ((c % lattice) + lattice) % lattice == 0; };
  std::vector<Ranked> inner;                    // of lattice cells
  std::vector<std::array<Ranked, 8>> rim;       // in eight directions
  std::vector<std::int32_t> place = state;      // number in `inner`, or −4 − number in `rim`
  for (std::int64_t y = 1; y + 1 < cells.rows; ++y) {
    for (std::int64_t x = 1; x + 1 < cells.columns; ++x) {
      const auto c = static_cast<std::size_t>(y * cells.columns + x);
      if (state[c] == kEmpty) continue;
      bool surrounded = true;
      for (std::int64_t d = 0; d < 9; ++d) surrounded = surrounded && state[static_cast<std::size_t>((y + d / 3 - 1) * cells.columns + x + d % 3 - 1)] != kEmpty;
      if (!surrounded) {
        place[c] = -4 - static_cast<std::int32_t>(rim.size());
        rim.emplace_back();
      } else if (on_lattice(x + first_column) && on_lattice(y + first_row)) {
        place[c] = static_cast<std::int32_t>(inner.size());
        inner.emplace_back();
      } else {
        place[c] = kSkipped;
      }
    }
  }
  std::array<Eigen::Vector2d, 8> inwards;
  for (std::size_t d = 0; d < 8; ++d) {
    const double angle = static_cast<double>(d) * std::numbers::pi / 4;
    inwards[d] = {-std::cos(angle), -std::sin(angle)};
  }
  for (const Eigen::Vector2d& p : points) {
    const std::int32_t where = place[cells.at(p)];
    if (where >= 0) {
      const Eigen::Vector2d middle = cell * ((p / cell).array().floor() + 0.5).matrix();
      inner[static_cast<std::size_t>(where)].offer((p - middle).squaredNorm(), p);
    } else if (where <= -4) {
      for (std::size_t d = 0; d < 8; ++d) rim[static_cast<std::size_t>(-4 - where)][d].offer(inwards[d].dot(p), p);
    }
  }
  const auto keep = [&kept](const Ranked& r, double weight) {
    kept.points.push_back(r.point);
    kept.weights.push_back(weight);
  };
  for (const Ranked& r : inner) keep(r, static_cast<double>(lattice * lattice));
  for (const auto& directions : rim) {
    for (const Ranked& r : directions) keep(r, 1.0 / 8);
  }
  return kept;
}

}  // namespace scenelore::perception
