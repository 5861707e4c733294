// The edges of a region by height, for those who ask about one height after the other.
#pragma once

#include <span>
#include <vector>

#include "region.hpp"

namespace scenelore::rules {

/// The region's height is divided into even strips, each with a copy of the edges that reach into it.
class EdgesByHeight {
 public:
  struct Edge {
    Eigen::Vector2d from, to;  ///< as in the ring
  };

  EdgesByHeight() = default;
  explicit EdgesByHeight(const Region& region);

  [[nodiscard]] const Box2& box() const { return box_; }
  /// All edges that reach height y, and some that come near it. A height outside the region has those of the strip next to it.
  [[nodiscard]] std::span<const Edge> at(double y) const;
  /// As Region::contains, sooner.
  [[nodiscard]] bool contains(const Eigen::Vector2d& point) const;
  /// Whether any edge's box meets the given one.
  [[nodiscard]] bool enter(const Box2& box) const;

 private:
  [[nodiscard]] std::size_t strip(double y) const;

  Box2 box_;
  double strips_a_metre_ = 0, last_ = 0;  // number of the highest strip
  std::vector<std::size_t> first_;  // of each strip in edges_, then the end
  std::vector<Edge> edges_;
};

}  // namespace scenelore::rules
