// A region prepared to be cut by many lines along x, as the shared part of two areas needs it for each pair of planes.
#pragma once

#include <span>
#include <vector>

#include "region.hpp"

namespace scenelore::rules {

class ScannedRegion {
 public:
  ScannedRegion() = default;
  explicit ScannedRegion(Region region);

  /// An edge with what the cuts need of it at hand.
  struct Level {
    Eigen::Vector2d from, to;
    double low, high;     ///< of from.y and to.y
    Eigen::Vector2d along;  ///< unit vector from → to; zero for a point
    double length;
  };

  [[nodiscard]] const Region& region() const { return region_; }
  [[nodiscard]] const Box2& box() const { return region_.box; }
  [[nodiscard]] double area() const { return area_; }
  [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }  ///< by rising `low`
  /// Whether any edge's box meets the given one.
  [[nodiscard]] bool boundary_enters(const Box2& box) const;

  /// The region's height in even slabs, each with a few lines through it: where line `i`, counted from below, runs inside.
  /// Computed when it is first asked for; not safe for concurrent use.
  static constexpr int kSlabs = 16, kLinesPerSlab = 4;
  [[nodiscard]] std::span<const std::pair<double, double>> even_line(int i) const;

 private:
  Region region_;
  double area_ = 0;
  std::vector<Level> levels_;
  mutable Intervals even_;
  mutable std::vector<std::size_t> even_ends_;  // of each line in even_
};

/// As share_within of regions, for regions that are asked about again.
[[nodiscard]] double share_within(const ScannedRegion& a, const ScannedRegion& b, double reach);

}  // namespace scenelore::rules
