// From cost functions of any number of variables, with costs of either sign, to a Problem.
#pragma once

#include <string>
#include <vector>

#include "auxiliary.hpp"
#include "scenelore/engine/problem_file.hpp"

namespace scenelore::engine {

class FileBuilder {
 public:
  /// Costs from `top` on stand for "forbidden".
  void set_top(double top) { top_ = top; }
  void add_variable(std::string name, std::vector<std::string> labels);
  int variables() const { return static_cast<int>(variables_.size()); }
  const std::vector<std::string>& labels(int v) const { return variables_[static_cast<std::size_t>(v)].labels; }
  /// Entries of a full table over the scope; more than kMostTuples = too many.
  static constexpr std::size_t kMostTuples = std::size_t{1} << 22;
  std::size_t tuples(const std::vector<int>& scope) const;
  /// One cost a tuple, the last variable running fastest. Variables of the scope differ.
  void add_function(const std::string& name, const std::vector<int>& scope, std::vector<double> costs);
  /// The problem; worlds that cost `top` or more are not wanted.
  ProblemFile finish();

 private:
  void add_found(Constraint& constraint);
  void add_pair(FileFunction& function);  ///< takes its costs
  void add_many(const FileFunction& function);

  double top_ = kHard;
  double constant_ = 0;
  std::vector<Variable> variables_;
  std::vector<FileFunction> functions_;  ///< of two and more variables
  Problem problem_;
  std::vector<int> in_problem_;  ///< of each variable; −1 = it follows from others
};

}  // namespace scenelore::engine
