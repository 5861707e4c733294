#include "rectangle_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

namespace scenelore::perception {
namespace {

constexpr int kDirections = 90;      // steps of 2 degrees
constexpr double kStray = 0.015;     // share of the cells that may lie beyond each side of a rectangle
constexpr double kLeastShare = 0.03;  // of the cells, in a part
constexpr double kFewestCells = 4;   // in a part
constexpr double kNarrowest = 0.1;   // metres, of a part's rectangle
constexpr double kAreaWeight = 0.1;  // m² empty for a m² of rectangle
constexpr double kSeamWeight = 0.15;  // m² empty for a metre of seam
// Two rectangles have five numbers more than one; a few cells at a ragged edge must not pay for them.
constexpr double kLeastGain = 0.08;  // m²
constexpr double kLeastGainShare = 0.1;  // of the area held
constexpr double kMostLeft = 0.35;   // of what the single rectangle claims: the parts must explain the rest
constexpr int kMostCuts = 2;         // along a path

using Indices = std::vector<std::size_t>;

/// Cells of one rectangle along a direction and across it: first and last column and row, inclusive.
struct Box {
  int x0 = 0, x1 = -1, y0 = 0, y1 = -1;
  [[nodiscard]] int narrow() const { return std::min(x1 - x0, y1 - y0) + 1; }
  [[nodiscard]] double area() const { return static_cast<double>(x1 - x0 + 1) * (y1 - y0 + 1); }  // cells
};

/// The cells in columns along one direction and rows across it.
class Raster {
 public:
  Raster(const PlaneView& view, const Indices& cells, const Eigen::Vector2d& along);

  [[nodiscard]] int columns() const { return nx_; }
  [[nodiscard]] int held(int column) const { return column_[static_cast<std::size_t>(column)]; }
  /// Where a column begins, metres along the direction.
  [[nodiscard]] double begin_of(int column) const { return low_.x() + column * edge_; }
  /// The boxes around the columns from the first to each one or, `mirrored`, from each one to the last.
  [[nodiscard]] std::vector<Box> growing_boxes(bool mirrored) const;
  /// Cells seen through within a box, without the outermost columns and rows: cells at its edge may be of both kinds.
  [[nodiscard]] int empty_within(const Box& box) const;

 private:
  [[nodiscard]] Eigen::Vector2i place(const Eigen::Vector2d& p) const {
    const Eigen::Vector2d at(along_.dot(p), along_.x() * p.y() - along_.y() * p.x());
    return ((at - low_) / edge_).array().floor().cast<int>();
  }
  int& sum(int x, int y) { return empty_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_ + 1) + static_cast<std::size_t>(x)]; }
  [[nodiscard]] int sum(int x, int y) const { return const_cast<Raster&>(*this).sum(x, y); }
  [[nodiscard]] std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x); }

  double edge_;
  Eigen::Vector2d along_, low_;
  int nx_ = 0, ny_ = 0;
  std::vector<int> held_, column_;  // row by row; by column
  std::vector<int> empty_;          // of all cells before a column and below a row
};

Raster::Raster(const PlaneView& view, const Indices& cells, const Eigen::Vector2d& along) : edge_(view.edge), along_(along), low_(0, 0) {
  Eigen::Vector2i low = Eigen::Vector2i::Constant(std::numeric_limits<int>::max()), high = -low;
  std::vector<Eigen::Vector2i> places;
  for (const std::size_t c : cells) {
    places.push_back(place(view.held[c]));
    low = low.cwiseMin(places.back()), high = high.cwiseMax(places.back());
  }
  nx_ = high.x() - low.x() + 1, ny_ = high.y() - low.y() + 1;
  held_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), 0);
  column_.assign(static_cast<std::size_t>(nx_), 0);
  empty_.assign(static_cast<std::size_t>(nx_ + 1) * static_cast<std::size_t>(ny_ + 1), 0);
  for (const Eigen::Vector2i& p : places) {
    ++held_[index(p.x() - low.x(), p.y() - low.y())];
    ++column_[static_cast<std::size_t>(p.x() - low.x())];
  }
  for (const Eigen::Vector2d& e : view.empty) {
    const Eigen::Vector2i p = place(e) - low;
    if (p.x() >= 0 && p.y() >= 0 && p.x() < nx_ && p.y() < ny_) ++sum(p.x() + 1, p.y() + 1);
  }
  for (int y = 1; y <= ny_; ++y) {
    for (int x = 1; x <= nx_; ++x) sum(x, y) += sum(x - 1, y) + sum(x, y - 1) - sum(x - 1, y - 1);
  }
  low_ = low.cast<double>() * edge_;
}

int Raster::empty_within(const Box& box) const {
  if (box.narrow() < 3) return 0;
  return sum(box.x1, box.y1) - sum(box.x0 + 1, box.y1) - sum(box.x1, box.y0 + 1) + sum(box.x0 + 1, box.y0 + 1);
}

/// First and last place of a histogram beyond which at most `stray` lie.
std::pair<int, int> trimmed(const std::vector<int>& histogram, int first, int last, double stray) {
  const int from = first;
  for (int n = histogram[static_cast<std::size_t>(first)]; first < last && n <= stray; n += histogram[static_cast<std::size_t>(first)]) ++first;
  for (int n = histogram[static_cast<std::size_t>(last)]; last > from && n <= stray; n += histogram[static_cast<std::size_t>(last)]) --last;
  return {first, std::max(first, last)};
}

std::vector<Box> Raster::growing_boxes(bool mirrored) const {
  std::vector<Box> boxes(static_cast<std::size_t>(nx_));
  std::vector<int> rows(static_cast<std::size_t>(ny_), 0);
  int taken = 0;
  for (int k = 0; k < nx_; ++k) {
    const int x = mirrored ? nx_ - 1 - k : k;
    for (int y = 0; y < ny_; ++y) rows[static_cast<std::size_t>(y)] += held_[index(x, y)];
    taken += held(x);
    const double stray = kStray * taken;
    Box& box = boxes[static_cast<std::size_t>(x)];
    std::tie(box.x0, box.x1) = mirrored ? trimmed(column_, x, nx_ - 1, stray) : trimmed(column_, 0, x, stray);
    std::tie(box.y0, box.y1) = trimmed(rows, 0, ny_ - 1, stray);
  }
  return boxes;
}

/// Appends the parts of these cells; returns the area that their rectangles claim and that is empty. Whether a line pays
/// shows when both sides are parted in turn: a row of three desks needs two.
double part(const PlaneView& view, const Indices& cells, int depth, std::vector<Indices>& out) {
  const std::size_t before = out.size();
  const std::optional<RectanglePair> pair = best_rectangle_pair(view, cells);
  const double least = std::max(kLeastGain, kLeastGainShare * static_cast<double>(cells.size()) * view.edge * view.edge);
  if (pair && depth < kMostCuts && pair->empty_one - pair->empty_two > least / 2) {
    Indices first, second;
    for (const std::size_t c : cells) (pair->across.dot(view.held[c]) < pair->at ? first : second).push_back(c);
    const double left = part(view, first, depth + 1, out) + part(view, second, depth + 1, out);
    if (left < kMostLeft * pair->empty_one && pair->empty_one - left > least) return left;
    out.resize(before);
  }
  out.push_back(cells);
  return pair ? pair->empty_one : 0;
}

}  // namespace

std::optional<RectanglePair> best_rectangle_pair(const PlaneView& view, const std::vector<std::size_t>& cells) {
  std::optional<RectanglePair> best;
  const double cell = view.edge * view.edge, all = static_cast<double>(cells.size());
  const double least = std::max(kFewestCells, kLeastShare * all);
  double best_one = std::numeric_limits<double>::infinity(), best_two = best_one, empty_one = 0;
  for (int k = 0; k < kDirections && 2 * kFewestCells <= all; ++k) {
    const double angle = k * std::numbers::pi / kDirections;
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    const Raster raster(view, cells, along);
    const std::vector<Box> before = raster.growing_boxes(false), behind = raster.growing_boxes(true);
    const double one = raster.empty_within(before.back()) * cell, one_cost = one + kAreaWeight * before.back().area() * cell;
    if (one_cost < best_one) best_one = one_cost, empty_one = one;
    double held = 0;
    for (int x = 0; x + 1 < raster.columns(); ++x) {
      held += raster.held(x);
      const Box &a = before[static_cast<std::size_t>(x)], &b = behind[static_cast<std::size_t>(x + 1)];
      if (held < least || all - held < least || std::min(a.narrow(), b.narrow()) * view.edge < kNarrowest) continue;
      const double two = (raster.empty_within(a) + raster.empty_within(b)) * cell;
      const double seam = std::max(0, std::min(a.y1, b.y1) - std::max(a.y0, b.y0) + 1) * view.edge;
      const double cost = two + kAreaWeight * (a.area() + b.area()) * cell + kSeamWeight * seam;
      if (cost >= best_two) continue;
      best_two = cost;
      best = RectanglePair{.across = along, .at = raster.begin_of(x + 1), .empty_one = 0, .empty_two = two};
    }
  }
  if (best) best->empty_one = empty_one;
  return best;
}

std::vector<std::vector<std::size_t>> part_into_rectangles(const PlaneView& view) {
  std::vector<Indices> parts;
  Indices all(view.held.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (view.empty.empty()) return {all};
  part(view, all, 0, parts);
  return parts;
}

}  // namespace scenelore::perception
