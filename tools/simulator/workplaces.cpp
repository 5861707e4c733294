// What goes with tables: screens, keyboards, partitions, chairs.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

constexpr double kPi = std::numbers::pi;

// Puts something with this footprint on the top, wholly within it, if nothing is in the way.
std::optional<Eigen::Isometry3d> on_top(Office& office, const Desk& desk, double x, double y, double yaw,
                                        const Eigen::Vector2d& half, double height) {
  Eigen::Isometry3d frame = placed(desk.frame, x, y, yaw);
  frame.translation().z() += desk.height;
  const double c = std::abs(std::cos(yaw)), s = std::abs(std::sin(yaw));
  if (std::abs(x) + c * half.x() + s * half.y() > desk.width / 2 + 0.01 ||
      std::abs(y) + s * half.x() + c * half.y() > desk.depth / 2 + 0.01)
    return {};
  const Volume space = volume(frame, {-half.x(), -half.y(), 0.001}, {half.x(), half.y(), height});
  if (!office.taken.free(space)) return {};
  office.taken.add(space);
  return frame;
}

void draw_screen(Office& office, const Brush& brush, double width, double height, double lift, double thickness) {
  Random& random = office.random;
  const std::string thing = office.name("screen");
  const Material rim =
      random.pick({Material::black_plastic, Material::black_plastic, Material::metal, Material::lacquer});
  const int panel = brush.object(ObjectClass::flat_screen, thing, Material::screen),
            foot = brush.clutter(thing + " foot", rim);
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
  const double aspect = diagonal < 0.5 ? 5.0 / 4 : 16.0 / 10, height = diagonal / std::hypot(1.0, aspect),
               width = height * aspect;
  const double lift = random.between(0.06, 0.16), thickness = random.between(0.02, 0.045);
  const double yaw = random.between(-0.35, 0.35) + 0.4 * x;
  const double y = -desk.depth / 2 + random.between(0.2, 0.32);
  // The foot needs room on the top, the panel above it may reach over the edge.
  const Eigen::Isometry3d above = placed(desk.frame, x, y, yaw);
  const Volume panel = volume(above, {-width / 2, -thickness - 0.06, desk.height + lift},
                              {width / 2, 0.02, desk.height + lift + height});
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
  const double width = random.chance(0.2) ? 0.3 : random.between(0.41, 0.47), depth = random.between(0.125, 0.175),
               thickness = random.between(0.02, 0.03);
  const double slope = random.between(0, 6) * kPi / 180, yaw = random.between(-0.2, 0.2);
  const double y = desk.depth / 2 - random.between(0.1, std::max(0.12, desk.depth - 0.5));
  const auto frame = on_top(office, desk, x, y, yaw, {width / 2 + 0.005, depth / 2 + 0.005}, 0.05);
  if (!frame) return false;
  const std::string thing = office.name("keyboard");
  const Brush brush = office.on(*frame).at(0, 0, std::sin(slope) * depth / 2).turned(-slope, Vector3d::UnitX());
  const Material material =
      random.pick({Material::black_plastic, Material::black_plastic, Material::lacquer, Material::paint});
  const int top = brush.object(ObjectClass::keyboard, thing, material),
            sides = brush.clutter(thing + " sides", material);
  brush.box({-width / 2, -depth / 2, 0}, {width / 2, depth / 2, thickness},
            {.bottom = -1, .top = top, .others = sides});
  ++desk.keyboards;
  if (const auto mouse = on_top(office, desk, x + width / 2 + random.between(0.08, 0.2), y, 0, {0.035, 0.06}, 0.04)) {
    office.on(*mouse).ellipsoid(office.room().clutter(office.name("mouse"), material), {0, 0, 0.019},
                                {0.03, 0.055, 0.019});
  }
  return true;
}

// Where a second screen stands.
double draw_beside(Random& random) {
  const double side = random.sign();
  return side * random.between(0.3, 0.7);
}

// Gives every desk that may have screens one before any gets a second.
bool add_screens(Office& office, int wanted) {
  for (int round = 0; round < 2; ++round) {
    for (int tries = 0; tries < 60 && wanted > 0; ++tries) {
      Desk& desk =
          office.desks[static_cast<std::size_t>(office.random.integer(0, static_cast<int>(office.desks.size()) - 1))];
      if (desk.screens > round || (!desk.workplace && tries < 30)) continue;
      const double x =
          desk.screens == 0 ? office.random.between(-0.3, 0.3) * (desk.width - 0.6) * 2 : draw_beside(office.random);
      if (add_screen(office, desk, x)) --wanted;
    }
  }
  return wanted == 0;
}

bool add_keyboards(Office& office, int wanted) {
  for (int tries = 0; tries < 120 && wanted > 0; ++tries) {
    Desk& desk =
        office.desks[static_cast<std::size_t>(office.random.integer(0, static_cast<int>(office.desks.size()) - 1))];
    // In front of a screen; only when there are more keyboards than screens, on some other desk too.
    if (desk.keyboards >= std::max(desk.screens, tries < 80 ? 0 : 1)) continue;
    const auto next = static_cast<std::size_t>(desk.keyboards);
    const double x = next < desk.screen_at.size() ? desk.screen_at[next] + office.random.between(-0.1, 0.1)
                                                  : office.random.between(-0.3, 0.3) * (desk.width - 0.6);
    if (add_keyboard(office, desk, x)) --wanted;
  }
  return wanted == 0;
}

// A partition between desks that face each other: upright like a screen, and none.
void add_partition(Office& office, const Desk& desk) {
  if (!office.random.chance(0.25)) return;
  const Brush brush = office.on(desk.frame);
  const double height = desk.height + office.random.between(0.25, 0.5), x = desk.width / 2 - 0.05,
               y = -desk.depth / 2 - 0.004;
  const Vector3d low(-x, y - 0.025, desk.height + 0.002), high(x, y, height);
  if (!office.taken.free(volume(desk.frame, low, high))) return;
  const std::string thing = office.name("partition");
  brush.panel(brush.object(ObjectClass::unknown, thing, Material::fabric),
              brush.clutter(thing + " edges", Material::metal), low, high);
  office.taken.add(volume(desk.frame, low, high));
}

}  // namespace

bool add_workplaces(Office& office, const Inventory& inventory) {
  Random& random = office.random;
  if (!add_desks(office, inventory)) return false;
  if (inventory.tables > 0 && !(add_screens(office, inventory.screens) && add_keyboards(office, inventory.keyboards)))
    return false;
  for (const Desk& desk : std::vector<Desk>(office.desks)) {
    if (desk.workplace) add_partition(office, desk);
    if (random.chance(desk.workplace ? 0.95 : 0.5)) add_chair(office, desk);
    if (random.chance(0.3)) {  // a visitor's chair at the far side, where there is room for it
      Desk other = desk;
      other.frame = placed(desk.frame, 0, 0, kPi);
      add_chair(office, other);
    }
  }
  return true;
}

}  // namespace scenelore::simulator
