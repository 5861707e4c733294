// What stands along the walls and hangs on them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

const Wall& pick_wall(Office& office) {
  return office.walls[static_cast<std::size_t>(office.random.integer(0, static_cast<int>(office.walls.size()) - 1))];
}

// Boxes and plants on top of low furniture.
void load_top(Office& office, const Brush& brush, const Vector3d& size) {
  Random& random = office.random;
  for (double x = -size.x() / 2 + 0.05; x < size.x() / 2 - 0.3 && size.z() < 2.0; x += random.between(0.3, 0.8)) {
    if (!random.chance(0.45)) continue;
    const double wide = random.between(0.15, 0.26), deep = random.between(0.15, std::max(0.16, size.y() - 0.1)),
                 high = random.between(0.05, 0.35);
    const double yaw = random.between(-0.15, 0.15);
    brush.at(x + 0.13, size.y() / 2, size.z(), yaw)
        .crate(office.name("box"), random.pick({Material::paper, Material::wood, Material::dark_paint}),
               {-wide / 2, -deep / 2, 0}, {wide / 2, deep / 2, high});
  }
}

void add_cabinet(Office& office) {
  Random& random = office.random;
  const bool tall = random.chance(0.55);
  double wide = random.pick({0.6, 0.8, 0.8, 1.0, 1.2});
  const double deep = random.between(0.36, 0.6);
  double high = tall ? random.between(1.6, 2.15) : random.between(0.7, 1.3);
  if (office.varied) {  // wardrobes up to the ceiling, whole walls of them
    wide = random.between(0.5, 2.6);
    if (tall) high = random.between(1.5, office.height - 0.02);
  }
  const auto frame = along_wall(office, {wide, deep, high}, 0, 0.6);
  if (!frame) return;
  const Brush brush = office.on(*frame);
  const std::string thing = office.name("cabinet");
  const Material material = random.pick({Material::wood, Material::lacquer, Material::metal, Material::dark_wood});
  const auto face = [&] { return brush.object(ObjectClass::cabinet, thing, material); };
  const int left = face(), right = face(), front = face(), top = face();
  const double half = wide / 2;
  const bool ajar = random.chance(0.15);
  brush.box({-half, 0, 0}, {half, deep, high},
            {.left = left, .right = right, .rear = -1, .front = front, .bottom = -1, .top = top});
  const int handles = brush.clutter(thing + " handles", Material::metal);
  for (const double x : {-0.06, 0.04})
    brush.box({x, deep, high * 0.5}, {x + 0.02, deep + 0.03, high * 0.5 + 0.14}, handles);
  if (ajar) {  // one wing stands open; it is a face of the cabinet
    const Brush wing = brush.at(half, deep + 0.02, 0, -random.between(20, 80) * std::numbers::pi / 180);
    wing.panel(face(), handles, {-half + 0.01, 0, 0.08}, {0, 0.02, high - 0.02});
  }
  load_top(office, brush, {wide, deep, high});
}

void add_shelf(Office& office) {
  Random& random = office.random;
  const double wide = random.between(0.6, 1.2), deep = random.between(0.25, 0.4), high = random.between(0.9, 2.2);
  const auto frame = along_wall(office, {wide, deep, high}, 0, 0.5);
  if (!frame) return;
  draw_shelf(office, office.on(*frame), wide, deep, high);
  load_top(office, office.on(*frame), {wide, deep, high});
}

void add_wall_board(Office& office) {
  Random& random = office.random;
  const double wide = random.between(0.9, 2.4), high = random.between(0.9, 1.2), proud = random.between(0.01, 0.03),
               bottom = random.between(0.85, 1.05);
  const auto frame = along_wall(office, {wide, 0.06, high}, bottom, 0);
  if (!frame) return;
  const Brush brush = office.on(*frame);
  const std::string thing = office.name("whiteboard");
  const int board = brush.object(ObjectClass::whiteboard, thing, Material::lacquer),
            rim = brush.clutter(thing + " rim", Material::metal);
  brush.box({-wide / 2, 0, bottom}, {wide / 2, proud, bottom + high}, {.rear = -1, .front = board, .others = rim});
  brush.box({-wide / 4, proud, bottom - 0.02}, {wide / 4, proud + 0.05, bottom}, rim);
}

// Pictures, notices and, rarely, a television: class unknown.
void add_picture(Office& office) {
  Random& random = office.random;
  const bool television = random.chance(0.12);
  const double wide = television ? random.between(0.9, 1.3) : random.between(0.2, 0.9),
               high = television ? wide * 0.57 : random.between(0.25, 0.8);
  const double proud = television ? 0.08 : random.between(0.004, 0.03), bottom = random.between(1.25, 1.5);
  const auto frame = along_wall(office, {wide, proud, high}, bottom, 0);
  if (!frame) return;
  const Brush brush = office.on(*frame);
  const std::string thing = office.name(television ? "television" : "picture");
  const int front = brush.object(ObjectClass::unknown, thing, television ? Material::screen : Material::paper),
            rim = brush.clutter(thing + " rim", Material::black_plastic);
  brush.box({-wide / 2, 0, bottom}, {wide / 2, proud, bottom + high}, {.rear = -1, .front = front, .others = rim});
}

void add_coats(Office& office) {
  const auto frame = along_wall(office, {0.8, 0.3, 1.74}, 0.01, 0);  // nothing stands below coats
  if (!frame) return;
  const Brush brush = office.on(*frame);
  brush.box({-0.4, 0, 1.68}, {0.4, 0.03, 1.74}, brush.clutter("coat rack", Material::wood));
  const int coats = office.random.integer(1, 3);
  for (int i = 0; i < coats; ++i) {
    const double x = -0.25 + 0.25 * i + office.random.between(-0.04, 0.04);
    brush.ellipsoid(brush.clutter(office.name("coat"), Material::dark_fabric), {x, 0.13, 1.3}, {0.15, 0.11, 0.42});
  }
}

void add_cable_duct(Office& office) {
  const Wall& wall = pick_wall(office);
  if (wall.door) return;
  const double z = office.random.pick({0.05, 0.3, 0.62}), high = office.random.between(0.08, 0.14);
  const Volume space = volume(wall.frame, {0.02, 0, z}, {wall.length - 0.02, 0.05, z + high});
  if (!office.taken.free(space)) return;
  office.taken.add(space);
  office.on(wall.frame).crate("cable duct", Material::lacquer, {0.02, 0, z}, {wall.length - 0.02, 0.045, z + high});
}

// Books of one compartment, upright or leaning, with gaps.
void fill_compartment(Office& office, const Brush& brush, double width, double depth, double height) {
  Random& random = office.random;
  if (random.chance(0.12) || height < 0.16) return;
  const int books = brush.clutter("books", Material::paper), dark = brush.clutter("books", Material::dark_paint);
  const double usual_depth = depth * random.between(0.55, 0.85), usual_height = height * random.between(0.6, 0.9);
  double x = 0.005;
  while (x < width - 0.08) {
    if (random.chance(0.07)) x += random.between(0.05, 0.25);
    const double thick = random.between(0.012, 0.06),
                 deep = std::min(depth - 0.01, usual_depth * random.between(0.8, 1.15));
    const double tall = std::min(height - 0.02, usual_height * random.between(0.8, 1.1));
    if (x + thick > width - 0.01) break;
    const bool leans = random.chance(0.08) && x + thick + tall * 0.3 < width;
    const double angle = leans ? random.between(0.08, 0.25) : 0;
    brush.at(x, 0, std::sin(angle) * thick)
        .turned(angle, Vector3d::UnitY())
        .box({0, 0, 0}, {thick, deep, tall * (leans ? 0.93 : 1)}, random.chance(0.6) ? books : dark);
    x += leans ? thick + std::sin(angle) * tall : thick;
  }
}

}  // namespace

std::optional<Eigen::Isometry3d> along_wall(Office& office, const Vector3d& size, double bottom, double front) {
  for (int tries = 0; tries < 40; ++tries) {
    const Wall& wall = pick_wall(office);
    const double x = office.random.uniform(), gap = bottom > 0 ? 0.0 : office.random.between(0.005, 0.06);
    if (wall.length < size.x() + 0.05) continue;
    Eigen::Isometry3d frame = wall.frame;
    frame.translate(Vector3d(size.x() / 2 + x * (wall.length - size.x()), gap, 0));
    const double half = size.x() / 2;
    if (!office.free_for_furniture(volume(frame, {-half, 0, bottom}, {half, size.y(), bottom + size.z()}))) continue;
    if (front > 0 && !office.taken.free(volume(frame, {-half, size.y(), 0}, {half, size.y() + front, 1.5}))) continue;
    office.taken.add(volume(frame, {-half, 0, bottom}, {half, size.y(), bottom + size.z()}));
    if (front > 0) office.zones.add(volume(frame, {-half, size.y(), 0}, {half, size.y() + front, 1.5}));
    return frame;
  }
  return std::nullopt;
}

void draw_shelf(Office& office, const Brush& brush, double width, double depth, double height) {
  Random& random = office.random;
  constexpr double thick = 0.02;
  const std::string thing = office.name("shelf");
  const Material material = random.pick({Material::wood, Material::lacquer, Material::dark_wood});
  const auto face = [&] { return brush.object(ObjectClass::shelf, thing, material); };
  const int edges = brush.clutter(thing + " edges", material);
  const double half = width / 2;
  for (const double x : {-half, half - thick}) {
    const int side = face();
    brush.box({x, 0, 0}, {x + thick, depth, height},
              {.left = x < 0 ? side : -1, .right = x < 0 ? -1 : side, .others = edges});
    brush.quad(side, {x < 0 ? x + thick : x, 0, 0}, {0, depth, 0}, {0, 0, height}, false);
  }
  if (random.chance(0.6)) brush.quad(face(), {-half, 0.002, 0}, {0, 0, height}, {width, 0, 0});
  const int gaps = std::max(2, static_cast<int>(height / random.between(0.3, 0.42)));
  const double step = (height - 0.07 - thick) / gaps;
  for (int i = 0; i <= gaps; ++i) {
    const double z = 0.05 + i * step;
    const int board = face();
    brush.box({-half + thick, 0, z}, {half - thick, depth, z + thick}, {.bottom = -1, .top = board, .others = edges});
    brush.quad(board, {-half + thick, 0, z}, {0, depth, 0}, {width - 2 * thick, 0, 0}, false);
    if (i < gaps)
      fill_compartment(office, brush.at(-half + thick, 0.005, z + thick), width - 2 * thick, depth, step - thick);
  }
}

void add_wall_furniture(Office& office) {
  Random& random = office.random;
  const int cabinets = random.integer(0, 4), shelves = random.integer(0, 3), pictures = random.integer(0, 4);
  for (int i = 0; i < cabinets; ++i) add_cabinet(office);
  for (int i = 0; i < shelves; ++i) add_shelf(office);
  if (random.chance(0.6)) add_wall_board(office);
  if (random.chance(0.15)) add_wall_board(office);
  if (random.chance(0.3)) add_coats(office);
  for (int i = 0; i < pictures; ++i) add_picture(office);
  if (random.chance(0.3)) add_cable_duct(office);
}

}  // namespace scenelore::simulator
