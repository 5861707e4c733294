#include "search.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "dominance.hpp"
#include "proof_log.hpp"
#include "tree_solver.hpp"

namespace scenelore::engine {
SearchResult Search::run(const std::vector<Decision>& assumptions, Cost limit) {
  SearchResult result;
  result.cost = limit;
  rounding_ = true;
  const auto accept = [&](const std::vector<int>& assignment, Cost cost) {
    result.cost = cost;
    result.assignment = assignment;
    preferred_ = assignment;
    if (report_.observer != nullptr) report_.observer->improved(report_.real(cost));
    return cost;
  };
  const int base = network_.level();
  result.complete = enumerate(assumptions, limit, accept);
  while (network_.level() > base) network_.pop();
  result.lower_bound = result.cost;
  if (!result.complete && !open_.empty()) result.lower_bound = std::min(result.cost, open_.top().bound);
  return result;
}

/// Once the search is a long one, the incumbent is better than it was when the root was made: costs diffuse there again, and
/// dominated labels go. False: no assignment is cheaper than the limit.
bool Search::tighten_root() {
  constexpr std::uint64_t kLongSearch = 16;
  constexpr int kMostRounds = 8;
  constexpr std::int64_t kMostWork = 10'000'000;
  if (tightened_ || !rounding_ || !network_.shifts() || budget_.nodes - nodes_before_ < kLongSearch) return true;
  tightened_ = true;
  network_.push();
  network_.set_limit(limit_);
  network_.set_budget(&budget_);
  bool alive = network_.strengthen(Network::Place::root_again);
  for (int round = 0; round < kMostRounds && dominates_ && alive; ++round) {
    const auto dominated = dominated_labels(network_.residual(), kMostWork);
    if (dominated.empty()) break;
    for (const auto& [v, label] : dominated) alive = alive && network_.remove(v, label);
    alive = alive && network_.strengthen(Network::Place::root_again);
  }
  network_.set_budget(nullptr);
  return alive;
}

bool Search::enumerate(const std::vector<Decision>& assumptions, Cost limit, const Accept& accept) {
  constexpr std::uint64_t kMostBacktracks = 4096;  // of one burst
  limit_ = network_.rounded_limit(limit);
  accept_ = accept;
  open_ = {};
  weight_.assign(static_cast<std::size_t>(network_.variables()), 1.0);
  burst_limit_ = in_order_ || log_ != nullptr ? std::numeric_limits<std::uint64_t>::max() : 1;
  last_failed_ = assumptions.empty() || assumptions.back().equal ? -1 : assumptions.back().variable;
  open_.push({network_.bound(), number_++, assumptions});
  nodes_before_ = budget_.nodes;
  next_polish_ = is_forbidden(limit) ? 0 : 1;
  tightened_ = false;
  Cost reported = 0;
  while (!open_.empty() && open_.top().bound < limit_) {
    if (stopped()) return false;
    if (rounding_ && polish_ && budget_.nodes - nodes_before_ >= next_polish_) polish();
    if (!tighten_root()) return true;
    const Open next = open_.top();
    open_.pop();
    if (report_.observer != nullptr && next.bound > reported) {
      reported = next.bound;
      report_.observer->bounded(report_.real(reported));
    }
    if (report_.observer != nullptr) report_.observer->entered(next.number);
    // Entering a node costs about its depth in nodes: bursts grow until that is less than a tenth of the work.
    const std::uint64_t before = budget_.nodes;
    burst(next);
    const std::uint64_t spent = budget_.nodes - before;
    if (in_order_) continue;
    if (next.path.size() * 10 > spent && burst_limit_ < kMostBacktracks)
      burst_limit_ *= 2;
    else if (next.path.size() * 20 < spent && burst_limit_ > 1)
      burst_limit_ /= 2;
  }
  return true;
}

bool Search::stopped() { return budget_.exhausted() || (log_ != nullptr && log_->is_full()); }

bool Search::apply(const Decision& d) {
  return d.equal ? network_.assign(d.variable, d.label) : network_.remove(d.variable, d.label);
}

bool Search::enter(const std::vector<Decision>& path) {
  network_.set_limit(limit_);
  for (const Decision& decision : path)
    if (!apply(decision)) return false;
  return network_.strengthen(log_ != nullptr ? Network::Place::root : Network::Place::entered);
}

/// All variables have one label: is it a better assignment?
bool Search::leaf(Cost& cost) {
  assignment_.resize(static_cast<std::size_t>(network_.variables()));
  for (int v = 0; v < network_.variables(); ++v) {
    if (network_.live(v).size() > 1) return false;
    assignment_[static_cast<std::size_t>(v)] = network_.value(v);
  }
  cost = network_.evaluate(assignment_);
  return true;
}

/// The labels that cost nothing, taken together, are often a good assignment, and the best one when they cost no more
/// than the bound.
void Search::round() {
  network_.round(assignment_);
  const Cost cost = network_.evaluate(assignment_);
  if (cost < limit_) limit_ = network_.rounded_limit(accept_(assignment_, cost));
}

/// A node whose open variables hang together so loosely that small tables do is settled without a branch. Returns whether.
bool Search::finish() {
  constexpr int kMostOpen = 48;
  constexpr std::size_t kMostEntries = 10'000;
  constexpr int kMostPairsAVariable = 3;
  if (!eliminates_ || log_ != nullptr || !network_.shifts()) return false;
  int open = 0;
  for (int v = 0; v < network_.variables(); ++v) open += network_.live(v).size() > 1 ? 1 : 0;
  if (open > kMostOpen || network_.open_pairs() > kMostPairsAVariable * open) return false;
  const Residual residual = network_.residual();
  const auto best = solve_by_elimination(residual, kMostEntries);
  if (!best) return false;
  if (best->cost >= limit_) return true;
  assignment_.resize(static_cast<std::size_t>(network_.variables()));
  for (int v = 0; v < network_.variables(); ++v) assignment_[static_cast<std::size_t>(v)] = network_.value(v);
  for (std::size_t i = 0; i < residual.variables.size(); ++i)
    assignment_[static_cast<std::size_t>(residual.variables[i].variable)] = residual.variables[i].labels[static_cast<std::size_t>(best->labels[i])];
  limit_ = network_.rounded_limit(accept_(assignment_, best->cost));
  return true;
}

/// A little at first; more once the search is a long one, or has nothing.
void Search::polish() {
  constexpr std::uint64_t kFewSweeps = 100, kManySweeps = 500, kSweepsANode = 2, kAfterNone = 4, kLongSearch = 256;
  const std::uint64_t nodes = budget_.nodes - nodes_before_;
  const bool had_none = is_forbidden(limit_), thorough = nodes >= kAfterNone;
  const auto better = polish_(limit_, thorough ? std::max(kManySweeps, kSweepsANode * nodes) : kFewSweeps);
  if (better) limit_ = network_.rounded_limit(accept_(*better, network_.evaluate(*better)));
  next_polish_ = std::max(had_none ? kAfterNone : kLongSearch, 2 * nodes);
}

void Search::burst(const Open& open) {
  const int base = network_.level();
  network_.set_budget(&budget_);
  network_.push();
  path_ = open.path;
  frames_.clear();
  burst_backtracks_ = 0;
  bool alive = enter(path_);
  if (!alive) learn_from_failure({-1, -1, true}, 0);
  for (;;) {
    if (alive) {
      Cost cost = 0;
      if (leaf(cost)) {
        if (cost < limit_) limit_ = network_.rounded_limit(accept_(assignment_, cost));
        alive = false;
      } else if (rounding_) {
        round();
        alive = network_.bound() < limit_ && !finish();
      }
    }
    if (alive && stopped()) {  // this node is open still
      open_.push({std::max(network_.bound(), open.bound), number_++, path_});
      hand_back(0);
      break;
    }
    if (alive) {
      const Decision decision = choose();
      frames_.push_back({decision, network_.bound(), path_.size()});
      path_.push_back(decision);
      ++budget_.nodes;
      if (report_.observer != nullptr)
        report_.observer->expanded(static_cast<int>(frames_.size()), report_.literal(decision.variable, decision.label),
                                   report_.real(network_.bound()));
      if (log_ != nullptr) log_->assumed(decision.variable, decision.label);
      network_.push();
      network_.set_limit(limit_);
      alive = apply(decision) && network_.strengthen(Network::Place::branch);
      if (!alive) learn_from_failure(decision, static_cast<int>(frames_.size()));
      continue;
    }
    // Back to the nearest node with an alternative that may still be cheaper.
    while (!frames_.empty() && frames_.back().bound >= limit_) {
      network_.pop();
      frames_.pop_back();
    }
    if (frames_.empty()) break;
    ++budget_.backtracks;
    if (report_.observer != nullptr) report_.observer->backtracked(static_cast<int>(frames_.size()));
    if (++burst_backtracks_ > burst_limit_) {
      hand_back(0);
      break;
    }
    const Frame frame = frames_.back();
    frames_.pop_back();
    if (log_ != nullptr) log_->refuted();
    network_.pop();
    path_.resize(frame.path);
    const Decision other{frame.decision.variable, frame.decision.label, !frame.decision.equal};
    path_.push_back(other);
    network_.set_limit(limit_);
    alive = apply(other) && network_.strengthen(Network::Place::branch);
    if (!alive) learn_from_failure(other, static_cast<int>(frames_.size()));
  }
  if (log_ != nullptr) log_->finish();
  while (network_.level() > base) network_.pop();
  network_.set_budget(nullptr);
}

/// The other branches of all frames become open nodes, the deepest first.
void Search::hand_back(std::size_t base_path) {
  while (frames_.size() > base_path) {
    const Frame& frame = frames_.back();
    if (frame.bound < limit_) {
      std::vector<Decision> path(path_.begin(), path_.begin() + static_cast<std::ptrdiff_t>(frame.path));
      path.push_back({frame.decision.variable, frame.decision.label, !frame.decision.equal});
      if (report_.observer != nullptr) report_.observer->deferred(static_cast<int>(frames_.size()), number_);
      open_.push({frame.bound, number_++, std::move(path)});
    }
    frames_.pop_back();
  }
}

Decision Search::first_in_order() const {
  int v = 0;
  while (network_.live(v).size() < 2) ++v;
  const auto labels = network_.live(v);
  return {v, *std::min_element(labels.begin(), labels.end()), true};
}

/// Fewest labels for its weight (how often it was where a branch failed) first: Boussemart, Hemery, Lecoutre, Sais,
/// "Boosting systematic search by weighting constraints", ECAI 2004; but the variable of the last conflict before all
/// others: Lecoutre, Sais, Tabary, Vidal, "Reasoning from last conflict(s)", AIJ 2009.
int Search::branching_variable() const {
  if (last_failed_ >= 0 && network_.live(last_failed_).size() > 1) return last_failed_;
  int best = -1;
  double best_key = 0;
  const bool diving = is_forbidden(limit_);
  for (int v = 0; v < network_.variables(); ++v) {
    const auto labels = network_.live(v);
    if (labels.size() < 2) continue;
    double key = 0;
    if (diving) {  // to a first assignment: the clearest first
      key = -static_cast<double>(clearance(v));
    } else {
      const Cost room = limit_ - network_.bound();
      double spread = 0;  // in [0, number of labels]: how near to hopeless its labels are
      for (const int label : labels)
        spread += static_cast<double>(std::min(network_.unary(v, label), room)) / static_cast<double>(room);
      key = static_cast<double>(labels.size()) /
            (weight_[static_cast<std::size_t>(v)] * (1 + network_.degree(v)) * (1 + spread));
    }
    if (best < 0 || key < best_key) best = v, best_key = key;
  }
  return best;
}

/// By how much the second best label is dearer than the best one.
Cost Search::clearance(int v) const {
  Cost least = kTop, second = kTop;
  for (const int label : network_.live(v)) {
    const Cost cost = network_.unary(v, label);
    if (cost < least)
      second = std::exchange(least, cost);
    else
      second = std::min(second, cost);
  }
  return second - least;
}

Decision Search::choose() {
  if (in_order_) return first_in_order();
  const int best = branching_variable();
  int label = -1;
  for (const int candidate : network_.live(best)) {
    if (label < 0) {
      label = candidate;
      continue;
    }
    const auto key = [&](int l) {
      const bool preferred = !preferred_.empty() && preferred_[static_cast<std::size_t>(best)] == l;
      return std::tuple(network_.unary(best, l), !preferred, network_.original(best, l), l);
    };
    if (key(candidate) < key(label)) label = candidate;
  }
  return {best, label, true};
}

void Search::learn_from_failure(const Decision& decision, int depth) {
  if (network_.failed_variable() >= 0) {
    weight_[static_cast<std::size_t>(network_.failed_variable())] += weight_step_;
  }
  if (decision.variable >= 0 && decision.equal) last_failed_ = decision.variable;
  if (report_.observer != nullptr && decision.variable >= 0)
    report_.observer->pruned(depth, report_.literal(decision.variable, decision.label), network_.failed_constraint());
}

}  // namespace scenelore::engine
