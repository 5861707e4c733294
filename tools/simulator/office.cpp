#include "simulator/office.hpp"

#include <stdexcept>

namespace scenelore::simulator {
namespace {

// False when something of the inventory found no place.
bool furnish(Office& office, const Inventory& inventory, RoomKind kind) {
  if (kind == RoomKind::kitchen && !add_kitchen_furniture(office)) return false;
  if (kind == RoomKind::home && !add_home_furniture(office)) return false;
  if (!add_workplaces(office, inventory)) return false;
  add_wall_furniture(office);
  if (!add_stands(office)) return false;
  add_desk_clutter(office);
  add_floor_clutter(office);
  return true;
}

void check(const Inventory& inventory) {
  if (inventory.tables < 0 || inventory.screens < 0 || inventory.keyboards < 0) {
    throw std::invalid_argument("inventory: numbers of tables, screens and keyboards must not be negative");
  }
  if (inventory.tables > 40) throw std::invalid_argument("inventory: a room holds at most 40 tables");
  if (inventory.screens > inventory.tables || inventory.keyboards > inventory.tables) {
    if (inventory.screens > 2 * inventory.tables)
      throw std::invalid_argument("inventory: at most two screens a table; ask for more tables");
    if (inventory.keyboards > 2 * inventory.tables)
      throw std::invalid_argument("inventory: at most two keyboards a table; ask for more tables");
  }
}

}  // namespace

// Stands are drawn before the clutter and kept free, so that which of them is best can be judged in the finished room.
// Who measures likes to stand well clear of things; in a full room any gap has to do.
bool add_stands(Office& office) {
  constexpr std::size_t enough = 8;
  for (int tries = 0; tries < 400 && office.stands.size() < enough; ++tries) {
    const double x = office.random.uniform() * office.width, y = office.random.uniform() * office.depth;
    const double half = tries < 200 ? 0.5 : 0.32;
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.translate(Vector3d(x, y, 0));
    if (!office.taken.free(volume(frame, {-half, -half, 0}, {half, half, 1.7}))) continue;
    office.taken.add(volume(frame, {-0.3, -0.3, 0}, {0.3, 0.3, 1.7}));
    office.stands.emplace_back(x, y);
  }
  return office.stands.size() >= 2;
}

Office make_office(std::uint64_t seed, const Inventory& inventory, bool varied, RoomKind kind) {
  check(inventory);
  for (int attempt = 0; attempt < 60; ++attempt) {
    Office office =
        build_shell(Random(seed, static_cast<std::uint64_t>(attempt)).next(), inventory, 1 + 0.05 * attempt, varied);
    if (!furnish(office, inventory, kind)) continue;
    if (varied) divide(office, seed);
    if (kind == RoomKind::home) office.scene.classify("radiator", ObjectClass::radiator);
    return office;
  }
  throw std::invalid_argument("inventory: no room found that holds " + std::to_string(inventory.tables) + " tables, " +
                              std::to_string(inventory.screens) + " screens and " +
                              std::to_string(inventory.keyboards) + " keyboards");
}

Inventory draw_inventory(std::uint64_t seed, RoomKind kind) {
  if (kind != RoomKind::office) return {.tables = 1};
  Random random(seed, 1000);
  Inventory inventory;
  inventory.tables = random.integer(1, 4);
  for (int i = 0; i < inventory.tables; ++i) {
    const double u = random.uniform();
    inventory.screens += u < 0.3 ? 0 : u < 0.85 ? 1 : 2;
  }
  for (int i = 0; i < inventory.screens; ++i) inventory.keyboards += random.chance(0.75) ? 1 : 0;
  inventory.keyboards = std::min(inventory.keyboards, inventory.tables);
  return inventory;
}

}  // namespace scenelore::simulator
