// The problem inside the search: a weighted constraint network over whole numbers, whose costs are shifted between
// constraints, labels and one constant without changing the cost of any assignment. The constant is the lower bound.
//
// Each constraint function keeps its original costs and, for each (variable, label) in its scope, how much has been
// taken out of it towards that label ("shift"; negative: put in). At all times, for each assignment t of live labels,
//     evaluate(t) = bound() + sum over v of unary(v, t[v]) + sum over functions f of (f(t) − its shifts at t)
// and every one of these terms is >= 0. Only this invariant is needed for correct answers; how well the shifting is
// done decides how good the bound is. Sources: Cooper, de Givry, Sanchez, Schiex, Zytnicki, Werner, "Soft arc
// consistency revisited", AIJ 2010; de Givry, Heras, Zytnicki, Larrosa, "Existential arc consistency", IJCAI 2005.
//
// Everything that changes is on a trail, so that push() and pop() go down and up the search tree.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "cost.hpp"
#include "index_set.hpp"
#include "residual.hpp"

namespace scenelore::engine {

class Budget;
class ProofLog;

/// Cost of each pair of labels of two variables.
struct BinaryFunction {
  int x, y;            ///< x < y
  int table;           ///< index into Network::tables_, row-major by the label of x
  int x_cell, y_cell;  ///< cells of the shifts
  int idle_cell;       ///< not 0: no pair of live labels costs anything, and no shifts are left
  int constraint;      ///< the caller's (the first one, when several were added up)
};

/// A binary function seen from one side: it gives costs `to` a variable, from another.
struct View {
  const Cost* table;
  int to_stride, from_stride;
  int to, from;
  int to_cell, from_cell;
};

/// Cost when variable `x` has `label`: the least cost of a label that another variable has, at most `weight`.
struct RequirementFunction {
  struct Member {
    int variable;
    int cell = -1;                                 ///< shifts, one a label
    std::vector<std::pair<int, Cost>> supports{};  ///< (label, cost < weight)
    auto operator<=>(const Member&) const = default;
  };
  struct Support {
    int member, variable;
    int label_cell, shift_cell;
    Cost cost;
  };
  int x, label;
  Cost weight;
  int constraint;
  std::vector<Member> members{};
  // Set by Network:
  int x_cell = -1;
  int lifted_cell = -1;             ///< not 0: costs were taken out towards members
  int shifted_cell = -1;            ///< not 0: some shift is not 0
  std::vector<Support> supports{};  ///< of all members
  std::size_t witness = 0;          ///< the support that was cheapest when last looked at
  int idle = -1;                    ///< a label of x that cost nothing when last looked at
};

/// Cost when variable `x` has `label` (or always, x = −1): weight for each member too many or too few.
struct CardinalityFunction {
  struct Member {
    int variable;
    int cell;
    std::vector<char> counts;  ///< for each label
    auto operator<=>(const Member&) const = default;
  };
  int x, label, x_cell;
  int low, high;
  Cost weight;
  std::vector<Member> members;
  int constraint;
  Cost violation(int count) const {
    const int off = count < low ? low - count : count > high ? count - high : 0;
    return off == 0 ? 0 : weight >= kTop ? kTop : weight * off;
  }
};

/// A function written out: costs of all tuples of its scope, the last variable running fastest.
struct Table {
  std::vector<int> scope;  ///< ascending
  std::vector<Cost> costs;
};

class Network {
 public:
  // --- building, before close() ---
  int add_variable(const std::vector<Cost>& costs);
  /// A table that binary functions may share, row-major; equal ones are kept once. Returns its index.
  int add_table(const std::vector<Cost>& table);
  /// Adds a table (row-major by x) to what there is between x and y; x < y.
  void add_binary(int x, int y, int table, int constraint);
  /// The same with one entry of the table.
  void add_binary(int x, int y, int label_x, int label_y, Cost cost, int constraint);
  void add_requirement(RequirementFunction function);  ///< cells are set here
  void add_cardinality(CardinalityFunction function);
  void close();
  /// False: propagate like the paper's bound, only what assigned variables cost, and hard arc consistency.
  void set_shifting(bool on) { shifting_ = on; }
  bool shifts() const { return shifting_; }
  /// From now on each step is told to `log` (nullptr: to nobody), and labels go only when the shifts that show it are made.
  void set_log(ProofLog* log) { log_ = log; }
  /// From now on propagation ends early, with what it has, when this is out of time (nullptr: it does not).
  void set_budget(Budget* budget) { budget_ = budget; }
  /// Calls visit(cell, function, variable, label) for the cell of each shift; a function is a BinaryFunction,
  /// RequirementFunction or CardinalityFunction.
  void for_each_shift(const auto& visit) const;

  // --- state ---
  int variables() const { return static_cast<int>(variable_.size()); }
  int labels(int v) const { return at(v).size; }
  std::span<const int> live(int v) const { return {order_.data() + at(v).first, static_cast<std::size_t>(at(v).live)}; }
  bool is_live(int v, int label) const { return position_[cell(v, label)] < at(v).live; }
  int value(int v) const { return order_[static_cast<std::size_t>(at(v).first)]; }
  Cost unary(int v, int label) const { return cost_[cell(v, label)]; }
  Cost original(int v, int label) const { return original_[cell(v, label)]; }
  Cost bound() const { return cost_[0]; }
  Cost cost_at(int cell) const { return cost_[static_cast<std::size_t>(cell)]; }
  /// Cost of a complete assignment from the original costs; forbidden when a hard constraint is broken.
  Cost evaluate(std::span<const int> assignment) const;
  /// The same from the shifted costs: equal for assignments of live labels (for tests of the invariant).
  Cost evaluate_shifted(std::span<const int> assignment) const;
  /// For each variable the label that costs least, with its neighbours where that is known.
  void round(std::vector<int>& assignment) const;
  /// All functions of two and more variables from their original costs; nothing when one has more than `most` tuples.
  std::optional<std::vector<Table>> written_out(std::size_t most) const;
  /// What is left when only live labels count.
  Residual residual() const;
  /// Adjacent through a function; for components and variable choice.
  int degree(int v) const { return static_cast<int>(links_[static_cast<std::size_t>(v)].size()); }

  /// How many binary functions two open variables depend on still.
  int open_pairs() const;

  // --- search ---
  void push();
  void pop();
  int level() const { return static_cast<int>(marks_.size()); }
  /// Upper bound: labels that cannot be part of an assignment cheaper than this may be removed.
  void set_limit(Cost limit) { limit_ = rounded_limit(limit); }
  /// The least limit that lets the same assignments through: each costs a multiple of granularity_. The verifier of a
  /// proof does not know that.
  Cost rounded_limit(Cost limit) const {
    const bool as_it_is = is_forbidden(limit) || limit <= 0 || log_ != nullptr;
    return as_it_is ? limit : (limit - 1) / granularity_ * granularity_ + 1;
  }
  /// An assignment of this cost is known: the root need not be strengthened beyond it.
  void set_met(Cost cost) { met_ = cost; }
  bool assign(int v, int label);
  bool remove(int v, int label);
  /// To a fixed point. False: no assignment of live labels is cheaper than the limit.
  bool propagate();
  enum class Place { root, root_again, entered, branch };
  /// propagate(), and then what pays at that place of the search to raise the bound further.
  bool strengthen(Place place = Place::root);
  /// After a failure: the constraint that did it, −1 = the bound; and the variable that ran out of labels, −1.
  int failed_constraint() const { return failed_constraint_; }
  int failed_variable() const { return failed_variable_; }

 private:
  friend class RequirementDiffusion;

  struct Domain {
    int first, size, live;  ///< live labels are order_[first .. first + live)
  };
  struct Link {
    int function;
    int other;
  };
  struct Saved {
    int cell;
    Cost cost;
  };
  struct Shrunk {
    int variable, live;
  };
  struct Mark {
    std::size_t costs, domains;
  };
  /// `amount` goes from a function to a label (or back, when negative).
  struct Move {
    int label_cell, shift_cell;
    Cost amount;
  };

  const Domain& at(int v) const { return variable_[static_cast<std::size_t>(v)]; }
  std::size_t cell(int v, int label) const { return static_cast<std::size_t>(at(v).first + label); }
  Cost available(int cell) const { return cost_at(cell) - spent_[static_cast<std::size_t>(cell)]; }
  int new_cells(int count);
  void close_binary(int x, std::vector<int>& function_with);
  Cost common_divisor() const;
  View view(const BinaryFunction& function, int to) const;

  void set(int cell, Cost cost) {
    const auto i = static_cast<std::size_t>(cell);
    if (cost_[i] == cost) return;
    if (saved_at_[i] != stamp_ && !marks_.empty()) save(cell);
    cost_[i] = cost;
    if (log_ != nullptr) log(cell);
  }
  void save(int cell);
  void log(int cell);
  bool fail(int v);
  /// Removes a label that is in no world below the limit, as the costs now show.
  bool strike(int v, int label);
  /// Whether a label that would get `amount`, and cost `total` then, goes at once.
  bool goes(Cost amount, Cost total) const { return is_forbidden(amount) || (log_ == nullptr && total >= limit_); }
  bool out_of_time();
  bool settle(int v);
  bool settle_all();
  bool is_met(Place place);
  void turn_order();
  int rank(int v) const { return rank_[static_cast<std::size_t>(v)]; }
  void announce(int v);
  void start_empty();

  // Each pull adds to gain_[label] what `to` could get from one function and notes the moves that it takes.
  // `above`: only variables after it may pay; −1 = all may.
  void pull(const View& view);
  void pull(RequirementFunction& function, int to, int above);
  void pull(const CardinalityFunction& function, int to, int above);
  void pull_to_owner(RequirementFunction& function, int above);
  void pull_to_member(RequirementFunction& function, std::size_t member, int above);
  Cost given(const RequirementFunction::Support& support, int above) const;
  bool is_live(const RequirementFunction::Support& support) const;
  Cost least_given(const RequirementFunction& function, std::size_t without, int above);
  void charge(const RequirementFunction& function, std::size_t without, Cost target, int above);
  bool release(const RequirementFunction& function);
  void pull_global(int global, int to, int above);
  void project_cardinality(const CardinalityFunction& function, int to);
  void lift_cardinality(const CardinalityFunction& function, int to, int above);
  bool is_tight(const CardinalityFunction& function) const;
  void offer(int to, int shift_cell, int label, Cost amount);
  void move(int label_cell, int shift_cell, Cost amount);
  bool commit(int to);
  void forget();

  bool arcs_from(int v);
  bool project(const View& view, bool only_forbidden);
  bool filter_global(int global);
  bool directed_from(int v);
  bool existential(int v);
  bool existential_support(int v, int label);
  bool turn_to_and_fro(int most_turns, int most_idle);

  bool diffuse(int most_passes, Cost part, int most_idle);
  bool diffuse(const BinaryFunction& function);
  bool diffuse(int requirement);
  void pour_in(int v, int shift_cell, std::size_t first);
  void pour_out(int v, int shift_cell, std::span<const Cost> got, std::span<const Cost> kept);
  bool set_idle(const BinaryFunction& function, std::span<Cost> x, std::span<Cost> y);
  bool strike_forbidden(const BinaryFunction& function);

  std::vector<Domain> variable_;
  std::vector<int> order_, position_;
  std::vector<Cost> cost_;      ///< cell 0: the bound; then labels; then shifts
  std::vector<Cost> original_;  ///< by label cell
  std::vector<Cost> spent_;     ///< by label cell: promised to moves not yet committed
  std::vector<int> owner_;      ///< by label cell
  std::vector<std::vector<Cost>> tables_;
  std::unordered_multimap<std::size_t, int> table_index_;  ///< by hash
  struct Pending {  ///< part of a binary function of x and y, until close()
    int y, constraint;
    int table;  ///< −1: one entry
    int entry;
    Cost cost;
  };
  std::vector<std::vector<Pending>> pending_;  ///< by x
  std::vector<BinaryFunction> binary_;
  std::vector<RequirementFunction> requirements_;
  std::vector<CardinalityFunction> cardinalities_;
  std::vector<std::vector<Link>> links_;    ///< binary functions of each variable
  std::vector<std::vector<int>> globals_;   ///< of each variable: requirement r is r, cardinality c is ~c
  std::vector<std::vector<int>> watchers_;  ///< by label cell: globals to look at when the label goes

  std::vector<Saved> saved_costs_;
  std::vector<std::uint32_t> saved_at_;  ///< by cell: stamp of the level that saved it
  std::vector<Shrunk> saved_domains_;
  std::vector<Mark> marks_;
  std::uint32_t stamp_ = 1;
  std::vector<std::uint32_t> stamps_;
  std::uint32_t next_stamp_ = 1;

  std::vector<int> rank_, by_rank_;  ///< place of each variable in the order of shifting, and the variable at each place
  IndexSet reduced_, dirty_requirements_, dirty_cardinalities_;
  IndexSet raised_, checks_;  ///< of ranks
  std::vector<int> support_;  ///< by variable: the label that last passed the existential check
  std::vector<Cost> gain_;
  std::vector<Move> moves_;
  std::vector<Cost> scratch_;
  std::vector<int> rounded_;
  struct Count {
    Cost in, out;  ///< least cost of being counted or not, kTop = cannot
  };
  std::vector<Count> counts_;
  std::vector<Cost> potentials_;  ///< of labels inside the function that is being looked at
  struct Side {                   ///< of a requirement that is being looked at: a member, or in the end the owner
    int variable, cell;
    std::size_t first, size;  ///< its live labels in potentials_, prices_, got_
    Cost least = 0;           ///< what the member costs at least
    Cost support = kTop;      ///< what it costs as a support on top of that
  };
  std::vector<Side> sides_;
  std::vector<Cost> prices_, got_, after_;
  std::vector<Cost> differences_;
  bool bound_rose_ = false;
  bool shifting_ = true;
  bool pushing_ = true;  ///< false: costs go from functions to labels only, as when diffusion does the rest
  ProofLog* log_ = nullptr;
  Budget* budget_ = nullptr;
  unsigned steps_ = 0;  ///< since the last look at the budget
  Cost limit_ = kTop;
  Cost met_ = kTop;
  Cost least_gain_ = 1;
  Cost granularity_ = 1;  ///< a common divisor of all finite costs
  int source_ = -1;  ///< constraint whose costs are being moved
  int failed_constraint_ = -1, failed_variable_ = -1;
};

void Network::for_each_shift(const auto& visit) const {
  const auto of = [&](const auto& function, int first, int v) {
    for (int label = 0; label < labels(v); ++label) visit(first + label, function, v, label);
  };
  for (const BinaryFunction& f : binary_) {
    of(f, f.x_cell, f.x);
    of(f, f.y_cell, f.y);
  }
  for (const RequirementFunction& f : requirements_) {
    of(f, f.x_cell, f.x);
    for (const auto& member : f.members) of(f, member.cell, member.variable);
  }
  for (const CardinalityFunction& f : cardinalities_) {
    if (f.x >= 0) of(f, f.x_cell, f.x);
    for (const auto& member : f.members) of(f, member.cell, member.variable);
  }
}

}  // namespace scenelore::engine
