// Faces flush with their wall, from the cut of a grid up to segmentation.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "binary_cut.hpp"
#include "flush_faces.hpp"
#include "planar_scenes.hpp"
#include "scenelore/perception/segment.hpp"
#include "step_faces.hpp"
#include "step_scan.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;
using testing::Scene;

HeightGrid grid_of(int columns, int rows, double edge, double points) {
  HeightGrid grid{.columns = columns, .rows = rows, .edge = edge, .count = {}, .height = {}};
  grid.count.assign(static_cast<std::size_t>(columns * rows), points);
  grid.height.assign(grid.count.size(), 0.0);
  return grid;
}

/// A wall of 4 m × 2.4 m in cells of 5 cm with eight points each that scatter by 1 cm; `height_of` says how high it
/// stands.
HeightGrid wall(Random& random, auto height_of) {
  HeightGrid grid = grid_of(80, 48, 0.05, 8);
  grid.for_each_cell([&](int x, int y, std::size_t c) {
    grid.height[c] = height_of((x + 0.5) * 0.05, (y + 0.5) * 0.05) + 0.01 / std::sqrt(8) * random.normal();
  });
  return grid;
}

bool in_door(double u, double v) { return u > 2.5 && u < 3.4 && v < 2.0; }

double worth(const HeightGrid& grid, const std::vector<double>& evidence, double border,
             const std::vector<bool>& inside) {
  double sum = 0;
  for (std::size_t c = 0; c < inside.size(); ++c) sum += inside[c] ? evidence[c] : 0;
  grid.for_each_pair([&](std::size_t a, std::size_t b) { sum -= inside[a] != inside[b] ? border : 0; });
  return sum;
}

TEST(BinaryCut, IsAsGoodAsTheBestOfAllSets) {
  Random random(1);
  for (int round = 0; round < 40; ++round) {
    HeightGrid grid = grid_of(4, 4, 0.05, 1);
    if (round % 3 == 0) grid.count[static_cast<std::size_t>(random.uniform(0, 16))] = 0;
    std::vector<double> evidence;
    for (int c = 0; c < 16; ++c)
      evidence.push_back(grid.count[static_cast<std::size_t>(c)] > 0 ? random.normal() + 0.2 : 0);
    const double border = random.uniform(0, 1);
    double best = 0;
    for (unsigned set = 0; set < 1U << 16; ++set) {
      std::vector<bool> inside(16);
      for (std::size_t c = 0; c < 16; ++c) inside[c] = (set >> c & 1U) != 0 && grid.count[c] > 0;
      best = std::max(best, worth(grid, evidence, border, inside));
    }
    EXPECT_NEAR(worth(grid, evidence, border, binary_cut(grid, evidence, border)), best, 1e-3) << "round " << round;
  }
}

TEST(BinaryCut, HandlesASingleRowAndASingleColumn) {
  for (const auto& [columns, rows] : {std::pair{6, 1}, {1, 6}}) {
    const HeightGrid grid = grid_of(columns, rows, 0.05, 1);
    const std::vector<bool> inside = binary_cut(grid, {3, 2, -0.5, 2, -4, -3}, 1);
    EXPECT_EQ(inside, (std::vector<bool>{true, true, true, true, false, false}));
  }
}

TEST(StepScan, FindsTheRectangleOnAWallThatBends) {
  Random random(2);
  const HeightGrid grid =
      wall(random, [](double u, double v) { return 0.004 * (u - 2) * (u - 2) + (in_door(u, v) ? 0.005 : 0); });
  const std::vector<double> weight(grid.count.size(), 8 / (0.01 * 0.01));
  const auto found = scan_for_steps(grid, weight, 16, 4);
  ASSERT_FALSE(found.empty());
  const CellRectangle& r = found.front();
  EXPECT_NEAR(r.left * 0.05, 2.5, 0.16);
  EXPECT_NEAR(r.right * 0.05, 3.4, 0.16);
  EXPECT_EQ(r.bottom, 0);
  EXPECT_NEAR(r.top * 0.05, 2.0, 0.16);
}

TEST(StepFaces, FindADoorHalfADeviationBehindItsWallButNothingOnABareOne) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    StepFaceFinder bare(wall(random, [](double, double) { return 0.0; }), 0.01);
    EXPECT_FALSE(bare.next()) << "seed " << seed;

    const HeightGrid grid = wall(random, [](double u, double v) { return in_door(u, v) ? -0.005 : 0.0; });
    StepFaceFinder finder(grid, 0.01);
    const auto face = finder.next();
    ASSERT_TRUE(face) << "seed " << seed;
    EXPECT_NEAR(face->step, -0.005, 0.001);
    double right = 0, either = 0;
    grid.for_each_cell([&](int x, int y, std::size_t c) {
      const bool door = in_door((x + 0.5) * 0.05, (y + 0.5) * 0.05);
      right += door && face->cells[c], either += door || face->cells[c];
    });
    EXPECT_GT(right / either, 0.9) << "seed " << seed;
    EXPECT_FALSE(finder.next()) << "seed " << seed;
  }
}

TEST(StepFaces, TakeNeitherBendsNorWavesNorUnevenPlasterForFaces) {
  const std::array<double (*)(double, double), 4> shapes{
      [](double u, double) { return 0.012 * std::sin(u); },                          // bends by 2 cm over its length
      [](double u, double) { return u > 2 ? 0.015 * (u - 2) : 0.0; },                // one half leans by a degree
      [](double u, double v) { return 0.003 * std::sin(6 * u) * std::cos(5 * v); },  // bumps of half a metre
      [](double u, double v) { return 0.004 * std::sin(2.2 * u + v) + 0.002 * std::cos(9 * v); },
  };
  for (std::size_t s = 0; s < shapes.size(); ++s) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Random random(seed);
      EXPECT_FALSE(StepFaceFinder(wall(random, shapes[s]), 0.01).next()) << "shape " << s << ", seed " << seed;
    }
  }
}

TEST(StepFaces, FindWhatIsSeenOfADoorOnBothSidesOfWhatStandsBeforeIt) {
  Random random(3);
  HeightGrid grid = wall(random, [](double u, double v) { return in_door(u, v) ? -0.006 : 0.0; });
  const auto hidden = [](double u) { return u > 2.8 && u < 3.1; };
  grid.for_each_cell([&](int x, int, std::size_t c) { grid.count[c] = hidden((x + 0.5) * 0.05) ? 0 : grid.count[c]; });
  StepFaceFinder finder(grid, 0.01);
  const auto face = finder.next();
  ASSERT_TRUE(face);
  const auto holds = [&](double u, double v) {
    return face->cells[grid.at(static_cast<int>(u / 0.05), static_cast<int>(v / 0.05))];
  };
  EXPECT_TRUE(holds(2.65, 1.0));
  EXPECT_TRUE(holds(3.25, 1.0));
  EXPECT_FALSE(holds(2.95, 1.0));
  EXPECT_FALSE(holds(1.0, 1.0));
}

/// What hangs on a wall: a board that the sensor stands before, so that its cells hold far more points than those of all the rest, a door
/// leaf, and two pictures of one thickness.
struct Hanging {
  double left, right, bottom, top, height;
  [[nodiscard]] bool holds(double u, double v) const { return u > left && u < right && v > bottom && v < top; }
};
constexpr std::array<Hanging, 4> kHangings{
    {{0.0, 1.3, 0.8, 2.0, 0.011}, {2.5, 3.4, 0.0, 2.0, -0.005}, {1.6, 2.1, 1.2, 1.7, 0.02}, {3.55, 3.85, 1.2, 1.8, 0.02}}};

TEST(StepFaces, FindEachOfSeveralOnOneWallHoweverUnevenlyItIsSeen) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Random random(seed);
    HeightGrid grid = wall(random, [](double u, double v) {
      double height = 0.004 * u;  // the wall was fitted to the board and leans
      for (const Hanging& h : kHangings) height += h.holds(u, v) ? h.height : 0;
      return height;
    });
    grid.for_each_cell([&](int x, int y, std::size_t c) {
      if (!kHangings[0].holds((x + 0.5) * 0.05, (y + 0.5) * 0.05)) return;
      grid.count[c] = 200;
      grid.height[c] = 0.011 + 0.004 * (x + 0.5) * 0.05 + 0.01 / std::sqrt(200) * random.normal();
    });
    StepFaceFinder finder(grid, 0.01);
    std::array<double, kHangings.size()> best{};
    int faces = 0;
    for (auto face = finder.next(); face && faces < 10; face = finder.next(), ++faces) {
      for (std::size_t h = 0; h < kHangings.size(); ++h) {
        double both = 0, either = 0;
        grid.for_each_cell([&](int x, int y, std::size_t c) {
          const bool held = kHangings[h].holds((x + 0.5) * 0.05, (y + 0.5) * 0.05);
          both += held && face->cells[c], either += held || face->cells[c];
        });
        best[h] = std::max(best[h], both / either);
      }
    }
    EXPECT_EQ(faces, 4) << "seed " << seed;
    for (std::size_t h = 0; h < kHangings.size(); ++h) EXPECT_GT(best[h], 0.85) << "seed " << seed << ", " << h;
  }
}

TEST(StepFaces, TakeEmptyAndTinyGrids) {
  EXPECT_FALSE(StepFaceFinder(grid_of(1, 1, 0.05, 0), 0.01).next());
  EXPECT_FALSE(StepFaceFinder(grid_of(1, 1, 0.05, 9), 0.01).next());
  EXPECT_FALSE(StepFaceFinder(grid_of(3, 1, 0.05, 9), 0.01).next());
  EXPECT_FALSE(StepFaceFinder(grid_of(40, 40, 0.05, 9), 0.0).next()) << "exact";
}

/// A floor and a wall along x with a door leaf `recess` behind it, as a sensor in the room sees them.
Scene room_with_door(double recess, double noise, double bend, Random& random) {
  Scene scene;
  scene.cloud.sensors = SensorPositions(Eigen::Vector3d(2, 2, 1.4));
  scene.add_rectangle({0, 0, 0}, {4, 0, 0}, {0, 3, 0}, 2500, noise, 0, random);
  for (int i = 0; i < 30'000; ++i) {
    const double u = random.uniform(0, 4), v = random.uniform(0, 2.4);
    const bool door = in_door(u, v);
    scene.add({u, (door ? -recess : 0) + bend * std::sin(u) + noise * random.normal(), v}, door ? 2 : 1);
  }
  return scene;
}

/// Intersection over union of plane `truth` with the plane that fits it best.
double best_iou(const Scene& scene, const std::vector<int>& plane_of_point, int truth) {
  std::vector<double> both(1000, 0.0), own(1000, 0.0);
  double of_truth = 0;
  for (std::size_t i = 0; i < scene.truth.size(); ++i) {
    of_truth += scene.truth[i] == truth;
    if (plane_of_point[i] < 0) continue;
    own[static_cast<std::size_t>(plane_of_point[i])] += 1;
    both[static_cast<std::size_t>(plane_of_point[i])] += scene.truth[i] == truth;
  }
  double best = 0;
  for (std::size_t p = 0; p < both.size(); ++p) best = std::max(best, both[p] / (own[p] + of_truth - both[p]));
  return best;
}

TEST(FlushFaces, SegmentationPartsADoorLeafFromItsWall) {
  Random random(4);
  const Scene scene = room_with_door(0.006, 0.01, 0, random);
  const auto found = segment(scene.cloud);
  EXPECT_GT(best_iou(scene, found.plane_of_point, 1), 0.9);
  EXPECT_GT(best_iou(scene, found.plane_of_point, 2), 0.8);
}

TEST(FlushFaces, SegmentationPartsAStepOfTheFloor) {
  for (const double noise : {0.0, 0.004}) {
    Random random(6);
    Scene scene;
    for (int i = 0; i < 40'000; ++i) {
      const double u = random.uniform(0, 4), v = random.uniform(0, 3);
      scene.add({u, v, (u > 2.8 ? 0.004 : 0) + noise * random.normal()}, u > 2.8 ? 1 : 0);
    }
    const auto found = segment(scene.cloud);
    EXPECT_GT(best_iou(scene, found.plane_of_point, 0), 0.9) << noise;
    EXPECT_GT(best_iou(scene, found.plane_of_point, 1), 0.8) << noise;
  }
}

TEST(FlushFaces, SegmentationLeavesABentWallWhole) {
  Random random(5);
  Scene scene = room_with_door(0, 0.01, 0.008, random);
  for (int& t : scene.truth) t = std::min(t, 1);
  const auto found = segment(scene.cloud);
  EXPECT_GT(best_iou(scene, found.plane_of_point, 1), 0.9);
}

}  // namespace
}  // namespace scenelore::perception
