#include "pair_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <utility>

#include "scenelore/perception/parallel.hpp"

namespace scenelore::rules {

namespace {

/// How an answer is kept; without gaps between the fields.
struct Entry {
  std::int32_t a, b;
  double reach, low, high;
};
static_assert(sizeof(Entry) == 32);

constexpr double kUnknown = -1;  ///< no angle

}  // namespace

void PairGeometry::grow() {
  shapes_.resize(planes_->size());
  known_.resize(planes_->size());
}

void PairGeometry::prepare(int threads) const {
  constexpr std::size_t kPiece = 16;
  perception::parallel_pieces(planes_->size(), kPiece, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) (void)shape(static_cast<int>(i));
  });
}

const PlaneShape& PairGeometry::shape(int i) const {
  if (shapes_.size() < planes_->size()) shapes_.resize(planes_->size());
  std::unique_ptr<PlaneShape>& shape = shapes_[static_cast<std::size_t>(i)];
  if (!shape) shape = std::make_unique<PlaneShape>((*planes_)[static_cast<std::size_t>(i)]);
  return *shape;
}

std::vector<Box3> boxes_of(const std::vector<perception::Plane>& planes) {
  std::vector<Box3> boxes;
  boxes.reserve(planes.size());
  for (const perception::Plane& plane : planes) boxes.push_back(box_of(plane));
  return boxes;
}

double PairGeometry::angle(int a, int b) {
  constexpr std::size_t kMostPlanes = 1000;  // so that what is kept stays below 4 MB
  const auto compute = [&] {
    const Eigen::Vector3d &n = shape(a).normal, &m = shape(b).normal;
    return std::atan2(n.cross(m).norm(), std::abs(n.dot(m))) * 180 / std::numbers::pi;
  };
  if (known_.size() < planes_->size()) grow();
  if (known_.size() > kMostPlanes) return compute();
  const auto smaller = static_cast<std::size_t>(std::min(a, b)), further = static_cast<std::size_t>(std::abs(a - b));
  std::vector<double>& angles = known_[smaller].angles;
  if (angles.size() <= further) angles.resize(known_.size() - smaller, kUnknown);
  if (angles[further] == kUnknown) angles[further] = compute();
  return angles[further];
}

/// The limits tell what must be known; what is found out is kept.
template <typename Compute>
double PairGeometry::known_or(const KnownRanges::Key& key, const Limits& limits, Compute compute) {
  if (known_.size() < planes_->size()) grow();
  Known& known = known_[static_cast<std::size_t>(std::min(key.a, key.b))];
  KnownRanges::Range& range = known.ranges.of(key);
  if (range.low == range.high) return limits(range.low);
  if (range.low >= limits.high) return limits.high;
  if (range.high <= limits.low) return limits.low;
  known.has_news = true;
  const double value = compute();
  if (value >= limits.high) {
    range.low = limits.high;
  } else if (value <= limits.low) {
    range.high = value;
  } else {
    range = {value, value};
  }
  return limits(value);
}

double PairGeometry::gap(int a, int b, const Limits& limits) {
  const int i = std::min(a, b), j = std::max(a, b);
  return known_or({i, j, -1}, limits, [&] { return hull_gap(shape(i), shape(j), limits); });
}

double PairGeometry::footprint_overlap(int a, int b, double reach, const Limits& limits) {
  reach = std::max(reach, 0.0);
  return known_or({a, b, reach}, limits, [&] { return footprint_share(shape(a), shape(b), reach, limits); });
}

double PairGeometry::vertical_gap(int a, int b) const { return shape(a).box.min().z() - shape(b).box.max().z(); }
double PairGeometry::plane_distance(int a, int b) const { return std::abs(side(a, b)); }
double PairGeometry::side(int a, int b) const { return shape(b).signed_distance(shape(a).centroid); }
double PairGeometry::centroid_distance(int a, int b) const { return (shape(a).centroid - shape(b).centroid).norm(); }

std::string PairGeometry::answers() const {
  std::vector<Entry> entries;
  std::size_t count = 0;
  for (const Known& known : known_) count += known.ranges.size();
  entries.reserve(count);
  for (const Known& known : known_) {
    known.ranges.for_each([&](const KnownRanges::Key& key, const KnownRanges::Range& range) {
      entries.push_back({key.a, key.b, key.reach, range.low, range.high});
    });
  }
  const auto pair = [](const Entry& e) { return (static_cast<std::int64_t>(e.a) << 32) + e.b; };  // compared at once
  std::sort(entries.begin(), entries.end(),
            [&](const Entry& e, const Entry& f) { return pair(e) != pair(f) ? pair(e) < pair(f) : e.reach < f.reach; });
  return {reinterpret_cast<const char*>(entries.data()), entries.size() * sizeof(Entry)};
}

void PairGeometry::remember(std::string_view answers) {
  for (; answers.size() >= sizeof(Entry); answers.remove_prefix(sizeof(Entry))) {
    Entry entry;
    std::memcpy(&entry, answers.data(), sizeof entry);
    const bool sane = entry.a >= 0 && entry.b >= 0 && entry.a < size() && entry.b < size() && entry.low >= 0 && entry.low <= entry.high;
    if (!sane) continue;
    known_[static_cast<std::size_t>(std::min(entry.a, entry.b))].ranges.of({entry.a, entry.b, entry.reach}) = {entry.low, entry.high};
  }
}

bool PairGeometry::has_news() const {
  return std::any_of(known_.begin(), known_.end(), [](const Known& known) { return known.has_news; });
}

namespace {

/// Squares of how far two boxes are apart.
struct Apart {
  double in_space, seen_from_above;

  Apart(const Box3& a, const Box3& b) {
    const Eigen::Vector3d gaps = (a.min() - b.max()).cwiseMax(b.min() - a.max()).cwiseMax(0.0);
    in_space = gaps.squaredNorm();
    seen_from_above = gaps.head<2>().squaredNorm();
  }
  [[nodiscard]] bool within(const Reach& reach) const {
    return in_space <= reach.within * reach.within && seen_from_above <= reach.within_plan * reach.within_plan;
  }
};

}  // namespace

bool in_reach(const Box3& a, const Box3& b, double within, double within_plan) { return Apart(a, b).within({within, within_plan}); }

std::vector<Pairs> pairs_in_reach(const std::vector<Box3>& boxes, std::span<const Reach> reaches) {
  double furthest = 0;
  for (const Reach& reach : reaches) furthest = std::max(furthest, std::min(reach.within, reach.within_plan));
  furthest = furthest * (1 + 1e-9) + 1e-9;  // whatever is rounded where
  std::vector<Pairs> out(reaches.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const double left = boxes[i].min().x() - furthest, right = boxes[i].max().x() + furthest;
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (boxes[j].max().x() < left || boxes[j].min().x() > right) continue;
      const Apart apart(boxes[i], boxes[j]);
      for (std::size_t r = 0; r < reaches.size(); ++r) {
        if (apart.within(reaches[r])) out[r].emplace_back(static_cast<int>(i), static_cast<int>(j));
      }
    }
  }
  return out;
}

Pairs pairs_in_reach(const std::vector<Box3>& boxes, double within, double within_plan) {
  const Reach reach{within, within_plan};
  return std::move(pairs_in_reach(boxes, {&reach, 1}).front());
}

}  // namespace scenelore::rules
