// The Lua texts that are compiled in: prelude, built-in relations and features, their tests.
#pragma once

#include <span>
#include <string_view>

#include "scenelore/embedded_file.hpp"

namespace scenelore::rules {

/// All of them, in the order of CMakeLists.txt.
std::span<const EmbeddedFile> lua_files();

/// One by its name; a name that is not there is a bug.
std::string_view embedded(std::string_view name);

}  // namespace scenelore::rules
