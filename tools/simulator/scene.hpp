// A room as surfaces that belong to objects, and the brush furniture is drawn with.
//
//   Brush desk = room.at(x, y, 0, yaw);                       // its own frame: x right, y towards the user, z up
//   int top = desk.object(ObjectClass::table, "desk 1", Material::wood);
//   desk.box({-0.8, -0.4, 0.70}, {0.8, 0.4, 0.73}, {.top = top, .others = edges});
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulator/shape.hpp"

namespace scenelore::simulator {

/// Values are the class ids of docs/classes.md and of the packs in schemas/knowledge.
enum class ObjectClass {
  unknown,
  floor,
  ceiling,
  wall,
  table,
  flat_screen,
  keyboard,
  chair_seat,
  chair_back,
  door,
  window,
  whiteboard,
  shelf,
  cabinet,
  // of the knowledge packs home and kitchen
  sofa = 40,
  sofa_back,
  bed,
  radiator,
  counter = 50,
  stove,
  fridge,
  wall_cabinet
};
[[nodiscard]] const char* name_of(ObjectClass object_class);

enum class Material {
  paint,
  dark_paint,
  wood,
  dark_wood,
  lacquer,
  metal,
  black_plastic,
  screen,
  glass,
  fabric,
  dark_fabric,
  paper,
  leaf,
  skin
};

/// How a surface answers light: share sent back evenly, share mirrored, share let through.
struct Reflectance {
  double diffuse, gloss, transmission;
};
[[nodiscard]] Reflectance reflectance(Material material);

/// One planar face or curved thing; what the ground truth is about.
struct Object {
  ObjectClass object_class = ObjectClass::unknown;
  std::string thing;
  Material material = Material::paint;
  bool planar = true;
  Vector3d centroid = Vector3d::Zero(), normal = Vector3d::Zero();
  double area = 0;
};

class Scene {
 public:
  /// Returns the index of the new object; its instance number is one more.
  int add(Object object);
  /// Objects of this kind of thing ("radiator 2" is a "radiator") become that class.
  void classify(const std::string& kind, ObjectClass object_class);
  /// A shape of the object; `counts` tells whether it enters area, centroid and normal (the rear of a panel does not).
  /// Its material is the object's, unless told otherwise.
  void add(int object, Shape shape, bool counts = true, std::optional<Material> material = {});

  [[nodiscard]] const std::vector<Object>& objects() const { return objects_; }
  [[nodiscard]] const std::vector<Shape>& shapes() const { return shapes_; }

 private:
  std::vector<Object> objects_;
  std::vector<Shape> shapes_;
};

/// Which object the faces of a box belong to; -1 leaves a face out, `others` serves the faces not named.
struct Faces {
  std::optional<int> left, right, rear, front, bottom, top;  // -x, +x, -y, +y, -z, +z
  int others = -1;
};

class Brush {
 public:
  Brush(Scene& scene, const Eigen::Isometry3d& frame) : scene_(&scene), frame_(frame) {}

  [[nodiscard]] Brush at(double x, double y, double z, double yaw = 0) const;
  /// The same brush, drawing shapes of this material whatever their object's is.
  [[nodiscard]] Brush of(Material material) const;
  [[nodiscard]] Brush turned(double angle, const Vector3d& axis) const;
  [[nodiscard]] const Eigen::Isometry3d& frame() const { return frame_; }

  int object(ObjectClass object_class, const std::string& thing, Material material, bool planar = true) const;
  /// An object of class unknown that is no plane: legs, edges, clutter.
  int clutter(const std::string& thing, Material material) const;

  void quad(int object, const Vector3d& corner, const Vector3d& u, const Vector3d& v, bool counts = true) const;
  void triangle(int object, const Vector3d& corner, const Vector3d& u, const Vector3d& v) const;
  void box(const Vector3d& low, const Vector3d& high, const Faces& faces) const;
  /// A box whose six faces are one object.
  void box(const Vector3d& low, const Vector3d& high, int object) const { box(low, high, Faces{.others = object}); }
  /// A box of class unknown, each of its faces (but the bottom) an object.
  void crate(const std::string& thing, Material material, const Vector3d& low, const Vector3d& high) const;
  /// A thin panel: both large faces (±y) belong to `panel`, whose plane is the front; the narrow ones to `edges`.
  void panel(int panel, int edges, const Vector3d& low, const Vector3d& high) const;
  void tube(int object, const Vector3d& base, const Vector3d& axis, double radius) const;
  void arc(int object, const Vector3d& base, const Vector3d& axis, double radius, const Vector3d& towards,
           double half_angle) const;
  void disc(int object, const Vector3d& centre, const Vector3d& normal, double radius) const;
  void ellipsoid(int object, const Vector3d& centre, const Vector3d& semi_axes) const;

 private:
  [[nodiscard]] Vector3d turn(const Vector3d& v) const { return frame_.linear() * v; }
  Scene* scene_;
  Eigen::Isometry3d frame_;
  std::optional<Material> material_;
};

}  // namespace scenelore::simulator
