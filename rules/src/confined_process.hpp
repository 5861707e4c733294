// A task in a child process that can write no file, start no program and use up only so much.
#pragma once

#include <functional>
#include <string>

#include "byte_stream.hpp"
#include "scenelore/rules/isolated.hpp"

namespace scenelore::rules {

/// What the task wrote. Throws Error with the message and traceback of an exception of the task, or with what ended the child.
[[nodiscard]] std::string in_confined_process(const Isolation& limits, const std::function<void(Writer&)>& task);

}  // namespace scenelore::rules
