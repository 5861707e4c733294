// One plane prepared for geometry questions: its outline in space, in its own plane, and as a footprint on the floor plan.
#pragma once

#include <Eigen/Geometry>

#include <vector>

#include "box_row.hpp"
#include "edges_by_height.hpp"
#include "scanned_region.hpp"
#include "scenelore/perception/plane.hpp"

namespace scenelore::rules {

/// A plane this steep or steeper has a line as its footprint: the sliver that remains says nothing but noise.
inline constexpr double kSteepDegrees = 80;

struct Edge3 {
  Eigen::Vector3d from, to;
  Box3 box;
};

/// Neighbouring edges and the box around them, so that far pieces of two outlines are told apart at once.
struct EdgeBlock {
  static constexpr std::size_t kMost = 8;  ///< edges
  std::size_t begin = 0, end = 0;
  Box3 box;
};

/// A plane without an outline is its centroid: a point.
struct PlaneShape {
  explicit PlaneShape(const perception::Plane& plane);

  Eigen::Vector3d centroid, normal, u, v;  ///< u, v span the plane; normal of length 1
  Box3 box;
  std::vector<Edge3> edges;                ///< of outer boundary and holes; one of length 0 for a point
  std::vector<EdgeBlock> blocks;           ///< of edges
  BoxRow block_boxes;                      ///< of blocks
  EdgesByHeight in_plane;                  ///< outline in (u, v) from the centroid
  ScannedRegion footprint;                 ///< outline seen from above; the line or point where `line` stands
  bool steep = false;                      ///< footprint is `line`
  Segment2 line;

  [[nodiscard]] double signed_distance(const Eigen::Vector3d& point) const { return normal.dot(point - centroid); }
  /// Whether the foot of the perpendicular from `point` lies inside the outline.
  [[nodiscard]] bool covers(const Eigen::Vector3d& point) const;
};

/// Of the outline with its holes; of the centroid where there is none.
[[nodiscard]] Box3 box_of(const perception::Plane& plane);

/// Smallest distance of two outlines with all they enclose (holes are left out); 0 when they touch or cross. Exact between the limits; below
/// the lower one, that or something greater, but no more than the limit; above the upper one, the limit.
[[nodiscard]] double hull_gap(const PlaneShape& a, const PlaneShape& b, const Limits& limits = {});

/// Share of a's footprint that lies over b's, or within `reach` metres of it; in [0, 1]. Exact between the limits.
[[nodiscard]] double footprint_share(const PlaneShape& a, const PlaneShape& b, double reach, const Limits& limits = {});

}  // namespace scenelore::rules
