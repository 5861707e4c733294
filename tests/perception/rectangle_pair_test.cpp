// Desks side by side are told apart by what the sensor saw past them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "part_outlines.hpp"
#include "planar_scenes.hpp"
#include "rectangle_pair.hpp"
#include "scenelore/perception/perceive.hpp"

namespace scenelore::perception {
namespace {

using testing::Random;
using testing::Scene;

constexpr double kEdge = 0.05;

struct Rectangle {
  Eigen::Vector2d low, high;
  [[nodiscard]] bool holds(const Eigen::Vector2d& p) const { return (p.array() > low.array()).all() && (p.array() < high.array()).all(); }
};

// A desk and the return that makes an L of it; the notch lies beside the return.
const Rectangle kDesk{{0, 0}, {1.6, 0.8}}, kReturn{{0, 0.8}, {0.5, 1.8}}, kNotch{{0.5, 0.8}, {1.6, 1.8}};

/// The cells of a view whose middles, turned by `angle`, are held or empty.
template <typename Held, typename Empty>
PlaneView make_view(double angle, Held held, Empty empty) {
  PlaneView view;
  view.edge = kEdge;
  const Eigen::Rotation2Dd turn(angle);
  for (int x = -40; x < 60; ++x) {
    for (int y = -40; y < 60; ++y) {
      const Eigen::Vector2d p = (Eigen::Vector2d(x, y).array() + 0.5) * kEdge, q = turn.inverse() * p;
      if (held(q)) {
        view.held.push_back(p);
      } else if (empty(q)) {
        view.empty.push_back(p);
      }
    }
  }
  view.points.assign(view.held.size(), 5);
  return view;
}

bool on_desks(const Eigen::Vector2d& p) { return kDesk.holds(p) || kReturn.holds(p); }
bool nowhere(const Eigen::Vector2d&) { return false; }

TEST(RectanglePair, PartsAnLWhoseNotchWasLookedThrough) {
  for (double angle = 0; angle < 1.6; angle += 0.23) {
    const PlaneView view = make_view(angle, on_desks, [](const Eigen::Vector2d& p) { return !on_desks(p); });
    const auto parts = part_into_rectangles(view);
    ASSERT_EQ(parts.size(), 2u) << "at " << angle;
    const Eigen::Rotation2Dd back(-angle);
    for (const auto& part : parts) {
      const auto of_desk = static_cast<std::size_t>(std::count_if(part.begin(), part.end(), [&](std::size_t c) { return kDesk.holds(back * view.held[c]); }));
      EXPECT_GT(std::max(of_desk, part.size() - of_desk), part.size() * 93 / 100) << "at " << angle;
    }
  }
}

TEST(RectanglePair, LeavesAnLWholeWhoseNotchIsInShadow) {
  EXPECT_EQ(part_into_rectangles(make_view(0.4, on_desks, nowhere)).size(), 1u);
  const auto beyond = [](const Eigen::Vector2d& p) { return !on_desks(p) && !kNotch.holds(p); };
  EXPECT_EQ(part_into_rectangles(make_view(0.4, on_desks, beyond)).size(), 1u);
}

TEST(RectanglePair, LeavesARoundTableWhole) {
  const auto on_table = [](const Eigen::Vector2d& p) { return p.norm() < 0.7; };
  EXPECT_EQ(part_into_rectangles(make_view(0, on_table, [](const Eigen::Vector2d& p) { return p.norm() > 0.7; })).size(), 1u);
}

TEST(RectanglePair, PartsThreeDesksThatStandStaggered) {
  const Rectangle first{{-1.2, -0.5}, {0, 0.2}}, second{{0, 0}, {1.2, 0.7}}, third{{1.2, 0.5}, {2.4, 1.2}};
  const auto held = [&](const Eigen::Vector2d& p) { return first.holds(p) || second.holds(p) || third.holds(p); };
  const PlaneView view = make_view(0.1, held, [&](const Eigen::Vector2d& p) { return !held(p); });
  const auto parts = part_into_rectangles(view);
  EXPECT_EQ(parts.size(), 3u);
  std::vector<std::size_t> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  std::vector<std::size_t> expected(view.held.size());
  std::iota(expected.begin(), expected.end(), std::size_t{0});
  EXPECT_EQ(all, expected);
}

TEST(RectanglePair, TakesNothingAndOneCell) {
  PlaneView view;
  view.edge = kEdge;
  EXPECT_LE(part_into_rectangles(view).size(), 1u);
  view.held = {{0.1, 0.1}};
  view.empty = {{0.2, 0.1}};
  EXPECT_EQ(part_into_rectangles(view).size(), 1u);
  EXPECT_FALSE(best_rectangle_pair(view, {0}).has_value());
}

/// The desks at a height of 0.74 m and the floor, as a sensor at `eye` sees them: it does not see through the desks nor
/// through the screen that stands on them.
Scene seen_desks(const Eigen::Vector3d& eye, double noise, std::uint64_t seed) {
  constexpr double kHeight = 0.74;
  Random random(seed);
  Scene scene;
  const auto crossing = [&](const Eigen::Vector3d& p, double z) -> Eigen::Vector3d { return eye + (eye.z() - z) / (eye.z() - p.z()) * (p - eye); };
  const auto before_screen = [&](const Eigen::Vector3d& p) {  // an upright square at y = 0.5 over the desk
    if ((p.y() - 0.5) * (eye.y() - 0.5) > 0) return true;
    const Eigen::Vector3d at = eye + (eye.y() - 0.5) / (eye.y() - p.y()) * (p - eye);
    return at.z() < kHeight || at.z() > 1.2 || at.x() < 1 || at.x() > 1.4;
  };
  for (int i = 0; i < 90'000; ++i) {
    const Eigen::Vector3d floor(random.uniform(-2, 5), random.uniform(-1, 6), 0), top(random.uniform(0, 1.6), random.uniform(0, 1.8), kHeight);
    if (!on_desks(crossing(floor, kHeight).head<2>()) && before_screen(floor)) scene.add(floor + noise * random.normal() * Eigen::Vector3d::UnitZ(), 0);
    if (i % 5 == 0 && on_desks(top.head<2>()) && before_screen(top)) {
      scene.add(top + noise * random.normal() * Eigen::Vector3d::UnitZ(), kDesk.holds(top.head<2>()) ? 1 : 2);
    }
  }
  scene.cloud.sensors = SensorPositions(eye);
  return scene;
}

struct Tops {
  std::vector<std::uint32_t> points;
  PlaneFit plane;
  PlaneView view;
};

/// The points on desks as one plane, and its cells.
Tops tops_of(const Scene& scene) {
  std::vector<std::uint32_t> points;
  Moments moments;
  for (std::uint32_t i = 0; i < scene.cloud.size(); ++i) {
    if (scene.truth[i] > 0) points.push_back(i), moments.add(scene.cloud.offset(i).cast<double>());
  }
  const PlaneFit plane = fit_plane(moments);
  return {points, plane, view_of(scene.cloud, plane, points, kEdge)};
}

TEST(LookPast, KnowsTheNotchButNotWhatAScreenHides) {
  const Eigen::Vector3d eye(0.8, -1.5, 1.5);
  const Scene scene = seen_desks(eye, 0, 3);
  auto [points, plane, view] = tops_of(scene);
  EXPECT_EQ(std::accumulate(view.points.begin(), view.points.end(), std::size_t{0}), points.size());
  EXPECT_TRUE(view.empty.empty());
  look_past(scene.cloud, plane, kEdge, view);
  // Behind the screen, as seen from the eye, at the height of the desks.
  const auto hidden = [&](const Eigen::Vector2d& p) {
    const double share = (0.5 - eye.y()) / (p.y() - eye.y()), x = eye.x() + share * (p.x() - eye.x());
    return p.y() > 0.5 && x > 1 && x < 1.4;
  };
  double seen = 0, wanted = 0;
  for (const Eigen::Vector2d& e : view.empty) {
    const Eigen::Vector2d p = (plane.centroid + e.x() * plane.axes.col(1) + e.y() * plane.axes.col(2)).head<2>();
    const bool inside = kNotch.holds(p) && !hidden(p);
    seen += inside;
    if (inside) continue;
    // What else was looked through lies outside the desks, but for cells at an edge.
    const auto near = [&](const Rectangle& r) { return Rectangle{r.low.array() + kEdge, r.high.array() - kEdge}.holds(p); };
    EXPECT_FALSE(near(kDesk) || near(kReturn)) << p.transpose();
  }
  for (double x = 0.5; x < 1.6; x += kEdge) {
    for (double y = 0.8; y < 1.8; y += kEdge) wanted += !hidden(Eigen::Vector2d(x, y));
  }
  EXPECT_GT(seen, 0.75 * wanted);  // cells at the edges are of both kinds
  EXPECT_LT(seen, 1.1 * wanted);
}

TEST(LookPast, SeesNothingPastAPlaneItLiesIn) {
  Scene scene = seen_desks({0.8, -1.5, 1.5}, 0, 3);
  auto [points, plane, view] = tops_of(scene);
  scene.cloud.sensors = SensorPositions(Eigen::Vector3d(-2, 0, 0.75));
  look_past(scene.cloud, plane, kEdge, view);
  EXPECT_TRUE(view.empty.empty());
}

/// Three desks that touch in a U of 4.4 x 2.2 m, more than 4 m² as points spread; `eye` sees the floor through its notch.
struct DesksInAU {
  explicit DesksInAU(const Eigen::Vector3d& eye) {
    Random random(4);
    const auto desk_of = [&](const Eigen::Vector2d& p) {
      const auto of = std::find_if(desks.begin(), desks.end(), [&](const Rectangle& desk) { return desk.holds(p); });
      return of == desks.end() ? -1 : static_cast<int>(of - desks.begin());
    };
    for (int i = 0; i < 60'000; ++i) {
      const Eigen::Vector3d floor(random.uniform(-1.5, 4.7), random.uniform(-2, 3), 0);
      const Eigen::Vector2d crossed = (eye + (eye.z() - 0.74) / eye.z() * (floor - eye)).head<2>(), top(random.uniform(-0.6, 3.8), random.uniform(0, 2.2));
      if (desk_of(crossed) < 0) add(floor, -1);
      if (i % 4 == 0 && desk_of(top) >= 0) add({top.x(), top.y(), 0.74 + 0.005 * random.normal()}, desk_of(top));
    }
    cloud.sensors = SensorPositions(eye);
    for (const int desk : truth) regions.of_point.push_back(desk < 0 ? -1 : 0);
    regions.planes.resize(1);
    refit(cloud, regions);
  }

  void add(const Eigen::Vector3d& p, int desk) {
    cloud.x.push_back(static_cast<float>(p.x())), cloud.y.push_back(static_cast<float>(p.y())), cloud.z.push_back(static_cast<float>(p.z()));
    truth.push_back(desk);
  }
  /// The region with most points of a desk, and what share of them it has.
  [[nodiscard]] std::pair<std::int32_t, double> mostly(int desk) const {
    std::vector<int> held(regions.planes.size(), 0);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (truth[i] == desk) ++held[static_cast<std::size_t>(regions.of_point[i])];
    }
    const auto most = std::max_element(held.begin(), held.end());
    return {static_cast<std::int32_t>(most - held.begin()), *most / static_cast<double>(std::accumulate(held.begin(), held.end(), 0))};
  }

  std::vector<Rectangle> desks{{{-0.6, 0}, {3.8, 0.8}}, {{0, 0.8}, {0.8, 2.2}}, {{2.4, 0.8}, {3.2, 2.2}}};
  Cloud cloud;
  std::vector<int> truth;
  Regions regions;
};

TEST(PartOutlines, TellsDesksApartThatTouchInAUAcrossARoom) {
  DesksInAU scene({1.6, 3.5, 1.7});
  ASSERT_GT(scene.regions.planes[0].spread_area(), 4) << "as large as small floors";
  part_outlines(scene.cloud, Eigen::Vector3d::UnitZ(), scene.regions);
  std::vector<std::int32_t> regions;
  for (int desk = 0; desk < 3; ++desk) {
    const auto [region, share] = scene.mostly(desk);
    EXPECT_GT(share, desk == 0 ? 0.55 : 0.95) << "desk " << desk << "; cuts go straight through, and the first may go on through the long one";
    regions.push_back(region);
  }
  std::sort(regions.begin(), regions.end());
  EXPECT_EQ(std::unique(regions.begin(), regions.end()), regions.end());
}

TEST(PartOutlines, LeavesALargeLevelPlaneWholeThatNobodySawPast) {
  DesksInAU scene({1.6, 3.5, 1.7});
  scene.cloud.sensors = {};
  part_outlines(scene.cloud, Eigen::Vector3d::UnitZ(), scene.regions);
  EXPECT_EQ(scene.regions.planes.size(), 1U);
}

TEST(Segment, TellsTwoDesksOfOneHeightApartByWhatLiesBehindThem) {
  const Scene scene = seen_desks({0.8, -1.5, 1.5}, 0.008, 8);
  const Perception found = perceive(scene.cloud);
  std::array<std::vector<int>, 3> held;
  for (auto& counts : held) counts.assign(found.planes.size(), 0);
  for (std::size_t i = 0; i < scene.truth.size(); ++i) {
    if (found.plane_of_point[i] >= 0) ++held[static_cast<std::size_t>(scene.truth[i])][static_cast<std::size_t>(found.plane_of_point[i])];
  }
  const auto most = [](const std::vector<int>& counts) { return std::max_element(counts.begin(), counts.end()) - counts.begin(); };
  EXPECT_NE(most(held[1]), most(held[2]));
  for (const int desk : {1, 2}) {
    const auto& counts = held[static_cast<std::size_t>(desk)];
    EXPECT_GT(*std::max_element(counts.begin(), counts.end()), 0.9 * static_cast<double>(std::count(scene.truth.begin(), scene.truth.end(), desk)));
  }
}

}  // namespace
}  // namespace scenelore::perception
