// What rule files see of the world, each thing once: the host registers from this table, and the reference, the editor's
// files and luacheck's are written from it.
#pragma once

#include <lua.hpp>

#include <span>

#include "scenelore/perception/plane.hpp"

namespace scenelore::rules {

struct PlaneField {
  const char* name;
  double (*value)(const perception::Plane& plane);
  const char* text;
};
[[nodiscard]] std::span<const PlaneField> plane_field_table();

/// A function of the table `geometry`, over two planes.
struct GeometryFunction {
  const char* name;
  lua_CFunction function;
  const char* further;  ///< parameters after a and b with their types, "" = none
  const char* text;     ///< begins with the unit
};
[[nodiscard]] std::span<const GeometryFunction> geometry_table();

}  // namespace scenelore::rules
