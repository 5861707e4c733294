#include "gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenelore::perception {
namespace {

constexpr double kSeenThrough = 0.5;  // share of the ways between two pieces
constexpr double kShortest = 1.5;     // cells between them
constexpr double kBeside = 2;         // cells: ways so much longer than the shortest one count as well

}  // namespace

double gap_cell(double area, double points) {
  constexpr double kWanted = 4, kFinest = 0.03, kCoarsest = 0.08;
  return std::clamp(std::sqrt(kWanted * area / points), kFinest, kCoarsest);
}

CellKey key_of(const PlaneView& view, const Eigen::Vector2d& p) {
  return cell_key(static_cast<std::int64_t>(std::floor(p.x() / view.edge)), static_cast<std::int64_t>(std::floor(p.y() / view.edge)), 0);
}

CellIndex index_of(const PlaneView& view, const std::vector<Eigen::Vector2d>& places) {
  std::vector<CellKey> keys;
  for (const Eigen::Vector2d& p : places) keys.push_back(key_of(view, p));
  return CellIndex(keys);
}

double Gap::width(std::size_t a, std::size_t b) const {
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t c : pieces_[a]) least = std::min(least, nearest(c, b).first);
  return least;
}

bool Gap::seen_through(std::size_t a, std::size_t b) const {
  const double shortest = width(a, b);
  if (shortest < (1 + kShortest) * view_.edge) return false;
  double through = 0, all = 0;
  for (const std::size_t c : pieces_[a]) {
    const auto [distance, other] = nearest(c, b);
    if (distance > shortest + kBeside * view_.edge) continue;
    const int steps = static_cast<int>(std::ceil(distance / view_.edge));
    for (int k = 1; k < steps; ++k, ++all) {
      const Eigen::Vector2d p = view_.held[c] + (view_.held[other] - view_.held[c]) * k / steps;
      through += empty_.find(key_of(view_, p)) >= 0;
    }
  }
  return through > kSeenThrough * all;
}

std::pair<double, std::size_t> Gap::nearest(std::size_t cell, std::size_t piece) const {
  std::pair<double, std::size_t> best(std::numeric_limits<double>::infinity(), 0);
  for (const std::size_t c : pieces_[piece]) best = std::min(best, {(view_.held[c] - view_.held[cell]).squaredNorm(), c});
  return {std::sqrt(best.first), best.second};
}

}  // namespace scenelore::perception
