// What the facts of a relation depend on, as a hash: the same inputs give the same facts.
#pragma once

#include <string>

#include "rule_file.hpp"

namespace scenelore::rules {

/// Of everything that Lua can see of the planes: ids, fields, features, outlines.
[[nodiscard]] std::string digest(const Scene& scene);

/// Of a relation's text and the settings for it, the planes (their digest) and the program that answers it.
[[nodiscard]] std::string fact_inputs(const RuleSource& relation, const Overrides& settings, const std::string& planes);

}  // namespace scenelore::rules
