// What homes and kitchens have and offices have not.
#include <algorithm>
#include <array>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

// A seat of cushions with a back and arms, its rear at the wall.
bool add_sofa(Office& office) {
  Random& random = office.random;
  const double wide = random.between(1.5, 2.2), deep = random.between(0.8, 0.95), seat = random.between(0.4, 0.46), back = random.between(0.75, 0.88);
  const auto frame = along_wall(office, {wide, deep, back}, 0, 0.6);
  if (!frame) return false;
  const Brush brush = office.on(*frame);
  const std::string thing = office.name("sofa");
  const Material cloth = random.pick({Material::fabric, Material::dark_fabric});
  const int top = brush.object(ObjectClass::sofa, thing, cloth), rest = brush.object(ObjectClass::sofa_back, thing, cloth),
            body = brush.clutter(thing + " body", cloth);
  const double half = wide / 2, arm = 0.15, thick = 0.22;
  brush.box({-half + arm, thick, 0.08}, {half - arm, deep, seat}, {.rear = -1, .bottom = -1, .top = top, .others = body});
  brush.box({-half + arm, 0, 0.08}, {half - arm, thick, back}, {.rear = -1, .front = rest, .bottom = -1, .others = body});
  for (const double x : {-half, half - arm}) brush.box({x, 0, 0.08}, {x + arm, deep, seat + 0.16}, body);
  return true;
}

// Its head at the wall.
bool add_bed(Office& office) {
  Random& random = office.random;
  const double wide = random.pick({0.9, 1.0, 1.4, 1.6, 1.8}), high = random.between(0.45, 0.6), deep = random.between(2.0, 2.1);
  const auto frame = along_wall(office, {wide, deep, 1.0}, 0, 0.4);
  if (!frame) return false;
  const Brush brush = office.on(*frame);
  const std::string thing = office.name("bed");
  const int top = brush.object(ObjectClass::bed, thing, Material::fabric), frame_parts = brush.clutter(thing + " frame", Material::wood);
  const double half = wide / 2;
  brush.box({-half, 0.04, 0.1}, {half, deep, high}, {.bottom = -1, .top = top, .others = frame_parts});
  brush.box({-half, 0, 0}, {half, 0.04, random.between(0.7, 1.0)}, frame_parts);
  for (double x = -half + 0.38; x < half; x += 0.75) {
    brush.ellipsoid(brush.clutter(office.name("pillow"), Material::fabric), {x, 0.3, high + 0.03}, {0.32, 0.2, 0.08});
  }
  return true;
}

// Of sheet metal, hung before a wall.
bool add_panel_radiator(Office& office) {
  Random& random = office.random;
  const double wide = random.between(0.8, 1.6), top = random.between(0.6, 0.75);
  const auto frame = along_wall(office, {wide, 0.14, top}, 0, 0.4);
  if (!frame) return false;
  const Brush brush = office.on(*frame);
  const std::string thing = office.name("heater");
  const int front = brush.object(ObjectClass::radiator, thing, Material::lacquer), sides = brush.clutter(thing + " sides", Material::lacquer);
  brush.box({-wide / 2, 0.03, 0.12}, {wide / 2, 0.12, top}, {.rear = -1, .front = front, .others = sides});
  return true;
}

void add_cupboard(Office& office, const Brush& brush, double left, double right, double low, double high) {
  const std::string thing = office.name("cupboard");
  const auto face = [&] { return brush.object(ObjectClass::wall_cabinet, thing, Material::lacquer); };
  const int front = face(), left_side = face(), right_side = face(), bottom = face();
  brush.box({left, 0, low}, {right, 0.33, high}, {.left = left_side, .right = right_side, .rear = -1, .front = front, .bottom = bottom, .top = -1});
}

// A worktop with a sink in it over base cabinets; the sink's basin is a hole with a floor of its own.
void draw_counter(Office& office, const Brush& brush, double left, double right, double high) {
  const std::string thing = office.name("counter");
  const int top = brush.object(ObjectClass::counter, thing, Material::wood), edges = brush.clutter(thing + " edges", Material::wood),
            front = brush.object(ObjectClass::cabinet, thing, Material::lacquer), basin = brush.clutter(thing + " basin", Material::metal);
  const double deep = 0.6, x = left + (right - left) * office.random.between(0.25, 0.5), x2 = x + 0.4, y = 0.12, y2 = 0.5;
  for (const auto& [a, b, c, d] : {std::array{left, x, 0.0, deep}, std::array{x2, right, 0.0, deep}, std::array{x, x2, 0.0, y}, std::array{x, x2, y2, deep}}) {
    brush.quad(top, {a, c, high}, {b - a, 0, 0}, {0, d - c, 0});
  }
  brush.box({x, y, high - 0.17}, {x2, y2, high}, {.bottom = basin, .top = -1, .others = basin});
  brush.box({left, 0, high - 0.04}, {right, deep, high}, {.rear = -1, .bottom = -1, .top = -1, .others = edges});
  brush.box({left, 0.02, 0.1}, {right, deep - 0.03, high - 0.04}, {.left = edges, .right = edges, .rear = -1, .front = front, .bottom = -1, .top = -1});
}

}  // namespace

bool add_home_furniture(Office& office) {
  const bool bed = office.random.chance(0.6);
  const int sofas = bed ? office.random.integer(1, 2) : 2;
  if (bed && !add_bed(office)) return false;
  for (int i = 0; i < sofas; ++i) {
    if (!add_sofa(office)) return false;
  }
  return add_panel_radiator(office);
}

bool add_kitchen_furniture(Office& office) {
  Random& random = office.random;
  const double counter = random.between(1.5, 2.2), high = random.between(0.88, 0.94), stove = 0.6, fridge = random.between(0.55, 0.62),
               tall = random.between(1.5, 1.9), wide = counter + stove + fridge + 0.1;
  const auto frame = along_wall(office, {wide, 0.65, 2.2}, 0, 0.9);
  if (!frame) return false;
  const Brush brush = office.on(*frame);
  double x = -wide / 2;
  draw_counter(office, brush, x, x + counter, high);
  for (double left = x; left + 0.5 < x + counter; left += 0.6) {
    if (random.chance(0.8)) add_cupboard(office, brush, left, std::min(left + 0.6, x + counter), 1.42, 2.1);
  }
  x += counter + 0.02;
  const std::string hob = office.name("stove");
  const int plate = brush.object(ObjectClass::stove, hob, Material::metal), oven = brush.clutter(hob + " front", Material::lacquer);
  brush.box({x, 0.02, 0}, {x + stove - 0.02, 0.6, high - random.between(0.06, 0.09)}, {.rear = -1, .bottom = -1, .top = plate, .others = oven});
  x += stove + 0.04;
  const std::string cold = office.name("fridge");
  const auto face = [&] { return brush.object(ObjectClass::fridge, cold, Material::lacquer); };
  const int front = face(), left = face(), right = face(), top = face();
  brush.box({x, 0.03, 0}, {x + fridge, 0.63, tall}, {.left = left, .right = right, .rear = -1, .front = front, .bottom = -1, .top = top});
  return true;
}

}  // namespace scenelore::simulator
