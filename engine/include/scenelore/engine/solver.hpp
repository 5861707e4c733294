// The search: the world model of least cost, what it costs to differ from it, and a proof that nothing is cheaper.
//
//   Problem problem; … Solver solver(problem);
//   Solution best = solver.solve();            // best.assignment[v] is the label of variable v
//   Solution other = solver.solve({.forbidden = {{3, best.assignment[3]}}});   // the best world where 3 is something
//   else
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "scenelore/engine/observer.hpp"
#include "scenelore/engine/problem.hpp"

namespace scenelore::engine {

enum class Outcome {
  proved,      ///< the assignment is optimal
  feasible,    ///< an assignment and a gap: a limit was reached
  infeasible,  ///< proved: no assignment satisfies the hard constraints
  stopped      ///< a limit was reached before any assignment was found
};
const char* to_string(Outcome outcome);

enum class Bound {
  soft_consistency,  ///< local consistency by cost shifting (the default)
  paper              ///< sum of the best unary costs of the open variables (Goldhoorn & Hartanto 2014)
};

struct Limits {
  double seconds = std::numeric_limits<double>::infinity();
  std::uint64_t nodes = std::numeric_limits<std::uint64_t>::max();
  const std::atomic<bool>* interrupt = nullptr;  ///< set from a signal handler or another thread
};

struct SolverOptions {
  Bound bound = Bound::soft_consistency;
  Limits limits;
  Observer* observer = nullptr;
  /// Nodes whose open variables hang together loosely are finished by dynamic programming. False: by branches, like others.
  bool elimination = true;
  /// Labels that another one can replace in every world, always for less, leave the root of a long search for the optimum. False: they stay.
  bool dominance = true;
};

/// What is assumed on top of the problem for one solve.
struct Assumptions {
  std::vector<Literal> fixed;
  std::vector<Literal> forbidden;
  /// Only worlds cheaper than this are of interest. When there is none, the outcome is `stopped` with a lower bound of
  /// at least this. Makes "is the margin below 10?" much cheaper than the margin itself: once the optimum is known, a
  /// limit not far above it is kept as a reduced problem without the labels that cannot occur below it. Searches in that
  /// one tell the observer nothing.
  double below = std::numeric_limits<double>::infinity();
};

struct Violation {
  int constraint = -1;  ///< index into Problem::constraints()
  double amount = 0;    ///< what it adds to the cost; > 0
};

struct Solution {
  Outcome outcome = Outcome::stopped;
  double cost = std::numeric_limits<double>::infinity();
  double lower_bound = 0;
  std::vector<int> assignment;        ///< empty without an incumbent
  std::vector<Violation> violations;  ///< of soft constraints, in the problem's order
  std::uint64_t nodes = 0;
  std::uint64_t backtracks = 0;
  double seconds = 0;
};

/// Least cost of a world that contains each literal: value[v][l]; infinite where there is none. `exact` is false when
/// a limit struck: values are then lower bounds.
struct MinMarginals {
  std::vector<std::vector<double>> value;
  bool exact = true;
};

/// Probability of each literal under P(world) ∝ exp(−cost), over worlds that satisfy the hard constraints.
struct Marginals {
  std::vector<std::vector<double>> probability;
  bool exact = true;   ///< by variable elimination; else from the k best worlds
  double covered = 1;  ///< share of the probability mass that was enumerated; when not exact, no more than that share
};

/// Hard constraints that cannot hold together.
struct Conflicting {
  std::vector<int> constraints;  ///< ascending; empty when there are none, or when a limit struck before that was known
  bool minimal = true;           ///< without any one of them the rest can hold; false when a limit struck
};

/// What to give up so that the rest can hold.
struct Relaxation {
  Solution solution;             ///< the world that breaks fewest hard constraints, and of these the cheapest; its cost
                                 ///< is that of what it does not break, its violations name both
  std::vector<int> constraints;  ///< the hard ones that it breaks, ascending
};

/// Fewest hard constraints to give up (a cardinality counts once for each one too many or too few), then least cost.
/// Labels of infinite cost stay forbidden. Outcome as for Solver::solve; `infeasible` when some variable has no label.
Relaxation cheapest_relaxation(const Problem& problem, const SolverOptions& options = {});

/// Keeps the propagated root of one problem, so that repeated solves are cheap. Not safe for concurrent use; the
/// problem must outlive it. It may be changed between calls: costs, constraints added and dropped, variables. Everything
/// is then built anew from the problem alone, when a question first needs it, so that the answers are those of a new
/// Solver, bit by bit. All answers are deterministic.
class Solver {
 public:
  explicit Solver(const Problem& problem, SolverOptions options = {});
  ~Solver();
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;

  Solution solve(const Assumptions& assumptions = {});
  /// The k cheapest different assignments, cheapest first, equal costs in lexicographic order of labels; fewer if there
  /// are fewer.
  std::vector<Solution> k_best(int k);
  MinMarginals min_marginals();
  Marginals marginals(int most_worlds = 200);

  /// Hard constraints that cannot hold together (with the domains); empty if feasible.
  Conflicting conflict();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace scenelore::engine
