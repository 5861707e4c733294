// Distractors that stand about, all of class unknown.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

constexpr double kPi = std::numbers::pi;

// A free spot on the floor; things like to stand near walls and under desks.
std::optional<Eigen::Isometry3d> floor_spot(Office& office, double half_x, double half_y, double height, bool at_wall) {
  Random& random = office.random;
  for (int tries = 0; tries < 40; ++tries) {
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    const double a = random.uniform(), b = random.uniform();
    if (at_wall) {
      const Wall& wall =
          office.walls[static_cast<std::size_t>(random.integer(0, static_cast<int>(office.walls.size()) - 1))];
      frame = wall.frame;
      frame.translate(Vector3d(a * wall.length, half_y + 0.02 + 0.1 * b, 0));
    } else {
      frame.translate(Vector3d(a * office.width, b * office.depth, 0))
          .rotate(Eigen::AngleAxisd(random.between(0, 2 * kPi), Vector3d::UnitZ()));
    }
    const Volume space = volume(frame, {-half_x, -half_y, 0}, {half_x, half_y, height});
    if (!office.taken.free(space)) continue;
    office.taken.add(space);
    return frame;
  }
  return std::nullopt;
}

void add_bin(Office& office) {
  const auto frame = floor_spot(office, 0.15, 0.15, 0.35, office.random.chance(0.6));
  if (!frame) return;
  const Brush brush = office.on(*frame);
  const int bin = brush.clutter(office.name("bin"), Material::black_plastic);
  brush.tube(bin, {0, 0, 0}, {0, 0, 0.33}, 0.14);
  brush.disc(bin, {0, 0, 0.02}, Vector3d::UnitZ(), 0.14);
}

void add_boxes(Office& office) {
  Random& random = office.random;
  const auto frame = floor_spot(office, 0.33, 0.3, 0.9, random.chance(0.5));
  if (!frame) return;
  double z = 0;
  const int count = random.integer(1, 2);
  for (int i = 0; i < count; ++i) {
    const double x = random.between(0.15, 0.27), y = random.between(0.13, 0.22), high = random.between(0.2, 0.42),
                 yaw = random.between(-0.15, 0.15);
    office.on(*frame).at(0, 0, z, yaw).crate(office.name("carton"), Material::paper, {-x, -y, 0}, {x, y, high});
    z += high;
  }
}

void add_bag(Office& office) {
  const auto frame = floor_spot(office, 0.22, 0.14, 0.42, office.random.chance(0.5));
  if (!frame) return;
  const Brush brush = office.on(*frame);
  brush.ellipsoid(brush.clutter(office.name("bag"), Material::dark_fabric), {0, 0, 0.19}, {0.21, 0.12, 0.21});
}

// A board or carton sheet leaning against a wall: a plane neither upright nor level.
void add_leaning_board(Office& office) {
  Random& random = office.random;
  const double wide = random.between(0.5, 1.1), high = random.between(0.7, 1.4), lean = random.between(0.12, 0.4);
  const auto frame = floor_spot(office, wide / 2, 0.05 + 0.5 * std::sin(lean) * high, high, true);
  if (!frame) return;
  const double y = 0.5 * std::sin(lean) * high;
  const std::string thing = office.name("leaning board");
  const Brush brush = office.on(*frame).at(0, y, 0).turned(lean, Vector3d::UnitX());
  brush.panel(
      brush.object(ObjectClass::unknown, thing, random.pick({Material::wood, Material::paper, Material::lacquer})),
      brush.clutter(thing, Material::wood), {-wide / 2, -0.02, 0.01}, {wide / 2, 0, high});
}

void add_plant(Office& office) {
  const double scale = office.random.between(0.6, 1.1);
  if (const auto frame = floor_spot(office, 0.34 * scale, 0.34 * scale, 1.9 * scale, office.random.chance(0.8)))
    draw_pot_plant(office, office.on(*frame), scale);
}

void add_standing_person(Office& office) {
  if (const auto frame = floor_spot(office, 0.3, 0.25, 1.85, false)) draw_person(office, office.on(*frame), false);
}

}  // namespace

void add_floor_clutter(Office& office) {
  Random& random = office.random;
  if (random.chance(0.7)) add_bin(office);
  if (random.chance(0.4)) add_bin(office);
  if (random.chance(0.5)) add_boxes(office);
  if (random.chance(0.5)) add_bag(office);
  if (random.chance(0.35)) add_leaning_board(office);
  if (random.chance(0.45)) add_plant(office);
  if (random.chance(0.25)) add_standing_person(office);
  if (random.chance(0.35)) add_boxes(office);
  if (random.chance(0.3)) add_bag(office);
  if (random.chance(0.2)) add_plant(office);
}

}  // namespace scenelore::simulator
