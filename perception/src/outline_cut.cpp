#include "outline_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace scenelore::perception {
namespace {

constexpr std::size_t kDirections = 12;        // steps of 7.5 degrees
constexpr double kLeastShare = 0.06;   // of the cells
constexpr int kMostCuts = 4;           // along a path

using Indices = std::vector<std::size_t>;

/// A place along all directions, then across them.
using Projections = std::array<double, 2 * kDirections>;

/// The smallest rectangles, in all directions tried, around the places taken in so far.
struct Extents {
  Projections low, high;

  Extents() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }
  void add(const Projections& p) {
    for (std::size_t k = 0; k < p.size(); ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  }
  /// Of the smallest one that holds the cells whole.
  [[nodiscard]] double area(double edge) const {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kDirections; ++k) {
      best = std::min(best, (high[k] - low[k] + edge) * (high[k + kDirections] - low[k + kDirections] + edge));
    }
    return best;
  }
};

class Cutter {
 public:
  Cutter(const std::vector<Eigen::Vector2d>& places, double edge, const OutlineCut& limits) : edge_(edge), limits_(limits), along_(places.size()) {
    for (std::size_t k = 0; k < kDirections; ++k) {
      const double angle = static_cast<double>(k) * std::numbers::pi / 2 / kDirections;
      const Eigen::Vector2d d(std::cos(angle), std::sin(angle));
      for (std::size_t i = 0; i < places.size(); ++i) {
        along_[i][k] = d.dot(places[i]);
        along_[i][k + kDirections] = d.x() * places[i].y() - d.y() * places[i].x();
      }
    }
  }

  void cut(const Indices& cells, int depth, std::vector<Indices>& out) const;

 private:
  [[nodiscard]] double area(const Indices& cells) const {
    Extents extents;
    for (const std::size_t c : cells) extents.add(along_[c]);
    return extents.area(edge_);
  }
  /// A way to cut: before the cell at `at` of some order.
  struct Cut {
    std::size_t at = 0;
    double left = 0, right = 0;  ///< m², around the parts
  };
  [[nodiscard]] std::vector<Cut> cuts_along(const Indices& order, std::size_t k) const;
  [[nodiscard]] double best_cut(Indices& cells, std::size_t& at) const;

  double edge_;
  OutlineCut limits_;
  std::vector<Projections> along_;
};

/// The cuts across direction k of cells that are sorted along it, an edge of a cell apart. Both parts' rectangles come
/// from one pass each.
std::vector<Cutter::Cut> Cutter::cuts_along(const Indices& order, std::size_t k) const {
  const auto least = std::max<std::size_t>(2, static_cast<std::size_t>(kLeastShare * static_cast<double>(order.size())));
  std::vector<Cut> cuts;
  double next = along_[order.front()][k] + edge_;
  for (std::size_t i = least; i + least <= order.size(); ++i) {
    if (along_[order[i]][k] < next) continue;
    next = along_[order[i]][k] + edge_;
    cuts.push_back({.at = i});
  }
  Extents left, right;
  std::size_t i = 0;
  for (Cut& cut : cuts) {
    for (; i < cut.at; ++i) left.add(along_[order[i]]);
    cut.left = left.area(edge_);
  }
  i = order.size();
  for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut) {
    while (i > cut->at) right.add(along_[order[--i]]);
    cut->right = right.area(edge_);
  }
  return cuts;
}

/// Orders the cells so that the best cut is before `at`; returns the area of both parts.
double Cutter::best_cut(Indices& cells, std::size_t& at) const {
  double best = std::numeric_limits<double>::infinity();
  Indices best_order;
  std::vector<std::pair<double, std::size_t>> sorted(cells.size());
  Indices order(cells.size());
  for (std::size_t k = 0; k < 2 * kDirections; ++k) {
    for (std::size_t i = 0; i < cells.size(); ++i) sorted[i] = {along_[cells[i]][k], cells[i]};
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < cells.size(); ++i) order[i] = sorted[i].second;
    const double cell = edge_ * edge_;
    bool better = false;
    for (const auto& [i, left, right] : cuts_along(order, k)) {
      const bool filled = static_cast<double>(i) * cell >= limits_.fill * left &&
                          static_cast<double>(order.size() - i) * cell >= limits_.fill * right;
      if (!filled || left + right >= best || std::min(left, right) < limits_.smallest_part) continue;
      best = left + right;
      at = i;
      better = true;
    }
    if (better) best_order = order;
  }
  if (!best_order.empty()) cells = std::move(best_order);
  return best;
}

void Cutter::cut(const Indices& cells, int depth, std::vector<Indices>& out) const {
  const bool large = static_cast<double>(cells.size()) * edge_ * edge_ > limits_.largest;
  if (depth < kMostCuts && cells.size() >= 8 && !large) {
    Indices order = cells;
    std::size_t at = 0;
    if (best_cut(order, at) < limits_.clearly * area(order)) {
      cut(Indices(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(at)), depth + 1, out);
      cut(Indices(order.begin() + static_cast<std::ptrdiff_t>(at), order.end()), depth + 1, out);
      return;
    }
  }
  out.push_back(cells);
}

}  // namespace

std::vector<std::vector<std::size_t>> cut_outline(const std::vector<Eigen::Vector2d>& places, double edge, const OutlineCut& limits) {
  std::vector<Indices> out;
  Indices all(places.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Cutter(places, edge, limits).cut(all, 0, out);
  return out;
}

}  // namespace scenelore::perception
