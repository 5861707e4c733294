// Shifting costs through a cardinality. Each member j is counted at least cost in_j or not at least cost out_j; the sum
// for exactly t counted ones is least with the t smallest differences in_j − out_j, which makes it convex in t, as is
// the price of t itself. So the least total, and a multiplier that shows it, come from one sort.
#include <algorithm>

#include "network.hpp"

namespace scenelore::engine {

/// Whether one label more or less could matter: how many are counted in any case, and how many can be.
bool Network::is_tight(const CardinalityFunction& f) const {
  int least = 0, most = 0;
  for (const auto& member : f.members) {
    bool in = false, out = false;
    for (const int label : live(member.variable))
      (member.counts[static_cast<std::size_t>(label)] != 0 ? in : out) = true;
    least += out ? 0 : 1;
    most += in ? 1 : 0;
  }
  return least + 1 > f.high || most - 1 < f.low;
}

void Network::pull(const CardinalityFunction& f, int to, int above) {
  if (f.x >= 0 && !is_live(f.x, f.label)) return;
  if (above >= variables())
    project_cardinality(f, to);
  else
    lift_cardinality(f, to, above);
}

/// Notes that `label` of `to` gets `amount`, or goes.
void Network::offer(int to, int shift_cell, int label, Cost amount) {
  Cost& gain = gain_[static_cast<std::size_t>(label)];
  if (is_forbidden(gain)) return;
  if (goes(amount, bound() + unary(to, label) + gain + amount)) {
    gain = kTop;
  } else if (amount > 0) {
    gain += amount;
    move(static_cast<int>(cell(to, label)), shift_cell + label, amount);
  }
}

/// What the function costs in any case for each label of `to`, exactly, without new payments.
void Network::project_cardinality(const CardinalityFunction& f, int to) {
  const bool conditional = f.x >= 0 && at(f.x).live > 1;
  if (conditional && to != f.x) return;
  differences_.clear();
  int forced = 0;
  Cost base = 0, free = 0;
  const CardinalityFunction::Member* mine = nullptr;
  for (const auto& member : f.members) {
    if (member.variable == to) {
      mine = &member;
      continue;
    }
    Cost in = kTop, out = kTop;
    for (const int label : live(member.variable)) {
      Cost& side = member.counts[static_cast<std::size_t>(label)] != 0 ? in : out;
      side = std::min(side, -cost_at(member.cell + label));
    }
    free += std::min(in, out);
    base += is_forbidden(out) ? in : out;
    if (is_forbidden(out))
      ++forced;
    else if (!is_forbidden(in))
      differences_.push_back(in - out);
  }
  std::sort(differences_.begin(), differences_.end());
  const auto least = [&](int extra) {
    Cost sum = base, best = kTop;
    for (std::size_t t = 0;; ++t) {
      const Cost price = f.violation(forced + extra + static_cast<int>(t));
      if (!is_forbidden(price)) best = std::min(best, sum + price);
      if (t == differences_.size()) return best;
      sum += differences_[t];
    }
  };
  if (to == f.x) {
    const Cost active = least(0);
    for (const int label : live(to))
      offer(to, f.x_cell, label, (label == f.label ? active : free) - cost_at(f.x_cell + label));
    return;
  }
  const Cost owner = f.x < 0 ? 0 : -cost_at(f.x_cell + f.label);
  const Cost out = least(0), in = least(1);
  for (const int label : live(to))
    offer(to, mine->cell, label,
          owner + (mine->counts[static_cast<std::size_t>(label)] != 0 ? in : out) - cost_at(mine->cell + label));
}

/// What `to` could get when the other members after `above` pay: with a multiplier lambda for being counted, member j
/// owes s_j = min(out_j, in_j − lambda), and the whole costs at least sum of s_j + min over t of (violation(t) + lambda
/// t).
void Network::lift_cardinality(const CardinalityFunction& f, int to, int above) {
  if (f.x >= 0 && to != f.x && at(f.x).live > 1) return;
  counts_.clear();
  differences_.clear();
  int forced = 0;
  const CardinalityFunction::Member* mine = nullptr;
  const auto potential = [&](const CardinalityFunction::Member& member, int label) {
    const Cost given = -cost_at(member.cell + label);
    return rank(member.variable) > above || member.variable == to
               ? given + available(static_cast<int>(cell(member.variable, label)))
               : given;
  };
  for (const auto& member : f.members) {
    if (member.variable == to) mine = &member;
    Count count{kTop, kTop};
    for (const int label : live(member.variable)) {
      Cost& side = member.counts[static_cast<std::size_t>(label)] != 0 ? count.in : count.out;
      side = std::min(side, potential(member, label));
    }
    counts_.push_back(count);
    if (is_forbidden(count.out))
      ++forced;
    else if (!is_forbidden(count.in))
      differences_.push_back(count.in - count.out);
  }
  std::sort(differences_.begin(), differences_.end());
  const int most = static_cast<int>(differences_.size());
  Cost sum = 0, best = kTop;
  int at_best = 0;
  for (int t = 0; t <= most; ++t) {
    const Cost price = f.violation(forced + t);
    if (!is_forbidden(price) && sum + price < best) best = sum + price, at_best = t;
    if (t < most) sum += differences_[static_cast<std::size_t>(t)];
  }
  if (is_forbidden(best)) return;  // the filter sees to it
  // lambda: between the neighbouring differences, and a slope of the price; the one nearest to zero asks least.
  const Cost here = f.violation(forced + at_best);
  Cost low = -kTop, high = kTop;
  if (at_best > 0) {
    low = differences_[static_cast<std::size_t>(at_best) - 1];
    high = std::min(high, f.violation(forced + at_best - 1) - here);
  }
  if (at_best < most) {
    high = std::min(high, differences_[static_cast<std::size_t>(at_best)]);
    low = std::max(low, here - f.violation(forced + at_best + 1));
  }
  const Cost lambda = low > 0 ? low : high < 0 ? high : 0;
  Cost dual = kTop;
  for (int t = 0; t <= most; ++t) {
    const Cost price = f.violation(forced + t);
    if (!is_forbidden(price)) dual = std::min(dual, price + lambda * (forced + t));
  }
  Cost free = 0;
  scratch_.resize(counts_.size());
  for (std::size_t j = 0; j < counts_.size(); ++j) {
    if (f.members[j].variable == to) continue;
    const Count& count = counts_[j];
    scratch_[j] = std::min(count.out, is_forbidden(count.in) ? kTop : count.in - lambda);
    dual += scratch_[j];
    free += std::min(count.in, count.out);
  }
  const std::size_t before = moves_.size();
  if (to == f.x) {
    for (const int label : live(to))
      offer(to, f.x_cell, label, (label == f.label ? dual : free) - cost_at(f.x_cell + label));
  } else {
    const Cost owner = f.x < 0 ? 0 : -cost_at(f.x_cell + f.label);
    for (const int label : live(to))
      offer(to, mine->cell, label,
            owner + dual - (mine->counts[static_cast<std::size_t>(label)] != 0 ? lambda : 0) -
                cost_at(mine->cell + label));
  }
  if (moves_.size() == before) return;
  for (std::size_t j = 0; j < counts_.size(); ++j) {
    const auto& member = f.members[j];
    if (rank(member.variable) <= above || member.variable == to) continue;
    const Cost floor = to == f.x ? std::min(counts_[j].in, counts_[j].out) : -kTop;
    for (const int label : live(member.variable)) {
      const bool counted = member.counts[static_cast<std::size_t>(label)] != 0;
      const Cost need = std::max(floor, scratch_[j] + (counted ? lambda : 0)) + cost_at(member.cell + label);
      if (need > 0) move(static_cast<int>(cell(member.variable, label)), member.cell + label, -need);
    }
  }
}

}  // namespace scenelore::engine
