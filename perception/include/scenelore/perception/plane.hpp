// A segmented plane and its feature vector Φ (Goldhoorn & Hartanto 2014, section 3.2). A value type: kb stores it.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

namespace scenelore::perception {

using Ring = std::vector<Eigen::Vector3d>;  ///< corners in order, the first one not repeated; all on the plane

/// Outer boundary counter-clockwise seen against the normal, holes clockwise; no ring crosses itself or another.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

/// Coordinates are the scan's own (those of its file). `height`, `z_min`, `z_max`, `tilt_deg` are in the upright frame:
/// metres above the floor level, degrees from the vertical.
struct Plane {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit; towards the sensor where known, else the upper half space
  /// Rotates local axes into the scan's frame: local z = normal, x = intermediate, y = largest eigenvector.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Polygon hull;              ///< alpha shape in the plane; outer empty for a degenerate plane
  double area_m2 = 0;        ///< of the alpha hull
  double length = 0;         ///< metres, longer side of the minimum-area rectangle
  double width = 0;          ///< metres, shorter side
  double rectangularity = 0; ///< in [0, 1]
  /// Metres, sides of the rectangle that spreads as the points do when evenly filled: √12 σ along the two larger axes.
  /// A few stray points stretch the minimum-area rectangle, but hardly these. 0 = not known.
  double spread_length = 0, spread_width = 0;
  double tilt_deg = 0;       ///< angle between normal and vertical, 0..90
  double height = 0;         ///< centroid above the floor
  double z_min = 0, z_max = 0;  ///< lower and upper edge above the floor
  double rmse = 0;           ///< metres, of the fit
  double facing_up = 0;      ///< z of the sensor-side normal in the upright frame, −1..1; |z| when the sensor is unknown
  double point_density = 0;  ///< points a square metre of hull
  double seen_share = 0;     ///< share of the hull's 5 cm cells that hold points, 0..1
  /// Does the room end here? Of the 10 cm cubes with points in and around the outline's box, 1.5 m deep to both sides: how many
  /// lie off the plane on the side with fewer, as a share of these and the plane's own, 0..1. About 0 for floor, ceiling, walls and
  /// what hangs on them. Where it turns into another plane around an upright edge, what that one faces is beside it and does not
  /// count. −1 = not known.
  double behind = -1;
  /// What the sensor saw beyond the outline, in shares of the outline's length (0..1) beyond which it measured anything: rays
  /// went past into the room behind (free), or met more of the same surface within 4 cm of the plane (joined); along the rest it
  /// turns into another plane around an upright edge, or something before it hides how it goes on. `edge_free_top`: free, of the upper edge of what is not level alone.
  /// −1 = not known, or measured along less than a quarter of it.
  double edge_free = -1, edge_free_top = -1, edge_joined = -1;
  /// Share of the outline's length (0..1) beyond which nothing was measured: the sensor's field of view ends there, or no echo came
  /// back. What else its outline tells is then of the view and not of the thing. −1 = not known.
  double edge_unseen = -1;
  std::size_t point_count = 0;
};

}  // namespace scenelore::perception
