#include "simulator/bvh.hpp"

#include <gtest/gtest.h>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

TEST(Bvh, FindsTheSameFirstHitAsTryingEveryShape) {
  const Office office = make_office(5, draw_inventory(5));
  const std::vector<Shape>& shapes = office.scene.shapes();
  const Bvh tree(shapes);
  Random random(9);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const double x = random.between(0, office.width), y = random.between(0, office.depth),
                 z = random.between(0, office.height);
    const double dx = random.normal(), dy = random.normal(), dz = random.normal();
    const Ray ray{{x, y, z}, Vector3d(dx, dy, dz).normalized()};
    double expected = kMiss;
    for (const Shape& shape : shapes) expected = std::min(expected, intersect(shape, ray, 0.01));
    const Hit hit = tree.cast(ray, 0.01);
    ASSERT_EQ(hit.range, expected);
    hits += hit.shape != nullptr;
  }
  EXPECT_GT(hits, 1500);
}

TEST(Bvh, RayAlongAnAxisThroughABoxFaceStillHits) {
  const Bvh tree({make_quad({0, 0, 1}, {1, 0, 0}, {0, 1, 0})});
  EXPECT_DOUBLE_EQ(tree.cast({{0, 0, 0}, {0, 0, 1}}, 0.01).range, 1);
  EXPECT_DOUBLE_EQ(tree.cast({{0.5, 1, 0}, {0, 0, 1}}, 0.01).range, 1);
}

TEST(Bvh, HitsNothingBeyondTheFarthestOrInAnEmptyScene) {
  const Bvh tree({make_quad({-1, -1, 2}, {2, 0, 0}, {0, 2, 0})});
  EXPECT_EQ(tree.cast({{0, 0, 0}, {0, 0, 1}}, 0.01, 1.9).shape, nullptr);
  EXPECT_EQ(tree.cast({{0, 0, 0}, {0, 0, 1}}, 2.5).shape, nullptr);
  EXPECT_EQ(Bvh({}).cast({{0, 0, 0}, {0, 0, 1}}, 0).range, kMiss);
}

TEST(Bvh, ManyShapesInOnePlaceDoNotOverflowTheStack) {
  const std::vector<Shape> same(5000, make_quad({-1, -1, 2}, {2, 0, 0}, {0, 2, 0}));
  EXPECT_DOUBLE_EQ(Bvh(same).cast({{0, 0, 0}, {0, 0, 1}}, 0.01).range, 2);
}

}  // namespace
}  // namespace scenelore::simulator
