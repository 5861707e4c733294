// Tables, and the screens, keyboards and chairs that go with them.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kThickness = 0.03;

Eigen::Isometry3d placed(const Eigen::Isometry3d& frame, double x, double y, double yaw) {
  Eigen::Isometry3d result = frame;
  result.translate(Vector3d(x, y, 0)).rotate(Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
  return result;
}

Volume body(const Desk& desk) {
  return volume(desk.frame, {-desk.width / 2, -desk.depth / 2, 0}, {desk.width / 2, desk.depth / 2, desk.height + 0.02});
}

Volume user_zone(const Desk& desk) {
  const double half = std::min(desk.width / 2, 0.55);
  return volume(desk.frame, {-half, desk.depth / 2, 0}, {half, desk.depth / 2 + 0.75, 1.3});
}

Desk draw_desk_size(Random& random, bool workplace) {
  Desk desk;
  desk.workplace = workplace;
  desk.width = workplace ? random.pick({1.2, 1.4, 1.6, 1.6, 1.8}) : random.between(0.9, 1.9);
  desk.depth = workplace ? random.pick({0.65, 0.7, 0.8, 0.8, 0.9}) : random.between(0.6, 0.95);
  desk.width += random.between(-0.03, 0.03);
  desk.height = random.between(0.68, 0.78);
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
    for (const double sx : {-x, x - 0.025}) {
      solid({sx, -y + 0.03, 0}, {sx + 0.025, y - 0.05, under}, brush.object(ObjectClass::unknown, desk.name + " side", Material::wood));
    }
    solid({-x + 0.025, -y + 0.06, under - 0.4}, {x - 0.025, -y + 0.08, under}, brush.object(ObjectClass::unknown, desk.name + " rear", Material::wood));
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
  const Material material = office.random.pick({Material::wood, Material::lacquer, Material::paint, Material::dark_wood});
  const int top = brush.object(ObjectClass::table, desk.name, material), edges = brush.clutter(desk.name + " edges", material);
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
  const Wall& wall = office.walls[static_cast<std::size_t>(random.integer(0, static_cast<int>(office.walls.size()) - 1))];
  const double way = random.uniform(), gap = random.between(0.01, 0.2), x = random.uniform();
  const double jitter = random.chance(0.4) ? random.between(-0.05, 0.05) : 0;
  if (way < 0.45) {
    return placed(wall.frame, desk.width / 2 + x * (wall.length - desk.width), desk.depth / 2 + gap + std::abs(jitter) * desk.width / 2, jitter);
  }
  if (way < 0.75) {
    return placed(wall.frame, desk.depth / 2 + x * (wall.length - desk.depth), desk.width / 2 + gap, random.sign() * kPi / 2);
  }
  const double y = random.uniform();
  return placed(Eigen::Isometry3d::Identity(), x * office.width, y * office.depth, random.integer(0, 3) * kPi / 2 + jitter);
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
    partner.frame = placed(desk.frame, side * (desk.width - partner.depth) / 2, desk.depth / 2 + partner.width / 2 + 0.005, -side * kPi / 2);
  }
  const Volume space = body(partner);
  // The return of an L may reach into its own desk's zone, hence only the solid things count for it.
  const bool free = partner.workplace ? fits(office, partner) : office.taken.free(space);
  return free ? std::optional(partner) : std::nullopt;
}

// Puts something with this footprint on the top, wholly within it, if nothing is in the way.
std::optional<Eigen::Isometry3d> on_top(Office& office, const Desk& desk, double x, double y, double yaw, const Eigen::Vector2d& half, double height) {
  Eigen::Isometry3d frame = placed(desk.frame, x, y, yaw);
  frame.translation().z() += desk.height;
  const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
  if (std::abs(x) + c * half.x() + s * half.y() > desk.width / 2 + 0.01 || std::abs(y) + s * half.x() + c * half.y() > desk.depth / 2 + 0.01) return {};
  const Volume space = volume(frame, {-half.x(), -half.y(), 0.001}, {half.x(), half.y(), height});
  if (!office.taken.free(space)) return {};
  office.taken.add(space);
  return frame;
}

void draw_screen(Office& office, const Brush& brush, double width, double height, double lift, double thickness) {
  Random& random = office.random;
  const std::string thing = office.name("screen");
  const Material rim = random.pick({Material::black_plastic, Material::black_plastic, Material::metal, Material::lacquer});
  const int panel = brush.object(ObjectClass::flat_screen, thing, Material::screen), foot = brush.clutter(thing + " foot", rim);
  if (random.chance(0.5)) {
    brush.box({-0.13, -0.11, 0}, {0.13, 0.09, 0.012}, foot);
  } else {
    brush.tube(foot, {0, -0.02, 0}, {0, 0, 0.012}, 0.11);
    brush.disc(foot, {0, -0.02, 0.012}, Vector3d::UnitZ(), 0.11);
  }
  brush.box({-0.03, -thickness - 0.05, 0.01}, {0.03, -thickness - 0.02, lift + height / 2}, foot);
  const Brush tilted = brush.at(0, 0, lift).turned(random.between(-2, 11) * kPi / 180, Vector3d::UnitX());
  tilted.panel(panel, foot, {-width / 2, -thickness, 0}, {width / 2, 0, height});
}

bool add_screen(Office& office, Desk& desk, double x) {
  Random& random = office.random;
  const double diagonal = random.pick({17.0, 19.0, 20.0, 22.0, 24.0, 24.0, 27.0}) * 0.0254;
  const double aspect = diagonal < 0.5 ? 5.0 / 4 : 16.0 / 10, height = diagonal / std::hypot(1.0, aspect), width = height * aspect;
  const double lift = random.between(0.06, 0.16), thickness = random.between(0.02, 0.045);
  const double yaw = random.between(-0.35, 0.35) + 0.4 * x;
  const double y = -desk.depth / 2 + random.between(0.2, 0.32);
  // The foot needs room on the top, the panel above it may reach over the edge.
  const Eigen::Isometry3d above = placed(desk.frame, x, y, yaw);
  const Volume panel = volume(above, {-width / 2, -thickness - 0.06, desk.height + lift}, {width / 2, 0.02, desk.height + lift + height});
  if (!office.taken.free(panel)) return false;
  const auto frame = on_top(office, desk, x, y, yaw, {0.13, 0.12}, lift);
  if (!frame) return false;
  office.taken.add(panel);
  draw_screen(office, office.on(*frame), width, height, lift, thickness);
  ++desk.screens;
  desk.screen_at.push_back(x);
  return true;
}

bool add_keyboard(Office& office, Desk& desk, double x) {
  Random& random = office.random;
  const double width = random.chance(0.2) ? 0.3 : random.between(0.41, 0.47), depth = random.between(0.125, 0.175), thickness = random.between(0.02, 0.03);
  const double slope = random.between(0, 6) * kPi / 180, yaw = random.between(-0.2, 0.2);
  const double y = desk.depth / 2 - random.between(0.1, std::max(0.12, desk.depth - 0.5));
  const auto frame = on_top(office, desk, x, y, yaw, {width / 2 + 0.005, depth / 2 + 0.005}, 0.05);
  if (!frame) return false;
  const std::string thing = office.name("keyboard");
  const Brush brush = office.on(*frame).at(0, 0, std::sin(slope) * depth / 2).turned(-slope, Vector3d::UnitX());
  const Material material = random.pick({Material::black_plastic, Material::black_plastic, Material::lacquer, Material::paint});
  const int top = brush.object(ObjectClass::keyboard, thing, material), sides = brush.clutter(thing + " sides", material);
  brush.box({-width / 2, -depth / 2, 0}, {width / 2, depth / 2, thickness}, {.bottom = -1, .top = top, .others = sides});
  ++desk.keyboards;
  if (const auto mouse = on_top(office, desk, x + width / 2 + random.between(0.08, 0.2), y, 0, {0.035, 0.06}, 0.04)) {
    office.on(*mouse).ellipsoid(office.room().clutter(office.name("mouse"), material), {0, 0, 0.01}, {0.03, 0.055, 0.028});
  }
  return true;
}

// Gives every desk that may have screens one before any gets a second.
bool add_screens(Office& office, int wanted) {
  for (int round = 0; round < 2; ++round) {
    for (int tries = 0; tries < 60 && wanted > 0; ++tries) {
      Desk& desk = office.desks[static_cast<std::size_t>(office.random.integer(0, static_cast<int>(office.desks.size()) - 1))];
      if (desk.screens > round || (!desk.workplace && tries < 30)) continue;
      const double x = desk.screens == 0 ? office.random.between(-0.3, 0.3) * (desk.width - 0.6) * 2 : office.random.sign() * office.random.between(0.3, 0.7);
      if (add_screen(office, desk, x)) --wanted;
    }
  }
  return wanted == 0;
}

bool add_keyboards(Office& office, int wanted) {
  for (int tries = 0; tries < 120 && wanted > 0; ++tries) {
    Desk& desk = office.desks[static_cast<std::size_t>(office.random.integer(0, static_cast<int>(office.desks.size()) - 1))];
    // In front of a screen; only when there are more keyboards than screens, on some other desk too.
    if (desk.keyboards >= std::max(desk.screens, tries < 80 ? 0 : 1)) continue;
    const auto next = static_cast<std::size_t>(desk.keyboards);
    const double x = next < desk.screen_at.size() ? desk.screen_at[next] + office.random.between(-0.1, 0.1) : office.random.between(-0.3, 0.3) * (desk.width - 0.6);
    if (add_keyboard(office, desk, x)) --wanted;
  }
  return wanted == 0;
}

// A partition between desks that face each other: upright like a screen, and none.
void add_partition(Office& office, const Desk& desk) {
  if (!office.random.chance(0.25)) return;
  const Brush brush = office.on(desk.frame);
  const double height = desk.height + office.random.between(0.25, 0.5), x = desk.width / 2 - 0.05, y = -desk.depth / 2 - 0.004;
  const Vector3d low(-x, y - 0.025, desk.height + 0.002), high(x, y, height);
  if (!office.taken.free(volume(desk.frame, low, high))) return;
  const std::string thing = office.name("partition");
  brush.panel(brush.object(ObjectClass::unknown, thing, Material::fabric), brush.clutter(thing + " edges", Material::metal), low, high);
  office.taken.add(volume(desk.frame, low, high));
}

}  // namespace

bool add_workplaces(Office& office, const Inventory& inventory) {
  Random& random = office.random;
  const int with_user = std::max(1, std::max((inventory.screens + 1) / 2, inventory.tables - random.integer(0, 1)));
  for (int tries = 0; tries < 400 && static_cast<int>(office.desks.size()) < inventory.tables; ++tries) {
    Desk desk = draw_desk_size(random, static_cast<int>(office.desks.size()) < with_user);
    desk.frame = draw_site(office, desk);
    if (!fits(office, desk)) continue;
    settle(office, desk);
    if (static_cast<int>(office.desks.size()) >= inventory.tables || !random.chance(0.5)) continue;
    if (const auto partner = draw_partner(office, desk)) settle(office, *partner);
  }
  if (static_cast<int>(office.desks.size()) < inventory.tables) return false;
  if (inventory.tables > 0 && !(add_screens(office, inventory.screens) && add_keyboards(office, inventory.keyboards))) return false;
  for (const Desk& desk : std::vector<Desk>(office.desks)) {
    if (!desk.workplace) continue;
    add_partition(office, desk);
    if (random.chance(0.9)) add_chair(office, desk);
  }
  return true;
}

}  // namespace scenelore::simulator
