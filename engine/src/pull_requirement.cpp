// Shifting costs through a requirement R(x, y_1 … y_m): when x has the label, the least cost of a support that holds,
// at most the weight. With e_j(b) = what R has been given for label b of y_j plus what y_j can still give, and m_j the
// least of these, the least cost of R over all labels of the y_j is, when x has the label,
//     sum of m_j + min(weight, least of cost_j(b) + e_j(b) − m_j over the supports b of y_j)
// because at most one support need hold, and the sum of m_j when it has not. The same with y_k fixed gives what goes to
// the labels of y_k. So one pass over R does what a supporter variable with a binary function to each y_j would.
//
// m_j may be replaced by anything smaller; as long as nothing has been taken out towards members it is set to 0, so
// that only the supports need be looked at.
#include <algorithm>

#include "network.hpp"

namespace scenelore::engine {

namespace {
constexpr std::size_t kNone = static_cast<std::size_t>(-1);
}

void Network::pull(RequirementFunction& f, int to, int above) {
  if (!is_live(f.x, f.label)) return;
  if (to == f.x) return pull_to_owner(f, above);
  // Nothing can be got from x or the other supports: another label of x, or another support, is free.
  if (f.idle >= 0 && is_live(f.x, f.idle) && unary(f.x, f.idle) <= 0 && cost_at(f.x_cell + f.idle) >= 0) return;
  if (f.witness < f.supports.size()) {
    const auto& witness = f.supports[f.witness];
    const Cost active = unary(f.x, f.label) - cost_at(f.x_cell + f.label);
    if (witness.variable != to && is_live(witness) && cost_at(f.lifted_cell) == 0 &&
        active + witness.cost + given(witness, -1) <= 0)
      return;
  }
  for (std::size_t k = 0; k < f.members.size(); ++k)
    if (f.members[k].variable == to) return pull_to_member(f, k, above);
}

bool Network::is_live(const RequirementFunction::Support& support) const {
  return position_[static_cast<std::size_t>(support.label_cell)] < at(support.variable).live;
}

/// What the function has been given for a support, and can still be given when its variable may pay.
Cost Network::given(const RequirementFunction::Support& support, int above) const {
  const Cost before = -cost_at(support.shift_cell);
  return rank(support.variable) > above ? before + available(support.label_cell) : before;
}

/// scratch_[j] = m_j; returns their sum, without that of member `without`.
Cost Network::least_given(const RequirementFunction& f, std::size_t without, int above) {
  scratch_.assign(f.members.size(), 0);
  if (cost_at(f.lifted_cell) == 0) return 0;
  Cost sum = 0;
  for (std::size_t j = 0; j < f.members.size(); ++j) {
    if (j == without) continue;
    const auto& member = f.members[j];
    const Cost* const shift = cost_.data() + member.cell;
    const bool pays = rank(member.variable) > above;
    Cost least = kTop;
    for (const int label : live(member.variable))
      least = std::min(least, pays ? available(static_cast<int>(cell(member.variable, label))) - shift[label] : -shift[label]);
    scratch_[j] = least;
    sum += least;
  }
  return sum;
}

void Network::pull_to_owner(RequirementFunction& f, int above) {
  const Cost taken = cost_at(f.x_cell + f.label);
  const bool lifted = cost_at(f.lifted_cell) != 0;
  if (!lifted && f.witness < f.supports.size()) {
    const auto& witness = f.supports[f.witness];
    if (is_live(witness) && witness.cost + given(witness, above) < taken + least_gain_) return;
  }
  const Cost sum = least_given(f, kNone, above);
  Cost cheapest = f.weight;
  for (std::size_t s = 0; s < f.supports.size(); ++s) {
    const auto& support = f.supports[s];
    if (!is_live(support)) continue;
    const Cost cost = support.cost + given(support, above) - scratch_[static_cast<std::size_t>(support.member)];
    if (cost < cheapest) cheapest = cost, f.witness = s;
  }
  const auto got_of = [&](int label) { return sum + (label == f.label ? cheapest : 0) - cost_at(f.x_cell + label); };
  bool any = false, owner_gains = false;
  for (const int label : live(f.x)) {
    Cost& gain = gain_[static_cast<std::size_t>(label)];
    if (is_forbidden(gain)) continue;
    const Cost got = got_of(label);
    if (goes(got, got + bound() + unary(f.x, label) + gain)) {
      gain = kTop;
    } else if (got >= least_gain_) {
      any = true;
      owner_gains = owner_gains || label == f.label;
    }
  }
  if (!any) return;
  charge(f, kNone, owner_gains ? cheapest : 0, above);
  for (const int label : live(f.x)) {
    Cost& gain = gain_[static_cast<std::size_t>(label)];
    if (is_forbidden(gain)) continue;
    const Cost got = got_of(label);
    if (got < least_gain_) continue;
    gain += got;
    move(static_cast<int>(cell(f.x, label)), f.x_cell + label, got);
  }
  moves_.push_back({-1, f.shifted_cell, 1});
}

/// Members pay so that each label has given m_j at least, and each support cost + given − m_j >= target.
void Network::charge(const RequirementFunction& f, std::size_t without, Cost target, int above) {
  if (cost_at(f.lifted_cell) != 0)
    for (std::size_t j = 0; j < f.members.size(); ++j) {
      const auto& member = f.members[j];
      if (j == without || rank(member.variable) <= above) continue;
      for (const int label : live(member.variable)) {
        Cost need = scratch_[j] + cost_at(member.cell + label);
        for (const auto& [support, cost] : member.supports)
          if (support == label) need += std::max<Cost>(0, target - cost);
        if (need > 0) move(static_cast<int>(cell(member.variable, label)), member.cell + label, -need);
      }
    }
  else
    for (const auto& support : f.supports) {
      if (static_cast<std::size_t>(support.member) == without || rank(support.variable) <= above || !is_live(support))
        continue;
      const Cost need = target - support.cost + cost_at(support.shift_cell);
      if (need > 0) move(support.label_cell, support.shift_cell, -need);
    }
}

void Network::pull_to_member(RequirementFunction& f, std::size_t k, int above) {
  const auto& mine = f.members[k];
  const int to = mine.variable;
  const auto owner_gives = [&](int label) {
    const Cost before = -cost_at(f.x_cell + label);
    return rank(f.x) > above ? before + available(static_cast<int>(cell(f.x, label))) : before;
  };
  Cost idle = kTop;  // what x costs at least with another label
  for (const int label : live(f.x)) {
    if (label == f.label || owner_gives(label) >= idle) continue;
    idle = owner_gives(label);
    f.idle = label;
  }
  const Cost active = owner_gives(f.label);
  const Cost sum = least_given(f, k, above);
  Cost others = f.weight;
  for (const auto& support : f.supports)
    if (static_cast<std::size_t>(support.member) != k && is_live(support))
      others =
          std::min(others, support.cost + given(support, above) - scratch_[static_cast<std::size_t>(support.member)]);
  const auto got_of = [&](int label) {
    Cost best = others;
    for (const auto& [support, cost] : mine.supports)
      if (support == label) best = std::min(best, cost);
    return sum + std::min(idle, active + best) - cost_at(mine.cell + label);
  };
  bool any = false;
  Cost target = 0;  // the most that is asked of x and the other supports
  for (const int label : live(to)) {
    Cost& gain = gain_[static_cast<std::size_t>(label)];
    if (is_forbidden(gain)) continue;
    const Cost got = got_of(label);
    if (goes(got, got + bound() + unary(to, label) + gain)) {
      gain = kTop;
    } else if (got >= least_gain_) {
      const Cost asked = got + cost_at(mine.cell + label) - sum;
      target = any ? std::max(target, asked) : asked;
      any = true;
    }
  }
  if (!any) return;
  const Cost from_owner = std::min(active, target);
  if (rank(f.x) > above)
    for (const int label : live(f.x)) {
      const Cost need = (label == f.label ? from_owner : target) + cost_at(f.x_cell + label);
      if (need > 0) move(static_cast<int>(cell(f.x, label)), f.x_cell + label, -need);
    }
  charge(f, k, std::max<Cost>(0, target - from_owner), above);
  for (const int label : live(to)) {
    Cost& gain = gain_[static_cast<std::size_t>(label)];
    if (is_forbidden(gain)) continue;
    const Cost got = got_of(label);
    if (got < least_gain_) continue;
    gain += got;
    move(static_cast<int>(cell(to, label)), mine.cell + label, got);
  }
  moves_.push_back({-1, f.lifted_cell, 1});
  moves_.push_back({-1, f.shifted_cell, 1});
}

/// x cannot have the label any more: the function is a sum of what it was given, which goes back.
bool Network::release(const RequirementFunction& f) {
  if (cost_at(f.shifted_cell) == 0) return true;
  set(f.shifted_cell, 0);
  set(f.lifted_cell, 0);
  Cost sum = 0;
  source_ = -1;
  const auto give_back = [&](int v, int first, Cost extra, bool keep_least) {
    std::fill(gain_.begin(), gain_.end(), 0);
    Cost least = keep_least ? kTop : 0;
    if (keep_least)
      for (const int label : live(v)) least = std::min(least, -cost_at(first + label));
    for (const int label : live(v)) {
      const Cost amount = extra - cost_at(first + label) - least;
      if (amount > 0) move(static_cast<int>(cell(v, label)), first + label, amount);
    }
    sum += least;
    return commit(v);
  };
  for (const auto& member : f.members)
    if (!give_back(member.variable, member.cell, 0, true)) return false;
  return give_back(f.x, f.x_cell, sum, false);
}

}  // namespace scenelore::engine
