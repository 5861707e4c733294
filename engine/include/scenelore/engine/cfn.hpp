// Problems as files for toulbar2, to compare answers.
#pragma once

#include <iosfwd>

#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {

/// Writes the problem as a toulbar2 cost function network; costs with six decimals. Variables and labels keep their names
/// when they differ from each other, with _ for all but letters, digits, points and dashes; requirement c adds a variable "supporter<c>" (none, or one of the supports) and
/// cardinality c variables "count<c>_<i>", so that functions have at most three variables. The problem's variables come
/// first, in order. `toulbar2 FILE -s=3` shows the labels.
void write_cfn(const Problem& problem, std::ostream& out);

}  // namespace scenelore::engine
