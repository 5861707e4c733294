// Cost functions of two and three variables can say what a requirement or a cardinality says, by variables of their own:
// one that names the support, or a chain of counters (cfn_writer.cpp writes them so). Here these are found again: costs
// that a search cannot see through become constraints that it knows, and each such variable follows from the others.
#pragma once

#include <string>
#include <vector>

#include "scenelore/engine/problem.hpp"
#include "scenelore/engine/problem_file.hpp"

namespace scenelore::engine {

/// A cost function of a file: one cost a tuple, the last variable running fastest; none below 0.
struct FileFunction {
  std::string name;
  std::vector<int> scope;
  std::vector<double> costs;
};

/// What the auxiliary variables stand for; all literals are those of the file's variables.
struct Auxiliaries {
  std::vector<Follower> followers;         ///< each after those that it follows from
  std::vector<Constraint> constraints;     ///< requirements and cardinalities
  std::vector<std::pair<Literal, double>> charges;  ///< costs that one label has to bear
  std::vector<char> gone;                  ///< by function: said by one of these
  double constant = 0;
};

Auxiliaries find_auxiliaries(const std::vector<Variable>& variables, const std::vector<FileFunction>& functions);

}  // namespace scenelore::engine
