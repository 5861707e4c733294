// The surfaces rays can hit, each intersected in closed form. All are hit from both sides.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <utility>

namespace scenelore::simulator {

using Eigen::Vector3d;

inline constexpr double kMiss = std::numeric_limits<double>::infinity();

struct Ray {
  Vector3d origin;
  Vector3d direction;  ///< unit length
};

/// A value; made by the functions below, which say what the vectors mean.
struct Shape {
  enum class Kind : unsigned char { quad, triangle, disc, cylinder, ellipsoid };
  Kind kind = Kind::quad;
  int surface = 0;   ///< index of the object it belongs to
  int face = -1;     ///< index of the planar face that it is part of (faces.hpp), −1 = none
  int material = 0;  ///< see scene.hpp
  Vector3d a = Vector3d::Zero(), b = Vector3d::Zero(), c = Vector3d::Zero(), d = Vector3d::Zero();
  double radius = 0, height = 0, limit = 0;
  Eigen::AlignedBox3d bounds;
  Vector3d centroid = Vector3d::Zero();
  double area = 0;
};

/// Parallelogram with corner and two edges; its normal is u × v. Requires: u and v not parallel.
[[nodiscard]] Shape make_quad(const Vector3d& corner, const Vector3d& u, const Vector3d& v);
/// Half of that parallelogram.
[[nodiscard]] Shape make_triangle(const Vector3d& corner, const Vector3d& u, const Vector3d& v);
[[nodiscard]] Shape make_disc(const Vector3d& centre, const Vector3d& unit_normal, double radius);
/// The mantle of a cylinder on `base`; only the part within `half_angle` (radians) of the direction `towards`, which is
/// a unit vector orthogonal to the axis. A half angle of pi or more keeps the whole mantle.
[[nodiscard]] Shape make_cylinder(const Vector3d& base, const Vector3d& axis, double radius, const Vector3d& towards,
                                  double half_angle);
/// Ellipsoid with three mutually orthogonal semi-axes.
[[nodiscard]] Shape make_ellipsoid(const Vector3d& centre, const Vector3d& a, const Vector3d& b, const Vector3d& c);

/// Distance of the first hit beyond `nearest`, or kMiss.
[[nodiscard]] double intersect(const Shape& shape, const Ray& ray, double nearest);
/// The two edges of a quad or triangle from its corner.
[[nodiscard]] std::pair<Vector3d, Vector3d> edges(const Shape& shape);
/// Unit normal at a point of the shape; outwards, or u × v for flat ones.
[[nodiscard]] Vector3d normal_at(const Shape& shape, const Vector3d& point);

}  // namespace scenelore::simulator
