#include "simulator/shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scenelore::simulator {
namespace {

// Flat shapes keep the corner in a, the unit normal in b and in c, d the dual vectors that give the coordinates of a
// point along the two edges.
Shape make_flat(Shape::Kind kind, const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
  Shape shape;
  shape.kind = kind;
  const Vector3d cross = u.cross(v);
  const double squared = cross.squaredNorm();
  shape.a = corner;
  shape.b = cross / std::sqrt(squared);
  shape.c = v.cross(cross) / squared;
  shape.d = cross.cross(u) / squared;
  shape.bounds.extend(corner).extend(corner + u).extend(corner + v);
  shape.area = std::sqrt(squared);
  shape.centroid = corner + (u + v) / 2;
  return shape;
}

double intersect_flat(const Shape& shape, const Ray& ray, double nearest) {
  const double slope = shape.b.dot(ray.direction);
  if (slope == 0) return kMiss;
  const double t = shape.b.dot(shape.a - ray.origin) / slope;
  if (!(t > nearest)) return kMiss;
  const Vector3d local = ray.origin + t * ray.direction - shape.a;
  if (shape.kind == Shape::Kind::disc) return local.squaredNorm() <= shape.radius * shape.radius ? t : kMiss;
  constexpr double slack = 1e-9;  // neighbouring quads leave no gap
  const double u = shape.c.dot(local), v = shape.d.dot(local);
  const bool inside = u >= -slack && v >= -slack &&
                      (shape.kind == Shape::Kind::quad ? u <= 1 + slack && v <= 1 + slack : u + v <= 1 + slack);
  return inside ? t : kMiss;
}

double intersect_cylinder(const Shape& shape, const Ray& ray, double nearest) {
  const Vector3d from = ray.origin - shape.a;
  const Vector3d across = ray.direction - shape.b * shape.b.dot(ray.direction);
  const Vector3d off = from - shape.b * shape.b.dot(from);
  const double a = across.squaredNorm(), b = across.dot(off), c = off.squaredNorm() - shape.radius * shape.radius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0 || a == 0) return kMiss;
  const double root = std::sqrt(discriminant);
  for (const double t : {(-b - root) / a, (-b + root) / a}) {
    if (!(t > nearest)) continue;
    const Vector3d local = from + t * ray.direction;
    const double along = shape.b.dot(local);
    if (along >= 0 && along <= shape.height && shape.c.dot(local) >= shape.limit) return t;
  }
  return kMiss;
}

// b, c, d hold axis / |axis|², which turns the ellipsoid into the unit sphere.
double intersect_ellipsoid(const Shape& shape, const Ray& ray, double nearest) {
  const Vector3d from = ray.origin - shape.a;
  const Vector3d o(shape.b.dot(from), shape.c.dot(from), shape.d.dot(from));
  const Vector3d r(shape.b.dot(ray.direction), shape.c.dot(ray.direction), shape.d.dot(ray.direction));
  const double a = r.squaredNorm(), b = r.dot(o), discriminant = b * b - a * (o.squaredNorm() - 1);
  if (discriminant < 0) return kMiss;
  const double root = std::sqrt(discriminant);
  if ((-b - root) / a > nearest) return (-b - root) / a;
  return (-b + root) / a > nearest ? (-b + root) / a : kMiss;
}

}  // namespace

Shape make_quad(const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
  Shape shape = make_flat(Shape::Kind::quad, corner, u, v);
  shape.bounds.extend(corner + u + v);
  return shape;
}

Shape make_triangle(const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
  Shape shape = make_flat(Shape::Kind::triangle, corner, u, v);
  shape.area /= 2;
  shape.centroid = corner + (u + v) / 3;
  return shape;
}

Shape make_disc(const Vector3d& centre, const Vector3d& unit_normal, double radius) {
  Shape shape;
  shape.kind = Shape::Kind::disc;
  shape.a = shape.centroid = centre;
  shape.b = unit_normal;
  shape.radius = radius;
  const Vector3d reach = radius * (Vector3d::Ones() - unit_normal.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
  shape.bounds.extend(centre - reach).extend(centre + reach);
  shape.area = std::numbers::pi * radius * radius;
  return shape;
}

Shape make_cylinder(const Vector3d& base, const Vector3d& axis, double radius, const Vector3d& towards,
                    double half_angle) {
  Shape shape;
  shape.kind = Shape::Kind::cylinder;
  shape.a = base;
  shape.height = axis.norm();
  shape.b = axis / shape.height;
  shape.c = towards;
  shape.radius = radius;
  const double half = std::min(half_angle, std::numbers::pi);
  shape.limit = half >= std::numbers::pi ? -2 * radius : radius * std::cos(half);
  const Vector3d reach = radius * (Vector3d::Ones() - shape.b.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
  shape.bounds.extend(base - reach).extend(base + reach).extend(base + axis - reach).extend(base + axis + reach);
  shape.area = 2 * half * radius * shape.height;
  shape.centroid = base + axis / 2 + towards * (radius * std::sin(half) / half);
  return shape;
}

Shape make_ellipsoid(const Vector3d& centre, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  Shape shape;
  shape.kind = Shape::Kind::ellipsoid;
  shape.a = shape.centroid = centre;
  shape.b = a / a.squaredNorm();
  shape.c = b / b.squaredNorm();
  shape.d = c / c.squaredNorm();
  const Vector3d reach = (a.cwiseAbs2() + b.cwiseAbs2() + c.cwiseAbs2()).cwiseSqrt();
  shape.bounds.extend(centre - reach).extend(centre + reach);
  // Thomsen's approximation, within 1.1 %.
  const double p = 1.6075, x = std::pow(a.norm(), p), y = std::pow(b.norm(), p), z = std::pow(c.norm(), p);
  shape.area = 4 * std::numbers::pi * std::pow((x * y + x * z + y * z) / 3, 1 / p);
  return shape;
}

double intersect(const Shape& shape, const Ray& ray, double nearest) {
  switch (shape.kind) {
    case Shape::Kind::cylinder:
      return intersect_cylinder(shape, ray, nearest);
    case Shape::Kind::ellipsoid:
      return intersect_ellipsoid(shape, ray, nearest);
    default:
      return intersect_flat(shape, ray, nearest);
  }
}

// The dual of the dual vectors.
std::pair<Vector3d, Vector3d> edges(const Shape& shape) {
  const Vector3d cross = shape.c.cross(shape.d);
  const double squared = cross.squaredNorm();
  return {shape.d.cross(cross) / squared, cross.cross(shape.c) / squared};
}

Vector3d normal_at(const Shape& shape, const Vector3d& point) {
  const Vector3d local = point - shape.a;
  switch (shape.kind) {
    case Shape::Kind::cylinder:
      return (local - shape.b * shape.b.dot(local)).normalized();
    case Shape::Kind::ellipsoid:
      return (shape.b * shape.b.dot(local) + shape.c * shape.c.dot(local) + shape.d * shape.d.dot(local)).normalized();
    default:
      return shape.b;
  }
}

}  // namespace scenelore::simulator
