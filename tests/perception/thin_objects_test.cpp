// Parts of the thin-object pass on made-up supports: the outline cut and the flat things of a height map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "height_map.hpp"
#include "outline_cut.hpp"
#include "planar_scenes.hpp"
#include "thin_objects.hpp"

namespace scenelore::perception {
namespace {

/// Centres of the cells of a rectangle, turned by `angle` about its corner.
std::vector<Eigen::Vector2d> rectangle(double length, double width, Eigen::Vector2d corner, double angle, double edge) {
  std::vector<Eigen::Vector2d> places;
  const Eigen::Vector2d u(std::cos(angle), std::sin(angle)), v(-u.y(), u.x());
  for (double x = edge / 2; x < length; x += edge) {
    for (double y = edge / 2; y < width; y += edge) places.push_back(corner + x * u + y * v);
  }
  return places;
}

TEST(OutlineCut, LeavesARectangleWholeAtEveryAngle) {
  for (double angle = 0; angle < 1.6; angle += 0.1) {
    EXPECT_EQ(cut_outline(rectangle(0.45, 0.16, {0, 0}, angle, 0.02), 0.02).size(), 1u) << "at " << angle;
  }
}

TEST(OutlineCut, PartsTwoRectanglesThatTouchAtACorner) {
  for (double angle = 0; angle < 1.6; angle += 0.2) {
    const Eigen::Vector2d u(std::cos(angle), std::sin(angle)), v(-u.y(), u.x());
    std::vector<Eigen::Vector2d> places = rectangle(0.45, 0.16, {0, 0}, angle, 0.02);
    const std::size_t first = places.size();
    const auto second = rectangle(0.24, 0.18, 0.30 * u + 0.16 * v, angle, 0.02);
    places.insert(places.end(), second.begin(), second.end());
    const auto parts = cut_outline(places, 0.02);
    ASSERT_EQ(parts.size(), 2u) << "at " << angle;
    std::size_t of_first = 0;  // in the part that holds cell 0
    const auto& part = std::find(parts[0].begin(), parts[0].end(), 0u) != parts[0].end() ? parts[0] : parts[1];
    for (const std::size_t cell : part) of_first += cell < first;
    EXPECT_GE(of_first, first * 9 / 10) << "at " << angle;
    EXPECT_LE(part.size() - of_first, second.size() / 10) << "at " << angle;
  }
}

TEST(OutlineCut, ReturnsEveryCellOnce) {
  std::vector<Eigen::Vector2d> places = rectangle(0.3, 0.1, {0, 0}, 0.3, 0.02);
  const auto other = rectangle(0.3, 0.1, {0.05, 0.2}, 1.2, 0.02);
  places.insert(places.end(), other.begin(), other.end());
  std::vector<std::size_t> all;
  for (const auto& part : cut_outline(places, 0.02)) all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  std::vector<std::size_t> expected(places.size());
  std::iota(expected.begin(), expected.end(), std::size_t{0});
  EXPECT_EQ(all, expected);
}

TEST(OutlineCut, TakesNothingAndOneCell) {
  EXPECT_EQ(cut_outline({{0, 0}}, 0.02).size(), 1u);
  EXPECT_LE(cut_outline({}, 0.02).size(), 1u);
}

/// A desk of 1.2 m x 0.7 m with points 7 mm apart; `height` says what lies where.
template <typename Height>
std::vector<Sample> desk(Height height, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> scatter(0, noise);
  std::vector<Sample> samples;
  for (double x = 0; x < 1.2; x += 0.007) {
    for (double y = 0; y < 0.7; y += 0.007) {
      samples.push_back({static_cast<std::uint32_t>(samples.size()), {static_cast<float>(x), static_cast<float>(y)}, static_cast<float>(height(x, y) + scatter(random))});
    }
  }
  return samples;
}

TEST(FlatThings, FindsNothingOnABareDesk) {
  const auto samples = desk([](double, double) { return 0.0; }, 0.004, 1);
  const HeightMap map = make_height_map(samples, fitting_edge(samples), 0.004);
  EXPECT_TRUE(flat_things(map, 0.004, 20).empty());
}

TEST(FlatThings, FollowsASlopingKeyboardWholeAndPartsItFromABookBeside) {
  const double slope = std::tan(5 * M_PI / 180);
  const auto in = [](double v, double low, double high) { return v > low && v < high; };
  const auto samples = desk(
      [&](double x, double y) {
        if (in(x, 0.3, 0.75) && in(y, 0.1, 0.26)) return 0.014 + slope * (y - 0.1);
        if (in(x, 0.76, 0.97) && in(y, 0.1, 0.25)) return 0.035;
        return 0.0;
      },
      0.004, 2);
  const HeightMap map = make_height_map(samples, fitting_edge(samples), 0.004);
  const auto things = flat_things(map, 0.004, 100);
  ASSERT_GE(things.size(), 2u);
  const auto covers = [&](const FlatThing& thing, double x0, double x1, double y0, double y1) {
    std::size_t inside = 0;
    for (const std::size_t c : thing.cells) inside += in(map.cell[c].at.x(), x0, x1) && in(map.cell[c].at.y(), y0, y1);
    return static_cast<double>(inside) * map.edge * map.edge / ((x1 - x0) * (y1 - y0));
  };
  EXPECT_GT(covers(things[0], 0.3, 0.75, 0.1, 0.26), 0.8);
  EXPECT_LT(covers(things[0], 0.76, 0.97, 0.1, 0.25), 0.15);
  EXPECT_GT(covers(things[1], 0.76, 0.97, 0.1, 0.25), 0.7);
  EXPECT_NEAR(things[0].slope.y(), slope, 0.02);
  EXPECT_NEAR(things[1].level, 0.035, 0.003);
}

TEST(FlatThings, WidensItsCellsWherePointsAreFew) {
  const auto dense = desk([](double, double) { return 0.0; }, 0.004, 3);
  std::vector<Sample> sparse;
  for (std::size_t k = 0; k < dense.size(); k += 20) sparse.push_back(dense[k]);
  EXPECT_LT(fitting_edge(dense), 0.02);
  EXPECT_GT(fitting_edge(sparse), 1.8 * fitting_edge(dense));
  EXPECT_LE(fitting_edge({}), 0.04);
}

/// Regions that come from a board of a square metre and a half two centimetres before a wall that scatters less, each a region already.
TEST(ThinObjects, LeaveABoardOnItsWallInOnePiece) {
  testing::Scene scene;
  testing::Random random(4);
  using V = Eigen::Vector3d;
  scene.cloud.sensors = SensorPositions(V(2, -2, 1.2));
  scene.add_rectangle(V(0, 0, 0), V(4, 0, 0), V(0, 0, 2.5), 6000, 0.005, 0, random);
  scene.add_rectangle(V(1, -0.02, 0.8), V(1.5, 0, 0), V(0, 0, 1), 6000, 0.009, 1, random);
  Regions regions;
  regions.of_point.assign(scene.truth.begin(), scene.truth.end());
  regions.planes.resize(2);
  refit(scene.cloud, regions);
  const Limits limits{.max_point_distance = 1.6, .max_plane_distance = 0.03, .max_mse = 1e-4, .min_points = 20, .max_neighbours = 30, .small_plane_step = 0.3};
  split_thin_objects(scene.cloud, {}, limits, regions);
  std::size_t kept = 0, board = 0;
  for (std::size_t i = 0; i < scene.truth.size(); ++i) {
    if (scene.truth[i] != 1) continue;
    ++board;
    kept += regions.of_point[i] == 1;
  }
  EXPECT_GT(kept, 99 * board / 100);
}

}  // namespace
}  // namespace scenelore::perception
