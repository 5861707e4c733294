// A shelf seen from above and before it: its face is seen at a slant, its front edge is not.
#include "assign.hpp"
#include "front_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "planar_scenes.hpp"
#include "sample.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;

constexpr double kNoise = 0.01;  // metres along the ray
constexpr int kOfFace = 600, kOfEdge = 150;

/// A board of 0.8 x 0.25 m, 2 m away and 2 cm thick, all of whose points within 2.5 cm of its face are one plane.
struct Shelf {
  explicit Shelf(double sensor_above = 0.6, int of_edge = kOfEdge) {
    Random random(4);
    const Eigen::Vector3d sensor(0, 0, sensor_above);
    const auto measure = [&](const Eigen::Vector3d& p) {
      const Eigen::Vector3d seen = p + kNoise * random.normal() * (p - sensor).normalized();
      cloud.x.push_back(static_cast<float>(seen.x())), cloud.y.push_back(static_cast<float>(seen.y())), cloud.z.push_back(static_cast<float>(seen.z()));
    };
    for (int i = 0; i < kOfFace; ++i) measure({2 + random.uniform(0, 0.25), random.uniform(-0.4, 0.4), 0});
    for (int i = 0; i < of_edge; ++i) measure({2, random.uniform(-0.4, 0.4), random.uniform(-0.02, 0)});
    cloud.sensors = SensorPositions(sensor);
    const VoxelisedCloud voxels = voxelise(cloud, 0.05, 1);
    PlaneFit plane;
    plane.normal = Eigen::Vector3d::UnitZ(), plane.count = static_cast<double>(cloud.size());
    Candidates one;
    for (std::size_t v = 0; v <= voxels.grid.count(); ++v) one.first.push_back(static_cast<std::uint32_t>(v));
    one.regions.assign(voxels.grid.count(), 0);
    AssignRule rule;
    rule.reach = {0.025}, rule.unit = {1.0};
    slots = assign_points(cloud, voxels, one, {plane}, rule, 1, slot_of_point);
    planes = {plane};
    refit(slots, planes);
    before = kept(0, cloud.size());
  }

  void free_edges(int threads = 1) { free_front_edges(cloud, kNoise, threads, slot_of_point, slots, planes); }
  [[nodiscard]] long kept(std::size_t begin, std::size_t end) const {
    const std::vector<std::int32_t> regions = regions_of_points(slots, slot_of_point);
    return std::count(regions.begin() + static_cast<std::ptrdiff_t>(begin), regions.begin() + static_cast<std::ptrdiff_t>(end), 0);
  }
  [[nodiscard]] long kept_of_edge() const { return kept(kOfFace, cloud.size()); }

  Cloud cloud;
  Slots slots;
  SlotOfPoint slot_of_point;
  std::vector<PlaneFit> planes;
  long before = 0;
};

TEST(FrontEdges, AreNotOfTheFaceThatIsSeenAtASlant) {
  Shelf shelf;
  ASSERT_GT(shelf.kept_of_edge(), 0.9 * kOfEdge) << "one plane of both";
  shelf.free_edges();
  EXPECT_LT(shelf.kept_of_edge(), 0.3 * kOfEdge);
  EXPECT_GT(shelf.kept(0, kOfFace), 0.93 * kOfFace);
  EXPECT_GT(std::abs(shelf.planes[0].normal.z()), 0.9999) << "within 0.8 degrees of level";
}

TEST(FrontEdges, LeaveSlotsThatHoldWhatTheirPointsSay) {
  Shelf shelf;
  shelf.free_edges();
  std::vector<double> n(shelf.slots.count(), 0);
  std::vector<Eigen::Vector3d> sum(shelf.slots.count(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < shelf.cloud.size(); ++i) {
    n[shelf.slot_of_point[i]] += 1;
    sum[shelf.slot_of_point[i]] += shelf.cloud.offset(i).cast<double>();
  }
  for (std::size_t s = 0; s < shelf.slots.count(); ++s) {
    EXPECT_EQ(shelf.slots.moments[s].n, n[s]);
    EXPECT_NEAR((shelf.slots.moments[s].sum - sum[s]).norm(), 0, 1e-5) << "moments are of coordinates in whole steps";
  }
}

TEST(FrontEdges, TakeNothingFromAFaceWithoutOne) {
  Shelf shelf(0.6, 0);
  shelf.free_edges();
  EXPECT_EQ(shelf.kept(0, kOfFace), shelf.before);
}

TEST(FrontEdges, TakeNothingWhereTheSensorLooksSquarely) {
  Shelf shelf(6);
  shelf.free_edges();
  EXPECT_EQ(shelf.kept(0, shelf.cloud.size()), shelf.before);
}

TEST(FrontEdges, TakeNothingWithoutTheSensorsPosition) {
  Shelf shelf;
  shelf.cloud.sensors = {};
  shelf.free_edges();
  EXPECT_EQ(shelf.kept(0, shelf.cloud.size()), shelf.before);
}

TEST(FrontEdges, AreTheSameWithAnyNumberOfThreads) {
  Shelf one, four;
  one.free_edges(1);
  four.free_edges(4);
  EXPECT_EQ(one.slot_of_point, four.slot_of_point);
}

}  // namespace
}  // namespace scenelore::perception
