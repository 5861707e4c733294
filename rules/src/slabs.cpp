#include "slabs.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scenelore::rules {

namespace {

using Eigen::Vector2d;
using Interval = Slabs::Interval;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;  ///< metres, far above that of corners

bool is_empty(const Interval& interval) { return interval.first > interval.second; }
double length(const Interval& interval) { return std::max(0.0, interval.second - interval.first); }
Interval common(const Interval& a, const Interval& b) { return {std::max(a.first, b.first), std::min(a.second, b.second)}; }
Interval grown(const Interval& interval, double by) { return {interval.first - by, interval.second + by}; }

/// The part of an edge between two heights, along x; the edge must reach into them.
Interval part_between(const Vector2d& from, const Vector2d& to, double low, double high) {
  const auto x_at = [&](double y) { return from.x() + (to.x() - from.x()) * std::clamp((y - from.y()) / (to.y() - from.y()), 0.0, 1.0); };
  if (from.y() == to.y()) return std::minmax({from.x(), to.x()});
  const double one = x_at(std::max(low, std::min(from.y(), to.y()))), other = x_at(std::min(high, std::max(from.y(), to.y())));
  return std::minmax({one, other});
}

/// The longest piece inside on the line at height y, by the even-odd rule.
Interval longest_inside(const Region& region, double y, std::vector<double>& crossings) {
  crossings.clear();
  for (const std::vector<Vector2d>& ring : region.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector2d &from = ring[i], &to = ring[i + 1 == ring.size() ? 0 : i + 1];
      if ((from.y() > y) != (to.y() > y)) crossings.push_back(from.x() + (to.x() - from.x()) * (y - from.y()) / (to.y() - from.y()));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  Interval longest{0, -1};
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i + 1] - crossings[i] > longest.second - longest.first) longest = {crossings[i], crossings[i + 1]};
  }
  return longest;
}

}  // namespace

// An inner rectangle holds no piece of the outline and begins as a line inside, so all of it is inside.
Slabs::Slabs(const Region& region) {
  std::vector<double> crossings;
  for (int i = 0; i < kCount; ++i) {
    Slab& slab = slabs_[static_cast<std::size_t>(i)];
    slab = {bound(region.box, i), i + 1 == kCount ? region.box.max().y() : bound(region.box, i + 1), {kInfinite, -kInfinite}, {0, -1}};
    slab.inner = longest_inside(region, (slab.low + slab.high) / 2, crossings);
  }
  for (const std::vector<Vector2d>& ring : region.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector2d &from = ring[i], &to = ring[i + 1 == ring.size() ? 0 : i + 1];
      const double low = std::min(from.y(), to.y()), high = std::max(from.y(), to.y());
      for (Slab& slab : slabs_) {
        if (slab.low > high + kRounding || slab.high < low - kRounding) continue;
        const Interval part = grown(part_between(from, to, slab.low, slab.high), kRounding);
        slab.outer = {std::min(slab.outer.first, part.first), std::max(slab.outer.second, part.second)};
        const bool beside = slab.low >= high || slab.high <= low;  // on the border at most
        if (beside || part.second <= slab.inner.first || part.first >= slab.inner.second) continue;
        const double left = part.first - slab.inner.first, right = slab.inner.second - part.second;  // what either side would leave
        left > right ? slab.inner.second = part.first : slab.inner.first = part.second;
      }
    }
  }
}

namespace {

/// Along x, what b has beside a slab of a.
struct Beside {
  Interval near{kInfinite, -kInfinite};  ///< nothing of b is within reach beyond
  Interval whole{0, -1};                 ///< is inside b at all heights of the slab
  double sure = 0;                       ///< length of the slab's inner part that is within reach
};

Beside beside(const Slabs::Slab& slab, const Slabs& b, double reach) {
  const auto wide = [reach](double away) { return away <= 0 ? reach : std::sqrt(std::max(0.0, reach * reach - away * away)); };
  Beside out;
  Interval across{-kInfinite, kInfinite};
  double seen_up_to = slab.low;
  for (const Slabs::Slab& other : b.between(slab.low - reach - kRounding, slab.high + reach + kRounding)) {
    const double nearest = std::max({0.0, other.low - slab.high, slab.low - other.high});
    if (nearest > reach + kRounding) continue;
    const Interval outer = grown(other.outer, wide(nearest) + kRounding);
    out.near = {std::min(out.near.first, outer.first), std::max(out.near.second, outer.second)};
    const double farthest = std::max({0.0, other.low - slab.low, slab.high - other.high});
    if (is_empty(other.inner)) {
      if (nearest <= 0) across = other.inner;
      continue;
    }
    if (farthest + kRounding <= reach) out.sure = std::max(out.sure, length(common(slab.inner, grown(other.inner, wide(farthest) - kRounding))));
    if (nearest > 0) continue;
    across = common(across, other.inner);
    if (other.low <= seen_up_to) seen_up_to = std::max(seen_up_to, other.high);
  }
  if (seen_up_to < slab.high || is_empty(across)) return out;
  out.whole = across;
  out.sure = std::max(out.sure, length(common(slab.inner, grown(across, reach - kRounding))));
  return out;
}

}  // namespace

std::span<const Slabs::Slab> Slabs::between(double low, double high) const {
  const double first = slabs_.front().low, height = (slabs_.back().high - first) / kCount;
  if (!(height > 0)) return slabs_;
  const auto index = [&](double y) { return std::clamp((y - first) / height, -1.0, kCount + 1.0); };
  const int begin = std::clamp(static_cast<int>(index(low)) - 1, 0, kCount), end = std::clamp(static_cast<int>(index(high)) + 2, begin, kCount);
  return std::span(slabs_).subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
}

SharedSlabs shared_slabs(const Slabs& a, const Slabs& b, double reach) {
  using Part = SharedSlabs::Part;
  SharedSlabs out;
  for (std::size_t i = Slabs::kCount; i-- > 0;) {
    const Slabs::Slab& slab = a.all()[i];
    const Beside of_b = beside(slab, b, reach);
    const double height = slab.high - slab.low, most = length(common(slab.outer, of_b.near));
    const bool all = of_b.whole.first <= slab.outer.first && slab.outer.second <= of_b.whole.second;
    out.part[i] = all ? Part::all : is_empty(common(slab.outer, of_b.near)) ? Part::none : Part::some;
    out.least[i] = out.least[i + 1] + std::max(0.0, of_b.sure - kRounding) * height;
    out.most[i] = out.most[i + 1] + (most + kRounding) * height;
  }
  return out;
}

}  // namespace scenelore::rules
