// A weighted labelling problem: variables that each take one label, costs of labels, constraints between literals.
// The caller builds it once; engine/solver.hpp searches it. Nothing here knows what a variable stands for.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
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

struct WeightedConflict {
  double weight = kHard;
  Conflict conflict;
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

/// A constraint of a problem where it lies; good until the problem changes.
class ConstraintView {
 public:
  const std::string& name;
  double weight;
  std::int64_t reference;

  template <typename Body>
  ConstraintView(const std::string& its_name, double its_weight, std::int64_t its_reference, const Body& body)
      : name(its_name), weight(its_weight), reference(its_reference), body_(&body) {}
  /// The body if it is of this kind, else nullptr.
  template <typename Body>
  const Body* as() const {
    const auto* const body = std::get_if<const Body*>(&body_);
    return body == nullptr ? nullptr : *body;
  }
  template <typename Visitor>
  decltype(auto) visit(Visitor&& visitor) const {
    return std::visit([&](const auto* body) -> decltype(auto) { return visitor(*body); }, body_);
  }
  operator Constraint() const {
    return visit([&](const auto& body) { return Constraint{name, weight, reference, body}; });
  }

 private:
  std::variant<const Conflict*, const Requirement*, const Cardinality*, const PairTable*> body_;
};

struct Variable {
  std::string name;
  std::vector<std::string> labels;
  std::vector<double> costs;  ///< one per label, ≥ 0 or infinite = forbidden
};

class Problem;

/// The constraints of a problem, each made into a view when it is asked for.
class Constraints {
 public:
  class Iterator {
   public:
    Iterator(const Problem& problem, std::size_t index) : problem_(&problem), index_(index) {}
    ConstraintView operator*() const;
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return index_ != other.index_; }

   private:
    const Problem* problem_;
    std::size_t index_;
  };

  explicit Constraints(const Problem& problem) : problem_(&problem) {}
  std::size_t size() const;
  bool empty() const { return size() == 0; }
  ConstraintView operator[](std::size_t index) const;
  Iterator begin() const { return {*problem_, 0}; }
  Iterator end() const { return {*problem_, size()}; }

 private:
  const Problem* problem_;
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
  /// Room for so many constraints, most of them conflicts.
  void reserve(std::size_t constraints);
  /// Returns the constraint's index, which Violation and Explanation use.
  int add(std::string name, double weight, std::int64_t reference,
          std::variant<Conflict, Requirement, Cardinality, PairTable> body);
  /// The same for conflicts, of which a problem may have very many; all or, when one is an error, none.
  int add(const std::string& name, double weight, std::int64_t reference, const Conflict& conflict);
  void add(const std::string& name, std::int64_t reference, std::span<const WeightedConflict> conflicts);

  const std::vector<Variable>& variables() const { return variables_; }
  /// By index; a range of ConstraintView.
  Constraints constraints() const { return Constraints(*this); }
  ConstraintView constraint(std::size_t index) const;
  /// For all constraints by rising index: of_conflict(index, weight, conflict), or of_other(index, view). A view of each of tens of
  /// thousands of conflicts would take longer than most of what is asked of them.
  template <typename OfConflict, typename OfOther>
  void for_each_constraint(OfConflict of_conflict, OfOther of_other) const {
    for (std::size_t i = 0; i < heads_.size(); ++i) {
      const Head& head = heads_[i];
      if (head.kind == Kind::conflict)
        of_conflict(i, head.weight, conflicts_[head.body]);
      else
        of_other(i, constraint(i));
    }
  }
  /// The constraint must be a conflict.
  const Conflict& conflict(std::size_t index) const { return conflicts_[heads_[index].body]; }
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
  /// A scan has tens of thousands of conflicts, and whoever goes over them waits for memory: kept apart from the larger kinds, and
  /// with what they are called by number, they take 32 bytes each.
  enum class Kind : std::uint8_t { conflict, requirement, cardinality, pair_table };
  struct Head {
    double weight;
    std::uint32_t call;  ///< in calls_
    std::uint32_t body : 30;  ///< in the list of its kind
    Kind kind : 2;
  };
  struct Call {
    std::string name;
    std::int64_t reference;
  };
  std::uint32_t call_of_next(const std::string& name, std::int64_t reference);
  int add_head(const std::string& name, double weight, std::int64_t reference, Kind kind, std::size_t body);

  std::vector<Variable> variables_;
  std::vector<Head> heads_;
  std::vector<Call> calls_;  ///< what constraints are called; neighbours that are called the same share it
  std::vector<Conflict> conflicts_;
  std::vector<Requirement> requirements_;
  std::vector<Cardinality> cardinalities_;
  std::vector<PairTable> pair_tables_;
  std::vector<Table> tables_;
  std::uint64_t revision_ = 0;
  friend class Constraints;
};

inline ConstraintView Problem::constraint(std::size_t index) const {
  const Head& head = heads_[index];
  const auto& [name, reference] = calls_[head.call];
  switch (head.kind) {
    case Kind::requirement: return {name, head.weight, reference, requirements_[head.body]};
    case Kind::cardinality: return {name, head.weight, reference, cardinalities_[head.body]};
    case Kind::pair_table: return {name, head.weight, reference, pair_tables_[head.body]};
    case Kind::conflict: break;
  }
  return {name, head.weight, reference, conflicts_[head.body]};
}

inline std::size_t Constraints::size() const { return problem_->heads_.size(); }
inline ConstraintView Constraints::operator[](std::size_t index) const { return problem_->constraint(index); }
inline ConstraintView Constraints::Iterator::operator*() const { return problem_->constraint(index_); }

}  // namespace scenelore::engine
