#include "simulator/scene.hpp"

#include <array>
#include <utility>

namespace scenelore::simulator {

const char* name_of(ObjectClass object_class) {
  switch (object_class) {
    case ObjectClass::sofa: return "sofa";
    case ObjectClass::sofa_back: return "sofa_back";
    case ObjectClass::bed: return "bed";
    case ObjectClass::radiator: return "radiator";
    case ObjectClass::counter: return "counter";
    case ObjectClass::stove: return "stove";
    case ObjectClass::fridge: return "fridge";
    case ObjectClass::wall_cabinet: return "wall_cabinet";
    default: break;
  }
  static constexpr std::array names = {"unknown",     "floor",      "ceiling",    "wall",       "table",
                                       "flat_screen", "keyboard",   "chair_seat", "chair_back", "door",
                                       "window",      "whiteboard", "shelf",      "cabinet"};
  return names[static_cast<std::size_t>(object_class)];
}

// Estimates at the 905 nm of the lasers and the near infra-red of depth cameras, where most paints and papers are
// bright and plastics of screens and keyboards dark.
Reflectance reflectance(Material material) {
  switch (material) {
    case Material::paint:
      return {0.75, 0.0, 0};
    case Material::dark_paint:
      return {0.25, 0.0, 0};
    case Material::wood:
      return {0.55, 0.1, 0};
    case Material::dark_wood:
      return {0.25, 0.2, 0};
    case Material::lacquer:
      return {0.7, 0.4, 0};
    case Material::metal:
      return {0.45, 0.7, 0};
    case Material::black_plastic:
      return {0.1, 0.2, 0};
    case Material::screen:
      return {0.07, 0.75, 0};
    case Material::glass:
      return {0.06, 0.9, 0.92};
    case Material::fabric:
      return {0.4, 0, 0};
    case Material::dark_fabric:
      return {0.12, 0, 0};
    case Material::paper:
      return {0.8, 0.05, 0};
    case Material::leaf:
      return {0.5, 0.15, 0};
    case Material::skin:
      return {0.5, 0, 0};
  }
  return {0.5, 0, 0};
}

int Scene::add(Object object) {
  objects_.push_back(std::move(object));
  return static_cast<int>(objects_.size()) - 1;
}

void Scene::classify(const std::string& kind, ObjectClass object_class) {
  for (Object& object : objects_) {
    if (object.thing.starts_with(kind + " ")) object.object_class = object_class;
  }
}

void Scene::add(int object, Shape shape, bool counts, std::optional<Material> material) {
  if (object < 0) return;
  Object& owner = objects_[static_cast<std::size_t>(object)];
  shape.surface = object;
  shape.material = static_cast<int>(material.value_or(owner.material));
  if (counts) {
    owner.centroid = (owner.centroid * owner.area + shape.centroid * shape.area) / (owner.area + shape.area);
    owner.area += shape.area;
    if (owner.planar && owner.normal.isZero()) owner.normal = normal_at(shape, shape.a);
  }
  shapes_.push_back(std::move(shape));
}

Brush Brush::at(double x, double y, double z, double yaw) const {
  Brush child = *this;
  child.frame_.translate(Vector3d(x, y, z)).rotate(Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
  return child;
}

Brush Brush::of(Material material) const {
  Brush child = *this;
  child.material_ = material;
  return child;
}

Brush Brush::turned(double angle, const Vector3d& axis) const {
  Brush child = *this;
  child.frame_.rotate(Eigen::AngleAxisd(angle, axis));
  return child;
}

int Brush::object(ObjectClass object_class, const std::string& thing, Material material, bool planar) const {
  Object object;
  object.object_class = object_class;
  object.thing = thing;
  object.material = material;
  object.planar = planar;
  return scene_->add(std::move(object));
}

int Brush::clutter(const std::string& thing, Material material) const {
  return object(ObjectClass::unknown, thing, material, false);
}

void Brush::quad(int object, const Vector3d& corner, const Vector3d& u, const Vector3d& v, bool counts) const {
  scene_->add(object, make_quad(frame_ * corner, turn(u), turn(v)), counts, material_);
}

void Brush::triangle(int object, const Vector3d& corner, const Vector3d& u, const Vector3d& v) const {
  scene_->add(object, make_triangle(frame_ * corner, turn(u), turn(v)), true, material_);
}

void Brush::box(const Vector3d& low, const Vector3d& high, const Faces& faces) const {
  const Vector3d size = high - low, x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
  quad(faces.left.value_or(faces.others), low, z, y);
  quad(faces.right.value_or(faces.others), low + x, y, z);
  quad(faces.rear.value_or(faces.others), low, x, z);
  quad(faces.front.value_or(faces.others), low + y, z, x);
  quad(faces.bottom.value_or(faces.others), low, y, x);
  quad(faces.top.value_or(faces.others), low + z, x, y);
}

void Brush::crate(const std::string& thing, Material material, const Vector3d& low, const Vector3d& high) const {
  const auto face = [&] { return object(ObjectClass::unknown, thing, material); };
  const int left = face(), right = face(), rear = face(), front = face(), top = face();
  box(low, high, {.left = left, .right = right, .rear = rear, .front = front, .bottom = -1, .top = top});
}

void Brush::panel(int panel, int edges, const Vector3d& low, const Vector3d& high) const {
  box(low, high, {.rear = -1, .front = panel, .others = edges});
  const Vector3d size = high - low;
  quad(panel, low, Vector3d(size.x(), 0, 0), Vector3d(0, 0, size.z()), false);
}

void Brush::tube(int object, const Vector3d& base, const Vector3d& axis, double radius) const {
  arc(object, base, axis, radius, axis.unitOrthogonal(), 4);
}

void Brush::arc(int object, const Vector3d& base, const Vector3d& axis, double radius, const Vector3d& towards,
                double half_angle) const {
  scene_->add(object, make_cylinder(frame_ * base, turn(axis), radius, turn(towards), half_angle), true, material_);
}

void Brush::disc(int object, const Vector3d& centre, const Vector3d& normal, double radius) const {
  scene_->add(object, make_disc(frame_ * centre, turn(normal), radius), true, material_);
}

void Brush::ellipsoid(int object, const Vector3d& centre, const Vector3d& semi) const {
  scene_->add(object,
              make_ellipsoid(frame_ * centre, turn(Vector3d(semi.x(), 0, 0)), turn(Vector3d(0, semi.y(), 0)),
                             turn(Vector3d(0, 0, semi.z()))),
              true, material_);
}

}  // namespace scenelore::simulator
