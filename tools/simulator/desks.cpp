// Tables: their sizes, what carries them, and where in a room they are put.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kThickness = 0.03;

Volume body(const Desk& desk) {
  return volume(desk.frame, {-desk.width / 2, -desk.depth / 2, 0},
                {desk.width / 2, desk.depth / 2, desk.height + 0.02});
}

Volume user_zone(const Desk& desk) {
  const double half = std::min(desk.width / 2, 0.55);
  return volume(desk.frame, {-half, desk.depth / 2, 0}, {half, desk.depth / 2 + 0.75, 1.3});
}

Desk draw_desk_size(Office& office, bool workplace) {
  Random& random = office.random;
  Desk desk;
  desk.workplace = workplace;
  desk.width = workplace ? random.pick({1.2, 1.4, 1.6, 1.6, 1.8}) : random.between(0.9, 1.9);
  desk.depth = workplace ? random.pick({0.65, 0.7, 0.8, 0.8, 0.9}) : random.between(0.6, 0.95);
  desk.width += random.between(-0.03, 0.03);
  desk.height = random.between(0.68, 0.78);
  if (office.varied) {  // desks that can be raised (EN 527-1 knows 0.62 to 1.28 m), and conference tables
    desk.height = random.chance(0.15) ? random.between(0.85, 1.2) : random.between(0.62, 0.85);
    if (!workplace) desk.width = random.between(0.6, 2.8), desk.depth = random.between(0.5, 1.4);
  }
  return desk;
}

void draw_support(Office& office, const Desk& desk, const Brush& brush) {
  Random& random = office.random;
  const double x = desk.width / 2, y = desk.depth / 2, under = desk.height - kThickness;
  const auto solid = [&](const Vector3d& low, const Vector3d& high, int object) {
    brush.box(low, high, object);
    office.taken.add(volume(desk.frame, low, high));
  };
  const int kind = random.integer(0, 2);
  if (kind == 0) {  // four legs
    const int legs = brush.clutter(desk.name + " legs", Material::metal);
    for (const double sx : {-x + 0.02, x - 0.07}) {
      for (const double sy : {-y + 0.02, y - 0.07}) solid({sx, sy, 0}, {sx + 0.05, sy + 0.05, under}, legs);
    }
  } else if (kind == 1) {  // side panels and a modesty panel
    const int edges = brush.clutter(desk.name + " edges", Material::wood);
    for (const double sx : {-x, x - 0.025}) {
      const int side = brush.object(ObjectClass::unknown, desk.name + " side", Material::wood);
      brush.at(sx, 0, 0, kPi / 2).panel(side, edges, {-y + 0.03, -0.025, 0}, {y - 0.05, 0, under});
      office.taken.add(volume(desk.frame, {sx, -y + 0.03, 0}, {sx + 0.025, y - 0.05, under}));
    }
    const Vector3d low(-x + 0.025, -y + 0.06, under - 0.4), high(x - 0.025, -y + 0.08, under);
    brush.panel(brush.object(ObjectClass::unknown, desk.name + " rear", Material::wood), edges, low, high);
    office.taken.add(volume(desk.frame, low, high));
  } else {  // two T-shaped feet and a beam
    const int legs = brush.clutter(desk.name + " legs", Material::metal);
    for (const double sx : {-x + 0.15, x - 0.22}) {
      solid({sx, -y + 0.05, 0}, {sx + 0.07, y - 0.05, 0.05}, legs);
      solid({sx, -0.05, 0.05}, {sx + 0.07, 0.05, under}, legs);
    }
    brush.box({-x + 0.15, -0.02, under - 0.08}, {x - 0.15, 0.02, under - 0.02}, legs);
  }
}

void draw_desk(Office& office, Desk& desk) {
  desk.name = office.name("desk");
  const Brush brush = office.on(desk.frame);
  const Material material =
      office.random.pick({Material::wood, Material::lacquer, Material::paint, Material::dark_wood});
  const int top = brush.object(ObjectClass::table, desk.name, material),
            edges = brush.clutter(desk.name + " edges", material);
  const double x = desk.width / 2, y = desk.depth / 2;
  brush.box({-x, -y, desk.height - kThickness}, {x, y, desk.height}, {.top = top, .others = edges});
  office.taken.add(volume(desk.frame, {-x, -y, desk.height - kThickness}, {x, y, desk.height}));
  draw_support(office, desk, brush);
  if (desk.workplace && office.random.chance(0.45)) {  // a pedestal with drawers, below the top
    const double side = office.random.sign() * (x - 0.3), high = std::min(0.58, desk.height - 0.08);
    const Vector3d low(side - 0.2, -y + 0.12, 0), upper(side + 0.2, y - 0.04, high);
    if (!office.taken.free(volume(desk.frame, low, upper))) return;
    const std::string thing = office.name("pedestal");
    const auto face = [&] { return brush.object(ObjectClass::cabinet, thing, material); };
    const int left = face(), right = face(), front = face(), lid = face();
    brush.box(low, upper, {.left = left, .right = right, .rear = -1, .front = front, .bottom = -1, .top = lid});
    office.taken.add(volume(desk.frame, low, upper));
  }
}

bool fits(Office& office, const Desk& desk) {
  return office.free_for_furniture(body(desk)) && (!desk.workplace || office.free_for_furniture(user_zone(desk)));
}

void settle(Office& office, Desk desk) {
  draw_desk(office, desk);
  if (desk.workplace) office.zones.add(user_zone(desk));
  office.desks.push_back(desk);
}

// A frame for a desk: along a wall, with its short side to a wall, or free in the room.
Eigen::Isometry3d draw_site(Office& office, const Desk& desk) {
  Random& random = office.random;
  const Wall& wall =
      office.walls[static_cast<std::size_t>(random.integer(0, static_cast<int>(office.walls.size()) - 1))];
  const double way = random.uniform(), gap = random.between(0.01, 0.2), x = random.uniform();
  const double jitter = random.chance(0.4) ? random.between(-0.05, 0.05) : 0;
  if (way < 0.45) {
    return placed(wall.frame, desk.width / 2 + x * (wall.length - desk.width),
                  desk.depth / 2 + gap + std::abs(jitter) * desk.width / 2, jitter);
  }
  if (way < 0.75) {
    return placed(wall.frame, desk.depth / 2 + x * (wall.length - desk.depth), desk.width / 2 + gap,
                  random.sign() * kPi / 2);
  }
  const double y = random.uniform();
  return placed(Eigen::Isometry3d::Identity(), x * office.width, y * office.depth,
                random.integer(0, 3) * kPi / 2 + jitter);
}

// A second table that belongs to the first: face to face with it, side by side, or at a right angle to it.
std::optional<Desk> draw_partner(Office& office, const Desk& desk) {
  Random& random = office.random;
  const double way = random.uniform();
  Desk partner = desk;
  if (way < 0.4) {
    partner.frame = placed(desk.frame, random.chance(0.3) ? random.between(-0.3, 0.3) : 0, -desk.depth - 0.01, kPi);
  } else if (way < 0.6) {
    partner.frame = placed(desk.frame, random.sign() * (desk.width + 0.01), 0, 0);
  } else {
    partner.workplace = false;
    partner.width = random.between(0.8, 1.1);
    partner.depth = random.between(0.45, 0.6);
    if (random.chance(0.5)) partner.height = desk.height - random.between(0.03, 0.08);
    partner.height = std::max(partner.height, 0.66);
    const int side = random.sign();
    partner.frame = placed(desk.frame, side * (desk.width - partner.depth) / 2,
                           desk.depth / 2 + partner.width / 2 + 0.005, -side * kPi / 2);
  }
  const Volume space = body(partner);
  // The return of an L may reach into its own desk's zone, hence only the solid things count for it.
  const bool free = partner.workplace ? fits(office, partner) : office.taken.free(space);
  return free ? std::optional(partner) : std::nullopt;
}

}  // namespace

bool add_desks(Office& office, const Inventory& inventory) {
  Random& random = office.random;
  const int with_user = std::max(1, std::max((inventory.screens + 1) / 2, inventory.tables - random.integer(0, 1)));
  for (int tries = 0; tries < 400 && static_cast<int>(office.desks.size()) < inventory.tables; ++tries) {
    Desk desk = draw_desk_size(office, static_cast<int>(office.desks.size()) < with_user);
    desk.frame = draw_site(office, desk);
    if (!fits(office, desk)) continue;
    settle(office, desk);
    if (static_cast<int>(office.desks.size()) >= inventory.tables || !random.chance(0.5)) continue;
    if (const auto partner = draw_partner(office, desk)) settle(office, *partner);
  }
  return static_cast<int>(office.desks.size()) >= inventory.tables;
}

}  // namespace scenelore::simulator
