// A lower bound before anything is built, led by a world that is known. Where that world's label is not the cheapest of its
// variable, something speaks against the cheaper ones; that cost is moved to them, paid by labels that the world does not
// have (complementary slackness: with the best shifting, the labels of a best world cost least). In most rooms the bound
// then is the cost of the world, and only labels whose cost is near it need be built.
#pragma once

#include <span>
#include <vector>

#include "cost.hpp"
#include "outline.hpp"

namespace scenelore::engine {

class EarlyBound {
 public:
  /// `world`: one label a variable; empty = none is known, and nothing is moved.
  EarlyBound(const Outline& outline, std::span<const int> world);

  /// Moves costs towards labels that are too cheap, variable by variable.
  void raise();
  /// Labels that reach the limit with the cheapest ones of all other variables go; one of each variable, and those of
  /// `keep`, stay. Returns whether any went.
  bool strike(Cost limit, std::span<const int> keep);
  std::vector<std::vector<char>> labels() const;

 private:
  struct Row {
    int other;   ///< literal
    int number;  ///< of the conflict
  };
  struct Charge {
    int literal;
    Cost amount;
  };

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  bool is_alive(int literal) const { return alive_[at(literal)] != 0; }
  int held(int v) const { return outline_.first_label[at(v)] + world_[at(v)]; }
  bool is_held(int literal) const { return held(outline_.variable(literal)) == literal; }
  /// What the label can pay without becoming cheaper than the world's one.
  Cost surplus(int literal) const;
  Cost weight(const Outline::Need& need) const { return left(need.weight, need); }
  Cost left(Cost cost, const Outline::Need& need) const;
  Cost left(const Outline::Pair& pair, std::size_t number, int label_a, int label_b) const;
  std::size_t taken_from(std::size_t pair, bool is_a, int label) const;

  Cost paid_by_world(int v) const;
  Cost raise(int literal, Cost wanted);
  Cost raise_by_needs(int literal, Cost wanted);
  Cost raise_by_clashes(int literal, Cost wanted);
  Cost raise_by_pairs(int literal, Cost wanted);
  Cost raise_by_row(int literal, std::span<const Row> row, Cost wanted);
  void raise_as_props(int v);
  void raise_by_count(const Outline::Count& count, Cost& left);
  void pay();

  std::vector<Cost> projected() const;
  std::vector<int> only_labels() const;

  const Outline& outline_;
  std::vector<int> world_;
  std::vector<char> alive_;        ///< by literal
  std::vector<Cost> cost_;         ///< by literal
  std::vector<Cost> clash_left_;   ///< by number
  std::vector<Cost> need_taken_;   ///< by need
  std::vector<Cost> count_left_;   ///< by count: of its weight
  std::vector<Cost> pair_taken_;   ///< see taken_from()
  std::vector<std::size_t> first_taken_;      ///< by pair
  std::vector<std::vector<int>> pairs_of_;    ///< by variable
  std::vector<std::vector<std::size_t>> props_of_world_;  ///< by variable: the needs that its label of the world is a prop of
  std::vector<Row> rows_;
  std::vector<Charge> charges_;
};

}  // namespace scenelore::engine
