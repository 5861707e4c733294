#include "model.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <sstream>

#include "scenelore/engine/certificate.hpp"
#include "scenelore/engine/cfn.hpp"
#include "scenelore/engine/problem_file.hpp"
#include "scenelore/engine/solver.hpp"
#include "shrink.hpp"

namespace scenelore::engine::testing {
namespace {

using World = std::pair<double, std::vector<int>>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// One problem with its enumeration; each question returns what is wrong.
class Model {
 public:
  Model(const Problem& problem, double largest)
      : problem_(problem), largest_(largest), tolerance_(1e-6 * largest), worlds_(all_worlds(problem, tolerance_)) {}

  std::string first_fault() const {
    for (const auto question : {&Model::optimum, &Model::certified, &Model::best_worlds, &Model::literals, &Model::probabilities,
                                &Model::conflicting, &Model::relaxed, &Model::written_and_read}) {
      std::string fault = (this->*question)();
      if (!fault.empty()) return fault;
    }
    return {};
  }

 private:
  bool same(double a, double b) const { return a == b || std::abs(a - b) <= tolerance_; }
  double least() const { return worlds_.empty() ? kInfinity : worlds_[0].first; }
  /// Least cost of a world with or without a literal.
  double least(Literal literal, bool with) const {
    for (const World& world : worlds_)
      if ((world.second[static_cast<std::size_t>(literal.variable)] == literal.label) == with) return world.first;
    return kInfinity;
  }
  void for_each_literal(const auto& visit) const {
    for (int v = 0; v < static_cast<int>(problem_.variables().size()); ++v)
      for (int l = 0; l < static_cast<int>(problem_.variables()[static_cast<std::size_t>(v)].labels.size()); ++l) visit(Literal{v, l});
  }

  std::string optimum() const {
    const SolverOptions usual, plain{.bound = Bound::paper}, branching{.elimination = false, .dominance = false};
    const SolverOptions dominating{.elimination = false};
    for (const SolverOptions& options : {usual, plain, branching, dominating}) {
      const Solution solution = Solver(problem_, options).solve();
      if (solution.outcome != (worlds_.empty() ? Outcome::infeasible : Outcome::proved))
        return std::string("solve: the outcome is ") + to_string(solution.outcome);
      if (!same(solution.cost, least())) return "solve: the cost is wrong";
      if (worlds_.empty()) continue;
      const Check checked = check(problem_, solution.assignment);
      if (!checked.valid || checked.cost != solution.cost) return "solve: the checker disagrees";
    }
    return {};
  }

  std::string certified() const {
    const Solution solution = Solver(problem_).solve();
    const auto text = certificate(problem_, solution);
    if (!text) return "certificate: there is none";
    std::istringstream in(*text);
    const Verdict verdict = verify(problem_, in);
    return verdict.accepted ? "" : "certificate: " + verdict.reason;
  }

  std::string best_worlds() const {
    const int k = 1 + static_cast<int>(worlds_.size() % 7);
    const auto best = Solver(problem_).k_best(k);
    if (best.size() != std::min(worlds_.size(), static_cast<std::size_t>(k))) return "k_best: wrong number of worlds";
    for (std::size_t i = 0; i < best.size(); ++i)
      if (!same(best[i].cost, worlds_[i].first) || best[i].assignment != worlds_[i].second) return "k_best: a wrong world";
    return {};
  }

  std::string literals() const {
    std::string fault;
    Solver solver(problem_, {.elimination = problem_.constraints().size() % 2 == 0});
    solver.solve();
    const MinMarginals marginals = solver.min_marginals();
    if (!marginals.exact) return "min_marginals: not exact";
    for_each_literal([&](Literal literal) {
      const double with = least(literal, true);
      if (!same(marginals.value[static_cast<std::size_t>(literal.variable)][static_cast<std::size_t>(literal.label)], with))
        fault = "min_marginals: a wrong value";
      if (!same(solver.solve({.fixed = {literal}, .forbidden = {}}).cost, with)) fault = "solve with a fixed literal: wrong cost";
      if (!same(solver.solve({.fixed = {}, .forbidden = {literal}}).cost, least(literal, false)))
        fault = "solve with a forbidden literal: wrong cost";
      const double below = least() + 0.3 * largest_;
      const Solution cut = solver.solve({.fixed = {literal}, .forbidden = {}, .below = below});
      if (same(with, below)) return;  // rounding decides
      if (with < below ? cut.outcome != Outcome::proved || !same(cut.cost, with)
                       : !cut.assignment.empty() || cut.outcome == Outcome::proved)
        fault = "solve below a limit: wrong answer";
    });
    return fault;
  }

  std::string probabilities() const {
    if (worlds_.empty() || largest_ > 1000) return {};  // one world has all the probability
    const Marginals marginals = Solver(problem_).marginals();
    if (!marginals.exact) return "marginals: not exact";
    double sum = 0;
    for (const World& world : worlds_) sum += std::exp(least() - world.first);
    std::string fault;
    for_each_literal([&](Literal literal) {
      double with = 0;
      for (const World& world : worlds_)
        if (world.second[static_cast<std::size_t>(literal.variable)] == literal.label) with += std::exp(least() - world.first);
      const double told = marginals.probability[static_cast<std::size_t>(literal.variable)][static_cast<std::size_t>(literal.label)];
      if (!(std::abs(told - with / sum) < 1e-6)) fault = "marginals: a wrong probability";
    });
    return fault;
  }

  /// Of the constraints, only those for which keep(c).
  bool can_hold(const auto& keep) const {
    Problem part = problem_;
    for (std::size_t c = 0; c < problem_.constraints().size(); ++c)
      if (!keep(static_cast<int>(c))) part.drop(static_cast<int>(c));  // a soft table may forbid as well
    return !all_worlds(part).empty();
  }

  std::string conflicting() const {
    const Conflicting found = Solver(problem_).conflict();
    const auto in = [&](int c) { return std::find(found.constraints.begin(), found.constraints.end(), c) != found.constraints.end(); };
    if (!worlds_.empty()) return found.constraints.empty() ? "" : "conflict: there is none";
    if (!found.minimal) return "conflict: not minimal";
    if (found.constraints.empty()) return can_hold([](int) { return false; }) ? "conflict: it is missing" : "";
    if (can_hold(in)) return "conflict: these can hold together";
    for (const int without : found.constraints)
      if (!can_hold([&](int c) { return c != without && in(c); })) return "conflict: one of them is not needed";
    return {};
  }

  std::string relaxed() const {
    const Relaxation relaxation = cheapest_relaxation(problem_);
    if (!worlds_.empty())
      return relaxation.constraints.empty() && same(relaxation.solution.cost, least()) ? "" : "relaxation: none is needed";
    const bool possible = can_hold([](int) { return false; });
    if (possible != (relaxation.solution.outcome == Outcome::proved)) return "relaxation: wrong outcome";
    if (!possible) return {};
    const auto given_up = [&](int c) {
      return std::find(relaxation.constraints.begin(), relaxation.constraints.end(), c) != relaxation.constraints.end();
    };
    return can_hold([&](int c) { return !given_up(c); }) ? "" : "relaxation: the rest cannot hold";
  }

  /// As .cfn and back: the same optimum within the six decimals of the file, for the problem that was read and for all
  /// variables of the file, auxiliary ones too.
  std::string written_and_read() const {
    if (largest_ > 1000 || largest_ < 1) return {};
    std::stringstream text;
    write_cfn(problem_, text);
    const ProblemFile file = read_problem(text, "problem", FileFormat::cfn);
    const Solution solution = Solver(file.problem).solve({.fixed = {}, .forbidden = {}, .below = file.below});
    if (worlds_.empty() != solution.assignment.empty()) return ".cfn: feasible on one side only";
    if (worlds_.empty()) return {};
    if (std::abs(file.in_file(solution.cost) - least()) > 1e-4) return ".cfn: another optimum";
    std::stringstream fixed(with_labels(text.str(), file.in_file(solution.assignment)));
    const ProblemFile all = read_problem(fixed, "fixed", FileFormat::cfn);
    const Solution same_one = Solver(all.problem).solve({.fixed = {}, .forbidden = {}, .below = all.below});
    if (!(std::abs(all.in_file(same_one.cost) - file.in_file(solution.cost)) < 1e-9)) return ".cfn: an auxiliary variable has a wrong label";
    return {};
  }

  /// The text of a .cfn file in which each variable has one label that is free of charge: no support is found by itself then.
  static std::string with_labels(std::string text, const std::vector<int>& labels) {
    std::ostringstream more;
    for (std::size_t v = 0; v < labels.size(); ++v)
      more << ",\n\"fixed" << v << "\":{\"scope\":[" << v << "],\"defaultcost\":1000000000,\"costs\":[" << labels[v] << ",0]}";
    return text.insert(text.rfind("\n}}"), more.str() + ",\n\"one\":{\"scope\":[0],\"defaultcost\":0,\"costs\":[0,0]}");
  }

  const Problem& problem_;
  double largest_, tolerance_;
  std::vector<World> worlds_;
};

}  // namespace

std::string what_is_wrong(const Problem& problem, double largest) {
  try {
    return Model(problem, largest).first_fault();
  } catch (const std::exception& error) {
    return std::string("an exception: ") + error.what();
  }
}

const std::vector<std::pair<std::string, Shape>>& shapes() {
  static const std::vector<std::pair<std::string, Shape>> all{
      {"mixed", {}},
      {"soft", {.most_constraints = 14, .hard = 0, .forbidden = 0}},
      {"hard", {.most_constraints = 16, .hard = 0.9, .forbidden = 0.2}},
      {"dense", {.most_variables = 5, .most_constraints = 25, .hard = 0.15}},
      {"twins", {.most_labels = 5, .twins = 0.5}},
      {"zero", {.most_constraints = 12, .zero = 0.8}},
      {"huge", {.largest = 1e9}},
      {"tiny", {.largest = 0x1p-10}}};
  return all;
}

std::string report(std::uint64_t number) {
  const auto& [name, shape] = shapes()[number % shapes().size()];
  const double largest = shape.largest;
  const Problem problem = random_problem(number * 0x9E3779B97F4A7C15u + 1, shape);
  const std::string fault = what_is_wrong(problem, largest);
  if (fault.empty()) return {};
  const Problem small = shrink(problem, [&](const Problem& p) { return !what_is_wrong(p, largest).empty(); });
  std::ostringstream text;
  text << "problem " << number << " (" << name << "): " << fault << "\nshrunk to one of " << small.variables().size()
       << " variables and " << small.constraints().size() << " constraints: " << what_is_wrong(small, largest) << '\n';
  write_cfn(small, text);
  return text.str();
}

}  // namespace scenelore::engine::testing
