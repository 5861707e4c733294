#include "scanned_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace scenelore::rules {

namespace {

using Level = ScannedRegion::Level;
using Interval = std::pair<double, double>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kGauss = 0.57735026918962576;  // 1 / √3: two lines so far from the middle are exact for cubic widths (Gauss–Legendre)

/// The edges that a line along x comes within a margin of, while it rises.
class Sweep {
 public:
  /// `by_low` must live as long.
  Sweep(std::span<const Level* const> by_low, double margin) : levels_(by_low), margin_(margin) {}

  /// `y` must not fall from call to call.
  const std::vector<const Level*>& at(double y) {
    for (; next_ < levels_.size() && levels_[next_]->low - margin_ <= y; ++next_) {
      active_.push_back(levels_[next_]);
      first_end_ = std::min(first_end_, levels_[next_]->high + margin_);
    }
    if (first_end_ < y) drop_below(y);
    return active_;
  }

 private:
  void drop_below(double y) {
    first_end_ = kInfinite;
    std::erase_if(active_, [&](const Level* level) {
      const double end = level->high + margin_;
      if (end >= y) first_end_ = std::min(first_end_, end);
      return end < y;
    });
  }

  std::span<const Level* const> levels_;
  double margin_;
  double first_end_ = kInfinite;  // where the first of the active ones is left behind
  std::size_t next_ = 0;
  std::vector<const Level*> active_;
};

/// Where the line at height y runs inside, by the even-odd rule. `crossings` is scratch.
void add_inside(const EdgesByHeight& edges, double y, std::vector<double>& crossings, Intervals& out) {
  crossings.clear();
  for (const auto& [from, to] : edges.at(y)) {
    if ((from.y() > y) != (to.y() > y)) crossings.push_back(from.x() + (to.x() - from.x()) * (y - from.y()) / (to.y() - from.y()));
  }
  if (crossings.size() == 2) {  // mostly
    out.push_back(std::minmax(crossings[0], crossings[1]));
    return;
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

/// The limit that a share lies beyond, if its bounds tell.
std::optional<double> decide(double least, double most, double area, const Limits& limits) {
  constexpr double kRounding = 1e-9;
  if (least >= limits.high * area * (1 + kRounding)) return limits.high;
  if (most <= limits.low * area * (1 - kRounding)) return limits.low;
  return std::nullopt;
}

/// How much of the lines through `a` lies within `reach` of b.
class Shares {
 public:
  Shares(const ScannedRegion& a, const ScannedRegion& b, double reach) : b_(b), reach_(reach) {
    const Box2 around(a.box().min().array() - reach, a.box().max().array() + reach);
    close_.reserve(b.levels().size());
    for (const Level& edge : b.levels()) {
      if (edge.low > around.max().y()) break;
      const bool reaches = edge.high >= around.min().y() && edge.low <= around.max().y() && edge.right >= around.min().x() && edge.left <= around.max().x();
      if (reaches) close_.push_back(&edge);
    }
  }

  /// The share of an area, of which `for_each_line` visits lines from below. Ends when the limits tell the answer.
  template <typename ForEachLine>
  [[nodiscard]] double of(double area, ForEachLine for_each_line, const Slabs& slabs, const SharedSlabs& plain, const Limits& limits) {
    Sweep near_b(close_, reach_);
    double all = 0, shared = 0;
    std::optional<double> decided;
    std::size_t slab = 0;
    for_each_line([&](const CutLine& line) {
      if (slab + 1 < slabs.all().size() && line.y > slabs.all()[slab].high) {
        ++slab;
        decided = decide(shared + plain.least[slab], shared + plain.most[slab], area, limits);
        if (decided) return false;
      }
      all += line.length * line.height;
      if (line.inside.empty() || plain.part[slab] == SharedSlabs::Part::none) return true;
      const bool is_all = plain.part[slab] == SharedSlabs::Part::all;
      shared += (is_all ? line.length : shared_on(line, near_b)) * line.height;
      return true;
    });
    return decided ? *decided : all > 0 ? std::clamp(shared / all, 0.0, 1.0) : 0;
  }

 private:
  /// Length on the line that a has and b has or is near to.
  double shared_on(const CutLine& line, Sweep& near_b) {
    of_b_.clear();
    add_inside(b_.edges(), line.y, crossings_, of_b_);
    const double shared = shared_length(line.inside, of_b_);
    if (shared >= line.length) return shared;  // b itself has all of it, whatever is near
    const std::size_t inside = of_b_.size();
    const bool all = add_near(line, near_b.at(line.y));
    if (all) return line.length;
    if (of_b_.size() == inside) return shared;
    merge(of_b_);
    return shared_length(line.inside, of_b_);
  }

  /// Adds to what b has the intervals near its edges, but for those that cannot matter: only where a goes on beyond b does it matter how
  /// far from b. Returns whether they make up for all that b lacks.
  bool add_near(const CutLine& line, const std::vector<const Level*>& edges) {
    Lack lack(line.inside, of_b_);
    const bool touching = std::adjacent_find(of_b_.begin(), of_b_.end(), [](const Interval& i, const Interval& j) { return i.second >= j.first; }) != of_b_.end();
    const bool a_matter_of_rounding = lack.none() || touching;  // which all intervals together settle
    for (const Level* edge : edges) {
      if (!a_matter_of_rounding && !lack.concerns(edge->left - reach_, edge->right + reach_)) continue;
      const Interval near = near_level(*edge, line.y, reach_);
      if (!(near.first < near.second)) continue;
      of_b_.push_back(near);
      lack.fill(near);
      if (lack.none() && !a_matter_of_rounding) return true;
    }
    return false;
  }

  const ScannedRegion& b_;
  double reach_;
  std::vector<const Level*> close_;  // edges of b that may be within reach of a
  std::vector<double> crossings_;
  Intervals of_b_;
};

std::vector<double> even_slabs(const Box2& box) {
  std::vector<double> cuts;
  for (int i = 0; i <= Slabs::kCount; ++i) cuts.push_back(Slabs::bound(box, i));
  return cuts;
}

/// Visits the lines through the slabs between the given heights, from below, until `visit` returns false.
template <typename Visit>
void cut_lines(const ScannedRegion& region, const std::vector<double>& heights, Visit visit) {
  std::vector<double> crossings;
  Intervals inside;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const double height = (heights[i + 1] - heights[i]) / 2, middle = heights[i] + height;
    for (const double place : {-kGauss, kGauss}) {
      const double y = middle + place * height;
      inside.clear();
      add_inside(region.edges(), y, crossings, inside);
      if (!visit(CutLine{y, height, length_of(inside), inside})) return;
    }
  }
}

/// Heights at which the share of a line may jump: corners, and b's corners moved by the reach. Nothing where there are so many that
/// the jumps are small and even slabs are enough.
std::vector<double> jumps(const ScannedRegion& a, const ScannedRegion& b, double reach) {
  constexpr std::size_t kMost = 4 * Slabs::kCount;
  const double low = a.box().min().y(), high = a.box().max().y();
  std::vector<double> heights;
  if (a.levels().size() > kMost) return heights;
  heights.reserve(kMost + 3);
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

void CutLines::add(const CutLine& line) {
  const std::size_t begin = inside_.size();
  inside_.insert(inside_.end(), line.inside.begin(), line.inside.end());
  lines_.push_back({line.y, line.height, line.length, begin, inside_.size()});
  area_ += line.length * line.height;
}

ScannedRegion::ScannedRegion(Region region) : region_(std::move(region)), area_(region_.area()), edges_(region_) {
  for (const std::vector<Eigen::Vector2d>& ring : region_.rings) {
    levels_.reserve(levels_.size() + ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d &from = ring[i], &to = ring[i + 1 == ring.size() ? 0 : i + 1], d = to - from;
      const double length = d.norm();
      const Eigen::Vector2d along = length > 0 ? Eigen::Vector2d(d / length) : Eigen::Vector2d(0, 0);
      levels_.push_back({from, to, std::min(from.y(), to.y()), std::max(from.y(), to.y()), std::min(from.x(), to.x()),
                         std::max(from.x(), to.x()), along, length});
    }
  }
  std::stable_sort(levels_.begin(), levels_.end(), [](const Level& e, const Level& f) { return e.low < f.low; });
}

const CutLines& ScannedRegion::even_lines() const {
  std::call_once(later_->even_lines_made, [&] {
    cut_lines(*this, even_slabs(box()), [&](const CutLine& line) {
      later_->even_lines.add(line);
      return true;
    });
  });
  return later_->even_lines;
}

const Slabs& ScannedRegion::slabs() const {
  std::call_once(later_->slabs_made, [&] { later_->slabs = Slabs(region_); });
  return later_->slabs;
}

double share_within(const ScannedRegion& a, const ScannedRegion& b, double reach, const Limits& limits) {
  if (a.box().isEmpty() || b.box().isEmpty()) return 0;
  const Box2 grown(b.box().min().array() - reach, b.box().max().array() + reach);
  if (!a.box().intersects(grown)) return 0;
  if (!b.edges().enter(a.box())) {  // b's outline stays clear of a: all of a is inside, or none of it
    if (b.edges().contains(a.box().center())) return 1;
    if (reach <= 0) return 0;
  }
  if (a.area() <= 0) return 0;
  if (reach <= 0) return std::clamp(shared_area(a.region(), b.region()) / a.area(), 0.0, 1.0);
  if (const auto decided = decide(0, grown.intersection(a.box()).sizes().prod(), a.area(), limits)) return *decided;  // b is too small to matter
  std::vector<double> cuts = jumps(a, b, reach);
  const SharedSlabs plain = shared_slabs(a.slabs(), b.slabs(), reach);
  const double area = cuts.empty() ? a.even_lines().area() : a.area();  // which lines cut at each corner have, too, unless a crosses itself
  if (const auto decided = decide(plain.least[0], plain.most[0], area, limits)) return *decided;
  Shares shares(a, b, reach);
  const auto share = [&](auto for_each_line) { return shares.of(area, for_each_line, a.slabs(), plain, limits); };
  if (cuts.empty()) return share([&](auto visit) { a.even_lines().for_each(visit); });
  const std::vector<double> even = even_slabs(a.box());
  cuts.insert(cuts.end(), even.begin(), even.end());
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return share([&](auto visit) { cut_lines(a, cuts, visit); });
}

/// Where b's outline stays out of reach, all of the segment is inside or none of it.
double share_within(const Segment2& a, const ScannedRegion& b, double reach) {
  constexpr double kRounding = 1e-6;  // metres, far above that of where a line is crossed
  const double clear = std::max(reach, 0.0) + kRounding;
  const Box2 around(a.from.cwiseMin(a.to).array() - clear, a.from.cwiseMax(a.to).array() + clear);
  if (!b.edges().enter(around)) return b.edges().contains(a.from) ? 1 : 0;
  return share_within(a, b.region(), reach);
}

double share_within(const Region& a, const Region& b, double reach) { return share_within(ScannedRegion(a), ScannedRegion(b), reach); }

}  // namespace scenelore::rules
