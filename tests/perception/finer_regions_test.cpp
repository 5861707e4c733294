// What is left is looked at in finer voxels.
#include "finer_regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "planar_scenes.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;
using testing::Scene;
using V = Eigen::Vector3d;

constexpr double kVoxel = 0.025;
const Limits kLimits{.max_point_distance = 1.6, .max_plane_distance = 0.02, .max_mse = 1e-4, .min_points = 20, .max_neighbours = 30, .small_plane_step = 0.3};

/// Two shelf boards of 12 cm depth, 15 cm apart (0 and 1), and a wall behind them that is a region already (2).
struct Shelf {
  Scene scene;
  Regions regions;

  Shelf() {
    Random random(3);
    scene.add_rectangle(V(0, 0, 0), V(0.5, 0, 0), V(0, 0.12, 0), 12'000, 0.002, 0, random);
    scene.add_rectangle(V(0, 0, 0.15), V(0.5, 0, 0), V(0, 0.12, 0), 12'000, 0.002, 1, random);
    scene.add_rectangle(V(0, 0.12, 0), V(0.5, 0, 0), V(0, 0, 0.3), 12'000, 0.002, 2, random);
    for (const int truth : scene.truth) regions.of_point.push_back(truth == 2 ? 0 : -1);
    regions.planes.resize(1);
    refit(scene.cloud, regions);
  }
};

TEST(FinerRegions, FindBoardsInWhatIsLeft) {
  Shelf shelf;
  grow_finer(shelf.scene.cloud, kVoxel, 12, kLimits, 1, shelf.regions);
  ASSERT_GE(shelf.regions.planes.size(), 3U);
  std::vector<std::vector<double>> both(2, std::vector<double>(shelf.regions.planes.size(), 0));
  std::vector<double> all(2, 0);
  for (std::size_t i = 0; i < shelf.scene.truth.size(); ++i) {
    const int truth = shelf.scene.truth[i];
    const std::int32_t region = shelf.regions.of_point[i];
    if (truth == 2) {
      ASSERT_EQ(region, 0) << "what a plane has stays with it";
    } else {
      all[static_cast<std::size_t>(truth)] += 1;
      if (region >= 0) both[static_cast<std::size_t>(truth)][static_cast<std::size_t>(region)] += 1;
    }
  }
  for (const std::size_t board : {0U, 1U}) EXPECT_GT(*std::max_element(both[board].begin(), both[board].end()), 0.8 * all[board]);
}

TEST(FinerRegions, DoNotDependOnThreads) {
  Shelf one, two;
  grow_finer(one.scene.cloud, kVoxel, 12, kLimits, 1, one.regions);
  grow_finer(two.scene.cloud, kVoxel, 12, kLimits, 2, two.regions);
  EXPECT_EQ(one.regions.of_point, two.regions.of_point);
}

TEST(FinerRegions, AreNoneWhereNothingIsLeft) {
  Shelf shelf;
  for (std::int32_t& r : shelf.regions.of_point) r = 0;
  grow_finer(shelf.scene.cloud, kVoxel, 12, kLimits, 1, shelf.regions);
  EXPECT_EQ(shelf.regions.planes.size(), 1U);
}

}  // namespace
}  // namespace scenelore::perception
