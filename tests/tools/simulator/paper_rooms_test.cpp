#include <gtest/gtest.h>

#include "simulator/simulate.hpp"

namespace scenelore::simulator {
namespace {

TEST(PaperRooms, HoldTheNumbersOfThePaperAndShowEveryObject) {
  for (const std::uint64_t seed : {1U, 2U, 9453U}) {  // of the last, screens come to stand at first where only six keyboards fit
    const std::vector<SimulationOptions> rooms = paper_rooms(seed);
    ASSERT_EQ(rooms.size(), 6U);
    int tables = 0, screens = 0, keyboards = 0;
    for (const SimulationOptions& options : rooms) {
      EXPECT_EQ(options.noise, 0.01);
      for (const TruthObject& object : simulate(options).objects) {
        tables += object.object_class == "table";
        screens += object.object_class == "flat_screen";
        keyboards += object.object_class == "keyboard";
        const std::size_t least = object.object_class == "table"         ? 300
                                  : object.object_class == "flat_screen" ? 100
                                  : object.object_class == "keyboard"    ? 60
                                                                         : 0;
        EXPECT_GE(object.points, least) << object.thing;
      }
    }
    EXPECT_EQ(tables, 12);
    EXPECT_EQ(screens, 9);
    EXPECT_EQ(keyboards, 7);
  }
}

TEST(PaperRooms, SameSeedGivesTheSameRoomsAndAnotherOthers) {
  const auto a = paper_rooms(3), b = paper_rooms(3), c = paper_rooms(4);
  bool differ = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].seed, b[i].seed);
    EXPECT_EQ(a[i].poses, b[i].poses);
    differ = differ || a[i].seed != c[i].seed;
  }
  EXPECT_TRUE(differ);
}

}  // namespace
}  // namespace scenelore::simulator
