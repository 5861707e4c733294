// The empty room.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/office.hpp"

namespace scenelore::simulator {
namespace {

constexpr double kPi = std::numbers::pi;

Wall wall_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  Wall wall;
  const Eigen::Vector2d along = to - from;
  wall.length = along.norm();
  wall.frame = Eigen::Translation3d(from.x(), from.y(), 0) *
               Eigen::AngleAxisd(std::atan2(along.y(), along.x()), Vector3d::UnitZ());
  return wall;
}

// A wall is one object of several rectangles: the cells of the grid that its openings' edges make, less the openings.
void draw_wall(Office& office, const Wall& wall) {
  const Brush brush = office.on(wall.frame);
  const int object = brush.object(ObjectClass::wall, office.name("wall"), Material::paint);
  std::vector<double> xs{0, wall.length}, zs{0, office.height};
  for (const Opening& o : wall.openings) {
    xs.insert(xs.end(), {o.left, o.right});
    zs.insert(zs.end(), {o.bottom, o.top});
  }
  for (std::vector<double>* cuts : {&xs, &zs}) {
    std::ranges::sort(*cuts);
    cuts->erase(std::unique(cuts->begin(), cuts->end()), cuts->end());
  }
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < zs.size(); ++j) {
      const double x = (xs[i] + xs[i + 1]) / 2, z = (zs[j] + zs[j + 1]) / 2;
      const bool open = std::ranges::any_of(
          wall.openings, [&](const Opening& o) { return x > o.left && x < o.right && z > o.bottom && z < o.top; });
      if (!open) brush.quad(object, {xs[i], 0, zs[j]}, {0, 0, zs[j + 1] - zs[j]}, {xs[i + 1] - xs[i], 0, 0});
    }
  }
}

// The sides of an opening, `depth` into the wall.
void draw_reveal(const Brush& brush, const Opening& o, double depth, const std::string& thing, bool with_bottom) {
  const int sides = brush.clutter(thing, Material::paint);
  const Vector3d in(0, -depth, 0), across(o.right - o.left, 0, 0), up(0, 0, o.top - o.bottom);
  brush.quad(sides, {o.left, 0, o.bottom}, in, up);
  brush.quad(sides, {o.right, 0, o.bottom}, up, in);
  brush.quad(sides, {o.left, 0, o.top}, in, across);
  if (with_bottom)
    brush.quad(brush.object(ObjectClass::unknown, thing + " sill", Material::lacquer), {o.left, 0, o.bottom}, across,
               in);
}

// What an open door lets see.
void draw_corridor(Office& office, const Brush& brush, double middle) {
  const double reach = 2.5, deep = office.random.between(1.4, 2.2), high = 2.5;
  const Vector3d corner(middle - reach, -0.12, 0), across(2 * reach, 0, 0), in(0, -deep, 0), up(0, 0, high);
  brush.quad(brush.object(ObjectClass::floor, "corridor floor", Material::dark_paint), corner, in, across);
  brush.quad(brush.object(ObjectClass::wall, "corridor wall", Material::paint), corner + in, up, across);
  brush.quad(brush.object(ObjectClass::ceiling, "corridor ceiling", Material::paint), corner + up, across, in);
}

void draw_leaf(Office& office, const Brush& brush, double from, double to, double top, Material material) {
  const std::string thing = office.name("door");
  const int leaf = brush.object(ObjectClass::door, thing, material),
            rest = brush.clutter(thing + " handle", Material::metal);
  const double low = std::min(from, to), high = std::max(from, to), handle = to + (from > to ? 0.08 : -0.08);
  brush.panel(leaf, rest, {low, -0.04, 0.005}, {high, 0, top});
  brush.box({handle - 0.06, 0, 1.04}, {handle + 0.06, 0.05, 1.06}, rest);
}

void add_door(Office& office, Wall& wall) {
  Random& random = office.random;
  const double width = random.between(0.82, 0.98), top = random.between(1.98, 2.12);
  const double left = random.chance(0.6) ? random.between(0.15, 0.5) : random.between(0.15, wall.length - width - 0.15);
  const Opening o{left, std::min(left + width, wall.length - 0.1), 0, top};
  const Brush brush = office.on(wall.frame);
  const bool open = random.chance(0.35);
  const double recess = random.chance(0.35) ? 0.004 : random.between(0.02, 0.1);
  draw_reveal(brush, o, open ? 0.12 : recess, "door reveal", false);
  const int frame = brush.clutter("door frame", Material::lacquer);
  for (const double x : {o.left - 0.06, o.right}) brush.box({x, 0, 0}, {x + 0.06, 0.012, o.top + 0.06}, frame);
  brush.box({o.left, 0, o.top}, {o.right, 0.012, o.top + 0.06}, frame);
  const double angle = open ? random.between(15, 100) * kPi / 180 : 0;
  const Material material = random.pick({Material::wood, Material::lacquer, Material::dark_wood});
  if (random.chance(0.5)) {
    draw_leaf(office, brush.at(o.left, -recess, 0, angle), 0, o.right - o.left, o.top - 0.01, material);
  } else {
    draw_leaf(office, brush.at(o.right, -recess, 0, -angle), 0, o.left - o.right, o.top - 0.01, material);
  }
  if (open) draw_corridor(office, brush, (o.left + o.right) / 2);
  wall.openings.push_back(o);
  wall.door = true;
  office.taken.add(volume(wall.frame, {o.left - 0.2, -0.2, 0}, {o.right + 0.2, width + 0.1, 2.15}));
}

void add_radiator(Office& office, const Brush& brush, double left, double right, double top) {
  const std::string thing = office.name("radiator");
  if (office.random.chance(0.5)) {
    brush.crate(thing, Material::lacquer, {left, 0.04, 0.12}, {right, 0.12, top});
    return;
  }
  const int fins = brush.clutter(thing, Material::lacquer);
  for (double x = left; x + 0.045 < right; x += 0.07) brush.box({x, 0.04, 0.12}, {x + 0.045, 0.14, top}, fins);
}

void add_window(Office& office, Wall& wall, const Opening& o, double niche, bool radiator) {
  Random& random = office.random;
  const Brush brush = office.on(wall.frame).at(0, -niche, 0);
  const std::string thing = office.name("window");
  if (niche > 0.01) draw_reveal(office.on(wall.frame), o, niche, thing + " niche", true);
  // Frame bars and pane are one window; the pane lies 15 mm behind the bars.
  const int window = brush.object(ObjectClass::window, thing, Material::lacquer);
  const double bar = random.between(0.05, 0.1);
  const int wings = o.right - o.left > 1.1 ? 2 : 1;
  const Vector3d up(0, 0, o.top - o.bottom), across(o.right - o.left, 0, 0);
  for (int i = 0; i <= wings; ++i) {
    const double x = o.left + (o.right - o.left - bar) * i / wings;
    brush.quad(window, {x, 0, o.bottom}, up, {bar, 0, 0}, false);
  }
  for (const double z : {o.bottom, o.top - bar}) brush.quad(window, {o.left, 0, z}, {0, 0, bar}, across, false);
  brush.of(Material::glass).quad(window, {o.left, -0.015, o.bottom}, up, across);
  if (random.chance(0.3)) {  // a roller blind, part of the way down
    const double drop = random.between(0.2, 1.0) * (o.top - o.bottom);
    brush.quad(brush.object(ObjectClass::window, thing + " blind", Material::fabric),
               {o.left + 0.03, 0.02, o.top - drop}, {0, 0, drop}, across - Vector3d(0.06, 0, 0));
  }
  if (radiator) {
    add_radiator(office, office.on(wall.frame), o.left + 0.05, o.right - 0.05, o.bottom - random.between(0.08, 0.2));
    office.taken.add(volume(wall.frame, {o.left, 0, 0}, {o.right, 0.16, o.bottom - 0.05}));
  }
  wall.openings.push_back(o);
  office.taken.add(volume(wall.frame, {o.left - 0.05, -0.3, o.bottom}, {o.right + 0.05, 0.03, o.top}));
  office.zones.add(volume(wall.frame, {o.left, 0, o.bottom}, {o.right, 0.5, o.top}));
}

void add_windows(Office& office, Wall& wall) {
  Random& random = office.random;
  const double sill = random.between(0.82, 1.0), top = std::min(office.height - 0.25, random.between(1.9, 2.4));
  const double niche = random.chance(0.3) ? 0.0 : random.between(0.05, 0.28), wide = random.between(0.9, 1.7);
  const int count = std::clamp(static_cast<int>((wall.length - 0.4) / (wide + 0.3)), 1, 3);
  const bool radiator = random.chance(0.7);
  const double share = wall.length / count;
  for (int i = 0; i < count; ++i) {
    const double left = share * i + (share - std::min(wide, share - 0.3)) / 2;
    add_window(office, wall, {left, left + std::min(wide, share - 0.3), sill, top}, niche, radiator);
  }
  wall.window = true;
}

void draw_outside(Office& office, const Wall& wall) {
  const double away = office.random.between(7, 22), wide = office.random.between(10, 30);
  const Brush brush = office.on(wall.frame);
  brush.quad(brush.object(ObjectClass::unknown, "building opposite", Material::paint),
             {wall.length / 2 - 15, -away, -4}, {0, 0, 14}, {wide, 0, 0});
}

void add_column(Office& office) {
  Random& random = office.random;
  const Wall& wall =
      office.walls[static_cast<std::size_t>(random.integer(0, static_cast<int>(office.walls.size()) - 1))];
  const double side = random.between(0.3, 0.55), gap = random.chance(0.6) ? 0.0 : random.between(0.8, 1.2);
  if (wall.length < 2.5) return;
  const double x = random.between(0.4, wall.length - 0.4 - side);
  const Vector3d low(x, gap, 0), high(x + side, gap + side, office.height);
  const Volume space = volume(wall.frame, low - Vector3d(0.1, 0, 0), high + Vector3d(0.1, 0.1, 0));
  if (!office.free_for_furniture(space)) return;
  const Brush brush = office.on(wall.frame);
  const std::string thing = office.name("column");
  const auto face = [&] { return brush.object(ObjectClass::wall, thing, Material::paint); };
  const int left = face(), right = face(), front = face(), rear = gap > 0 ? face() : -1;
  brush.box(low, high, {.left = left, .right = right, .rear = rear, .front = front, .others = -1});
  office.taken.add(volume(wall.frame, low, high));
}

// A strip of ceiling along one wall hangs lower.
void draw_soffit(Office& office, const Brush& brush) {
  Random& random = office.random;
  const double low = office.height - random.between(0.15, 0.45), deep = random.between(0.4, 1.5);
  if (low < 2.2) return;
  const std::string thing = office.name("soffit");
  const int under = brush.object(ObjectClass::ceiling, thing, Material::paint),
            front = brush.object(ObjectClass::unknown, thing + " front", Material::paint);
  brush.box({0, 0, low}, {office.width, deep, office.height}, {.left = -1, .right = -1, .rear = -1, .front = front, .bottom = under, .top = -1});
}

void draw_floor_and_ceiling(Office& office, double notch_x, double notch_y) {
  const Brush brush = office.room();
  const int floor = brush.object(ObjectClass::floor, "floor",
                                 office.random.pick({Material::paint, Material::dark_paint, Material::wood}));
  const int ceiling = brush.object(ObjectClass::ceiling, "ceiling", Material::paint);
  const auto slab = [&](double x0, double y0, double x1, double y1) {
    brush.quad(floor, {x0, y0, 0}, {x1 - x0, 0, 0}, {0, y1 - y0, 0});
    brush.quad(ceiling, {x0, y0, office.height}, {0, y1 - y0, 0}, {x1 - x0, 0, 0});
  };
  slab(0, 0, office.width, office.depth - notch_y);
  if (office.varied && office.random.chance(0.3)) draw_soffit(office, brush);
  if (notch_y > 0) slab(0, office.depth - notch_y, office.width - notch_x, office.depth);
}

void draw_lamps(Office& office) {
  Random& random = office.random;
  const bool recessed = random.chance(0.3);
  const double drop = random.between(0.02, 0.5), below = std::min(drop, office.height - 2.25),
               length = random.between(1.1, 1.6), step = random.between(1.6, 2.4);
  for (double y = step / 2; y + 0.2 < office.depth; y += step) {
    for (double x = step / 2; x + length < office.width && !recessed; x += length + step / 2) {
      const Brush brush = office.room();
      const double top = office.height - below;
      const Volume space = volume(brush.frame(), {x, y - 0.1, top - 0.4}, {x + length, y + 0.1, top});
      if (!office.taken.free(space)) continue;
      office.taken.add(space);
      const std::string thing = office.name("lamp");
      const int sides = brush.clutter(thing, Material::lacquer),
                under = brush.object(ObjectClass::unknown, thing, Material::paint);
      brush.box({x, y - 0.1, top - 0.08}, {x + length, y + 0.1, top}, {.bottom = under, .others = sides});
    }
  }
}

}  // namespace

Office build_shell(std::uint64_t seed, const Inventory& inventory, double enlarge, bool varied) {
  Random random(seed, 1);
  const double area = (8 + 5 * std::max(1, inventory.tables)) * random.between(0.9, 1.3) * enlarge;
  const double aspect = random.between(0.85, 1.6), width = std::sqrt(area * aspect);
  const double height = varied ? random.between(2.3, 3.9) : random.between(2.45, 3.1);
  Office office(random.next(), width, area / width, height);
  office.varied = varied;
  const bool notched = random.chance(0.35);
  const double notch_x = notched ? office.width * random.between(0.15, 0.4) : 0,
               notch_y = notched ? office.depth * random.between(0.15, 0.35) : 0;
  std::vector<Eigen::Vector2d> corners{{0, 0}, {office.width, 0}, {office.width, office.depth - notch_y}};
  if (notched)
    corners.insert(corners.end(),
                   {{office.width - notch_x, office.depth - notch_y}, {office.width - notch_x, office.depth}});
  corners.emplace_back(0, office.depth);
  for (std::size_t i = 0; i < corners.size(); ++i)
    office.walls.push_back(wall_between(corners[i], corners[(i + 1) % corners.size()]));
  if (notched) {
    office.taken.add(volume(Eigen::Isometry3d::Identity(), {office.width - notch_x, office.depth - notch_y, 0},
                            {office.width, office.depth, office.height}));
  }
  // The door is opposite the windows or on a wall beside them.
  const int window_wall = random.integer(0, 1),
            door_wall = random.chance(0.6) ? static_cast<int>(office.walls.size()) - 1 : 1 - window_wall;
  add_door(office, office.walls[static_cast<std::size_t>(door_wall)]);
  Wall& lit = office.walls[static_cast<std::size_t>(window_wall)];
  add_windows(office, lit);
  if (random.chance(0.6)) draw_outside(office, lit);
  if (random.chance(0.25)) add_column(office);
  draw_floor_and_ceiling(office, notch_x, notch_y);
  for (const Wall& wall : office.walls) draw_wall(office, wall);
  draw_lamps(office);
  return office;
}

}  // namespace scenelore::simulator
