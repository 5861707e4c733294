// Splitting a problem into parts that share no constraint, each with its own network.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "budget.hpp"
#include "network.hpp"
#include "outline.hpp"
#include "scenelore/engine/problem.hpp"
#include "scenelore/engine/solver.hpp"

namespace scenelore::engine {

struct Reduction;

/// One part of the problem (or of a reduced component): its variables in their order there, and those of their labels
/// that take part.
struct Component {
  std::vector<int> variables;
  std::vector<std::vector<int>> labels;  ///< of each variable, ascending; the network counts these
  Network network;             ///< at its root, propagated
  bool feasible = true;        ///< false: the root failed
  std::vector<int> best;       ///< an optimal assignment, once it is proved; else empty
  Cost best_cost = kTop;
  std::vector<std::pair<Cost, std::vector<int>>> pool;  ///< different assignments met so far, for upper bounds
  bool whole = true;                                    ///< false: part of a reduction, not to be reduced again
  std::unique_ptr<Reduction> reduction;                 ///< see reduction.hpp; made when it is first of use

  Component();
  Component(Component&&) noexcept;
  Component& operator=(Component&&) noexcept;
  ~Component();
};

struct Decomposition {
  std::vector<Component> components;
  std::vector<int> component_of, index_in;  ///< by variable of the problem, −1 = it is settled
  std::vector<std::vector<int>> label_in;   ///< of each label of each variable its number in the component, −1 = none
  std::vector<int> settled;                 ///< the label of each variable that has just one, −1 = it has more, or none was settled
  Cost constant = 0;                        ///< what no variable can change
  int broken = -1;                          ///< a hard one of these, −1 = none
  bool cut = false;                         ///< time ran out: nothing was built, or `built` but not propagated to the end
  bool built = false;
};

/// Which of `count` variables hang together.
class Parts {
 public:
  explicit Parts(std::size_t count);
  int find(int v);  ///< the least variable of v's part
  void join(int a, int b);

 private:
  std::vector<int> parent_;
};

/// What takes part; empty = all.
struct Selection {
  std::vector<std::vector<char>> labels{};  ///< at least one of each variable
  bool settle = false;                      ///< variables with one label are in no component, but for owners of open functions
};

/// What an assignment to the whole problem is in one component.
std::vector<int> part_of(const Decomposition& parts, const Component& component, std::span<const int> assignment);

/// Networks are not closed yet.
Decomposition build_parts(const Outline& outline, const Selection& selection = {}, Budget* budget = nullptr);

/// The same with closed networks. Each is propagated, and keeps only labels of assignments that cost less than `cutoff` in all.
/// `world`: an assignment that is known, of selected labels; empty = none.
Decomposition decompose(const Outline& outline, Bound bound, const Selection& selection = {}, Cost cutoff = kTop / 2,
                        Budget* budget = nullptr, std::span<const int> world = {});

}  // namespace scenelore::engine
