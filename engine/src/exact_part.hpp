// For the verifier of certificates: the terms of some variables, with the sum of their least values kept up to date.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "exact_terms.hpp"

namespace scenelore::engine::exact {

/// Which constraints each variable is in; a requirement is with its owner alone.
std::vector<std::vector<int>> constraints_of(const Problem& problem);

class Part {
 public:
  /// The variables with those of their labels that `live` leaves them, and all constraints that depend on some of them
  /// and on no other variable; none costs less than 0, so leaving one out raises no bound. The part works in the rows of
  /// `live` that are its variables'.
  Part(const Problem& problem, const Scale& scale, const std::vector<std::vector<int>>& constraints_of,
       std::vector<std::vector<char>>& live, const std::vector<int>& variables);

  /// `amount` in all has been moved from a function to a label. Throws: Refused when there is no such function or label.
  void move_from_pair(int x, int y, Literal to, Cost amount);
  void move_from_constraint(int constraint, Literal to, Cost amount);
  /// No world is cheaper. Looks no further when that is `enough`.
  Cost least(Cost enough = kNever) { return least({-1, -1}, enough); }
  /// No world with the literal is cheaper. {−1, −1} = any world.
  Cost least(Literal literal, Cost enough);
  bool is_live(Literal literal) const;
  void remove(Literal literal);

  /// Everything since the mark is undone by undo(mark).
  std::size_t mark() const { return trail_.size(); }
  void undo(std::size_t mark);

 private:
  struct Step {
    int term;  ///< −1: a label was removed
    Literal literal;
    Cost before;
  };
  void add(std::unique_ptr<Term> term);
  void add_pair(const Problem& problem, const Scale& scale, const ConstraintView& constraint, int a, int b);
  void move(int term, Literal to, Cost amount);
  void set(int term, Literal to, Cost amount);
  void mark_stale(int term);
  void refresh(std::vector<int>& terms);
  Cost known_least(Literal literal) const;

  std::vector<std::vector<char>>& live_;        ///< by variable of the problem
  std::vector<std::unique_ptr<Term>> terms_;
  std::map<int, int> label_term_;               ///< by variable
  std::map<std::pair<int, int>, int> pair_term_;
  std::map<int, int> constraint_term_;
  std::map<int, std::vector<int>> terms_of_;    ///< by variable
  std::vector<Cost> least_;                     ///< of each term: not above its least value, unless it is stale
  std::vector<char> stale_, weak_;
  std::vector<int> stale_terms_;                ///< changed
  std::vector<int> weak_terms_;                 ///< some label was removed, so that the least value may be higher
  Cost sum_ = 0;                                ///< of the least values that are not kNever
  int never_ = 0;                               ///< how many are
  std::vector<Step> trail_;
};

}  // namespace scenelore::engine::exact
