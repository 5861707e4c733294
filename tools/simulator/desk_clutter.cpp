// Distractors on and below desks, all of class unknown.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

void draw_paper_pile(Office& office, const Brush& brush) {
  Random& random = office.random;
  double z = 0;
  const int layers = random.integer(1, 4);
  for (int i = 0; i < layers; ++i) {
    const double high = random.between(0.002, 0.025), yaw = random.between(-0.15, 0.15),
                 x = random.between(-0.01, 0.01);
    brush.at(x, 0, z, yaw).crate("papers", Material::paper, {-0.105, -0.148, 0}, {0.105, 0.148, high});
    z += high;
  }
}

void draw_books(Office& office, const Brush& brush) {
  Random& random = office.random;
  double z = 0;
  const int layers = random.integer(1, 5);
  for (int i = 0; i < layers; ++i) {
    const double wide = random.between(0.13, 0.22), deep = random.between(0.18, 0.3),
                 high = random.between(0.012, 0.045), yaw = random.between(-0.25, 0.25);
    brush.at(0, 0, z, yaw)
        .crate("book", random.pick({Material::paper, Material::dark_paint, Material::lacquer}),
               {-wide / 2, -deep / 2, 0}, {wide / 2, deep / 2, high});
    z += high;
  }
}

void draw_mug(Office& office, const Brush& brush) {
  const int mug = brush.clutter(office.name("mug"), Material::lacquer);
  brush.tube(mug, {0, 0, 0}, {0, 0, 0.1}, 0.042);
  brush.disc(mug, {0, 0, 0.01}, Vector3d::UnitZ(), 0.042);
}

void draw_desk_lamp(Office& office, const Brush& brush) {
  const int lamp = brush.clutter(office.name("desk lamp"), Material::black_plastic);
  const double bend = office.random.between(0.05, 0.25);
  brush.tube(lamp, {0, 0, 0}, {0, 0, 0.02}, 0.08);
  brush.disc(lamp, {0, 0, 0.02}, Vector3d::UnitZ(), 0.08);
  brush.tube(lamp, {0, 0, 0.02}, {-bend / 2, 0, 0.26}, 0.009);
  brush.tube(lamp, {-bend / 2, 0, 0.28}, {bend, 0, 0.15}, 0.009);
  brush.ellipsoid(lamp, {bend / 2, 0, 0.41}, {0.07, 0.06, 0.045});
}

// Binders in a row: an upright plane on a desk that is no screen.
void draw_binders(Office& office, const Brush& brush) {
  Random& random = office.random;
  const int count = random.integer(2, 5);
  const Material material = random.pick({Material::dark_paint, Material::paint, Material::paper});
  for (int i = 0; i < count; ++i) {
    const double x = -0.17 + 0.07 * i, y = random.between(-0.01, 0.01);
    brush.crate("binder", material, {x, y - 0.14, 0}, {x + 0.066, y + 0.14, 0.315});
  }
}

void draw_trays(Office&, const Brush& brush) {
  const int trays = brush.clutter("letter trays", Material::black_plastic);
  for (int i = 0; i < 3; ++i) brush.box({-0.13, -0.17, 0.065 * i}, {0.13, 0.17, 0.065 * i + 0.01}, trays);
  for (const double x : {-0.13, 0.125}) brush.box({x, -0.17, 0}, {x + 0.005, 0.17, 0.17}, trays);
}

// An upright picture frame or calendar, leaning back.
void draw_stand_up(Office& office, const Brush& brush) {
  const std::string thing = office.name("frame");
  const double lean = office.random.between(0.15, 0.35);
  brush.at(0, 0.03, 0.02)
      .turned(lean, Vector3d::UnitX())
      .panel(brush.object(ObjectClass::unknown, thing, Material::paper), brush.clutter(thing, Material::wood),
             {-0.12, -0.015, 0}, {0.12, 0, 0.22});
}

void draw_telephone(Office& office, const Brush& brush) {
  const int phone = brush.clutter(office.name("telephone"), Material::black_plastic);
  brush.at(0, 0, 0.045).turned(-0.25, Vector3d::UnitX()).box({-0.09, -0.1, -0.015}, {0.09, 0.1, 0.03}, phone);
  brush.ellipsoid(phone, {-0.06, 0, 0.1}, {0.025, 0.1, 0.025});
}

void draw_small_box(Office& office, const Brush& brush) {
  Random& random = office.random;
  const double x = random.between(0.06, 0.17), y = random.between(0.06, 0.14), z = random.between(0.05, 0.3);
  brush.crate(office.name("box"), random.pick({Material::paper, Material::wood, Material::black_plastic}), {-x, -y, 0},
              {x, y, z});
}

void draw_desk_plant(Office& office, const Brush& brush) { draw_pot_plant(office, brush, 0.4); }

struct Kind {
  void (*draw)(Office&, const Brush&);
  double half_x, half_y, height;  ///< of the space it needs
};

void put_on_desk(Office& office, const Desk& desk, const Kind& kind) {
  Random& random = office.random;
  for (int tries = 0; tries < 12; ++tries) {
    const double x = random.between(-0.5, 0.5) * desk.width, y = random.between(-0.5, 0.5) * desk.depth,
                 yaw = random.normal() * 0.35;
    const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
    if (std::abs(x) + c * kind.half_x + s * kind.half_y > desk.width / 2 ||
        std::abs(y) + s * kind.half_x + c * kind.half_y > desk.depth / 2)
      continue;
    Eigen::Isometry3d frame = desk.frame;
    frame.translate(Vector3d(x, y, desk.height)).rotate(Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
    const Volume space = volume(frame, {-kind.half_x, -kind.half_y, 0.002}, {kind.half_x, kind.half_y, kind.height});
    if (!office.taken.free(space)) continue;
    office.taken.add(space);
    kind.draw(office, office.on(frame));
    return;
  }
}

void add_tower(Office& office, const Desk& desk) {
  Random& random = office.random;
  const double side = random.sign(), x = side * (desk.width / 2 - random.between(0.2, 0.4)),
               y = random.between(-0.08, 0.05), yaw = random.between(-0.1, 0.1);
  const Eigen::Isometry3d frame = placed(desk.frame, x, y, yaw);
  const Volume space = volume(frame, {-0.1, -0.22, 0}, {0.1, 0.22, 0.45});
  if (!office.taken.free(space)) return;
  office.taken.add(space);
  office.on(frame).crate(office.name("computer"), Material::black_plastic, {-0.095, -0.21, 0}, {0.095, 0.21, 0.43});
}

}  // namespace

void add_desk_clutter(Office& office) {
  static constexpr Kind kinds[] = {
      {draw_paper_pile, 0.12, 0.16, 0.1}, {draw_books, 0.13, 0.17, 0.2},      {draw_mug, 0.05, 0.05, 0.11},
      {draw_desk_lamp, 0.15, 0.09, 0.5},  {draw_binders, 0.19, 0.16, 0.32},   {draw_trays, 0.14, 0.18, 0.2},
      {draw_stand_up, 0.13, 0.09, 0.25},  {draw_telephone, 0.1, 0.12, 0.11},  {draw_small_box, 0.18, 0.15, 0.31},
      {draw_desk_plant, 0.13, 0.13, 0.7}, {draw_paper_pile, 0.12, 0.16, 0.1}, {draw_mug, 0.05, 0.05, 0.11}};
  Random& random = office.random;
  for (const Desk& desk : office.desks) {
    const int count = random.chance(0.12) ? 0 : random.integer(2, 9);
    for (int i = 0; i < count; ++i)
      put_on_desk(office, desk, kinds[random.integer(0, static_cast<int>(std::size(kinds)) - 1)]);
    if (random.chance(0.5)) add_tower(office, desk);
  }
}

}  // namespace scenelore::simulator
