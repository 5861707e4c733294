// The problem as questions need it: whole costs, and for each literal the conflicts that it is in. Made in one pass, since
// going over the caller's constraints again and again takes longer than most answers.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "cost.hpp"
#include "scale.hpp"
#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {

/// A literal is a number here: those of variable v are first_label[v] + label, below first_label[v + 1].
struct Outline {
  struct Clash {
    int other;   ///< the other literal, of another variable
    int number;  ///< of the conflict
  };
  struct Prop {
    int literal;
    Cost cost;  ///< of no use when it is not below the need's weight
    auto operator<=>(const Prop&) const = default;
  };
  /// When the owner holds: the least cost of a prop that holds, at most the weight.
  struct Need {
    int owner;
    Cost weight;            ///< > 0
    int constraint;
    std::size_t first, last;  ///< in `props`: distinct, ascending, none of the owner's variable
  };
  /// When the condition holds (−1: always): the weight for each literal that holds beyond `high` or is missing to `low`.
  struct Count {
    int condition, low, high;
    Cost weight;
    int constraint;
    std::vector<int> literals;  ///< distinct, ascending, none of the condition's variable
  };
  struct Pair {
    int a, b;       ///< variables
    int table;      ///< of the problem
    double weight;  ///< the caller's
    int constraint;
    auto operator<=>(const Pair&) const = default;
  };

  /// `used`: which constraints count; empty = all. All is in an order that depends on the constraints alone, but for conflicts.
  Outline(const Problem& problem, const Scale& scale, std::span<const char> used = {});

  int variables() const { return static_cast<int>(first_label.size()) - 1; }
  int literals() const { return first_label.back(); }
  int labels(int v) const { return first_label[at(v) + 1] - first_label[at(v)]; }
  int literal(const Literal& l) const { return first_label[at(l.variable)] + l.label; }
  int variable(int literal) const { return variable_of[at(literal)]; }
  int label(int literal) const { return literal - first_label[at(variable(literal))]; }
  std::span<const Clash> clashes_of(int literal) const {
    return std::span(clashes).subspan(first_clash[at(literal)], first_clash[at(literal) + 1] - first_clash[at(literal)]);
  }
  std::span<const Prop> props_of(const Need& need) const { return std::span(props).subspan(need.first, need.last - need.first); }
  /// What a pair of labels costs, kTop = it is forbidden.
  Cost cost(const Pair& pair, int label_a, int label_b) const {
    const double entry = problem_->table(pair.table)[at(label_a * problem_->table_size(pair.table).second + label_b)];
    return !(entry > 0) ? 0 : scale_->whole(entry * pair.weight);
  }
  std::span<const Need> needs_of(int literal) const {
    return std::span(needs).subspan(first_need[at(literal)], first_need[at(literal) + 1] - first_need[at(literal)]);
  }
  /// The constraints that can cost anything when just these labels hold, ascending: most conflicts and requirements are
  /// about labels that do not hold.
  std::vector<int> relevant(std::span<const int> assignment) const;

  std::vector<int> first_label;  ///< one more than variables
  std::vector<int> variable_of;  ///< by literal
  std::vector<Cost> own;         ///< by literal, with what it costs by itself
  std::vector<std::size_t> first_clash;  ///< by literal, one more
  std::vector<Clash> clashes;            ///< each conflict twice
  std::vector<Cost> price;               ///< by number of the conflict, > 0
  std::vector<int> conflict;             ///< by number: the constraint
  std::vector<Need> needs;               ///< by owner
  std::vector<std::size_t> first_need;   ///< by literal, one more
  std::vector<Prop> props;
  std::vector<Count> counts;
  std::vector<Pair> pairs;

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  void add(const Conflict& body, Cost weight, int constraint);
  void add(const Requirement& body, Cost weight, int constraint, const Scale& scale);
  void add(const Cardinality& body, Cost weight, int constraint);
  void sort();
  void place_clashes();

  std::vector<int> tiny_;                        ///< constraints that cost something, but are rounded to nothing
  std::vector<std::pair<int, int>> by_itself_;  ///< literal, constraint: conflicts of a label with itself, in `own`
  const Problem* problem_;
  const Scale* scale_;
};

}  // namespace scenelore::engine
