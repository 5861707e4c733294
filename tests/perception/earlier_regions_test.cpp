// Regions that were given up come back as they were before.
#include "earlier_regions.hpp"

#include <gtest/gtest.h>

#include "find_regions.hpp"
#include "planar_scenes.hpp"

namespace scenelore::perception {
namespace {

using V = Eigen::Vector3d;
constexpr int kFewest = 12;

/// A floor 0 and a board 1 over it, 400 and 100 points in this order, each a region.
struct Before {
  testing::Scene scene;
  Regions regions;

  Before() {
    testing::Random random(2);
    scene.add_rectangle(V(0, 0, 0), V(2, 0, 0), V(0, 2, 0), 100, 0.002, 0, random);
    scene.add_rectangle(V(0.5, 0.5, 0.4), V(0.5, 0, 0), V(0, 0.5, 0), 400, 0.002, 1, random);
    regions.of_point.assign(scene.truth.begin(), scene.truth.end());
    regions.planes.resize(2);
    refit(scene.cloud, regions);
  }
  /// Takes the first points of the board from it, or gives them to the floor.
  [[nodiscard]] Regions without(int points, std::int32_t now = -1) const {
    Regions result = regions;
    for (int i = 0; i < points; ++i) result.of_point[static_cast<std::size_t>(400 + i)] = now;
    return result;
  }
};

TEST(EarlierRegions, ComeBackWithTheirFreePointsAndTheirPlane) {
  const Before before;
  Regions now = before.without(80);
  for (std::size_t i = 480; i < 500; ++i) now.of_point[i] = 0;
  bring_back(before.scene.cloud, before.regions.of_point, kFewest, now);
  ASSERT_EQ(now.planes.size(), 3U);
  for (std::size_t i = 0; i < 500; ++i) EXPECT_EQ(now.of_point[i], i < 400 ? 0 : i < 480 ? 2 : 0) << i;
  EXPECT_EQ(now.planes[2].count, 80);
  EXPECT_NEAR(std::abs(now.planes[2].normal.z()), 1, 1e-3);
  EXPECT_NEAR(std::abs(now.planes[2].distance(before.scene.cloud.offset(0).cast<double>())), 0.4, 0.02);
}

TEST(EarlierRegions, StayGoneWhereMostOfThemIsOfOthersNow) {
  const Before before;
  for (const auto& [free, comes] : {std::pair(69, false), std::pair(70, true)}) {
    Regions now = before.without(free);
    for (int i = free; i < 100; ++i) now.of_point[static_cast<std::size_t>(400 + i)] = 0;
    bring_back(before.scene.cloud, before.regions.of_point, kFewest, now);
    EXPECT_EQ(now.planes.size(), comes ? 3U : 2U) << free;
  }
}

TEST(EarlierRegions, StayGoneWhereTheyAreOfFewPoints) {
  Before before;
  std::vector<std::int32_t> earlier(before.regions.of_point.size(), -1);
  for (const auto& [points, comes] : {std::pair(kFewest - 1, false), std::pair(kFewest, true)}) {
    for (int i = 0; i < points; ++i) earlier[static_cast<std::size_t>(400 + i)] = 7;
    Regions now = before.without(100);
    bring_back(before.scene.cloud, earlier, kFewest, now);
    EXPECT_EQ(now.planes.size(), comes ? 3U : 2U) << points;
  }
}

TEST(EarlierRegions, AreNoneWhereNothingWasGivenUpOrNothingIsThere) {
  const Before before;
  Regions now = before.regions;
  bring_back(before.scene.cloud, before.regions.of_point, kFewest, now);
  EXPECT_EQ(now.of_point, before.regions.of_point);
  EXPECT_EQ(now.planes.size(), 2U);
  Regions nothing;
  bring_back(Cloud(), {}, kFewest, nothing);
  EXPECT_TRUE(nothing.planes.empty());
}

TEST(EarlierRegions, AreJudgedByTreesOfTheirOwn) {
  FaceQuestions questions;
  const testing::Scene scene = testing::room(0.01);
  static_cast<void>(find_regions(scene.cloud, {.threads = 1}, &questions));
  ASSERT_EQ(questions.rounds.size(), 4U) << "as they are, in finer voxels, as they had grown, as they were before clutter went";
  EXPECT_EQ(questions.rounds[0].first, 0U);
  for (std::size_t k = 0; k < questions.rounds.size(); ++k) {
    const FaceRound& round = questions.rounds[k];
    ASSERT_EQ(round.origins.size(), round.traits.size());
    for (std::size_t r = round.first; r < round.origins.size(); ++r) {
      EXPECT_EQ(round.origins[r] == Origin::earlier, k > 1) << k << " " << r;
      EXPECT_EQ(round.origins[r] == Origin::finer, k == 1) << k << " " << r;
    }
  }
}

}  // namespace
}  // namespace scenelore::perception
