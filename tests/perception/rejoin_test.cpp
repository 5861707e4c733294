// A wall, and a piece beside it that was parted from it and given up.
#include "rejoin.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "planar_scenes.hpp"
#include "voxelise.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;

constexpr double kNoise = 0.01;  // metres
constexpr std::int32_t kWall = 0, kPiece = 1, kFurther = 2;

/// A level wall of 1 x 1 m, a piece of it 0.3 m wide and one of 0.2 m beyond that. The piece may lie over the wall, lean against it or be short.
struct PartedWall {
  explicit PartedWall(double step = 0, double lean = 0, double length = 1) {
    testing::Scene scene;
    Random random(7);
    scene.add_rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 3000, kNoise, kWall, random);
    scene.add_rectangle({1, 0, step}, {0.3, 0, 0.3 * lean}, {0, length, 0}, 3000, kNoise, kPiece, random);
    scene.add_rectangle({1.3, 0, 0}, {0.2, 0, 0}, {0, 1, 0}, 3000, kNoise, kFurther, random);
    const VoxelisedCloud voxels = voxelise(scene.cloud, 0.05, 1);
    std::vector<std::int32_t> region_of_voxel(voxels.grid.count());
    PointLocator locator(voxels.grid);
    for (std::size_t i = 0; i < scene.truth.size(); ++i) region_of_voxel[locator.locate(scene.cloud, i)] = scene.truth[i];
    slots = slots_of_voxels(voxels.grid, region_of_voxel);
    planes.resize(3);
    refit(slots, planes);
    pyramid = make_pyramid(voxels.grid, 1);
  }

  [[nodiscard]] std::vector<std::int32_t> into(std::vector<bool> given_up) const { return planes_to_rejoin(pyramid, slots, planes, given_up, kNoise); }

  Slots slots;
  std::vector<PlaneFit> planes;
  Pyramid pyramid;
};

TEST(Rejoin, APieceOfAWallGoesToTheWall) {
  EXPECT_EQ(PartedWall().into({false, true, false}), (std::vector<std::int32_t>{-1, kWall, -1}));
}

TEST(Rejoin, WhatIsNotGivenUpStays) { EXPECT_EQ(PartedWall().into({false, false, false}), (std::vector<std::int32_t>{-1, -1, -1})); }

TEST(Rejoin, NothingGoesToWhatIsGivenUpItselfOrIsSmaller) {
  EXPECT_EQ(PartedWall().into({true, true, true}), (std::vector<std::int32_t>{-1, -1, -1}));
  EXPECT_EQ(PartedWall().into({true, true, false}), (std::vector<std::int32_t>{-1, -1, -1}));
}

TEST(Rejoin, APieceGoesToWhatItTouchesAndNotToTheLargestThatWouldExplainIt) {
  EXPECT_EQ(PartedWall().into({false, false, true})[kFurther], kPiece);
}

TEST(Rejoin, WhatStandsBeforeTheWallByItsNoiseIsNoPieceOfIt) {
  EXPECT_EQ(PartedWall(0.003).into({false, true, false})[kPiece], kWall);
  EXPECT_EQ(PartedWall(kNoise).into({false, true, false})[kPiece], -1);
  EXPECT_EQ(PartedWall(-kNoise).into({false, true, false})[kPiece], -1);
}

TEST(Rejoin, WhatLeansIsNoPieceOfIt) { EXPECT_EQ(PartedWall(-0.03, 0.2).into({false, true, false})[kPiece], -1); }

TEST(Rejoin, WhatIsTooSmallToTellStays) { EXPECT_EQ(PartedWall(0, 0, 0.05).into({false, true, false})[kPiece], -1); }

}  // namespace
}  // namespace scenelore::perception
