// A weighted labelling problem: variables that each take one label, costs of labels, constraints between literals.
// The caller builds it once; engine/solver.hpp searches it. Nothing here knows what a variable stands for.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace scenelore::engine {

/// The weight of a constraint that must hold.
inline constexpr double kHard = std::numeric_limits<double>::infinity();

/// "This variable has this label"; both are indices from 0.
struct Literal {
  int variable = 0;
  int label = 0;
  auto operator<=>(const Literal&) const = default;
};

/// Not both literals.
struct Conflict {
  Literal a, b;
};

/// One way to satisfy a requirement, at a cost in [0, weight]; 0 = fully.
struct Support {
  Literal literal;
  double cost = 0;
};

/// If `literal`, then at least one of `supports`. Cost when `literal` holds: the least cost of a support that holds,
/// or the constraint's weight when none does. A hard requirement may have supports with a finite cost.
struct Requirement {
  Literal literal;
  std::vector<Support> supports;
};

/// If `condition` (or always, without one), then at least `low` and at most `high` of `literals`. Soft: the weight for
/// each one too many or too few. A literal that is listed twice counts once.
struct Cardinality {
  std::optional<Literal> condition;
  std::vector<Literal> literals;
  int low = 0;
  int high = std::numeric_limits<int>::max();
};

/// Cost of each pair of labels of two different variables: costs[table][label_a * labels(b) + label_b], times the
/// constraint's weight when that is finite; an infinite entry, or any entry > 0 of a hard constraint, forbids the pair.
struct PairTable {
  int a = 0, b = 0;
  int table = 0;  ///< index returned by Problem::add_table; many pairs may share one
};

struct Constraint {
  std::string name;
  double weight = kHard;        ///< > 0; kHard = must hold
  std::int64_t reference = -1;  ///< the caller's: which rule, which row
  std::variant<Conflict, Requirement, Cardinality, PairTable> body;
};

struct Variable {
  std::string name;
  std::vector<std::string> labels;
  std::vector<double> costs;  ///< one per label, ≥ 0 or infinite = forbidden
};

/// Plain data with checked insertion. Variables are in the order in which the search should prefer them.
/// Throws: Error naming variable, label or constraint for an index out of range, NaN, a negative cost or weight,
/// a variable without labels.
class Problem {
 public:
  int add_variable(std::string name, std::vector<std::string> labels, std::vector<double> costs);
  void set_cost(Literal literal, double cost);
  /// The constraint keeps its index and name but holds always, at no cost.
  void drop(int constraint);
  int add_table(int labels_a, int labels_b, std::vector<double> costs);
  void reserve(std::size_t constraints) { constraints_.reserve(constraints); }
  /// Returns the constraint's index, which Violation and Explanation use.
  int add(std::string name, double weight, std::int64_t reference,
          std::variant<Conflict, Requirement, Cardinality, PairTable> body);
  /// The same for conflicts, of which a problem may have very many: nothing is copied twice.
  int add(const std::string& name, double weight, std::int64_t reference, const Conflict& conflict);

  const std::vector<Variable>& variables() const { return variables_; }
  const std::vector<Constraint>& constraints() const { return constraints_; }
  const std::vector<double>& table(int index) const { return tables_[static_cast<std::size_t>(index)].costs; }
  /// Labels of a and of b that the table is for.
  std::pair<int, int> table_size(int index) const {
    const Table& table = tables_[static_cast<std::size_t>(index)];
    return {table.labels_a, table.labels_b};
  }
  int tables() const { return static_cast<int>(tables_.size()); }
  /// Grows with each change; a Solver sees by it that it must start anew.
  std::uint64_t revision() const { return revision_; }

 private:
  struct Table {
    int labels_a, labels_b;
    std::vector<double> costs;
  };
  std::vector<Variable> variables_;
  std::vector<Constraint> constraints_;
  std::vector<Table> tables_;
  std::uint64_t revision_ = 0;
};

}  // namespace scenelore::engine
