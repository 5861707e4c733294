#include "scanned_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenelore::rules {

namespace {

using Level = ScannedRegion::Level;
using Interval = std::pair<double, double>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// The edges that a line along x meets, or comes within a margin of, while it rises.
class Sweep {
 public:
  Sweep(const std::vector<Level>& by_low, double margin) : levels_(by_low), margin_(margin) {}

  /// `y` must not fall from call to call.
  const std::vector<const Level*>& at(double y) {
    for (; next_ < levels_.size() && levels_[next_].low - margin_ <= y; ++next_) active_.push_back(&levels_[next_]);
    std::erase_if(active_, [&](const Level* level) { return level->high + margin_ < y; });
    return active_;
  }

 private:
  const std::vector<Level>& levels_;
  double margin_;
  std::size_t next_ = 0;
  std::vector<const Level*> active_;
};

/// Where the line at height y runs inside, by the even-odd rule, from the edges that it may meet. `crossings` is scratch.
void add_inside(const std::vector<const Level*>& edges, double y, std::vector<double>& crossings, Intervals& out) {
  crossings.clear();
  for (const Level* edge : edges) {
    if (y < edge->low || y >= edge->high) continue;
    crossings.push_back(edge->from.x() + (edge->to.x() - edge->from.x()) * (y - edge->from.y()) / (edge->to.y() - edge->from.y()));
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) out.emplace_back(crossings[i], crossings[i + 1]);
}

/// The part of the line at height y that lies within `reach` of an edge: the edge's stadium is convex, hence one interval, the hull of
/// those of its strip and its two discs. Empty (low > high) where there is none.
Interval near_level(const Level& edge, double y, double reach) {
  double low = kInfinite, high = -kInfinite;
  for (const Eigen::Vector2d& end : {edge.from, edge.to}) {
    const double away = end.y() - y;
    if (std::abs(away) > reach) continue;
    const double half = std::sqrt(reach * reach - away * away);
    low = std::min(low, end.x() - half);
    high = std::max(high, end.x() + half);
  }
  if (edge.length <= 0) return {low, high};
  // Strip, for the point (s, y): |across·(point − from)| ≤ reach and 0 ≤ along·(point − from) ≤ length.
  const Eigen::Vector2d& u = edge.along;
  const double rise = y - edge.from.y();
  double strip_low = -kInfinite, strip_high = kInfinite;
  const auto clip = [&](double at_zero, double slope, double least, double most) {
    if (slope == 0) {
      if (at_zero < least || at_zero > most) strip_high = -kInfinite;
      return;
    }
    const double s = (least - at_zero) / slope, t = (most - at_zero) / slope;
    strip_low = std::max(strip_low, std::min(s, t));
    strip_high = std::min(strip_high, std::max(s, t));
  };
  clip(u.x() * rise + u.y() * edge.from.x(), -u.y(), -reach, reach);
  clip(u.y() * rise - u.x() * edge.from.x(), u.x(), 0, edge.length);
  if (strip_low > strip_high) return {low, high};
  return {std::min(low, strip_low), std::max(high, strip_high)};
}

double length_of(std::span<const Interval> intervals) {
  double length = 0;
  for (const auto& [low, high] : intervals) length += high - low;
  return length;
}

/// How much of `a` lies within `reach` of b, line by line from below.
class Shares {
 public:
  Shares(const ScannedRegion& a, const ScannedRegion& b, double reach) : reach_(reach), inside_b_(b.levels(), 0), near_b_(close_, reach) {
    const Box2 around(a.box().min().array() - reach, a.box().max().array() + reach);
    for (const Level& edge : b.levels()) {
      const bool reaches = edge.high >= around.min().y() && edge.low <= around.max().y() &&
                           std::max(edge.from.x(), edge.to.x()) >= around.min().x() && std::min(edge.from.x(), edge.to.x()) <= around.max().x();
      if (reaches) close_.push_back(edge);
    }
  }

  /// The line at height y, on which a has the intervals `of_a`, standing for a slab of this height.
  void add(double y, double height, std::span<const Interval> of_a) {
    if (of_a.empty()) return;
    const double length = length_of(of_a);
    all_ += length * height;
    of_b_.clear();
    add_inside(inside_b_.at(y), y, crossings_, of_b_);
    double shared = shared_length(of_a, of_b_);
    if (shared < length) {  // else b itself has all of it, whatever is near
      const std::size_t inside = of_b_.size();
      for (const Level* edge : near_b_.at(y)) {
        const Interval near = near_level(*edge, y, reach_);
        if (near.first < near.second) of_b_.push_back(near);
      }
      if (of_b_.size() > inside) {
        merge(of_b_);
        shared = shared_length(of_a, of_b_);
      }
    }
    shared_ += shared * height;
  }

  [[nodiscard]] double share() const { return all_ > 0 ? std::clamp(shared_ / all_, 0.0, 1.0) : 0; }

 private:
  double reach_;
  std::vector<Level> close_;  // edges of b that may be within reach of a
  Sweep inside_b_, near_b_;
  std::vector<double> crossings_;
  Intervals of_b_;
  double all_ = 0, shared_ = 0;
};

/// Calls back with height and slab of each of the lines through the slabs between the given heights.
template <typename Visit>
void for_each_line(const std::vector<double>& cuts, Visit visit) {
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double height = (cuts[i + 1] - cuts[i]) / ScannedRegion::kLinesPerSlab;
    for (int k = 0; k < ScannedRegion::kLinesPerSlab; ++k) visit(cuts[i] + (k + 0.5) * height, height);
  }
}

std::vector<double> even_slabs(const Box2& box) {
  const double low = box.min().y(), high = box.max().y();
  std::vector<double> cuts;
  for (int i = 0; i <= ScannedRegion::kSlabs; ++i) cuts.push_back(low + (high - low) * i / ScannedRegion::kSlabs);
  return cuts;
}

/// Heights at which the share of a line may jump: corners, and b's corners moved by the reach. Nothing where there are so many that
/// the jumps are small and even slabs are enough.
std::vector<double> jumps(const ScannedRegion& a, const ScannedRegion& b, double reach) {
  constexpr std::size_t kMost = 4 * ScannedRegion::kSlabs;
  const double low = a.box().min().y(), high = a.box().max().y();
  std::vector<double> heights;
  if (a.levels().size() > kMost) return heights;
  for (const Level& edge : a.levels()) heights.push_back(edge.from.y());
  for (const Level& edge : b.levels()) {
    for (const double move : {-reach, 0.0, reach}) {
      const double y = edge.from.y() + move;
      if (y >= low && y <= high) heights.push_back(y);
    }
    if (heights.size() > kMost) return {};
  }
  return heights;
}

}  // namespace

ScannedRegion::ScannedRegion(Region region) : region_(std::move(region)), area_(region_.area()) {
  for (const std::vector<Eigen::Vector2d>& ring : region_.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d &from = ring[i], &to = ring[i + 1 == ring.size() ? 0 : i + 1], d = to - from;
      const double length = d.norm();
      const Eigen::Vector2d along = length > 0 ? Eigen::Vector2d(d / length) : Eigen::Vector2d(0, 0);
      levels_.push_back({from, to, std::min(from.y(), to.y()), std::max(from.y(), to.y()), along, length});
    }
  }
  std::stable_sort(levels_.begin(), levels_.end(), [](const Level& e, const Level& f) { return e.low < f.low; });
}

bool ScannedRegion::boundary_enters(const Box2& box) const {
  for (const Level& edge : levels_) {
    if (edge.low > box.max().y()) return false;
    if (edge.high >= box.min().y() && std::max(edge.from.x(), edge.to.x()) >= box.min().x() &&
        std::min(edge.from.x(), edge.to.x()) <= box.max().x()) {
      return true;
    }
  }
  return false;
}

std::span<const Interval> ScannedRegion::even_line(int i) const {
  if (even_ends_.empty()) {
    Sweep sweep(levels_, 0);
    std::vector<double> crossings;
    for_each_line(even_slabs(box()), [&](double y, double) {
      add_inside(sweep.at(y), y, crossings, even_);
      even_ends_.push_back(even_.size());
    });
  }
  const auto line = static_cast<std::size_t>(i);
  const std::size_t begin = line == 0 ? 0 : even_ends_[line - 1];
  return std::span<const Interval>(even_).subspan(begin, even_ends_[line] - begin);
}

double share_within(const ScannedRegion& a, const ScannedRegion& b, double reach) {
  if (a.box().isEmpty() || b.box().isEmpty()) return 0;
  const Box2 grown(b.box().min().array() - reach, b.box().max().array() + reach);
  if (!a.box().intersects(grown)) return 0;
  if (!b.boundary_enters(a.box())) {  // b's outline stays clear of a: all of a is inside, or none of it
    if (b.region().contains(a.box().center())) return 1;
    if (reach <= 0) return 0;
  }
  if (a.area() <= 0) return 0;
  if (reach <= 0) return std::clamp(shared_area(a.region(), b.region()) / a.area(), 0.0, 1.0);
  Shares shares(a, b, reach);
  std::vector<double> cuts = jumps(a, b, reach);
  const std::vector<double> even = even_slabs(a.box());
  if (cuts.empty()) {
    int line = 0;
    for_each_line(even, [&](double y, double height) { shares.add(y, height, a.even_line(line++)); });
    return shares.share();
  }
  cuts.insert(cuts.end(), even.begin(), even.end());
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  Sweep sweep(a.levels(), 0);
  std::vector<double> crossings;
  Intervals of_a;
  for_each_line(cuts, [&](double y, double height) {
    of_a.clear();
    add_inside(sweep.at(y), y, crossings, of_a);
    shares.add(y, height, of_a);
  });
  return shares.share();
}

double share_within(const Region& a, const Region& b, double reach) { return share_within(ScannedRegion(a), ScannedRegion(b), reach); }

}  // namespace scenelore::rules
