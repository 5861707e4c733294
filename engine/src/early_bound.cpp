#include "early_bound.hpp"

#include <algorithm>

namespace scenelore::engine {

EarlyBound::EarlyBound(const Outline& outline, std::span<const int> world)
    : outline_(outline), world_(world.begin(), world.end()), alive_(outline.own.size(), 1), cost_(outline.own),
      clash_left_(outline.price), need_taken_(outline.needs.size(), 0), pairs_of_(at(outline.variables())),
      props_of_world_(pairs_of_.size()) {
  for (const Outline::Count& count : outline.counts) count_left_.push_back(count.weight);
  std::size_t taken = 0;
  for (std::size_t p = 0; p < outline.pairs.size(); ++p) {
    const Outline::Pair& pair = outline.pairs[p];
    pairs_of_[at(pair.a)].push_back(static_cast<int>(p));
    pairs_of_[at(pair.b)].push_back(static_cast<int>(p));
    first_taken_.push_back(taken);
    taken += at(outline.labels(pair.a) + outline.labels(pair.b));
  }
  pair_taken_.assign(taken, 0);
  if (world_.empty()) return;
  for (std::size_t n = 0; n < outline.needs.size(); ++n) {
    if (!is_held(outline.needs[n].owner)) continue;
    for (const auto& [literal, cost] : outline.props_of(outline.needs[n]))
      if (is_held(literal) && cost < outline.needs[n].weight) props_of_world_[at(outline.variable(literal))].push_back(n);
  }
}

Cost EarlyBound::surplus(int literal) const {
  return std::max<Cost>(0, cost_[at(literal)] - cost_[at(held(outline_.variable(literal)))]);
}

/// A need that gave t to its owner, and was given by each prop what it saved less than t, is at least as dear as the same
/// need with t off its weight and off the cost of each prop.
Cost EarlyBound::left(Cost cost, const Outline::Need& need) const {
  const auto number = static_cast<std::size_t>(&need - outline_.needs.data());
  return is_forbidden(cost) ? kTop : std::max<Cost>(0, cost - need_taken_[number]);
}

std::size_t EarlyBound::taken_from(std::size_t pair, bool is_a, int label) const {
  return first_taken_[pair] + at(label + (is_a ? 0 : outline_.labels(outline_.pairs[pair].a)));
}

Cost EarlyBound::left(const Outline::Pair& pair, std::size_t number, int label_a, int label_b) const {
  const Cost cost = outline_.cost(pair, label_a, label_b);
  const Cost taken = pair_taken_[taken_from(number, true, label_a)] + pair_taken_[taken_from(number, false, label_b)];
  return is_forbidden(cost) ? kTop : std::max<Cost>(0, cost - taken);
}

/// What the world's label of v pays still for functions with others.
Cost EarlyBound::paid_by_world(int v) const {
  const int literal = held(v);
  Cost sum = 0;
  for (const auto& [other, number] : outline_.clashes_of(literal))
    if (is_held(other)) sum += clash_left_[at(number)];
  for (const Outline::Need& need : outline_.needs_of(literal)) {
    Cost least = weight(need);
    for (const auto& [prop, cost] : outline_.props_of(need))
      if (is_held(prop)) least = std::min(least, left(cost, need));
    sum += least;
  }
  for (const int p : pairs_of_[at(v)]) {
    const Outline::Pair& pair = outline_.pairs[at(p)];
    sum += left(pair, at(p), world_[at(pair.a)], world_[at(pair.b)]);
  }
  return is_forbidden(sum) ? 0 : sum;
}

void EarlyBound::raise() {
  if (world_.empty()) return;
  for (int v = 0; v < outline_.variables(); ++v) {
    raise_as_props(v);
    const Cost pays = paid_by_world(v);
    const Cost wanted = cost_[at(held(v))] + pays;
    Cost least = kTop;
    for (int literal = outline_.first_label[at(v)]; literal < outline_.first_label[at(v) + 1]; ++literal) {
      if (!is_alive(literal) || is_held(literal)) continue;
      if (cost_[at(literal)] < wanted) raise(literal, wanted - cost_[at(literal)]);
      least = std::min(least, cost_[at(literal)]);
    }
    const Cost more = std::min(pays, least - cost_[at(held(v))]);
    if (more > 0) raise(held(v), more);
  }
  for (std::size_t c = 0; c < outline_.counts.size(); ++c) raise_by_count(outline_.counts[c], count_left_[c]);
}

Cost EarlyBound::raise(int literal, Cost wanted) {
  Cost got = raise_by_needs(literal, wanted);
  if (got < wanted) got += raise_by_clashes(literal, wanted - got);
  if (got < wanted) got += raise_by_pairs(literal, wanted - got);
  return got;
}

void EarlyBound::pay() {
  for (const auto& [literal, amount] : charges_) cost_[at(literal)] -= amount;
  charges_.clear();
}

Cost EarlyBound::raise_by_needs(int literal, Cost wanted) {
  Cost got = 0;
  for (const Outline::Need& need : outline_.needs_of(literal)) {
    if (got == wanted) break;
    Cost amount = std::min(wanted - got, weight(need));
    for (const auto& [prop, cost] : outline_.props_of(need))
      if (is_alive(prop) && amount > 0) amount = std::min(amount, left(cost, need) + surplus(prop));
    if (amount <= 0) continue;
    for (const auto& [prop, cost] : outline_.props_of(need))
      if (is_alive(prop) && left(cost, need) < amount) charges_.push_back({prop, amount - left(cost, need)});
    pay();
    need_taken_[static_cast<std::size_t>(&need - outline_.needs.data())] += amount;
    cost_[at(literal)] += amount;
    got += amount;
  }
  return got;
}

/// Conflicts with the labels of one other variable, together: the world's label must be among them, since it does not pay.
Cost EarlyBound::raise_by_clashes(int literal, Cost wanted) {
  rows_.clear();
  bool any = false;
  for (const auto& [other, number] : outline_.clashes_of(literal)) {
    if (!is_alive(other) || clash_left_[at(number)] == 0) continue;
    rows_.push_back({other, number});
    any = any || is_held(other);
  }
  if (!any) return 0;
  std::sort(rows_.begin(), rows_.end(), [&](const Row& a, const Row& b) {
    return a.other != b.other ? a.other < b.other : clash_left_[at(a.number)] < clash_left_[at(b.number)];
  });
  Cost got = 0;
  for (std::size_t first = 0, last = 0; first < rows_.size() && got < wanted; first = last) {
    const int v = outline_.variable(rows_[first].other);
    bool with_world = false;
    for (; last < rows_.size() && outline_.variable(rows_[last].other) == v; ++last) with_world = with_world || is_held(rows_[last].other);
    if (with_world) got += raise_by_row(literal, std::span(rows_).subspan(first, last - first), wanted - got);
  }
  return got;
}

Cost EarlyBound::raise_by_row(int literal, std::span<const Row> row, Cost wanted) {
  const int v = outline_.variable(row[0].other);
  const auto clash_with = [&](int other) {
    Cost sum = 0;
    for (const Row& entry : row)
      if (entry.other == other) sum = std::min(sum + clash_left_[at(entry.number)], kTop);
    return sum;
  };
  Cost amount = wanted;
  const int first = outline_.first_label[at(v)], last = outline_.first_label[at(v) + 1];
  for (int other = first; other < last && amount > 0; ++other)
    if (is_alive(other)) amount = std::min(amount, clash_with(other) + surplus(other));
  if (amount <= 0) return 0;
  for (int other = first; other < last; ++other)
    if (const Cost clash = clash_with(other); is_alive(other) && clash < amount) charges_.push_back({other, amount - clash});
  pay();
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool again = i > 0 && row[i - 1].other == row[i].other;  // the second of two conflicts of the same labels
    Cost& clash = clash_left_[at(row[i].number)];
    if (!is_forbidden(clash)) clash = again ? 0 : std::max<Cost>(0, clash - amount);
  }
  cost_[at(literal)] += amount;
  return amount;
}

Cost EarlyBound::raise_by_pairs(int literal, Cost wanted) {
  Cost got = 0;
  const int v = outline_.variable(literal), label = outline_.label(literal);
  for (const int p : pairs_of_[at(v)]) {
    if (got == wanted) break;
    const Outline::Pair& pair = outline_.pairs[at(p)];
    const bool is_a = pair.a == v;
    const int y = is_a ? pair.b : pair.a;
    const auto with = [&](int other) { return is_a ? left(pair, at(p), label, other) : left(pair, at(p), other, label); };
    Cost amount = std::min(wanted - got, with(world_[at(y)]));
    const int first = outline_.first_label[at(y)];
    for (int other = 0; other < outline_.labels(y) && amount > 0; ++other)
      if (is_alive(first + other)) amount = std::min(amount, with(other) + surplus(first + other));
    if (amount <= 0) continue;
    for (int other = 0; other < outline_.labels(y); ++other)
      if (is_alive(first + other) && with(other) < amount) charges_.push_back({first + other, amount - with(other)});
    pay();
    pair_taken_[taken_from(at(p), is_a, label)] += amount;
    cost_[at(literal)] += amount;
    got += amount;
  }
  return got;
}

/// The world's label of v is what a need of the world is met by; other labels of v cost what it is to meet it otherwise.
void EarlyBound::raise_as_props(int v) {
  for (const std::size_t n : props_of_world_[at(v)]) {
    const Outline::Need& need = outline_.needs[n];
    const int x = outline_.variable(need.owner);
    Cost wanted = 0;
    const int first = outline_.first_label[at(v)], last = outline_.first_label[at(v) + 1];
    for (int literal = first; literal < last; ++literal)
      if (is_alive(literal)) wanted = std::max(wanted, cost_[at(held(v))] - cost_[at(literal)]);
    if (wanted == 0) return;
    Cost amount = std::min(wanted, weight(need));
    for (int literal = outline_.first_label[at(x)]; literal < outline_.first_label[at(x) + 1]; ++literal)
      if (is_alive(literal) && literal != need.owner) amount = std::min(amount, surplus(literal));
    Cost own = kTop;  // of the world's label as a prop
    for (const auto& [prop, cost] : outline_.props_of(need)) {
      if (!is_alive(prop)) continue;
      if (prop == held(v)) own = left(cost, need);
      if (outline_.variable(prop) != v) amount = std::min(amount, left(cost, need) + surplus(prop));
    }
    if (amount <= 0 || own > 0) continue;
    for (int literal = outline_.first_label[at(x)]; literal < outline_.first_label[at(x) + 1]; ++literal)
      if (is_alive(literal) && literal != need.owner) charges_.push_back({literal, amount});
    for (const auto& [prop, cost] : outline_.props_of(need))
      if (is_alive(prop) && outline_.variable(prop) != v && left(cost, need) < amount)
        charges_.push_back({prop, amount - left(cost, need)});
    pay();
    for (int literal = first; literal < last; ++literal) {
      if (!is_alive(literal)) continue;
      Cost gain = amount;
      for (const auto& [prop, cost] : outline_.props_of(need))
        if (prop == literal) gain = std::min(gain, left(cost, need));
      cost_[at(literal)] += gain;
    }
    need_taken_[n] += amount;
  }
}

/// "At most so many", when the world has just so many: each further one costs what it is to do without one of them.
void EarlyBound::raise_by_count(const Outline::Count& count, Cost& left) {
  if (count.condition >= 0 || left == 0) return;
  const auto counts = [&](int literal) { return std::binary_search(count.literals.begin(), count.literals.end(), literal); };
  std::vector<char> is_in(at(outline_.variables()), 0);
  int in_world = 0;
  Cost amount = 0;
  for (const int literal : count.literals)
    if (is_held(literal)) is_in[at(outline_.variable(literal))] = 1, ++in_world;
  if (in_world != count.high) return;
  for (const int literal : count.literals) {
    const int v = outline_.variable(literal);
    if (is_alive(literal) && is_in[at(v)] == 0) amount = std::max(amount, cost_[at(held(v))] - cost_[at(literal)]);
  }
  amount = std::min(amount, left);
  const auto for_each_other = [&](const auto& visit) {
    for (int v = 0; v < outline_.variables(); ++v)
      for (int literal = outline_.first_label[at(v)]; is_in[at(v)] != 0 && literal < outline_.first_label[at(v) + 1]; ++literal)
        if (is_alive(literal) && !counts(literal)) visit(literal);
  };
  for_each_other([&](int literal) { amount = std::min(amount, surplus(literal)); });
  if (amount <= 0) return;
  for_each_other([&](int literal) { cost_[at(literal)] -= amount; });
  for (const int literal : count.literals)
    if (is_alive(literal) && is_in[at(outline_.variable(literal))] == 0) cost_[at(literal)] += amount;
  if (!is_forbidden(left)) left -= amount;
}

/// The label of each variable that has just one left, else −1.
std::vector<int> EarlyBound::only_labels() const {
  std::vector<int> only(at(outline_.variables()), -1);
  for (int v = 0; v < outline_.variables(); ++v) {
    int alive = 0;
    for (int literal = outline_.first_label[at(v)]; literal < outline_.first_label[at(v) + 1]; ++literal)
      if (is_alive(literal)) only[at(v)] = literal, ++alive;
    if (alive > 1) only[at(v)] = -1;
  }
  return only;
}

/// With what functions cost a label in any case: needs their owner, with the props that are left; conflicts and pairs with a
/// label that must hold.
std::vector<Cost> EarlyBound::projected() const {
  std::vector<Cost> costs = cost_;
  const auto add = [&](int literal, Cost cost) { costs[at(literal)] = std::min(costs[at(literal)] + cost, kTop); };
  for (const Outline::Need& need : outline_.needs) {
    if (!is_alive(need.owner)) continue;
    Cost least = weight(need);
    for (const auto& [prop, cost] : outline_.props_of(need)) {
      if (least == 0) break;
      if (is_alive(prop)) least = std::min(least, left(cost, need));
    }
    if (least > 0) add(need.owner, least);
  }
  const std::vector<int> only = only_labels();
  for (const int literal : only) {
    if (literal < 0) continue;
    for (const auto& [other, number] : outline_.clashes_of(literal))
      if (is_alive(other) && (only[at(outline_.variable(other))] < 0 || other > literal)) add(other, clash_left_[at(number)]);
  }
  for (std::size_t p = 0; p < outline_.pairs.size(); ++p) {
    const Outline::Pair& pair = outline_.pairs[p];
    const int a = only[at(pair.a)], b = only[at(pair.b)];
    const auto label = [&](int literal) { return outline_.label(literal); };
    if (a >= 0 && b >= 0) {
      add(a, left(pair, p, label(a), label(b)));
    } else if (a >= 0) {
      for (int l = 0; l < outline_.labels(pair.b); ++l) add(outline_.first_label[at(pair.b)] + l, left(pair, p, label(a), l));
    } else if (b >= 0) {
      for (int l = 0; l < outline_.labels(pair.a); ++l) add(outline_.first_label[at(pair.a)] + l, left(pair, p, l, label(b)));
    }
  }
  return costs;
}

bool EarlyBound::strike(Cost limit, std::span<const int> keep) {
  const std::vector<Cost> costs = projected();
  std::vector<int> cheapest;
  Cost bound = 0;
  for (int v = 0; v < outline_.variables(); ++v) {
    int best = outline_.first_label[at(v)];
    for (int literal = best; literal < outline_.first_label[at(v) + 1]; ++literal)
      if (is_alive(literal) && (!is_alive(best) || costs[at(literal)] < costs[at(best)])) best = literal;
    cheapest.push_back(best);
    bound = std::min(bound + costs[at(best)], kTop);
  }
  if (is_forbidden(bound)) return false;  // nothing is below the limit; the network will say so
  bool any = false;
  for (int literal = 0; literal < outline_.literals(); ++literal) {
    const int v = outline_.variable(literal), best = cheapest[at(v)];
    if (!is_alive(literal) || literal == best || bound - costs[at(best)] + costs[at(literal)] < limit) continue;
    if (!keep.empty() && keep[at(v)] == outline_.label(literal)) continue;
    alive_[at(literal)] = 0;
    any = true;
  }
  return any;
}

std::vector<std::vector<char>> EarlyBound::labels() const {
  std::vector<std::vector<char>> all;
  for (int v = 0; v < outline_.variables(); ++v)
    all.emplace_back(alive_.begin() + outline_.first_label[at(v)], alive_.begin() + outline_.first_label[at(v) + 1]);
  return all;
}

}  // namespace scenelore::engine
