// A region prepared to be cut by many lines along x, as the shared part of two areas needs it for each pair of planes.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "edges_by_height.hpp"
#include "slabs.hpp"

namespace scenelore::rules {

/// A line along x through a region, standing for a slab of some height.
struct CutLine {
  double y, height;  ///< of the line; of its slab
  double length;     ///< inside the region
  std::span<const std::pair<double, double>> inside;
};

/// Such lines from below, kept.
class CutLines {
 public:
  void add(const CutLine& line);
  /// Of lengths times heights.
  [[nodiscard]] double area() const { return area_; }
  template <typename Visit>
  void for_each(Visit visit) const {  ///< until it returns false
    for (const Kept& line : lines_) {
      if (!visit(CutLine{line.y, line.height, line.length, std::span(inside_).subspan(line.begin, line.end - line.begin)})) return;
    }
  }

 private:
  struct Kept {
    double y, height, length;
    std::size_t begin, end;  // in inside_
  };
  std::vector<Kept> lines_;
  Intervals inside_;
  double area_ = 0;
};

class ScannedRegion {
 public:
  ScannedRegion() = default;
  explicit ScannedRegion(Region region);

  /// An edge with what the cuts need of it at hand.
  struct Level {
    Eigen::Vector2d from, to;
    double low, high;     ///< of from.y and to.y
    double left, right;   ///< of from.x and to.x
    Eigen::Vector2d along;  ///< unit vector from → to; zero for a point
    double length;
  };

  [[nodiscard]] const Region& region() const { return region_; }
  [[nodiscard]] const Box2& box() const { return region_.box; }
  [[nodiscard]] double area() const { return area_; }
  [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }  ///< by rising `low`
  [[nodiscard]] const EdgesByHeight& edges() const { return edges_; }

  /// Both are computed when first asked for, by whichever thread.
  [[nodiscard]] const Slabs& slabs() const;
  [[nodiscard]] const CutLines& even_lines() const;  ///< two through each slab

 private:
  struct Later {
    std::once_flag slabs_made, even_lines_made;
    Slabs slabs;
    CutLines even_lines;
  };

  Region region_;
  double area_ = 0;
  std::vector<Level> levels_;
  EdgesByHeight edges_;
  std::unique_ptr<Later> later_ = std::make_unique<Later>();  // does not move with the region
};

/// As share_within of regions, for regions that are asked about again; the very same numbers.
[[nodiscard]] double share_within(const ScannedRegion& a, const ScannedRegion& b, double reach, const Limits& limits = {});

[[nodiscard]] double share_within(const Segment2& a, const ScannedRegion& b, double reach);

}  // namespace scenelore::rules
