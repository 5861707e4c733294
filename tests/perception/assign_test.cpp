// Points sorted by voxel are assigned in a pass of their own, which must do what the pass in the cloud's order does.
#include <gtest/gtest.h>

#include "assign.hpp"
#include "planar_scenes.hpp"
#include "sample.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;

/// A floor, a wall and a board 3 cm before it, with noise: voxels of one, two and three planes.
Cloud corner_with_board() {
  Cloud cloud;
  Random random(5);
  const auto add = [&](const Eigen::Vector3d& p) {
    cloud.x.push_back(static_cast<float>(p.x())), cloud.y.push_back(static_cast<float>(p.y())), cloud.z.push_back(static_cast<float>(p.z()));
  };
  for (int i = 0; i < 20'000; ++i) {
    const double a = random.uniform(0, 1), b = random.uniform(0, 1), noise = 0.005 * random.normal();
    add(i % 3 == 0 ? Eigen::Vector3d(a, b, noise) : i % 3 == 1 ? Eigen::Vector3d(noise, a, b) : Eigen::Vector3d(0.03 + noise, 0.3 * a, 0.3 * b));
  }
  return cloud;
}

PlaneFit plane(const Eigen::Vector3d& normal, double offset, double count) {
  PlaneFit fit;
  fit.normal = normal, fit.offset = offset, fit.count = count;
  return fit;
}

void expect_same(const Slots& a, const Slots& b) {
  EXPECT_EQ(a.first, b.first);
  EXPECT_EQ(a.region, b.region);
  EXPECT_EQ(a.ruler, b.ruler);
  ASSERT_EQ(a.moments.size(), b.moments.size());
  for (std::size_t s = 0; s < a.moments.size(); ++s) {
    EXPECT_EQ(a.moments[s].n, b.moments[s].n);
    EXPECT_EQ(a.moments[s].sum, b.moments[s].sum);
    EXPECT_EQ(a.moments[s].zz, b.moments[s].zz);
  }
}

TEST(AssignPoints, GivesSortedPointsTheSameSlots) {
  const Cloud cloud = corner_with_board();
  const VoxelisedCloud voxels = voxelise(cloud, 0.05, 1);
  const PointSample sample = take_sample(cloud, voxels, 1 << 20, 1);
  ASSERT_EQ(sample.points.size(), cloud.size());
  const std::vector<PlaneFit> planes{plane(Eigen::Vector3d::UnitZ(), 0, 3000), plane(Eigen::Vector3d::UnitX(), 0, 2000),
                                     plane(Eigen::Vector3d::UnitX(), 0.03, 1000)};
  Candidates all;
  for (std::size_t v = 0; v <= voxels.grid.count(); ++v) all.first.push_back(static_cast<std::uint32_t>(3 * v));
  for (std::size_t v = 0; v < voxels.grid.count(); ++v) all.regions.insert(all.regions.end(), {0, 1, 2});
  AssignRule rule;
  rule.reach = rule.unit = {0.02, 0.02, 0.015};
  SlotOfPoint by_points, by_voxels;
  const Slots a = assign_points(cloud, voxels, all, planes, rule, 2, by_points);
  const Slots b = assign_points(sample.by_voxel, voxels.grid, all, planes, rule, 2, by_voxels);
  EXPECT_EQ(by_points, by_voxels);
  expect_same(a, b);
}

/// Voxels that are assigned anew have what an assignment of all would give them, the rest what they had: slots before, among and after those that
/// grow and shrink.
TEST(AssignPoints, KeepsTheSlotsOfVoxelsThatAreNotAskedFor) {
  const Cloud cloud = corner_with_board();
  const VoxelisedCloud voxels = voxelise(cloud, 0.05, 1);
  const PointSample sample = take_sample(cloud, voxels, 1 << 20, 1);
  const std::vector<PlaneFit> planes{plane(Eigen::Vector3d::UnitZ(), 0, 3000), plane(Eigen::Vector3d::UnitX(), 0, 2000),
                                     plane(Eigen::Vector3d::UnitX(), 0.03, 1000)};
  const std::size_t count = voxels.grid.count();
  std::vector<bool> anew(count);
  Candidates before, after;
  for (std::size_t v = 0; v < count; ++v) {
    anew[v] = v % 5 == 1 || v % 5 == 2;
    before.first.push_back(static_cast<std::uint32_t>(before.regions.size()));
    after.first.push_back(static_cast<std::uint32_t>(after.regions.size()));
    before.regions.insert(before.regions.end(), {0, 1});
    if (v % 5 == 1) after.regions.insert(after.regions.end(), {0, 1, 2});
  }
  before.first.push_back(static_cast<std::uint32_t>(before.regions.size()));
  after.first.push_back(static_cast<std::uint32_t>(after.regions.size()));
  AssignRule rule;
  rule.larger_first = false;
  rule.reach = rule.unit = {0.02, 0.02, 0.015};
  SlotOfPoint slot_of_point, then;
  const Slots old = assign_points(sample.by_voxel, voxels.grid, before, planes, rule, 1, slot_of_point);
  const SlotOfPoint first = slot_of_point;
  const Slots all = assign_points(sample.by_voxel, voxels.grid, after, planes, rule, 1, then);
  for (const int threads : {1, 2}) {
    Slots slots = old;
    slot_of_point = first;
    assign_anew(sample.by_voxel, voxels.grid, anew, after, planes, rule, threads, slot_of_point, slots);
    for (std::size_t v = 0; v < count; ++v) {
      const Slots& source = anew[v] ? all : old;
      ASSERT_EQ(slots.first[v + 1] - slots.first[v], source.first[v + 1] - source.first[v]);
      for (std::uint32_t k = 0; k < source.first[v + 1] - source.first[v]; ++k) {
        const std::uint32_t s = slots.first[v] + k, from = source.first[v] + k;
        EXPECT_EQ(slots.voxel[s], v);
        EXPECT_EQ(slots.region[s], source.region[from]);
        EXPECT_EQ(slots.moments[s].n, source.moments[from].n);
        EXPECT_EQ(slots.moments[s].sum, source.moments[from].sum);
        ASSERT_EQ(slots.ruler[s] < 0, source.ruler[from] < 0);
        if (slots.ruler[s] < 0) continue;
        EXPECT_EQ(slots.rulers[slots.ruler[s]].offset, source.rulers[source.ruler[from]].offset);
      }
    }
    std::vector<double> held(slots.count(), 0);
    for (const std::int32_t s : slot_of_point) held[s] += 1;
    for (std::size_t s = 0; s < slots.count(); ++s) EXPECT_EQ(held[s], slots.moments[s].n);
  }
}

/// A shelf that is seen at a slant meets a wall: 30 points a voxel within millimetres of the one, 300 within a centimetre of the other.
TEST(AssignPoints, GivesWhatLiesWherePlanesCrossToTheOneThatHoldsMore) {
  constexpr int kOfShelf = 600, kOfWall = 6000;
  constexpr double kShelfNoise = 0.002, kWallNoise = 0.01;
  Cloud cloud;
  Random random(6);
  const auto add = [&](double x, double y, double z) {
    cloud.x.push_back(static_cast<float>(x)), cloud.y.push_back(static_cast<float>(y)), cloud.z.push_back(static_cast<float>(z));
  };
  for (int i = 0; i < kOfShelf; ++i) add(-random.uniform(0, 0.3), random.uniform(0, 0.4), kShelfNoise * random.normal());
  for (int i = 0; i < kOfWall; ++i) add(kWallNoise * random.normal(), random.uniform(0, 0.4), random.uniform(-0.2, 0.2));
  const VoxelisedCloud voxels = voxelise(cloud, 0.05, 1);
  const std::vector<PlaneFit> planes{plane(Eigen::Vector3d::UnitZ(), 0, kOfShelf), plane(Eigen::Vector3d::UnitX(), 0, kOfWall)};
  const auto of_wall_on_shelf = [&](const Candidates& candidates, AssignRule rule, Slots& slots) {
    rule.larger_first = false;
    rule.reach = {3 * kShelfNoise, 3 * kWallNoise};
    SlotOfPoint slot_of_point;
    slots = assign_points(cloud, voxels, candidates, planes, rule, 1, slot_of_point);
    const std::vector<std::int32_t> regions = regions_of_points(slots, slot_of_point);
    EXPECT_GT(std::count(regions.begin(), regions.begin() + kOfShelf, 0), 0.85 * kOfShelf);
    return std::count(regions.begin() + kOfShelf, regions.end(), 0);
  };
  Candidates both;
  for (std::size_t v = 0; v <= voxels.grid.count(); ++v) both.first.push_back(static_cast<std::uint32_t>(2 * v));
  for (std::size_t v = 0; v < voxels.grid.count(); ++v) both.regions.insert(both.regions.end(), {0, 1});
  Slots slots;
  const auto nearest = of_wall_on_shelf(both, {.reach = {}, .unit = {1, 1}}, slots);
  const std::vector<double> sigma{kShelfNoise, kWallNoise};
  const auto likeliest = of_wall_on_shelf(candidates_within(slots, sigma), {.reach = {}, .unit = sigma}, slots);
  EXPECT_GT(nearest, 100);
  EXPECT_LT(likeliest, 0.5 * static_cast<double>(nearest));
}

}  // namespace
}  // namespace scenelore::perception
