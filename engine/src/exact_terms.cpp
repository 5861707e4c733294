#include "exact_terms.hpp"

#include <algorithm>
#include <set>

namespace scenelore::engine::exact {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

Cost exactly(const Scale& scale, double cost) {
  const Cost whole = scale.whole(cost);
  return is_forbidden(whole) ? kNever : whole;
}

bool is_in(const std::vector<std::vector<char>>& live, const Literal& literal) {
  return live[index(literal.variable)][index(literal.label)] != 0;
}

/// If the owner has the label: the least cost of a support that holds.
class RequirementTerm : public Term {
 public:
  struct Way {
    std::size_t place;
    int label;
    Cost cost;
  };
  RequirementTerm(const Problem& problem, std::vector<int> scope, Literal owner, Cost weight,
                  const std::vector<Support>& supports, const Scale& scale)
      : Term(problem, std::move(scope)), owner_(owner), owner_place_(place(owner.variable)), weight_(weight) {
    for (const Support& support : supports)
      ways_.push_back({place(support.literal.variable), support.literal.label, exactly(scale, support.cost)});
  }

  /// At most one support need hold, so all other members may be where they cost least.
  Cost least(const Choice& choice) const override {
    std::vector<Cost> cheapest(scope().size(), 0);
    Cost all = 0;
    for (std::size_t j = 0; j < scope().size(); ++j) {
      if (j == owner_place_) continue;
      cheapest[j] = kNever;
      for (int label = 0; label < labels(j); ++label)
        if (choice.allows(scope()[j], label)) cheapest[j] = std::min(cheapest[j], minus(0, moved_at(j, label)));
      all = plus(all, cheapest[j]);
    }
    if (all == kNever) return kNever;
    Cost price = weight_;
    for (const Way& way : ways_)
      if (choice.allows(scope()[way.place], way.label))
        price = std::min(price, plus(way.cost, minus(minus(0, moved_at(way.place, way.label)), cheapest[way.place])));
    Cost least = kNever;
    for (int label = 0; label < labels(owner_place_); ++label)
      if (choice.allows(owner_.variable, label))
        least = std::min(least, minus(plus(all, label == owner_.label ? price : 0), moved_at(owner_place_, label)));
    return least;
  }

 private:
  Literal owner_;
  std::size_t owner_place_;
  Cost weight_;
  std::vector<Way> ways_;
};

/// If the condition holds (always, without one): the price of how many members are counted.
class CardinalityTerm : public Term {
 public:
  CardinalityTerm(const Problem& problem, std::vector<int> scope, const Cardinality& cardinality,
                  const std::set<Literal>& counted, int always, Cost weight)
      : Term(problem, std::move(scope)),
        condition_(cardinality.condition.value_or(Literal{-1, -1})),
        counted_(counted),
        always_(always),
        low_(cardinality.low),
        high_(cardinality.high),
        weight_(weight) {}

  Cost least(const Choice& choice) const override {
    Cost unpriced = 0;             // the members where they cost least
    Cost base = 0;                 // the same with as few counted as can be
    int count = always_;           // so many
    std::vector<Cost> differences; // what each further one costs
    for (std::size_t j = 0; j < scope().size(); ++j) {
      const int v = scope()[j];
      if (v == condition_.variable) continue;
      Cost in = kNever, out = kNever;
      for (int label = 0; label < labels(j); ++label) {
        if (!choice.allows(v, label)) continue;
        Cost& side = counted_.contains({v, label}) ? in : out;
        side = std::min(side, minus(0, moved_at(j, label)));
      }
      if (in == kNever && out == kNever) return kNever;
      unpriced = plus(unpriced, std::min(in, out));
      base = plus(base, out == kNever ? in : out);
      if (out == kNever)
        ++count;
      else if (in != kNever)
        differences.push_back(minus(in, out));
    }
    std::sort(differences.begin(), differences.end());
    Cost priced = kNever;
    for (std::size_t more = 0;; ++more) {
      priced = std::min(priced, plus(base, price(count + static_cast<int>(more))));
      if (more == differences.size()) break;
      base = plus(base, differences[more]);
    }
    if (condition_.variable < 0) return priced;
    const std::size_t owner = place(condition_.variable);
    Cost least = kNever;
    for (int label = 0; label < labels(owner); ++label) {
      if (!choice.allows(condition_.variable, label)) continue;
      const Cost cost = label == condition_.label ? priced : unpriced;
      if (cost != kNever) least = std::min(least, minus(cost, moved_at(owner, label)));
    }
    return least;
  }

 private:
  Cost price(int count) const {
    const long long off = std::max({0LL, static_cast<long long>(low_) - count, static_cast<long long>(count) - high_});
    if (off == 0) return 0;
    Cost product = 0;
    if (weight_ == kNever) return kNever;
    if (__builtin_mul_overflow(weight_, static_cast<Cost>(off), &product)) throw Refused("an amount is too large");
    return product;
  }

  Literal condition_;
  std::set<Literal> counted_;
  int always_, low_, high_;
  Cost weight_;
};

std::vector<int> sorted(const std::set<int>& scope) { return {scope.begin(), scope.end()}; }

}  // namespace

Cost plus(Cost a, Cost b) {
  if (a == kNever || b == kNever) return kNever;
  Cost sum = 0;
  if (__builtin_add_overflow(a, b, &sum) || sum == kNever) throw Refused("an amount is too large");
  return sum;
}

Cost minus(Cost a, Cost b) {
  if (a == kNever) return kNever;
  Cost difference = 0;
  if (__builtin_sub_overflow(a, b, &difference) || difference == kNever) throw Refused("an amount is too large");
  return difference;
}

Term::Term(const Problem& problem, std::vector<int> scope) : scope_(std::move(scope)) {
  for (const int v : scope_) moved_.emplace_back(problem.variables()[index(v)].labels.size(), 0);
}

std::size_t Term::place(int v) const {
  return static_cast<std::size_t>(std::lower_bound(scope_.begin(), scope_.end(), v) - scope_.begin());
}

Cost* Term::moved(int v, int label) {
  const std::size_t at = place(v);
  if (at == scope_.size() || scope_[at] != v || label < 0 || label >= labels(at)) return nullptr;
  return &moved_[at][index(label)];
}

std::unique_ptr<Term> make_term(const Problem& problem, const Scale& scale, const ConstraintView& constraint,
                                const std::vector<std::vector<char>>& live) {
  Cost weight = exactly(scale, constraint.weight);
  std::set<int> scope;
  if (const auto* requirement = constraint.as<Requirement>()) {
    const Literal owner = requirement->literal;
    std::vector<Support> supports;
    if (is_in(live, owner)) scope.insert(owner.variable);
    for (const Support& support : requirement->supports) {
      if (support.literal == owner) weight = std::min(weight, exactly(scale, support.cost));
      if (support.literal.variable == owner.variable || !is_in(live, support.literal) || scope.empty()) continue;
      scope.insert(support.literal.variable);
      supports.push_back(support);
    }
    if (scope.empty()) scope.insert(owner.variable);
    return std::make_unique<RequirementTerm>(problem, sorted(scope), owner, weight, supports, scale);
  }
  if (const auto* cardinality = constraint.as<Cardinality>()) {
    std::set<Literal> counted;
    int always = 0;
    if (cardinality->condition) scope.insert(cardinality->condition->variable);
    for (const Literal& literal : cardinality->literals) {
      if (cardinality->condition && literal.variable == cardinality->condition->variable) {
        if (literal == *cardinality->condition) always = 1;  // the other ones do not hold when it matters
        continue;
      }
      if (!is_in(live, literal) || (cardinality->condition && !is_in(live, *cardinality->condition))) continue;
      counted.insert(literal);
      scope.insert(literal.variable);
    }
    return std::make_unique<CardinalityTerm>(problem, sorted(scope), *cardinality, counted, always, weight);
  }
  return nullptr;
}

PairTerm::PairTerm(const Problem& problem, int x, int y) : Term(problem, {x, y}) {
  costs_.assign(problem.variables()[index(x)].labels.size() * problem.variables()[index(y)].labels.size(), 0);
}

void PairTerm::add(const Problem& problem, const Scale& scale, const ConstraintView& constraint) {
  const auto add = [&](int label_x, int label_y, Cost cost) {
    Cost& sum = costs_[index(label_x * labels(1) + label_y)];
    sum = plus(sum, cost);
  };
  if (const auto* conflict = constraint.as<Conflict>()) {
    const bool swapped = conflict->a.variable != scope()[0];
    const Literal& first = swapped ? conflict->b : conflict->a;
    const Literal& second = swapped ? conflict->a : conflict->b;
    add(first.label, second.label, exactly(scale, constraint.weight));
  } else if (const auto* pair = constraint.as<PairTable>()) {
    const bool swapped = pair->a != scope()[0];
    const std::vector<double>& table = problem.table(pair->table);
    const int columns = problem.table_size(pair->table).second;
    for (int x = 0; x < labels(0); ++x)
      for (int y = 0; y < labels(1); ++y) {
        const double entry = table[index(swapped ? y * columns + x : x * columns + y)];
        if (entry > 0) add(x, y, constraint.weight == kHard ? kNever : exactly(scale, entry * constraint.weight));
      }
  }
}

Cost PairTerm::least(const Choice& choice) const {
  const int v = scope()[0], w = scope()[1];
  Cost least = kNever;
  for (int x = choice.first(v); x < choice.last(v, labels(0)); ++x) {
    if (!choice.allows(v, x)) continue;
    for (int y = choice.first(w); y < choice.last(w, labels(1)); ++y)
      if (choice.allows(w, y))
        least = std::min(least, minus(minus(costs_[index(x * labels(1) + y)], moved_at(0, x)), moved_at(1, y)));
  }
  return least;
}

LabelTerm::LabelTerm(const Problem& problem, const Scale& scale, int v) : Term(problem, {v}) {
  for (const double cost : problem.variables()[index(v)].costs) costs_.push_back(exactly(scale, cost));
}

void LabelTerm::charge(int label, Cost cost) { costs_[index(label)] = plus(costs_[index(label)], cost); }

Cost LabelTerm::least(const Choice& choice) const {
  Cost least = kNever;
  for (int label = 0; label < labels(0); ++label)
    if (choice.allows(scope()[0], label)) least = std::min(least, minus(costs_[index(label)], moved_at(0, label)));
  return least;
}

}  // namespace scenelore::engine::exact
