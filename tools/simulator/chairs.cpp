// Chairs: swivel chairs and four-legged ones, pushed under the table or not, now and then with somebody on them.
#include <cmath>
#include <numbers>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

constexpr double kPi = std::numbers::pi;

struct ChairSize {
  double seat_height, half_width, half_depth, pad, back_low, back_high;
  bool swivel, arms;
};

// The chair looks along -y, towards the desk; its back is on the +y side.
void draw_legs(Office& office, const Brush& brush, const std::string& thing, const ChairSize& size) {
  const int legs = brush.clutter(thing + " legs", Material::metal);
  const double under = size.seat_height - size.pad;
  if (!size.swivel) {
    for (const double x : {-size.half_width + 0.02, size.half_width - 0.02}) {
      for (const double y : {-size.half_depth + 0.02, size.half_depth - 0.02})
        brush.tube(legs, {x, y, 0}, {0, 0, under}, 0.012);
    }
    return;
  }
  brush.tube(legs, {0, 0, 0.06}, {0, 0, under - 0.06}, 0.03);
  const double turn = office.random.between(0, 1);
  for (int i = 0; i < 5; ++i) {
    const Brush arm = brush.at(0, 0, 0, turn + i * 2 * kPi / 5);
    arm.box({0.02, -0.02, 0.07}, {0.29, 0.02, 0.1}, legs);
    arm.ellipsoid(legs, {0.28, 0, 0.03}, {0.03, 0.025, 0.03});
  }
}

void draw_back(Office& office, const Brush& brush, const std::string& thing, const ChairSize& size, Material material) {
  Random& random = office.random;
  const double lean = random.between(3, 16) * kPi / 180, high = size.back_high - size.back_low;
  const Brush back = brush.at(0, size.half_depth, size.back_low).turned(-lean, Vector3d::UnitX());
  const int rest = brush.clutter(thing + " rest", Material::black_plastic);
  if (random.chance(0.4)) {  // curved about a vertical axis in front of it
    const double radius = random.between(0.35, 0.6), half = std::asin(size.half_width / radius);
    const int shell = back.object(ObjectClass::chair_back, thing, material, false);
    back.arc(shell, {0, -radius, 0}, {0, 0, high}, radius, Vector3d::UnitY(), half);
  } else {
    // Its front is -y: the brush is turned round to draw it.
    const int panel = back.object(ObjectClass::chair_back, thing, material);
    back.at(0, 0, 0, kPi).panel(panel, rest, {-size.half_width, -0.04, 0}, {size.half_width, 0, high});
  }
  for (const double x : {-0.05, 0.03})
    brush.box({x, size.half_depth - 0.05, size.seat_height - 0.06}, {x + 0.02, size.half_depth, size.back_low + 0.05},
              rest);
  if (random.chance(0.12)) {  // a coat over it
    back.ellipsoid(back.clutter(office.name("coat"), Material::dark_fabric), {0, 0.05, high - 0.2},
                   {size.half_width + 0.03, 0.07, 0.3});
  }
}

void draw_chair(Office& office, const Brush& brush, const ChairSize& size) {
  Random& random = office.random;
  const std::string thing = office.name("chair");
  const Material material = random.pick({Material::fabric, Material::dark_fabric, Material::dark_fabric,
                                         size.swivel ? Material::black_plastic : Material::wood});
  const int seat = brush.object(ObjectClass::chair_seat, thing, material),
            edges = brush.clutter(thing + " edges", material);
  brush.box({-size.half_width, -size.half_depth, size.seat_height - size.pad},
            {size.half_width, size.half_depth, size.seat_height}, {.top = seat, .others = edges});
  draw_back(office, brush, thing, size, material);
  draw_legs(office, brush, thing, size);
  if (size.arms) {
    const int arms = brush.clutter(thing + " arms", Material::black_plastic);
    for (const double x : {-size.half_width - 0.05, size.half_width}) {
      brush.box({x, -0.08, size.seat_height - 0.05}, {x + 0.03, -0.04, size.seat_height + 0.17}, arms);
      brush.box({x - 0.01, -0.15, size.seat_height + 0.17}, {x + 0.05, 0.12, size.seat_height + 0.2}, arms);
    }
  }
}

}  // namespace

void add_chair(Office& office, const Desk& desk) {
  Random& random = office.random;
  ChairSize size{};
  size.seat_height = random.between(0.42, 0.52);
  size.half_width = random.between(0.2, 0.25);
  size.half_depth = random.between(0.19, 0.24);
  size.swivel = random.chance(0.7);
  size.arms = size.swivel && random.chance(0.4);
  size.pad = size.swivel ? random.between(0.05, 0.09) : random.between(0.02, 0.05);
  size.back_low = size.seat_height + random.between(0.06, 0.18);
  size.back_high = size.back_low + random.between(0.3, 0.55);
  for (int tries = 0; tries < 25; ++tries) {
    const bool tucked = random.chance(0.4);
    const double y = desk.depth / 2 + (tucked ? random.between(-0.12, 0.1) : random.between(0.1, 0.5));
    const double yaw = tucked ? random.between(-0.25, 0.25) : random.normal() * 0.5;
    const double x = random.between(-0.3, 0.3);
    const Eigen::Isometry3d frame = placed(desk.frame, x, y, yaw);
    const double w = size.half_width + 0.05, d = size.half_depth,
                 seat_top = size.seat_height + (size.arms ? 0.21 : 0.01);
    const std::vector<Volume> space{volume(frame, {-w, -d - 0.03, 0}, {w, d + 0.06, seat_top}),
                                    volume(frame, {-w, d - 0.14, size.seat_height}, {w, d + 0.18, size.back_high})};
    if (!office.taken.free(space)) continue;
    for (const Volume& part : space) office.taken.add(part);
    draw_chair(office, office.on(frame), size);
    if (!tucked && y > desk.depth / 2 + 0.25 && random.chance(0.15))
      draw_person(office, office.on(frame).at(0, 0.04, size.seat_height + 0.02), true);
    return;
  }
}

}  // namespace scenelore::simulator
