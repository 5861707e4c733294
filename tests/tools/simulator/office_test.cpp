// Rooms are what their inventory says, and things are where people put them.
#include "simulator/office.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>

#include "simulator/bvh.hpp"

namespace scenelore::simulator {
namespace {

std::vector<Object> of_class(const Office& office, ObjectClass wanted) {
  std::vector<Object> found;
  for (const Object& object : office.scene.objects()) {
    if (object.object_class == wanted) found.push_back(object);
  }
  return found;
}

bool over(const Desk& desk, const Vector3d& point, double margin) {
  const Vector3d local = desk.frame.inverse() * point;
  return std::abs(local.x()) < desk.width / 2 + margin && std::abs(local.y()) < desk.depth / 2 + margin;
}

TEST(Office, HoldsExactlyTheInventoryAskedFor) {
  const Inventory wanted[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {1, 2, 1}, {2, 1, 0},
                              {3, 3, 2}, {4, 5, 4}, {2, 0, 1}, {8, 6, 6}};
  std::uint64_t seed = 100;
  for (const Inventory& inventory : wanted) {
    const Office office = make_office(++seed, inventory);
    EXPECT_EQ(of_class(office, ObjectClass::table).size(), inventory.tables);
    EXPECT_EQ(of_class(office, ObjectClass::flat_screen).size(), inventory.screens);
    EXPECT_EQ(of_class(office, ObjectClass::keyboard).size(), inventory.keyboards);
  }
}

TEST(Office, RefusesInventoriesNoRoomHolds) {
  EXPECT_THROW((void)make_office(1, {-1, 0, 0}), std::invalid_argument);
  EXPECT_THROW((void)make_office(1, {41, 0, 0}), std::invalid_argument);
  EXPECT_THROW((void)make_office(1, {1, 3, 0}), std::invalid_argument);
  EXPECT_THROW((void)make_office(1, {1, 1, 3}), std::invalid_argument);
}

TEST(Office, ScreensAndKeyboardsStandOnTables) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const Office office = make_office(seed, draw_inventory(seed));
    for (const Object& keyboard : of_class(office, ObjectClass::keyboard)) {
      bool on_a_table = false;
      for (const Desk& desk : office.desks) {
        const double above = keyboard.centroid.z() - desk.height;
        on_a_table = on_a_table || (over(desk, keyboard.centroid, 0) && above > 0.01 && above < 0.05);
      }
      EXPECT_TRUE(on_a_table) << keyboard.thing << " of seed " << seed;
      EXPECT_GT(keyboard.normal.z(), 0.99);
    }
    for (const Object& screen : of_class(office, ObjectClass::flat_screen)) {
      bool on_a_table = false;
      for (const Desk& desk : office.desks) {
        const double above = screen.centroid.z() - desk.height;
        if (!over(desk, screen.centroid, 0.1) || above < 0.1 || above > 0.6) continue;
        on_a_table = true;
        EXPECT_GT(screen.normal.dot(desk.frame.linear().col(1)), 0.5) << "faces the user; seed " << seed;
      }
      EXPECT_TRUE(on_a_table) << screen.thing << " of seed " << seed;
      EXPECT_LT(std::abs(screen.normal.z()), 0.25);
    }
  }
}

TEST(Office, HeightsAreThoseOfFurniture) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const Office office = make_office(seed, draw_inventory(seed));
    for (const Object& object : office.scene.objects()) {
      const double z = object.centroid.z();
      switch (object.object_class) {
        case ObjectClass::table:
          EXPECT_GE(z, 0.65);
          EXPECT_LE(z, 0.79);
          break;
        case ObjectClass::chair_seat:
          EXPECT_GE(z, 0.41);
          EXPECT_LE(z, 0.53);
          break;
        case ObjectClass::chair_back:
          EXPECT_GT(z, 0.55);
          break;
        case ObjectClass::ceiling:
          EXPECT_GT(z, 2.4);
          break;
        case ObjectClass::floor:
          EXPECT_EQ(z, 0);
          break;
        default:
          break;
      }
    }
  }
}

// Points inside the thin solid of a table top must not lie inside another thing: here, no edge of a top is pierced by
// a face of another desk, cabinet, shelf or wall.
TEST(Office, NothingPassesThroughTableTops) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const Office office = make_office(seed, draw_inventory(seed));
    for (const Desk& desk : office.desks) {
      std::vector<Shape> others;
      for (const Shape& shape : office.scene.shapes()) {
        const std::string& thing = office.scene.objects()[static_cast<std::size_t>(shape.surface)].thing;
        if (thing.rfind(desk.name, 0) != 0) others.push_back(shape);
      }
      const Bvh tree(others);
      const double half = desk.width / 2 - 0.01;
      for (double y = -desk.depth / 2 + 0.01; y < desk.depth / 2; y += 0.02) {
        const Ray ray{desk.frame * Vector3d(-half, y, desk.height - 0.015), desk.frame.linear().col(0)};
        const Hit hit = tree.cast(ray, 0, 2 * half);
        ASSERT_EQ(hit.shape, nullptr) << desk.name << " is pierced by "
                                      << office.scene.objects()[static_cast<std::size_t>(hit.shape->surface)].thing
                                      << ", seed " << seed;
      }
    }
  }
}

TEST(Office, EveryClassOccursAndNoSeedLooksLikeAnother) {
  std::map<ObjectClass, int> rooms_with;
  std::set<std::pair<double, double>> sizes;
  constexpr int rooms = 40;
  for (std::uint64_t seed = 1; seed <= rooms; ++seed) {
    const Office office = make_office(seed, draw_inventory(seed));
    sizes.emplace(office.width, office.depth);
    std::set<ObjectClass> here;
    for (const Object& object : office.scene.objects()) here.insert(object.object_class);
    for (const ObjectClass c : here) ++rooms_with[c];
  }
  EXPECT_EQ(sizes.size(), rooms);
  for (int c = 0; c <= static_cast<int>(ObjectClass::cabinet); ++c) {
    EXPECT_GE(rooms_with[static_cast<ObjectClass>(c)], rooms / 3) << name_of(static_cast<ObjectClass>(c));
  }
  EXPECT_LT(rooms_with[ObjectClass::whiteboard], rooms) << "not every room has a whiteboard";
}

TEST(Office, VariedOnesHaveSizesThatUsualOnesHaveNot) {
  int low = 0, high = 0, soffits = 0, raised = 0, wide = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const Office office = make_office(seed, draw_inventory(seed), true);
    low += office.height < 2.44;
    high += office.height > 3.3;
    for (const Desk& desk : office.desks) raised += desk.height > 0.84, wide += desk.width > 2;
    for (const Object& object : office.scene.objects()) soffits += object.object_class == ObjectClass::ceiling && object.thing.starts_with("soffit");
  }
  for (const int count : {low, high, soffits, raised, wide}) EXPECT_GE(count, 3);
}

TEST(Office, VariedOnesAreDividedByColumnsAndPartitionsThatStandFree) {
  int columns = 0, partitions = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Office office = make_office(seed, draw_inventory(seed), true);
    for (const Object& wall : of_class(office, ObjectClass::wall)) {
      columns += wall.thing.starts_with("column");
      if (!wall.thing.starts_with("partition")) continue;
      ++partitions;
      EXPECT_LT(wall.centroid.z(), 0.5 * office.height) << "a partition ends below the ceiling";
      EXPECT_NEAR(wall.normal.z(), 0, 1e-9);
      for (const Desk& desk : office.desks) EXPECT_FALSE(over(desk, wall.centroid, 0)) << "seed " << seed;
      for (const Eigen::Vector2d& stand : office.stands) EXPECT_GT((wall.centroid.head<2>() - stand).norm(), 0.3);
    }
  }
  EXPECT_GT(columns, 20);
  EXPECT_GT(partitions, 20);
  for (const Object& wall : of_class(make_office(3, draw_inventory(3)), ObjectClass::wall)) EXPECT_FALSE(wall.thing.starts_with("partition"));
}

TEST(Office, StandsAreFarFromEverythingSolid) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    const Office office = make_office(seed, draw_inventory(seed));
    const Bvh tree(office.scene.shapes());
    for (const Eigen::Vector2d& stand : office.stands) {
      for (double angle = 0; angle < 6.28; angle += 0.1) {
        const Ray ray{{stand.x(), stand.y(), 1.3}, {std::cos(angle), std::sin(angle), 0}};
        EXPECT_GT(tree.cast(ray, 0).range, 0.2) << "seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace scenelore::simulator
