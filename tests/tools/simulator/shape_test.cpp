// Closed-form hits against what defines each surface.
#include "simulator/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simulator/random.hpp"

namespace scenelore::simulator {
namespace {

Vector3d draw_point(Random& random, double reach) {
  const double x = random.between(-reach, reach), y = random.between(-reach, reach), z = random.between(-reach, reach);
  return {x, y, z};
}

Ray draw_ray(Random& random) {
  const Vector3d from = draw_point(random, 3), to = draw_point(random, 1);
  return {from, (to - from).normalized()};
}

// Follows the ray in small steps and returns where `inside` first changes: a hit found without any formula.
template <typename Inside>
double march(const Ray& ray, const Inside& inside) {
  constexpr double step = 1e-3;
  const bool start = inside(ray.origin);
  for (double t = step; t < 8; t += step) {
    if (inside(ray.origin + t * ray.direction) != start) return t;
  }
  return kMiss;
}

TEST(Shape, EllipsoidIsHitWhereItsImplicitFunctionChangesSign) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Vector3d centre(0.1, -0.2, 0.3), semi(0.9, 0.4, 0.6);
  const Shape shape = make_ellipsoid(centre, turn.col(0) * semi.x(), turn.col(1) * semi.y(), turn.col(2) * semi.z());
  const auto inside = [&](const Vector3d& p) {
    return (turn.transpose() * (p - centre)).cwiseQuotient(semi).squaredNorm() < 1;
  };
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const Ray ray = draw_ray(random);
    const double expected = march(ray, inside), found = intersect(shape, ray, 0);
    if (expected == kMiss) continue;  // a grazing hit may slip between two steps, the reverse may not
    ++hits;
    ASSERT_NEAR(found, expected, 2e-3);
    ASSERT_TRUE(shape.bounds.contains(ray.origin + found * ray.direction));
  }
  EXPECT_GT(hits, 100);
}

TEST(Shape, MantleOfACylinderIsHitAtItsRadiusWithinItsArcAndLength) {
  const Vector3d base(0.2, 0.1, -0.5), axis = Vector3d(0.3, 0.2, 1).normalized(), towards = axis.unitOrthogonal();
  const double radius = 0.7, half = 0.8, height = 1.1;
  const Shape shape = make_cylinder(base, height * axis, radius, towards, half);
  Random random(2);
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Ray ray = draw_ray(random);
    const double t = intersect(shape, ray, 0);
    if (t == kMiss) continue;
    ++hits;
    const Vector3d local = ray.origin + t * ray.direction - base, off = local - axis * axis.dot(local);
    ASSERT_NEAR(off.norm(), radius, 1e-9);
    ASSERT_LE(std::acos(std::min(1.0, off.normalized().dot(towards))), half + 1e-9);
    ASSERT_GE(axis.dot(local), -1e-9);
    ASSERT_LE(axis.dot(local), height + 1e-9);
    ASSERT_NEAR(normal_at(shape, local + base).dot(off) / radius, 1, 1e-9);
    ASSERT_TRUE(shape.bounds.contains(local + base));
  }
  EXPECT_GT(hits, 100);
  EXPECT_NEAR(shape.area, 2 * half * radius * height, 1e-12);
}

TEST(Shape, FlatShapesShareOfHitsIsTheirShareOfArea) {
  // Parallel rays through a square of area 4, spread evenly over it.
  const Shape quad = make_quad({-0.5, -0.5, 0}, {1.2, 0.1, 0.3}, {0.2, 0.9, -0.1});
  const Shape triangle = make_triangle({-0.5, -0.5, 0}, {1.2, 0.1, 0.3}, {0.2, 0.9, -0.1});
  const Shape disc = make_disc({0, 0, 0}, Vector3d::UnitZ(), 0.6);
  Random random(3);
  const int rays = 40000;
  int in_quad = 0, in_triangle = 0, in_disc = 0;
  for (int i = 0; i < rays; ++i) {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    const Ray ray{{x, y, 5}, {0, 0, -1}};
    in_quad += intersect(quad, ray, 0) != kMiss;
    in_triangle += intersect(triangle, ray, 0) != kMiss;
    in_disc += intersect(disc, ray, 0) != kMiss;
  }
  const double shadow = quad.area * std::abs(quad.b.z());
  EXPECT_NEAR(4.0 * in_quad / rays, shadow, 0.03);
  EXPECT_NEAR(4.0 * in_triangle / rays, shadow / 2, 0.03);
  EXPECT_NEAR(4.0 * in_disc / rays, disc.area, 0.03);
}

TEST(Shape, RayWithinThePlaneOfAQuadMissesIt) {
  const Shape quad = make_quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(intersect(quad, {{-1, 0.5, 0}, {1, 0, 0}}, 0), kMiss);
  EXPECT_EQ(intersect(quad, {{0.5, 0.5, 1}, {0, 0, 1}}, 0), kMiss) << "it lies behind the ray";
}

TEST(Shape, AreaOfASphereIsThatOfTheFormula) {
  const Shape sphere = make_ellipsoid({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2});
  EXPECT_NEAR(sphere.area, 16 * std::numbers::pi, 1e-9);
}

}  // namespace
}  // namespace scenelore::simulator
