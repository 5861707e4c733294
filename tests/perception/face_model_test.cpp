// What is given up as no face of the scene, and the traits and curves that decide about it.
#include "assign.hpp"
#include "face_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "find_regions.hpp"
#include "planar_scenes.hpp"
#include "scenelore/perception/segment.hpp"
#include "voxelise.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;
using testing::Scene;
using V = Eigen::Vector3d;

double of(const FaceTraits& traits, Trait trait) { return traits[static_cast<std::size_t>(trait)]; }

/// A floor, and over a corner of it a smaller plane at this height.
std::vector<FaceTraits> floor_and_plane_above(double height, const RegionRange& things = {}, const View& view = {.up = V::UnitZ(), .noise = 0.005, .slant = {1, 1}}) {
  Scene scene;
  Random random(3);
  scene.add_rectangle(V(0, 0, 0), V(2, 0, 0), V(0, 2, 0), 4000, 0.005, 0, random);
  scene.add_rectangle(V(0.5, 0.5, height), V(0.5, 0, 0), V(0, 0.5, 0), 4000, 0.005, 1, random);
  const VoxelisedCloud voxels = voxelise(scene.cloud, 0.05, 1);
  PlaneFit floor, above;
  floor.normal = above.normal = V::UnitZ();
  floor.count = 16'000, above.count = 1000, above.offset = height;
  const std::vector<PlaneFit> both{floor, above};
  Candidates all;
  for (std::size_t v = 0; v <= voxels.grid.count(); ++v) all.first.push_back(static_cast<std::uint32_t>(2 * v));
  for (std::size_t v = 0; v < voxels.grid.count(); ++v) all.regions.insert(all.regions.end(), {0, 1});
  AssignRule rule;
  rule.reach = rule.unit = {0.03, 0.03};
  rule.larger_first = false;
  SlotOfPoint slot_of_point;
  const Slots slots = assign_points(scene.cloud, voxels, all, both, rule, 1, slot_of_point);
  std::vector<PlaneFit> planes(2);
  refit(slots, planes);
  return face_traits(voxels.grid, local_surfaces(voxels.grid, 1), {0.005, 0.005}, slots, planes, view, things);
}

TEST(FaceTraits, TellALayerFromAPlaneFurtherUp) {
  const std::vector<FaceTraits> near = floor_and_plane_above(0.012), far = floor_and_plane_above(0.3);
  EXPECT_LT(of(near[1], Trait::layer), 4);  // 1.2 cm are 2.4 deviations
  EXPECT_GT(of(near[1], Trait::foreign), 0.2);
  EXPECT_EQ(of(far[1], Trait::layer), 8);
  EXPECT_EQ(of(far[1], Trait::foreign), 0);
  EXPECT_EQ(of(near[0], Trait::layer), 8) << "the larger plane is nobody's layer";
}

TEST(FaceTraits, TellHowFarAThingIsOverItsPlaneInCentimetres) {
  const std::vector<FaceTraits> layer = floor_and_plane_above(0.012), thing = floor_and_plane_above(0.012, {.first = 1, .end = 2});
  EXPECT_NEAR(of(layer[1], Trait::layer), 2.4, 0.8) << "deviations";
  EXPECT_NEAR(of(thing[1], Trait::layer), 1.2, 0.4) << "centimetres";
  EXPECT_EQ(of(thing[0], Trait::layer), 8);
}

TEST(FaceTraits, TellTheTiltAgainstUp) {
  const double angle = 30 * std::numbers::pi / 180;
  const V leaning(std::sin(angle), 0, std::cos(angle));
  EXPECT_NEAR(of(floor_and_plane_above(0.3)[1], Trait::tilt), 0, 0.1);
  EXPECT_NEAR(of(floor_and_plane_above(0.3, {}, {.up = leaning, .noise = 0.005, .slant = {1, 1}})[1], Trait::tilt), 30, 0.1);
  EXPECT_NEAR(of(floor_and_plane_above(0.3, {}, {.up = -leaning, .noise = 0.005, .slant = {1, 1}})[1], Trait::tilt), 30, 0.1) << "a plane has two sides";
}

TEST(FaceTraits, ExpectLessNoiseAcrossAPlaneThatIsSeenAtASlant) {
  const auto seen_at = [](double slant) { return floor_and_plane_above(0.3, {}, {.up = V::UnitZ(), .noise = 0.005, .slant = {slant, slant}})[1]; };
  EXPECT_NEAR(of(seen_at(1), Trait::excess), 0, 0.03);
  EXPECT_NEAR(of(seen_at(0.5), Trait::excess), std::log10(2), 0.03);
  EXPECT_NEAR(of(seen_at(0), Trait::excess), 1, 0.03) << "a tenth at the least";
  EXPECT_EQ(of(seen_at(0.5), Trait::slant), 0.5);
}

TEST(FaceTraits, AreNotNumbersWhereNobodyKnowsFromWhereItWasSeen) {
  const FaceTraits plane = floor_and_plane_above(0.3, {}, {.up = V::UnitZ(), .noise = 0.005, .slant = {}})[1];
  EXPECT_TRUE(std::isnan(of(plane, Trait::slant)));
  EXPECT_TRUE(std::isnan(of(plane, Trait::excess)));
  EXPECT_GT(face_probability(plane, Origin::surface), 0.5) << "speaks neither for nor against";
}

TEST(FaceTraits, TakeWhatLiesBesideAPlaneForNoLayer) {
  // Two desks of one height, side by side.
  Scene scene;
  Random random(6);
  scene.add_rectangle(V(0, 0, 0.72), V(1.6, 0, 0), V(0, 0.8, 0), 4000, 0.005, 0, random);
  scene.add_rectangle(V(1.6, 0, 0.72), V(0.8, 0, 0), V(0, 0.8, 0), 4000, 0.005, 1, random);
  const VoxelisedCloud voxels = voxelise(scene.cloud, 0.05, 1);
  std::vector<std::int32_t> region(voxels.grid.count());
  for (std::size_t v = 0; v < region.size(); ++v) region[v] = voxels.grid.center(v).x() < 1.6 ? 0 : 1;
  const Slots slots = slots_of_voxels(voxels.grid, region);
  std::vector<PlaneFit> planes(2);
  refit(slots, planes);
  const auto traits = face_traits(voxels.grid, local_surfaces(voxels.grid, 1), {0.005, 0.005}, slots, planes, View{.up = V::UnitZ(), .noise = 0.005, .slant = {1, 1}});
  EXPECT_GT(of(traits[1], Trait::layer), 7.5);
  EXPECT_GT(face_probability(traits[1], Origin::surface), 0.5);
}

TEST(FaceTraits, MeasureACleanPlaneAsOne) {
  const FaceTraits plane = floor_and_plane_above(0.3)[1];
  EXPECT_NEAR(of(plane, Trait::points), 3, 0.02);
  EXPECT_NEAR(of(plane, Trait::area), std::log10(0.25), 0.05);
  EXPECT_NEAR(of(plane, Trait::length), 0, 0.05);
  EXPECT_NEAR(of(plane, Trait::roughness), 1, 0.1);
  EXPECT_GT(of(plane, Trait::agreeing), 0.95);
  EXPECT_LT(of(plane, Trait::left), 0.02);
  // A tenth more on each side, in voxels that the edge cuts.
  EXPECT_GT(of(plane, Trait::fill), 0.95);
  EXPECT_LT(of(plane, Trait::fill), 2.5);
}

TEST(FaceTraits, AreZerosForRegionsWithoutPoints) {
  const Scene scene = testing::room(0.005);
  const VoxelisedCloud voxels = voxelise(scene.cloud, 0.05, 1);
  const Slots slots = slots_of_voxels(voxels.grid, std::vector<std::int32_t>(voxels.grid.count(), -1));
  const auto traits = face_traits(voxels.grid, local_surfaces(voxels.grid, 1), {0.005}, slots, std::vector<PlaneFit>(1), View{});
  EXPECT_EQ(traits.front(), FaceTraits{});
}

TEST(FaceModel, TakesTheFacesOfARoomForFaces) {
  const Scene scene = testing::room(0.01);
  FaceQuestions questions;
  static_cast<void>(find_regions(scene.cloud, {.threads = 1}, &questions));
  const FaceRound& asked = questions.rounds.front();
  std::vector<double> size(asked.traits.size(), 0);
  for (const std::int32_t r : asked.region_of_point) {
    if (r >= 0) size[static_cast<std::size_t>(r)] += 1;
  }
  int faces = 0;
  for (std::size_t r = 0; r < size.size(); ++r) {
    if (size[r] < 1000) continue;
    ++faces;
    EXPECT_GT(face_probability(asked.traits[r], asked.origins[r]), 0.5) << "region of " << size[r] << " points";
  }
  EXPECT_EQ(faces, 7);
}

TEST(FaceModel, DoubtsAThinLayerOfALargerPlane) {
  const std::vector<FaceTraits> near = floor_and_plane_above(0.008), far = floor_and_plane_above(0.3);
  EXPECT_LT(face_probability(near[1], Origin::surface), 0.3 * face_probability(far[1], Origin::surface));
}

TEST(FaceModel, TakesForAThingWhatWouldBeALayer) {
  const FaceTraits alone = floor_and_plane_above(0.3)[1];
  const auto over = [&](double layer) {
    FaceTraits traits = alone;
    traits[static_cast<std::size_t>(Trait::layer)] = layer;
    return traits;
  };
  // Three deviations off a larger plane is scatter; three centimetres over a desk is what was looked for there.
  EXPECT_LT(face_probability(over(3), Origin::surface), face_probability(alone, Origin::surface));
  EXPECT_GT(face_probability(over(3), Origin::thing), 0.7);
  EXPECT_LT(face_probability(over(0.3), Origin::thing), face_probability(over(3), Origin::thing)) << "of what is 3 mm high nobody knows";
}

TEST(FaceModel, IsDefinedForAnyTraits) {
  FaceTraits traits{};
  for (const double x : {-1e30, 0.0, 1e30, std::numeric_limits<double>::quiet_NaN()}) {
    traits.fill(x);
    for (const Origin origin : {Origin::surface, Origin::thing, Origin::earlier}) {
      const double p = face_probability(traits, origin);
      EXPECT_GE(p, 0);
      EXPECT_LE(p, 1);
    }
  }
}

TEST(Segment, GivesUpABush) {
  Scene scene = testing::room(0.01);
  Random random(8);
  // Leaves: patches of 10 cm in all directions, within a ball of half a metre.
  for (int leaf = 0; leaf < 60; ++leaf) {
    const V at(2.8 + 0.5 * random.normal() / 3, 2.2 + 0.5 * random.normal() / 3, 1.0 + 0.5 * random.normal() / 3);
    const V a = V(random.normal(), random.normal(), random.normal()).normalized();
    const V b = a.cross(V(random.normal(), random.normal(), random.normal())).normalized();
    scene.add_rectangle(at, 0.1 * a, 0.1 * b, 6000, 0.01, -1, random);
  }
  const Segmentation found = segment(scene.cloud, {}, 1);
  std::vector<int> of_bush(found.planes.size(), 0);
  std::vector<int> all(found.planes.size(), 0);
  for (std::size_t i = 0; i < scene.truth.size(); ++i) {
    if (found.plane_of_point[i] < 0) continue;
    const auto p = static_cast<std::size_t>(found.plane_of_point[i]);
    ++all[p];
    of_bush[p] += scene.truth[i] < 0;
  }
  int bushy = 0;
  for (std::size_t p = 0; p < all.size(); ++p) bushy += 2 * of_bush[p] > all[p];
  EXPECT_LE(bushy, 6) << "of 60 leaves";
  const auto overlaps = testing::best_overlaps(scene, found.plane_of_point, 7);
  EXPECT_GT(*std::min_element(overlaps.begin(), overlaps.end()), 0.9);
}

}  // namespace
}  // namespace scenelore::perception
