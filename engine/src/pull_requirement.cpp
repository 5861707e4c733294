// Shifting costs through a requirement R(x, y_1 … y_m): when x has the label, the least cost of a support that holds, at
// most the weight. With e_j(b) = what R has been given for label b of y_j plus what y_j can still give, and m_j the least
// of these, the least cost of R over all labels of the y_j is, when x has the label,
//     sum of m_j + min(weight, least of cost_j(b) + e_j(b) − m_j over the supports b of y_j)
// because at most one support need hold, and the sum of m_j when it has not. The same with y_k fixed gives what goes to
// the labels of y_k. So one pass over R does what a supporter variable with a binary function to each y_j would.
#include <algorithm>

#include "network.hpp"

namespace scenelore::engine {

void Network::pull(const RequirementFunction& f, int to, int above) {
  if (!is_live(f.x, f.label)) return;
  if (to == f.x) return pull_to_owner(f, above);
  for (std::size_t k = 0; k < f.members.size(); ++k)
    if (f.members[k].variable == to) return pull_to_member(f, k, above);
}

void Network::pull_to_owner(const RequirementFunction& f, int above) {
  const auto potential = [&](const RequirementFunction::Member& member, int label) {
    const Cost given = -cost_at(member.cell + label);
    return member.variable > above ? given + available(static_cast<int>(cell(member.variable, label))) : given;
  };
  scratch_.resize(f.members.size());
  Cost sum = 0, cheapest = f.weight;
  for (std::size_t j = 0; j < f.members.size(); ++j) {
    const auto& member = f.members[j];
    Cost least = kTop, support = kTop;
    for (const int label : live(member.variable)) {
      const Cost e = potential(member, label);
      least = std::min(least, e);
      support = std::min(support, member.cost[static_cast<std::size_t>(label)] + e);
    }
    scratch_[j] = least;
    sum += least;
    cheapest = std::min(cheapest, support - least);
  }
  // Most often a support is free and there is nothing to gain.
  const auto room = [&](int label) {
    return limit_ - bound() - unary(f.x, label) - gain_[static_cast<std::size_t>(label)];
  };
  bool any = false, owner_gains = false;
  for (const int label : live(f.x)) {
    Cost& gain = gain_[static_cast<std::size_t>(label)];
    if (is_forbidden(gain)) continue;
    const Cost got = sum + (label == f.label ? cheapest : 0) - cost_at(f.x_cell + label);
    if (is_forbidden(got) || got >= room(label)) {
      gain = kTop;
    } else if (got >= least_gain_) {
      any = true;
      owner_gains = owner_gains || label == f.label;
    }
  }
  if (!any) return;
  for (std::size_t j = 0; j < f.members.size(); ++j) {
    const auto& member = f.members[j];
    if (member.variable <= above) continue;
    for (const int label : live(member.variable)) {
      const Cost shift = cost_at(member.cell + label);
      Cost need = scratch_[j] + shift;
      if (owner_gains) need = std::max(need, cheapest - member.cost[static_cast<std::size_t>(label)] + scratch_[j] + shift);
      if (need > 0) move(static_cast<int>(cell(member.variable, label)), member.cell + label, -need);
    }
  }
  for (const int label : live(f.x)) {
    Cost& gain = gain_[static_cast<std::size_t>(label)];
    if (is_forbidden(gain)) continue;
    const Cost got = sum + (label == f.label ? cheapest : 0) - cost_at(f.x_cell + label);
    if (got < least_gain_) continue;
    gain += got;
    move(static_cast<int>(cell(f.x, label)), f.x_cell + label, got);
  }
}

void Network::pull_to_member(const RequirementFunction& f, std::size_t k, int above) {
  const int to = f.members[k].variable;
  const auto owner_potential = [&](int label) {
    const Cost given = -cost_at(f.x_cell + label);
    return f.x > above ? given + available(static_cast<int>(cell(f.x, label))) : given;
  };
  // With another label of x that costs nothing, all that can be got is what was once put in.
  Cost idle = kTop;
  for (const int label : live(f.x))
    if (label != f.label) idle = std::min(idle, owner_potential(label));
  const int first = f.members[k].cell;
  const auto labels_of = live(to);
  if (idle <= 0 && std::none_of(labels_of.begin(), labels_of.end(), [&](int b) { return cost_at(first + b) < 0; })) return;
  const Cost active = owner_potential(f.label);
  const auto potential = [&](const RequirementFunction::Member& member, int label) {
    const Cost given = -cost_at(member.cell + label);
    return member.variable > above ? given + available(static_cast<int>(cell(member.variable, label))) : given;
  };
  scratch_.resize(f.members.size());
  Cost sum = 0, others = f.weight;
  for (std::size_t j = 0; j < f.members.size(); ++j) {
    if (j == k) continue;
    const auto& member = f.members[j];
    Cost least = kTop, support = kTop;
    for (const int label : live(member.variable)) {
      const Cost e = potential(member, label);
      least = std::min(least, e);
      support = std::min(support, member.cost[static_cast<std::size_t>(label)] + e);
    }
    scratch_[j] = least;
    sum += least;
    others = std::min(others, support - least);
  }
  const auto& mine = f.members[k];
  const auto got_of = [&](int label) {
    const Cost best = std::min(others, mine.cost[static_cast<std::size_t>(label)]);
    return sum + std::min(idle, active + best) - cost_at(mine.cell + label);
  };
  Cost target = -1;  // the most that is asked of x and the other supports
  for (const int label : live(to)) {
    Cost& gain = gain_[static_cast<std::size_t>(label)];
    if (is_forbidden(gain)) continue;
    const Cost got = got_of(label);
    if (is_forbidden(got) || got >= limit_ - bound() - unary(to, label) - gain)
      gain = kTop;
    else if (got >= least_gain_)
      target = std::max(target, got + cost_at(mine.cell + label) - sum);
  }
  if (target < 0) return;
  const Cost from_owner = std::min(active, target);
  const Cost from_others = std::max<Cost>(0, target - from_owner);
  if (f.x > above) {
    for (const int label : live(f.x)) {
      const Cost need = (label == f.label ? from_owner : target) + cost_at(f.x_cell + label);
      if (need > 0) move(static_cast<int>(cell(f.x, label)), f.x_cell + label, -need);
    }
  }
  for (std::size_t j = 0; j < f.members.size(); ++j) {
    const auto& member = f.members[j];
    if (j == k || member.variable <= above) continue;
    for (const int label : live(member.variable)) {
      const Cost shift = cost_at(member.cell + label);
      const Cost need =
          scratch_[j] + shift + std::max<Cost>(0, from_others - member.cost[static_cast<std::size_t>(label)]);
      if (need > 0) move(static_cast<int>(cell(member.variable, label)), member.cell + label, -need);
    }
  }
  for (const int label : live(to)) {
    Cost& gain = gain_[static_cast<std::size_t>(label)];
    if (is_forbidden(gain)) continue;
    const Cost got = got_of(label);
    if (got < least_gain_) continue;
    gain += got;
    move(static_cast<int>(cell(to, label)), mine.cell + label, got);
  }
}

}  // namespace scenelore::engine
