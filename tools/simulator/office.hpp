// The making of a furnished office, step by step, from a seed: shell, workplaces, furniture along the walls, places for
// the sensor, clutter. Every step keeps to the space the steps before it left free.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "simulator/occupancy.hpp"
#include "simulator/random.hpp"
#include "simulator/scene.hpp"
#include "simulator/simulate.hpp"

namespace scenelore::simulator {

/// Part of a wall's rectangle without wall; metres along the wall and above the floor.
struct Opening {
  double left, right, bottom, top;
};

struct Wall {
  Eigen::Isometry3d frame;  ///< at its first corner; x along the wall, y into the room
  double length = 0;
  std::vector<Opening> openings;
  bool door = false, window = false;
};

struct Desk {
  std::string name;
  Eigen::Isometry3d frame;  ///< at the floor below the middle of the top; y towards the user
  double width = 0, depth = 0, height = 0;
  bool workplace = true;  ///< has a seat in front of it, may have screens
  int screens = 0, keyboards = 0;
  std::vector<double> screen_at;  ///< x of each screen's foot
};

struct Office {
  Office(std::uint64_t seed, double room_width, double room_depth, double room_height)
      : random(seed),
        taken(room_width, room_depth),
        zones(room_width, room_depth),
        width(room_width),
        depth(room_depth),
        height(room_height) {}

  Random random;
  Scene scene;
  Occupancy taken;  ///< solid things, and the space doors need
  Occupancy
      zones;  ///< space in front of desks, cabinets and windows that furniture leaves free, but chairs and people use
  double width, depth, height;
  bool varied = false;  ///< sizes far beyond the usual ones
  std::vector<Wall> walls;
  std::vector<Desk> desks;
  std::vector<Eigen::Vector2d> stands;  ///< where the sensor may be put
  std::map<std::string, int> counts;

  [[nodiscard]] Brush room() { return {scene, Eigen::Isometry3d::Identity()}; }
  [[nodiscard]] Brush on(const Eigen::Isometry3d& frame) { return {scene, frame}; }
  /// "desk" becomes "desk 1", "desk 2", …
  std::string name(const std::string& kind) { return kind + " " + std::to_string(++counts[kind]); }
  [[nodiscard]] bool free_for_furniture(const Volume& wanted) const { return taken.free(wanted) && zones.free(wanted); }
};

/// Empty room with floor, ceiling, walls, doors, windows, radiators; its size suits the number of tables.
[[nodiscard]] Office build_shell(std::uint64_t seed, const Inventory& inventory, double enlarge, bool varied);
/// The frame moved by x, y within itself, then turned about its z.
[[nodiscard]] inline Eigen::Isometry3d placed(Eigen::Isometry3d frame, double x, double y, double yaw) {
  return frame.translate(Vector3d(x, y, 0)).rotate(Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
}
/// False when there is no room for all tables.
[[nodiscard]] bool add_desks(Office& office, const Inventory& inventory);
/// Tables with what stands on and before them; false when there is no room for all of the inventory.
[[nodiscard]] bool add_workplaces(Office& office, const Inventory& inventory);
void add_chair(Office& office, const Desk& desk);
/// A free place along some wall for a thing of this size, its rear at the wall; x is the thing's middle, y away from the wall.
/// `front` > 0 keeps so much room before it. Takes the place.
[[nodiscard]] std::optional<Eigen::Isometry3d> along_wall(Office& office, const Vector3d& size, double bottom, double front);
/// Sofas, a bed; false when the room has no place for them.
[[nodiscard]] bool add_home_furniture(Office& office);
/// A counter over cabinets, a stove, a fridge, cupboards on the wall; false when there is no place for them.
[[nodiscard]] bool add_kitchen_furniture(Office& office);
/// Cabinets, shelves, whiteboards, pictures, cable ducts.
void add_wall_furniture(Office& office);
/// Open boards with books between `low` and `high` of the brush's frame; the shelf's front is +y.
void draw_shelf(Office& office, const Brush& brush, double width, double depth, double height);
/// False when the room has no place for a tripod.
[[nodiscard]] bool add_stands(Office& office);
void draw_pot_plant(Office& office, const Brush& brush, double scale);
void add_desk_clutter(Office& office);
void add_floor_clutter(Office& office);
/// A person of ellipsoids; seated ones have their hips at the frame's origin and look along -y.
void draw_person(Office& office, const Brush& brush, bool seated);

/// Columns and partitions where there is space left.
void divide(Office& office, std::uint64_t seed);

/// The whole room; tries again, a little larger, until everything of the inventory fits.
/// Throws std::invalid_argument for an inventory no room can hold.
[[nodiscard]] Office make_office(std::uint64_t seed, const Inventory& inventory, bool varied = false, RoomKind kind = RoomKind::office);
/// Drawn from the seed: 1 to 4 tables, most with a screen, most screens with a keyboard.
[[nodiscard]] Inventory draw_inventory(std::uint64_t seed, RoomKind kind = RoomKind::office);

}  // namespace scenelore::simulator
