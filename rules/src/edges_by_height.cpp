#include "edges_by_height.hpp"

#include <algorithm>
#include <numeric>

namespace scenelore::rules {

EdgesByHeight::EdgesByHeight(const Region& region) : box_(region.box) {
  constexpr std::size_t kEdgesAStrip = 4, kMostStrips = 32;  // about; more strips take longer to fill than they save
  if (box_.isEmpty()) return;
  std::size_t edges = 0;
  for (const std::vector<Eigen::Vector2d>& ring : region.rings) edges += ring.size();
  const std::size_t strips = std::clamp<std::size_t>(edges / kEdgesAStrip, 1, kMostStrips);
  const double height = box_.max().y() - box_.min().y();
  if (height > 1e-9) strips_a_metre_ = static_cast<double>(strips) / height;
  last_ = static_cast<double>(strips - 1);
  first_.assign(strips + 1, 0);
  const auto for_each_place = [&](auto visit) {
    for_each_edge(region, [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
      const std::size_t last = strip(std::max(from.y(), to.y()));
      for (std::size_t i = strip(std::min(from.y(), to.y())); i <= last; ++i) visit(i, Edge{from, to});
    });
  };
  for_each_place([&](std::size_t i, const Edge&) { ++first_[i + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  edges_.resize(first_.back());
  std::vector<std::size_t> next = first_;
  for_each_place([&](std::size_t i, const Edge& edge) { edges_[next[i]++] = edge; });
}

/// Rises with y also when rounded, so that an edge lies in the strips of all heights between those of its ends.
std::size_t EdgesByHeight::strip(double y) const {
  return static_cast<std::size_t>(std::clamp((y - box_.min().y()) * strips_a_metre_, 0.0, last_));
}

std::span<const EdgesByHeight::Edge> EdgesByHeight::at(double y) const {
  if (edges_.empty()) return {};
  const std::size_t i = strip(y);
  return std::span(edges_).subspan(first_[i], first_[i + 1] - first_[i]);
}

bool EdgesByHeight::contains(const Eigen::Vector2d& point) const {
  if (!box_.contains(point)) return false;
  bool inside = false;
  for (const auto& [from, to] : at(point.y())) inside ^= is_left_of(point, from, to);
  return inside;
}

bool EdgesByHeight::enter(const Box2& box) const {
  if (edges_.empty()) return false;
  const auto first = first_[strip(box.min().y())], end = first_[strip(box.max().y()) + 1];
  return std::any_of(edges_.begin() + static_cast<std::ptrdiff_t>(first), edges_.begin() + static_cast<std::ptrdiff_t>(end),
                     [&](const Edge& edge) { return meets_box(edge.from, edge.to, box); });
}

}  // namespace scenelore::rules
