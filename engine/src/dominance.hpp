// Labels that are in no assignment of least cost, since another label of the variable can take their place in every one and
// makes it cheaper: dead-end elimination (Desmet, De Maeyer, Hazes, Lasters, Nature 1992; Goldstein, Biophysical Journal
// 1994, equation 6; for weighted constraints de Givry, Prestwich, O'Sullivan, CP 2013), extended from tables of two variables
// to requirements and cardinalities.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "residual.hpp"

namespace scenelore::engine {

/// Variables and labels of the network, in ascending order. All of them may go at once, and no assignment of least cost goes
/// with them, not even one of several: what takes their place is strictly cheaper. A variable keeps a label, unless there is
/// no assignment. `most_work`: how often a function is asked about two labels; what is left then stays.
std::vector<std::pair<int, int>> dominated_labels(const Residual& residual, std::int64_t most_work);

}  // namespace scenelore::engine
