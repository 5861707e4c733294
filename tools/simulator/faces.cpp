#include "simulator/faces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace scenelore::simulator {
namespace {

constexpr double kSameNormal = 0.99996;  // cosine of half a degree

bool is_flat(const Shape& shape) {
  return shape.kind == Shape::Kind::quad || shape.kind == Shape::Kind::triangle || shape.kind == Shape::Kind::disc;
}

/// A flat shape as a convex polygon; a disc has sixteen corners.
std::vector<Vector3d> corners(const Shape& shape) {
  if (shape.kind == Shape::Kind::disc) {
    const Vector3d u = shape.b.unitOrthogonal(), v = shape.b.cross(u);
    std::vector<Vector3d> round;
    for (int i = 0; i < 16; ++i) {
      const double angle = i * std::numbers::pi / 8;
      round.push_back(shape.a + shape.radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return round;
  }
  const auto [u, v] = edges(shape);
  if (shape.kind == Shape::Kind::triangle) return {shape.a, shape.a + u, shape.a + v};
  return {shape.a, shape.a + u, shape.a + u + v, shape.a + v};
}

double shorter_side(const Shape& shape) {
  if (shape.kind == Shape::Kind::disc) return 2 * shape.radius;
  const auto [u, v] = edges(shape);
  return std::min(u.norm(), v.norm());
}

/// Whether two convex polygons of about one plane with this normal come nearer than `gap`: no line parts them by more
/// (separating axes; at corners the gap is measured a little too small).
bool touch(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b, const Vector3d& normal, double gap) {
  for (const auto* polygon : {&a, &b}) {
    for (std::size_t i = 0; i < polygon->size(); ++i) {
      const Vector3d side = (*polygon)[(i + 1) % polygon->size()] - (*polygon)[i];
      const Vector3d axis = side.cross(normal).normalized();
      double low_a = kMiss, high_a = -kMiss, low_b = kMiss, high_b = -kMiss;
      for (const Vector3d& p : a) low_a = std::min(low_a, axis.dot(p)), high_a = std::max(high_a, axis.dot(p));
      for (const Vector3d& p : b) low_b = std::min(low_b, axis.dot(p)), high_b = std::max(high_b, axis.dot(p));
      if (low_b - high_a > gap || low_a - high_b > gap) return false;
    }
  }
  return true;
}

bool in_plane(const std::vector<Vector3d>& polygon, const Shape& shape) {
  return std::all_of(polygon.begin(), polygon.end(),
                     [&](const Vector3d& p) { return std::abs(shape.b.dot(p - shape.a)) <= kFaceStep; });
}

bool near(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b, double gap) {
  return (a.min().array() - gap <= b.max().array()).all() && (b.min().array() - gap <= a.max().array()).all();
}

}  // namespace

std::vector<Face> number_faces(std::vector<Shape>& shapes) {
  std::vector<std::vector<Vector3d>> outline(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (is_flat(shapes[i])) outline[i] = corners(shapes[i]);
  }
  std::vector<std::size_t> root(shapes.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto top = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Shape &a = shapes[i], &b = shapes[j];
      if (outline[i].empty() || outline[j].empty() || !near(a.bounds, b.bounds, kFaceGap)) continue;
      if (std::abs(a.b.dot(b.b)) < kSameNormal || !in_plane(outline[i], b) || !in_plane(outline[j], a)) continue;
      if (touch(outline[i], outline[j], a.b, kFaceGap)) root[std::max(top(i), top(j))] = std::min(top(i), top(j));
    }
  }
  std::vector<Face> faces;
  std::vector<double> largest;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Shape& shape = shapes[i];
    shape.face = -1;
    if (outline[i].empty()) continue;
    if (top(i) == i) faces.emplace_back(), largest.push_back(0);
    shape.face = top(i) == i ? static_cast<int>(faces.size()) - 1 : shapes[top(i)].face;
    const auto f = static_cast<std::size_t>(shape.face);
    faces[f].area += shape.area;
    faces[f].width = std::max(faces[f].width, shorter_side(shape));
    if (shape.area > largest[f]) largest[f] = shape.area, faces[f].normal = shape.b;
  }
  return faces;
}

}  // namespace scenelore::simulator
