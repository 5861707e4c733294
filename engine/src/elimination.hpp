// Exact marginals by variable elimination, where the tables stay small.
#pragma once

#include <optional>
#include <vector>

#include "network.hpp"
#include "scale.hpp"

namespace scenelore::engine {

/// Probability of each label of each variable under exp(−cost); nothing when a table of more than `most` tuples would
/// be needed, or when no assignment is allowed.
std::optional<std::vector<std::vector<double>>> eliminate(const Network& network, const Scale& scale, std::size_t most);

}  // namespace scenelore::engine
