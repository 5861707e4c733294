#include "outline_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace scenelore::perception {
namespace {

constexpr int kDirections = 12;        // steps of 7.5 degrees
constexpr double kLeastShare = 0.06;   // of the cells
constexpr int kMostCuts = 4;           // along a path

using Indices = std::vector<std::size_t>;

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double x) { low = std::min(low, x), high = std::max(high, x); }
};

class Cutter {
 public:
  Cutter(const std::vector<Eigen::Vector2d>& places, double edge, const OutlineCut& limits) : places_(places), edge_(edge), limits_(limits) {
    for (int k = 0; k < kDirections; ++k) {
      const double angle = k * std::numbers::pi / 2 / kDirections;
      directions_[static_cast<std::size_t>(k)] = {std::cos(angle), std::sin(angle)};
    }
  }

  void cut(const Indices& cells, int depth, std::vector<Indices>& out) const;

 private:
  /// Along direction k, or across it (k ≥ kDirections).
  [[nodiscard]] double along(std::size_t cell, int k) const {
    const Eigen::Vector2d& d = directions_[static_cast<std::size_t>(k % kDirections)];
    const Eigen::Vector2d& p = places_[cell];
    return k < kDirections ? d.dot(p) : d.x() * p.y() - d.y() * p.x();
  }
  [[nodiscard]] double area(const Indices& cells, std::size_t begin, std::size_t end) const;
  [[nodiscard]] double best_cut(Indices& cells, std::size_t& at) const;

  const std::vector<Eigen::Vector2d>& places_;
  double edge_;
  OutlineCut limits_;
  std::array<Eigen::Vector2d, kDirections> directions_;
};

/// Of the smallest rectangle, over the directions tried, that holds the cells whole.
double Cutter::area(const Indices& cells, std::size_t begin, std::size_t end) const {
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kDirections; ++k) {
    Extent x, y;
    for (std::size_t i = begin; i < end; ++i) x.add(along(cells[i], k)), y.add(along(cells[i], k + kDirections));
    best = std::min(best, (x.high - x.low + edge_) * (y.high - y.low + edge_));
  }
  return best;
}

/// Orders the cells so that the best cut is before `at`; returns the area of both parts.
double Cutter::best_cut(Indices& cells, std::size_t& at) const {
  double best = std::numeric_limits<double>::infinity();
  const auto least = std::max<std::size_t>(2, static_cast<std::size_t>(kLeastShare * static_cast<double>(cells.size())));
  Indices best_order;
  for (int k = 0; k < 2 * kDirections; ++k) {
    Indices order = cells;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return std::pair(along(a, k), a) < std::pair(along(b, k), b); });
    const double first = along(order.front(), k);
    double next = first + edge_;
    for (std::size_t i = least; i + least <= order.size(); ++i) {
      if (along(order[i], k) < next) continue;
      next = along(order[i], k) + edge_;
      const double left = area(order, 0, i), right = area(order, i, order.size());
      const double cell = edge_ * edge_;
      const bool filled = static_cast<double>(i) * cell >= limits_.fill * left &&
                          static_cast<double>(order.size() - i) * cell >= limits_.fill * right;
      if (!filled || left + right >= best || std::min(left, right) < limits_.smallest_part) continue;
      best = left + right;
      best_order = order;
      at = i;
    }
  }
  if (!best_order.empty()) cells = std::move(best_order);
  return best;
}

void Cutter::cut(const Indices& cells, int depth, std::vector<Indices>& out) const {
  const bool large = static_cast<double>(cells.size()) * edge_ * edge_ > limits_.largest;
  if (depth < kMostCuts && cells.size() >= 8 && !large) {
    Indices order = cells;
    std::size_t at = 0;
    if (best_cut(order, at) < limits_.clearly * area(order, 0, order.size())) {
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
