#include "exact_part.hpp"

#include <algorithm>

namespace scenelore::engine::exact {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

std::vector<std::vector<int>> constraints_of(const Problem& problem) {
  std::vector<std::vector<int>> all(problem.variables().size());
  for (std::size_t c = 0; c < problem.constraints().size(); ++c) {
    const auto note = [&](int v) {
      auto& of = all[index(v)];
      if (of.empty() || of.back() != static_cast<int>(c)) of.push_back(static_cast<int>(c));
    };
    const ConstraintView constraint = problem.constraints()[c];
    if (const auto* conflict = constraint.as<Conflict>()) {
      note(conflict->a.variable);
      note(conflict->b.variable);
    } else if (const auto* requirement = constraint.as<Requirement>()) {
      note(requirement->literal.variable);
    } else if (const auto* cardinality = constraint.as<Cardinality>()) {
      if (cardinality->condition) note(cardinality->condition->variable);
      for (const Literal& literal : cardinality->literals) note(literal.variable);
    } else if (const auto* pair = constraint.as<PairTable>()) {
      note(pair->a);
      note(pair->b);
    }
  }
  return all;
}

Part::Part(const Problem& problem, const Scale& scale, const std::vector<std::vector<int>>& constraints_of,
           std::vector<std::vector<char>>& live, const std::vector<int>& variables)
    : live_(live) {
  std::vector<char> mine(problem.variables().size(), 0);
  std::vector<int> constraints;
  for (const int v : variables) {
    mine[index(v)] = 1;
    label_term_[v] = static_cast<int>(terms_.size());
    add(std::make_unique<LabelTerm>(problem, scale, v));
    constraints.insert(constraints.end(), constraints_of[index(v)].begin(), constraints_of[index(v)].end());
  }
  std::sort(constraints.begin(), constraints.end());
  constraints.erase(std::unique(constraints.begin(), constraints.end()), constraints.end());
  for (const int c : constraints) {
    const ConstraintView constraint = problem.constraints()[index(c)];
    if (const auto* conflict = constraint.as<Conflict>()) {
      add_pair(problem, scale, constraint, conflict->a.variable, conflict->b.variable);
    } else if (const auto* pair = constraint.as<PairTable>()) {
      add_pair(problem, scale, constraint, pair->a, pair->b);
    } else {
      auto term = make_term(problem, scale, constraint, live_);
      const auto& scope = term->scope();
      if (scope.empty() || !std::all_of(scope.begin(), scope.end(), [&](int v) { return mine[index(v)] != 0; })) continue;
      constraint_term_[c] = static_cast<int>(terms_.size());
      add(std::move(term));
    }
  }
}

void Part::add_pair(const Problem& problem, const Scale& scale, const ConstraintView& constraint, int a, int b) {
  if (!label_term_.contains(a) || !label_term_.contains(b)) return;
  if (a == b) {
    const Conflict& conflict = *constraint.as<Conflict>();
    const Cost weight = scale.whole(constraint.weight);
    if (conflict.a == conflict.b)
      static_cast<LabelTerm&>(*terms_[index(label_term_[a])]).charge(conflict.a.label, is_forbidden(weight) ? kNever : weight);
    return;
  }
  const auto [known, fresh] = pair_term_.try_emplace(std::minmax(a, b), static_cast<int>(terms_.size()));
  if (fresh) add(std::make_unique<PairTerm>(problem, std::min(a, b), std::max(a, b)));
  static_cast<PairTerm&>(*terms_[index(known->second)]).add(problem, scale, constraint);
}

void Part::add(std::unique_ptr<Term> term) {
  for (const int v : term->scope()) terms_of_[v].push_back(static_cast<int>(terms_.size()));
  terms_.push_back(std::move(term));
  least_.push_back(0);
  stale_.push_back(0);
  weak_.push_back(0);
  mark_stale(static_cast<int>(terms_.size()) - 1);
}

void Part::mark_stale(int term) {
  if (stale_[index(term)] != 0) return;
  stale_[index(term)] = 1;
  stale_terms_.push_back(term);
}

void Part::refresh(std::vector<int>& terms) {
  const Choice choice(live_);
  for (const int term : terms) {
    if (stale_[index(term)] == 0 && weak_[index(term)] == 0) continue;
    Cost& least = least_[index(term)];
    if (least == kNever)
      --never_;
    else
      sum_ = minus(sum_, least);
    least = terms_[index(term)]->least(choice);
    if (least == kNever)
      ++never_;
    else
      sum_ = plus(sum_, least);
    stale_[index(term)] = weak_[index(term)] = 0;
  }
  terms.clear();
}

Cost Part::known_least(Literal literal) const {
  if (never_ > 0) return kNever;
  Cost sum = sum_;
  if (literal.variable < 0) return sum;
  const Choice choice(live_, literal);
  for (const int term : terms_of_.at(literal.variable)) {
    const Cost with = terms_[index(term)]->least(choice);
    if (with == kNever) return kNever;
    sum = plus(sum, minus(with, least_[index(term)]));
  }
  return sum;
}

Cost Part::least(Literal literal, Cost enough) {
  refresh(stale_terms_);
  const Cost known = known_least(literal);
  if (known >= enough || weak_terms_.empty()) return known;
  refresh(weak_terms_);
  return known_least(literal);
}

bool Part::is_live(Literal literal) const {
  if (!label_term_.contains(literal.variable)) throw Refused("the variable is not in this part");
  const auto& labels = live_[index(literal.variable)];
  if (literal.label < 0 || index(literal.label) >= labels.size()) throw Refused("the variable has no such label");
  return labels[index(literal.label)] != 0;
}

void Part::remove(Literal literal) {
  trail_.push_back({-1, literal, 0});
  live_[index(literal.variable)][index(literal.label)] = 0;
  for (const int term : terms_of_[literal.variable]) {
    if (weak_[index(term)] != 0) continue;
    weak_[index(term)] = 1;
    weak_terms_.push_back(term);
  }
}

void Part::set(int term, Literal to, Cost amount) {
  Cost& from = *terms_[index(term)]->moved(to.variable, to.label);
  const int labels = label_term_[to.variable];
  Cost& there = *terms_[index(labels)]->moved(to.variable, to.label);
  there = minus(there, minus(amount, from));
  from = amount;
  mark_stale(term);
  mark_stale(labels);
}

void Part::move(int term, Literal to, Cost amount) {
  const Cost* from = terms_[index(term)]->moved(to.variable, to.label);
  if (from == nullptr) throw Refused("the function has no such variable or label");
  trail_.push_back({term, to, *from});
  set(term, to, amount);
}

void Part::move_from_pair(int x, int y, Literal to, Cost amount) {
  const auto known = pair_term_.find({x, y});
  if (known == pair_term_.end()) throw Refused("this part has no constraint between the two variables");
  move(known->second, to, amount);
}

void Part::move_from_constraint(int constraint, Literal to, Cost amount) {
  const auto known = constraint_term_.find(constraint);
  if (known == constraint_term_.end()) throw Refused("this part has no such constraint of many variables");
  move(known->second, to, amount);
}

void Part::undo(std::size_t mark) {
  for (; trail_.size() > mark; trail_.pop_back()) {
    const Step& step = trail_.back();
    if (step.term >= 0) {
      set(step.term, step.literal, step.before);
      continue;
    }
    live_[index(step.literal.variable)][index(step.literal.label)] = 1;
    for (const int term : terms_of_[step.literal.variable]) mark_stale(term);
  }
}

}  // namespace scenelore::engine::exact
