// A text file compiled into the executable (cmake/embed.cmake).
#pragma once

#include <string_view>

namespace scenelore {

struct EmbeddedFile {
  std::string_view name;  ///< path relative to the project, e.g. "rules/relations/above.lua"
  std::string_view text;  ///< the whole file
};

}  // namespace scenelore
