#include "lua_files.hpp"

#include <string>

#include "scenelore/rules/error.hpp"

namespace scenelore::rules {

std::string_view embedded(std::string_view name) {
  for (const EmbeddedFile& file : lua_files()) {
    if (file.name == name) return file.text;
  }
  throw Error("no text named " + std::string(name) + " is compiled in");
}

}  // namespace scenelore::rules
