// What divides the space of large offices: columns, and partitions between workplaces. They come last, from a stream of their own,
// and take what space is left: rooms without them stay as they were.
#include <cmath>
#include <numbers>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

/// A free place for a box of this size, along the walls or at an angle of `skew` to them; takes it.
std::optional<Eigen::Isometry3d> free_place(Office& office, Random& random, const Vector3d& size, double skew) {
  for (int tries = 0; tries < 60; ++tries) {
    const double yaw = (random.chance(0.5) ? 0 : std::numbers::pi / 2) + skew;
    const Eigen::Isometry3d frame =
        placed(Eigen::Isometry3d::Identity(), random.uniform() * office.width, random.uniform() * office.depth, yaw);
    const Volume space = volume(frame, {-size.x() / 2, -size.y() / 2, 0}, {size.x() / 2, size.y() / 2, size.z()});
    if (!office.taken.free(space)) continue;
    office.taken.add(space);
    return frame;
  }
  return std::nullopt;
}

void add_free_column(Office& office, Random& random) {
  const double wide = random.between(0.25, 0.7), deep = random.between(0.25, 0.7);
  const auto frame = free_place(office, random, {wide, deep, office.height}, 0);
  if (!frame) return;
  const std::string thing = office.name("column");
  const Brush brush = office.on(*frame);
  const auto face = [&] { return brush.object(ObjectClass::wall, thing, Material::paint); };
  const int left = face(), right = face(), rear = face(), front = face();
  brush.box({-wide / 2, -deep / 2, 0}, {wide / 2, deep / 2, office.height}, {.left = left, .right = right, .rear = rear, .front = front});
}

/// A wall that ends below the ceiling: panels of cloth or laminate, on feet or down to the floor.
void add_partition(Office& office, Random& random) {
  const double wide = random.between(0.8, 2.6), thick = random.between(0.03, 0.1), high = random.between(1.1, 2.1);
  const double foot = random.chance(0.5) ? 0.0 : random.between(0.02, 0.15), skew = random.chance(0.8) ? 0 : random.between(-0.6, 0.6);
  const auto frame = free_place(office, random, {wide, thick + 0.06, high}, skew);
  if (!frame) return;
  const std::string thing = office.name("partition");
  const Material material = random.pick({Material::fabric, Material::dark_fabric, Material::lacquer, Material::paint});
  const Brush brush = office.on(*frame);
  const int front = brush.object(ObjectClass::wall, thing, material), rear = brush.object(ObjectClass::wall, thing, material);
  const int edges = brush.clutter(thing + " edges", Material::metal);
  brush.box({-wide / 2, -thick / 2, foot}, {wide / 2, thick / 2, high}, {.rear = rear, .front = front, .others = edges});
  for (const double x : {-wide / 2 + 0.05, wide / 2 - 0.1}) {
    if (foot > 0) brush.box({x, -thick / 2 - 0.03, 0}, {x + 0.05, thick / 2 + 0.03, foot}, edges);
  }
}

}  // namespace

void divide(Office& office, std::uint64_t seed) {
  Random random(seed, 2000);
  const int columns = random.chance(0.6) ? random.integer(1, 3) : 0, partitions = random.chance(0.6) ? random.integer(1, 4) : 0;
  for (int i = 0; i < columns; ++i) add_free_column(office, random);
  for (int i = 0; i < partitions; ++i) add_partition(office, random);
}

}  // namespace scenelore::simulator
