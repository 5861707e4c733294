#include "simulator/occupancy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/random.hpp"

namespace scenelore::simulator {
namespace {

Volume draw_volume(Random& random) {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  const double x = random.between(-1, 1), y = random.between(-1, 1), yaw = random.between(-3, 3);
  frame.translate(Eigen::Vector3d(x, y, 0)).rotate(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  const double half_x = random.between(0.2, 0.8), half_y = random.between(0.1, 0.6);
  return volume(frame, {-half_x, -half_y, 0}, {half_x, half_y, 1});
}

bool covers(const Volume& v, const Eigen::Vector2d& p, double margin) {
  const Eigen::Vector2d local = p - v.centre;
  return std::abs(local.dot(v.axis)) < v.half_x + margin &&
         std::abs(-v.axis.y() * local.x() + v.axis.x() * local.y()) < v.half_y + margin;
}

TEST(Occupancy, VolumesOverlapExactlyWhenTheyShareAPoint) {
  Random random(4);
  int together = 0, apart = 0;
  for (int i = 0; i < 300; ++i) {
    const Volume a = draw_volume(random), b = draw_volume(random);
    bool share = false, nearly = false;  // on a grid of 1 cm
    for (double x = -2.5; x < 2.5; x += 0.01) {
      for (double y = -2.5; y < 2.5; y += 0.01) {
        share = share || (covers(a, {x, y}, 0) && covers(b, {x, y}, 0));
        nearly = nearly || (covers(a, {x, y}, 0.03) && covers(b, {x, y}, 0.03));
      }
      if (share) break;
    }
    if (share != nearly) continue;  // too close to tell on the grid
    (share ? together : apart) += 1;
    ASSERT_EQ(overlap(a, b), share) << "pair " << i;
  }
  EXPECT_GT(together, 50);
  EXPECT_GT(apart, 50);
}

TEST(Occupancy, ThingsAboveOneAnotherDoNotOverlap) {
  const Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  EXPECT_FALSE(overlap(volume(frame, {0, 0, 0}, {1, 1, 0.7}), volume(frame, {0, 0, 0.7}, {1, 1, 2})));
  EXPECT_TRUE(overlap(volume(frame, {0, 0, 0}, {1, 1, 0.7}), volume(frame, {0, 0, 0.6}, {1, 1, 2})));
}

TEST(Occupancy, KeepsThingsInsideTheRoomAndClearOfOneAnother) {
  Occupancy room(4, 3);
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  EXPECT_TRUE(room.free(volume(frame, {0, 0, 0}, {1, 1, 1})));
  EXPECT_FALSE(room.free(volume(frame, {-0.1, 0, 0}, {1, 1, 1})));
  frame.rotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()));
  EXPECT_FALSE(room.free(volume(frame, {0, 0, 0}, {1, 1, 1}))) << "a turned box reaches through the wall";
  room.add(volume(Eigen::Isometry3d::Identity(), {2, 0, 0}, {3, 1, 1}));
  EXPECT_FALSE(room.free(volume(Eigen::Isometry3d::Identity(), {2.9, 0.9, 0}, {3.5, 1.5, 1})));
  EXPECT_TRUE(room.free(volume(Eigen::Isometry3d::Identity(), {3, 0, 0}, {4, 1, 1}))) << "touching is allowed";
}

}  // namespace
}  // namespace scenelore::simulator
