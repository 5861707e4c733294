// Problems as files: written for toulbar2 (.cfn), and read back or from other sources (.cfn, .wcsp, .uai).
#pragma once

#include <iosfwd>
#include <string>

#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {

/// Writes the problem as a toulbar2 cost function network; costs with six decimals. Variables keep their names when they
/// differ from each other; requirement c adds a variable "supporter<c>" (none, or one of the supports) and cardinality c
/// variables "count<c>_<i>", so that functions have at most three variables. The problem's variables come first, in order.
/// `toulbar2 FILE -s=3` shows the labels. Throws Error when a name holds a quote or backslash.
void write_cfn(const Problem& problem, std::ostream& out);

/// Reads table functions of any number of variables (more than two become an extra variable, whose labels are the tuples);
/// costs from "mustbe" on are infinite. Throws Error naming the place: bad syntax, unknown names, negative costs,
/// global cost functions, a function of more than a million tuples.
Problem read_cfn(std::istream& in);

/// toulbar2's and WCSPLIB's classical format; costs from the upper bound on are infinite.
Problem read_wcsp(std::istream& in);

/// A MARKOV or BAYES network: costs are −ln of the factors, each shifted so that its least is 0. `constant`, when given,
/// receives what was shifted away: −ln of the product = cost + constant.
Problem read_uai(std::istream& in, double* constant = nullptr);

}  // namespace scenelore::engine
