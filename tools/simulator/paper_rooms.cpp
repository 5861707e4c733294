// Six rooms with as many tables, screens and keyboards as the paper's.
#include <algorithm>
#include <array>
#include <optional>

#include "simulator/random.hpp"
#include "simulator/simulate.hpp"

namespace scenelore::simulator {
namespace {

constexpr int kRooms = 6, kTables = 12, kScreens = 9, kKeyboards = 7;

using Rooms = std::array<Inventory, kRooms>;

// Nothing where screens came to stand so that too few tables have room for keyboards, in one set of a thousand.
std::optional<Rooms> try_to_spread(Random& random) {
  Rooms rooms;
  for (Inventory& room : rooms) room.tables = 1;
  const auto any = [&]() -> Inventory& { return rooms[static_cast<std::size_t>(random.integer(0, kRooms - 1))]; };
  const auto deal = [&](int count, int Inventory::*what, auto&& allowed) {
    while (count > 0 && std::any_of(rooms.begin(), rooms.end(), allowed)) {
      Inventory& room = any();
      if (!allowed(room)) continue;
      ++(room.*what);
      --count;
    }
    return count == 0;
  };
  deal(kTables - kRooms, &Inventory::tables, [](const Inventory& room) { return room.tables < 3; });
  deal(kScreens, &Inventory::screens,
       [](const Inventory& room) { return room.screens < room.tables + (room.tables > 1 ? 1 : 0); });
  const bool all = deal(kKeyboards, &Inventory::keyboards,
                        [](const Inventory& room) { return room.keyboards < std::min(room.screens, room.tables); });
  return all ? std::optional(rooms) : std::nullopt;
}

Rooms spread(Random& random) {
  while (true) {
    if (const std::optional<Rooms> rooms = try_to_spread(random)) return *rooms;
  }
}

// Whether every table, screen and keyboard is seen well enough to be asked for, judged by a scan of a quarter of the
// points.
bool shows_everything(SimulationOptions options) {
  options.points = 100'000 * static_cast<std::size_t>(options.poses);
  for (const TruthObject& object : simulate(options).objects) {
    const std::size_t needed = object.object_class == "table"         ? 100
                               : object.object_class == "flat_screen" ? 40
                               : object.object_class == "keyboard"    ? 20
                                                                      : 0;
    if (object.points < needed) return false;
  }
  return true;
}

}  // namespace

std::vector<SimulationOptions> paper_rooms(std::uint64_t seed, double noise) {
  Random random(seed, 4000);
  std::vector<SimulationOptions> rooms;
  for (const Inventory& inventory : spread(random)) {
    SimulationOptions options;
    options.inventory = inventory;
    options.noise = noise;
    // A hidden object is looked for in another room, and more and more often from a second place.
    for (int attempt = 0; attempt < 40; ++attempt) {
      options.seed = random.next() >> 16;
      options.poses = random.chance(attempt < 8 ? 0.15 : 0.6) ? 2 : 1;
      if (shows_everything(options)) break;
    }
    rooms.push_back(options);
  }
  return rooms;
}

}  // namespace scenelore::simulator
