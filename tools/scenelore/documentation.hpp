#pragma once

#include <memory>
#include <string>
#include <vector>

#include "command.hpp"

namespace scenelore::tools {

/// docs/cli.md, made from the commands' own argument tables (`scenelore --documentation`).
[[nodiscard]] std::string documentation(const std::vector<std::unique_ptr<Command>>& commands);

/// Each line of `text` moved right by two spaces.
[[nodiscard]] std::string indented(const std::string& text);

}  // namespace scenelore::tools
