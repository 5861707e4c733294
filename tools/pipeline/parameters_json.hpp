#pragma once

#include <string>

#include "scenelore/perception/perceive.hpp"

namespace scenelore::pipeline {

/// What `scan.parameters` holds: the five parameters as used, spacing and noise found, how the upright frame was found.
[[nodiscard]] std::string parameters_json(const perception::Perception& perception);

}  // namespace scenelore::pipeline
