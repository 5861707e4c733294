// Problems from files: toulbar2's .cfn and .wcsp, and .uai (MAP), so that public instances can be solved.
#pragma once

#include <iosfwd>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {

enum class FileFormat { cfn, wcsp, uai };

/// A variable of a file that follows from others: the support that a requirement uses, or a count. All variables are those
/// of the file.
struct Follower {
  struct Choice {
    int label;
    Literal when;
    double cost;
  };
  int variable = -1;
  // A count, when `counted` says what of; else a support:
  Literal owner{};
  int idle = 0;                  ///< the label when the owner does not hold
  int otherwise = 0;             ///< the label when no choice that holds is cheaper than `weight`
  double weight = 0;
  std::vector<Choice> choices{};
  int before = -1;               ///< a count: the one that goes on, −1 = none
  std::optional<std::vector<Literal>> counted{};
};

/// What a file says. Variables by which it says "a needs one of these" or "at most so many of these" (as write_cfn()
/// does) are not in the problem, which has the requirement or cardinality instead.
struct ProblemFile {
  struct FileVariable {
    std::string name;
    std::vector<std::string> labels;
    int in_problem;  ///< −1: it follows from others
  };
  Problem problem;                     ///< variables after those of the file stand for functions of three and more
                                       ///< variables: one variable each, whose labels are the tuples that are allowed
  std::vector<FileVariable> variables; ///< in the order of the file
  std::vector<Follower> followers;     ///< each after those that it follows from
  double constant = 0;                 ///< costs are shifted so that none is negative
  double below = std::numeric_limits<double>::infinity();  ///< for the problem: only worlds cheaper than this count
  bool maximised = false;                                  ///< a .cfn whose best world is that of greatest value

  /// The cost of a world in the file's own terms.
  double in_file(double cost) const { return maximised ? -(cost + constant) : cost + constant; }
  /// The label of each variable of the file, from those of the problem.
  std::vector<int> in_file(const std::vector<int>& assignment) const;
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
