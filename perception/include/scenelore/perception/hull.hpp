// The outline of a set of points in the plane: alpha hull, minimum-area rectangle, share of the rectangle that is filled.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace scenelore::perception {

using Ring2 = std::vector<Eigen::Vector2d>;  ///< corners in order, the first one not repeated

/// Valid in the sense of OGC simple features: rings do not cross, a hole may touch another ring in single points.
struct Outline {
  Ring2 outer;               ///< counter-clockwise; empty when fewer than three points or all on a line
  std::vector<Ring2> holes;  ///< clockwise
  double area = 0;           ///< m², holes left out
  double radius = 0;         ///< metres, as used
  double covered = 0;        ///< share of the hull's points that the outline holds; < 1 when only the largest part was kept
};

/// One point per square cell, the one nearest to the cell's centre; of cells at the rim (with an empty one beside them) the
/// points furthest out in eight directions, since the hull would shrink by half a cell otherwise. Independent of their order.
[[nodiscard]] std::vector<Eigen::Vector2d> thinned(std::span<const Eigen::Vector2d> points, double cell);

/// The points that an outline of alpha radius `radius` depends on: those of the rim as thinned() keeps them, of the cells
/// that have all eight neighbours only one in every lattice square of 0.6 radii, which leaves no gap that a circle of that radius would
/// find. A tenth of thinned()'s points for a wall. Requires: cell ≤ radius / 3. Independent of their order.
struct OutlineSites {
  std::vector<Eigen::Vector2d> points;
  std::vector<double> weights;  ///< cells that each stands for
};
[[nodiscard]] OutlineSites outline_sites(std::span<const Eigen::Vector2d> points, double cell, double radius);

/// Alpha shape (Edelsbrunner et al. 1983) for alpha = radius²: the Delaunay triangles whose circumradius is at most
/// `radius`, one connected part of them. The radius is raised by steps of 1.4, six times at most, until one part holds
/// 95 % of the points (by their weights, where given); then the largest part is kept. Copies and points that are not
/// finite do no harm.
[[nodiscard]] Outline alpha_hull(std::span<const Eigen::Vector2d> points, double radius, std::span<const double> weights = {});

/// Area of a polygon by the shoelace formula, positive when counter-clockwise.
[[nodiscard]] double signed_area(const Ring2& ring);

struct Rectangle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();  ///< unit, direction of the longer side
  double length = 0, width = 0;                      ///< metres, length ≥ width
};

/// Minimum-area rectangle around the points. One point gives a rectangle of no size, points on a line one of no width.
[[nodiscard]] Rectangle minimum_rectangle(std::span<const Eigen::Vector2d> points);

/// Share of the rectangle that lies inside the outline, in [0, 1]: the paper's bitmap of 640×480 pixels, fitted to the
/// rectangle, filled by the even-odd rule. A pixel counts when its centre lies inside. Counting every pixel that the
/// outline touches (as cv::fillPoly does) would add half a pixel along the whole outline, joining pixel centres would take
/// half a pixel away; centres inside are off by neither, on average. 0 for a rectangle without area.
[[nodiscard]] double rectangularity(const Outline& outline, const Rectangle& rectangle);

}  // namespace scenelore::perception
