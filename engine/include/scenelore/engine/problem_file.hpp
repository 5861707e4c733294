// Problems from files: toulbar2's .cfn and .wcsp, and .uai (MAP), so that public instances can be solved.
#pragma once

#include <iosfwd>
#include <limits>
#include <string>

#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {

enum class FileFormat { cfn, wcsp, uai };

/// What a file says. The cost of a world in the file's own terms is `in_file(cost of the assignment)`.
struct ProblemFile {
  Problem problem;
  int variables = 0;    ///< the first ones are those of the file, in its order; what follows stands for functions of three
                        ///< and more variables: one variable each, whose labels are the tuples that are allowed
  double constant = 0;  ///< costs are shifted so that none is negative
  double below = std::numeric_limits<double>::infinity();  ///< for the problem: only worlds cheaper than this count
  bool maximised = false;                                  ///< a .cfn whose best world is that of greatest value

  double in_file(double cost) const { return maximised ? -(cost + constant) : cost + constant; }
};

/// `name` is for error messages. Throws FileError naming file, line and what was expected there.
///   .cfn   variables with labels or a number of labels; functions as full or sparse tables, or naming a function whose costs
///          they share; `mustbe` "<x" or ">x". Other global functions are refused by name.
///   .wcsp  tables, shared ones too; global functions are refused by name.
///   .uai   MARKOV and BAYES; the cost of a world is −ln of the product of its factors, not normalised.
ProblemFile read_problem(std::istream& in, const std::string& name, FileFormat format);

/// The format goes by the ending. Throws FileError when the file cannot be opened or has another ending.
ProblemFile read_problem_file(const std::string& path);

}  // namespace scenelore::engine
