// For the verifier of certificates: a part of a problem as a sum of terms in whole numbers, and the least value of each
// one. Knows nothing of the search; read word by word from problem.hpp.
#pragma once

#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cost.hpp"
#include "scale.hpp"
#include "scenelore/engine/problem.hpp"

namespace scenelore::engine::exact {

/// Why a certificate is not accepted.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A world that must not be. Apart from it, amounts are whole numbers that add up without rounding.
inline constexpr Cost kNever = std::numeric_limits<Cost>::max();

/// Throws: Refused when the sum is beyond 63 bits.
Cost plus(Cost a, Cost b);
Cost minus(Cost a, Cost b);  ///< b is not kNever

/// The labels that variables may still have; one of the variables may be looked at with one label alone.
class Choice {
 public:
  explicit Choice(const std::vector<std::vector<char>>& live, Literal only = {-1, -1}) : live_(live), only_(only) {}
  /// Labels [first, last) of a variable are to be looked at.
  int first(int v) const { return v == only_.variable ? only_.label : 0; }
  int last(int v, int labels) const { return v == only_.variable ? only_.label + 1 : labels; }
  bool allows(int v, int label) const {
    return (v != only_.variable || label == only_.label) &&
           live_[static_cast<std::size_t>(v)][static_cast<std::size_t>(label)] != 0;
  }

 private:
  const std::vector<std::vector<char>>& live_;
  Literal only_;
};

/// A function of some variables, less what has been moved to their labels.
class Term {
 public:
  Term(const Problem& problem, std::vector<int> scope);
  virtual ~Term() = default;
  /// Least value over all worlds of the choice; kNever when there is none.
  virtual Cost least(const Choice& choice) const = 0;

  const std::vector<int>& scope() const { return scope_; }  ///< ascending
  /// What has been moved to a label; nullptr when the variable is not in the scope.
  Cost* moved(int v, int label);

 protected:
  std::size_t place(int v) const;
  Cost moved_at(std::size_t place, int label) const { return moved_[place][static_cast<std::size_t>(label)]; }
  int labels(std::size_t place) const { return static_cast<int>(moved_[place].size()); }

 private:
  std::vector<int> scope_;
  std::vector<std::vector<Cost>> moved_;
};

/// The term of a constraint of many variables; nullptr for a conflict or pair table. Literals whose label is not live
/// take no part.
std::unique_ptr<Term> make_term(const Problem& problem, const Scale& scale, const ConstraintView& constraint,
                                const std::vector<std::vector<char>>& live);

/// Costs of the pairs of labels of two variables.
class PairTerm : public Term {
 public:
  PairTerm(const Problem& problem, int x, int y);
  void add(const Problem& problem, const Scale& scale, const ConstraintView& constraint);
  Cost least(const Choice& choice) const override;

 private:
  std::vector<Cost> costs_;  ///< row-major by x
};

/// The labels of one variable. What is moved to them from other terms is moved away from here with the other sign.
class LabelTerm : public Term {
 public:
  LabelTerm(const Problem& problem, const Scale& scale, int v);
  void charge(int label, Cost cost);
  Cost least(const Choice& choice) const override;

 private:
  std::vector<Cost> costs_;
};

}  // namespace scenelore::engine::exact
