#pragma once

#include <string>

#include "scenelore/kb/knowledge.hpp"

namespace scenelore::kb {

/// Statements that bring back priors, weights of features and constraint rows, Gaussians and densities as they are here, to the last
/// bit, in a knowledge base where any of them have changed. Classes, features and rows that are not here are left alone.
[[nodiscard]] std::string snapshot_sql(const Knowledge& knowledge);

}  // namespace scenelore::kb
