// A region between two stacks of rectangles, one in each of a few slabs: what it has for sure, and what it does not go beyond. Bounds
// what two regions share without their outlines, which is enough for most pairs of planes.
#pragma once

#include <array>
#include <span>
#include <utility>

#include "region.hpp"

namespace scenelore::rules {

class Slabs {
 public:
  static constexpr int kCount = 16;  ///< of even slabs, which the region's height is divided into
  using Interval = std::pair<double, double>;  ///< empty where the first is greater

  Slabs() = default;
  explicit Slabs(const Region& region);

  /// From the lowest; slab i lies between the bounds i and i + 1.
  [[nodiscard]] static double bound(const Box2& box, int i) { return box.min().y() + (box.max().y() - box.min().y()) * i / kCount; }

  struct Slab {
    double low, high;  ///< along y
    Interval outer;    ///< along x: all of the region within the slab
    Interval inner;    ///< all heights within the slab, borders left out, have all of this inside the region
  };
  [[nodiscard]] const std::array<Slab, kCount>& all() const { return slabs_; }
  /// Those that reach between two heights, and perhaps a neighbour or two.
  [[nodiscard]] std::span<const Slab> between(double low, double high) const;

 private:
  std::array<Slab, kCount> slabs_{};
};

/// What is plain about the part of a that lies within `reach` of b.
struct SharedSlabs {
  enum class Part { none, some, all };
  std::array<Part, Slabs::kCount> part{};                   ///< of a, by slab; `all` where b itself has it
  std::array<double, Slabs::kCount + 1> least{}, most{};    ///< area, from one slab of a on and up to the highest
};
[[nodiscard]] SharedSlabs shared_slabs(const Slabs& a, const Slabs& b, double reach);

}  // namespace scenelore::rules
