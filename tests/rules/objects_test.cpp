// Grouping planes to things, against all groupings there are.
#include "scenelore/rules/objects.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <random>

#include "scenelore/rules/labelling.hpp"

namespace scenelore::rules {
namespace {

kb::Knowledge chairs(int most = 1, int fewest = 0) {
  kb::Knowledge out;
  out.classes = {{.id = 0, .name = "unknown", .fallback = true}, {.id = 1, .name = "seat"}, {.id = 2, .name = "back"}};
  out.composites = {{"chair", {{.part = "seat", .object_class = "seat"},
                               {.part = "back", .object_class = "back", .relation = "near", .fewest = fewest, .most = most}}}};
  return out;
}

/// Seats first, then backs; ids 1, 2, ….
struct World {
  Scene scene;
  std::vector<kb::Label> labels;
  std::vector<kb::RelationFact> facts;
};

World world(int seats, int backs) {
  World out;
  for (int p = 0; p < seats + backs; ++p) {
    out.scene.ids.push_back(p + 1);
    out.scene.planes.emplace_back();
    out.labels.push_back({.plane = p + 1, .object_class = p < seats ? "seat" : "back"});
  }
  return out;
}

double degree_of(const World& w, kb::PlaneId a, kb::PlaneId b) {
  for (const kb::RelationFact& fact : w.facts) {
    if (fact.a == a && fact.b == b) return fact.degree;
  }
  return 0;
}

double total(const World& w, const std::vector<kb::Object>& objects) {
  double sum = 0;
  for (const kb::Object& object : objects) {
    for (std::size_t i = 1; i < object.planes.size(); ++i) sum += degree_of(w, object.planes[i].first, object.planes[0].first);
  }
  return sum;
}

/// Highest total of all assignments of backs to seats.
double best_total(const World& w, int seats, int backs, int most) {
  std::vector<int> used(static_cast<std::size_t>(seats), 0);
  const std::function<double(int)> rest = [&](int back) -> double {
    if (back == backs) return 0;
    double best = rest(back + 1);
    for (int s = 0; s < seats; ++s) {
      const double d = degree_of(w, seats + back + 1, s + 1);
      if (d < 0.5 || used[static_cast<std::size_t>(s)] >= most) continue;
      ++used[static_cast<std::size_t>(s)];
      best = std::max(best, d + rest(back + 1));
      --used[static_cast<std::size_t>(s)];
    }
    return best;
  };
  return rest(0);
}

TEST(GroupObjects, FindsTheBestGroupingOfRandomWorlds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform;
  for (int round = 0; round < 300; ++round) {
    const int seats = 1 + round % 4, backs = round % 6, most = 1 + round % 2;
    World w = world(seats, backs);
    for (int b = 0; b < backs; ++b) {
      for (int s = 0; s < seats; ++s) {
        if (uniform(random) < 0.6) w.facts.push_back({"near", seats + b + 1, s + 1, uniform(random)});
      }
    }
    const auto objects = group_objects(chairs(most), w.scene, w.labels, w.facts);
    EXPECT_EQ(objects.size(), static_cast<std::size_t>(seats));
    EXPECT_NEAR(total(w, objects), best_total(w, seats, backs, most), 1e-9) << "round " << round;
    std::map<kb::PlaneId, int> times;
    for (const kb::Object& object : objects) {
      EXPECT_LE(object.planes.size(), static_cast<std::size_t>(1 + most));
      for (const auto& [plane, part] : object.planes) EXPECT_EQ(++times[plane], 1);
    }
  }
}

TEST(GroupObjects, LeavesOutWhatLacksANeededPart) {
  World w = world(2, 1);
  w.facts = {{"near", 3, 2, 1}};
  const auto objects = group_objects(chairs(1, 1), w.scene, w.labels, w.facts);
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0].planes[0], std::pair(kb::PlaneId{2}, std::string("seat")));
  EXPECT_EQ(objects[0].planes[1], std::pair(kb::PlaneId{3}, std::string("back")));
  EXPECT_EQ(group_objects(chairs(), w.scene, w.labels, w.facts).size(), 2u);
}

TEST(GroupObjects, JoinsFacesOfOneClassThatTouch) {
  kb::Knowledge knowledge;
  knowledge.classes = {{.id = 0, .name = "unknown", .fallback = true}, {.id = 1, .name = "cabinet"}};
  knowledge.composites = {{"cabinet", {{.part = "front", .object_class = "cabinet", .orientation = kb::Orientation::upright},
                                       {.part = "side", .object_class = "cabinet", .relation = "touching", .orientation = kb::Orientation::upright, .most = 2},
                                       {.part = "top", .object_class = "cabinet", .relation = "touching", .orientation = kb::Orientation::level}}}};
  World w;
  const std::vector<std::pair<double, double>> planes{{90, 0.8}, {90, 1.6}, {0, 0.5}, {90, 1.0}};  // tilt, area: side, front, top; another
  for (const auto& [tilt, area] : planes) {
    w.scene.ids.push_back(static_cast<kb::PlaneId>(w.scene.ids.size()) + 1);
    w.scene.planes.emplace_back();
    w.scene.planes.back().tilt_deg = tilt, w.scene.planes.back().area_m2 = area;
    w.labels.push_back({.plane = w.scene.ids.back(), .object_class = "cabinet"});
  }
  w.facts = {{"touching", 1, 2, 1}, {"touching", 2, 1, 1}, {"touching", 1, 3, 0.9}};
  const auto objects = group_objects(knowledge, w.scene, w.labels, w.facts);
  ASSERT_EQ(objects.size(), 2u);
  const std::vector<std::pair<kb::PlaneId, std::string>> first{{2, "front"}, {1, "side"}, {3, "top"}};
  EXPECT_EQ(objects[0].planes, first);
  EXPECT_EQ(objects[1].planes.size(), 1u);
  EXPECT_EQ(objects[1].number, 2);
}

/// A plane that might be a back or nothing: whether there is a seat near decides, inside the one optimum.
TEST(Composites, DecideLabelsInsideTheSameOptimum) {
  const double weight = 2;
  kb::Knowledge knowledge = chairs();
  knowledge.constraints = {{.id = -1'000'000, .name = "chair.back", .object_class = "back", .quantifier = kb::Quantifier::some, .relation = "near",
                            .other_class = "seat", .weight = weight}};
  World w = world(1, 2);
  w.facts = {{"near", 2, 1, 1}, {"near", 1, 2, 1}};
  const std::vector<std::vector<double>> evidence{{0.3, 0.6, 0.1}, {0.45, 0.05, 0.5}, {0.45, 0.05, 0.5}};
  const Facts facts{.facts = w.facts, .reach = {{"near", {.within = 1}}}};
  const kb::Inference answer = label(knowledge, w.scene, evidence, facts, {}, {.alternatives = 0});

  double best = 1e9;  // all 27 worlds
  std::vector<int> least;
  for (int i = 0; i < 27; ++i) {
    const std::vector<int> c{i % 3, i / 3 % 3, i / 9};
    double cost = 0;
    for (std::size_t p = 0; p < 3; ++p) {
      cost -= std::log(evidence[p][static_cast<std::size_t>(c[p])]);
      if (c[p] != 2) continue;
      bool held = false;
      for (std::size_t q = 0; q < 3; ++q) held = held || (c[q] == 1 && degree_of(w, static_cast<kb::PlaneId>(p) + 1, static_cast<kb::PlaneId>(q) + 1) > 0);
      if (!held) cost += weight;
    }
    if (cost < best) best = cost, least = c;
  }
  ASSERT_EQ(answer.labels.size(), 3u);
  EXPECT_NEAR(answer.run.cost, best, 1e-6);
  for (std::size_t p = 0; p < 3; ++p) EXPECT_EQ(answer.labels[p].object_class, knowledge.classes[static_cast<std::size_t>(least[p])].name);
  EXPECT_EQ(answer.labels[1].object_class, "back");
  EXPECT_EQ(answer.labels[2].object_class, "unknown");
  ASSERT_EQ(answer.objects.size(), 1u);
  EXPECT_EQ(answer.objects[0].planes.size(), 2u);
}

}  // namespace
}  // namespace scenelore::rules
