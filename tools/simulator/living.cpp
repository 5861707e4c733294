// Plants and people.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

constexpr double kPi = std::numbers::pi;

void draw_leaves(Office& office, const Brush& brush, double radius, double low, double high, int count) {
  Random& random = office.random;
  const int leaves = brush.clutter(office.name("plant"), Material::leaf);
  for (int i = 0; i < count; ++i) {
    const double angle = random.between(0, 2 * kPi), r = radius * std::sqrt(random.uniform()),
                 z = random.between(low, high);
    const double size = random.between(0.05, 0.14), pitch = random.between(-0.9, 0.9), roll = random.between(-0.8, 0.8);
    const Brush leaf = brush.at(r * std::cos(angle), r * std::sin(angle), z, angle)
                           .turned(pitch, Vector3d::UnitY())
                           .turned(roll, Vector3d::UnitX());
    leaf.triangle(leaves, {0, 0, 0}, {size, size * 0.35, 0}, {size, -size * 0.35, 0});
    leaf.triangle(leaves, {size, 0, 0}, {size * 0.4, 0, -size * 0.2}, {0, size * 0.35, 0});
  }
}

}  // namespace

void draw_pot_plant(Office& office, const Brush& brush, double scale) {
  const int pot = brush.clutter(office.name("pot"), Material::dark_paint);
  brush.tube(pot, {0, 0, 0}, {0, 0, 0.3 * scale}, 0.14 * scale);
  brush.disc(pot, {0, 0, 0.27 * scale}, Vector3d::UnitZ(), 0.14 * scale);
  const double high = office.random.between(0.8, 1.5) * scale;
  draw_leaves(office, brush, 0.3 * scale, 0.3 * scale, 0.3 * scale + high, static_cast<int>(60 + 120 * scale));
  brush.tube(pot, {0, 0, 0.25 * scale}, {0, 0, high * 0.8}, 0.012);
}

void draw_person(Office& office, const Brush& brush, bool seated) {
  const std::string thing = office.name("person");
  const int clothes = brush.clutter(thing, office.random.pick({Material::fabric, Material::dark_fabric})),
            skin = brush.clutter(thing, Material::skin);
  const double hip = seated ? 0.1 : 0.95;
  brush.ellipsoid(clothes, {0, 0, hip + 0.27}, {0.2, 0.13, 0.33});
  brush.ellipsoid(skin, {0, -0.02, hip + 0.72}, {0.08, 0.1, 0.12});
  for (const double x : {-0.1, 0.1}) {
    if (seated) {
      brush.ellipsoid(clothes, {x, -0.24, 0.08}, {0.08, 0.26, 0.075});
      brush.ellipsoid(clothes, {x, -0.46, -0.18}, {0.06, 0.07, 0.25});
    } else {
      brush.ellipsoid(clothes, {x, 0, 0.48}, {0.085, 0.1, 0.48});
    }
    const Brush arm = brush.at(2.3 * x, -0.05, hip + 0.3).turned(seated ? -0.7 : 0.1, Vector3d::UnitX());
    arm.ellipsoid(clothes, {0, 0, 0}, {0.05, 0.055, 0.28});
  }
}

}  // namespace scenelore::simulator
