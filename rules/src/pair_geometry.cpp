#include "pair_geometry.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>
#include <numeric>
#include <tuple>
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

std::size_t PairGeometry::Hash::operator()(const Key& key) const {
  std::uint64_t h = (static_cast<std::uint64_t>(key.a) << 32) ^ static_cast<std::uint64_t>(key.b);
  h ^= std::bit_cast<std::uint64_t>(key.reach) >> 7;
  h *= 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(h ^ (h >> 29));
}

double PairGeometry::angle(int a, int b) const {
  const Eigen::Vector3d &n = shape(a).normal, &m = shape(b).normal;
  return std::atan2(n.cross(m).norm(), std::abs(n.dot(m))) * 180 / std::numbers::pi;
}

/// The limits tell what must be known; what is found out is kept.
template <typename Compute>
double PairGeometry::known_or(const Key& key, const Limits& limits, Compute compute) {
  if (known_.size() < planes_->size()) grow();
  Known& known = known_[static_cast<std::size_t>(std::min(key.a, key.b))];
  Range& range = known.ranges[key];
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
  for (const Known& known : known_) {
    for (const auto& [key, range] : known.ranges) entries.push_back({key.a, key.b, key.reach, range.low, range.high});
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& e, const Entry& f) { return std::tie(e.a, e.b, e.reach) < std::tie(f.a, f.b, f.reach); });
  return {reinterpret_cast<const char*>(entries.data()), entries.size() * sizeof(Entry)};
}

void PairGeometry::remember(std::string_view answers) {
  for (; answers.size() >= sizeof(Entry); answers.remove_prefix(sizeof(Entry))) {
    Entry entry;
    std::memcpy(&entry, answers.data(), sizeof entry);
    const bool sane = entry.a >= 0 && entry.b >= 0 && entry.a < size() && entry.b < size() && entry.low >= 0 && entry.low <= entry.high;
    if (!sane) continue;
    known_[static_cast<std::size_t>(std::min(entry.a, entry.b))].ranges.try_emplace(Key{entry.a, entry.b, entry.reach}, Range{entry.low, entry.high});
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
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto box = [&](int i) -> const Box3& { return boxes[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return std::pair(box(i).min().x(), i) < std::pair(box(j).min().x(), j); });
  double furthest = 0;
  for (const Reach& reach : reaches) furthest = std::max(furthest, std::min(reach.within, reach.within_plan));
  struct Partner {
    int index;
    Apart apart;
  };
  std::vector<std::vector<Partner>> partners(boxes.size());  // by the smaller index
  std::vector<int> open;  // those that may still reach what comes further along x
  for (const int i : order) {
    std::erase_if(open, [&](int j) { return box(j).max().x() + furthest < box(i).min().x(); });
    for (const int j : open) {
      const Apart apart(box(i), box(j));
      if (apart.seen_from_above <= furthest * furthest) partners[static_cast<std::size_t>(std::min(i, j))].push_back({std::max(i, j), apart});
    }
    open.push_back(i);
  }
  for (std::vector<Partner>& of : partners) {
    std::sort(of.begin(), of.end(), [](const Partner& p, const Partner& q) { return p.index < q.index; });
  }
  std::vector<Pairs> out;
  for (const Reach& reach : reaches) {
    Pairs& pairs = out.emplace_back();
    for (std::size_t i = 0; i < partners.size(); ++i) {
      for (const Partner& partner : partners[i]) {
        if (partner.apart.within(reach)) pairs.emplace_back(static_cast<int>(i), partner.index);
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
