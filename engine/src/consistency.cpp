// Propagation to a fixed point: node, arc, directional and existential consistency (EDAC), in this order, as in
// de Givry, Heras, Zytnicki, Larrosa (IJCAI 2005), extended to requirements and cardinalities.
#include <algorithm>

#include "budget.hpp"
#include "network.hpp"

namespace scenelore::engine {

View Network::view(const BinaryFunction& f, int to) const {
  const Cost* table = tables_[static_cast<std::size_t>(f.table)].data();
  const int columns = at(f.y).size;
  if (to == f.x) return {table, columns, 1, f.x, f.y, f.x_cell, f.y_cell};
  return {table, 1, columns, f.y, f.x, f.y_cell, f.x_cell};
}

/// Node consistency of one variable: the least cost of its labels goes into the bound, hopeless labels go away.
bool Network::settle(int v) {
  Cost least = kTop, most = 0;
  const Cost* const costs = cost_.data() + at(v).first;
  for (const int label : live(v)) {
    least = std::min(least, costs[label]);
    most = std::max(most, costs[label]);
  }
  if (least > 0) {
    if (least + bound() >= limit_) return fail(v);
    set(0, bound() + least);
    for (const int label : live(v)) set(static_cast<int>(cell(v, label)), unary(v, label) - least);
    bound_rose_ = true;
    most -= least;
  }
  if (bound() + most < limit_) return true;
  for (int i = at(v).live - 1; i >= 0; --i) {
    const int label = order_[static_cast<std::size_t>(at(v).first + i)];
    if (bound() + unary(v, label) >= limit_ && !strike(v, label)) return false;
  }
  return true;
}

bool Network::settle_all() {
  for (int v = 0; v < variables(); ++v)
    if (!settle(v)) return false;
  return true;
}

void Network::move(int label_cell, int shift_cell, Cost amount) {
  moves_.push_back({label_cell, shift_cell, amount});
  if (amount < 0) spent_[static_cast<std::size_t>(label_cell)] -= amount;
}

void Network::forget() {
  for (const Move& m : moves_)
    if (m.label_cell >= 0) spent_[static_cast<std::size_t>(m.label_cell)] = 0;
  moves_.clear();
}

/// Labels of v cost more than before: who may profit from it?
void Network::announce(int v) {
  raised_.insert(rank(v));
  checks_.insert(rank(v));
  for (const Link& link : links_[static_cast<std::size_t>(v)])
    if (rank(link.other) > rank(v)) checks_.insert(rank(link.other));
  for (const int global : globals_[static_cast<std::size_t>(v)]) {
    if (global < 0) continue;
    const RequirementFunction& f = requirements_[static_cast<std::size_t>(global)];
    if (!is_live(f.x, f.label)) continue;
    if (f.x != v) {
      checks_.insert(rank(f.x));
      continue;
    }
    const auto labels_of = live(v);
    if (std::all_of(labels_of.begin(), labels_of.end(), [&](int l) { return l == f.label || unary(v, l) > 0; }))
      for (const auto& member : f.members) checks_.insert(rank(member.variable));
  }
}

/// Carries out the noted moves towards `to`; labels with a forbidden gain are removed.
bool Network::commit(int to) {
  bool rose = false;
  for (const Move& m : moves_) {
    if (m.label_cell < 0) {  // a mark, not a cost
      set(m.shift_cell, 1);
      continue;
    }
    set(m.label_cell, cost_at(m.label_cell) + m.amount);
    set(m.shift_cell, cost_at(m.shift_cell) + m.amount);
    spent_[static_cast<std::size_t>(m.label_cell)] = 0;
    rose = rose || m.amount > 0;
  }
  moves_.clear();
  for (int i = at(to).live - 1; i >= 0; --i) {
    const int label = order_[static_cast<std::size_t>(at(to).first + i)];
    if (!is_forbidden(gain_[static_cast<std::size_t>(label)])) continue;
    failed_constraint_ = source_;
    if (!strike(to, label)) return false;
  }
  if (!rose) return true;
  failed_constraint_ = -1;
  announce(to);
  return settle(to);
}

/// What `to` could get from a binary function when the other variable puts all its costs in.
void Network::pull(const View& view) {
  const auto from = live(view.from);
  const auto to = live(view.to);
  scratch_.resize(from.size() + to.size());
  for (std::size_t j = 0; j < from.size(); ++j)
    scratch_[j] = available(static_cast<int>(cell(view.from, from[j]))) - cost_at(view.from_cell + from[j]);
  bool any = false;
  Cost* const got = scratch_.data() + from.size();
  for (std::size_t i = 0; i < to.size(); ++i) {
    got[i] = 0;
    Cost& gain = gain_[static_cast<std::size_t>(to[i])];
    if (is_forbidden(gain)) {
      got[i] = -1;
      continue;
    }
    const Cost* row = view.table + to[i] * view.to_stride;
    const Cost shift = cost_at(view.to_cell + to[i]);
    Cost least = kTop;
    for (std::size_t j = 0; j < from.size(); ++j) {
      least = std::min(least, row[from[j] * view.from_stride] + scratch_[j]);
      if (least <= shift) break;
    }
    least -= shift;
    if (least <= 0) continue;
    if (goes(least, bound() + unary(view.to, to[i]) + gain + least)) {
      gain = kTop;
      got[i] = -1;  // this label goes, so nothing need be paid for it
      continue;
    }
    if (least < least_gain_) continue;
    got[i] = least;
    gain += least;
    any = true;
  }
  if (!any) return;
  for (const int other : from) {
    const Cost shift = cost_at(view.from_cell + other);
    Cost need = 0;
    for (std::size_t i = 0; i < to.size(); ++i)
      if (got[i] > 0)
        need = std::max(need, got[i] + cost_at(view.to_cell + to[i]) + shift -
                                  view.table[to[i] * view.to_stride + other * view.from_stride]);
    if (need > 0) move(static_cast<int>(cell(view.from, other)), view.from_cell + other, -need);
  }
  for (std::size_t i = 0; i < to.size(); ++i)
    if (got[i] > 0) move(static_cast<int>(cell(view.to, to[i])), view.to_cell + to[i], got[i]);
}

/// What the other variable's labels cost in any case goes to the labels of `view.to`.
bool Network::project(const View& view, bool only_forbidden) {
  bool rose = false;
  for (int i = at(view.to).live - 1; i >= 0; --i) {
    const int label = order_[static_cast<std::size_t>(at(view.to).first + i)];
    const Cost* row = view.table + label * view.to_stride;
    const Cost shift = cost_at(view.to_cell + label);
    Cost least = kTop;
    for (const int other : live(view.from)) {
      least = std::min(least, row[other * view.from_stride] - cost_at(view.from_cell + other));
      if (least <= shift) break;
    }
    least -= shift;
    if (least <= 0) continue;
    if (bound() + unary(view.to, label) + least >= limit_) {
      if (!is_forbidden(least)) failed_constraint_ = -1;
      if (!strike(view.to, label)) return false;
      continue;
    }
    if (only_forbidden) continue;
    set(static_cast<int>(cell(view.to, label)), unary(view.to, label) + least);
    set(view.to_cell + label, shift + least);
    rose = true;
  }
  if (!rose) return true;
  announce(view.to);
  return settle(view.to);
}

/// Arc consistency from a variable that lost labels.
bool Network::arcs_from(int v) {
  if (!settle(v)) return false;
  raised_.insert(rank(v));
  checks_.insert(rank(v));
  const bool only_forbidden = !shifting_ && at(v).live > 1;
  for (const Link& link : links_[static_cast<std::size_t>(v)]) {
    const BinaryFunction& f = binary_[static_cast<std::size_t>(link.function)];
    if (at(link.other).live == 1 && at(v).live > 1) continue;
    failed_constraint_ = f.constraint;
    if (!project(view(f, link.other), only_forbidden)) return false;
  }
  failed_constraint_ = -1;
  return true;
}

bool Network::filter_global(int global) {
  const auto attempt = [&](int v) {
    std::fill(gain_.begin(), gain_.end(), 0);
    pull_global(global, v, variables());
    return commit(v);
  };
  source_ = global >= 0 ? requirements_[static_cast<std::size_t>(global)].constraint
                        : cardinalities_[static_cast<std::size_t>(~global)].constraint;
  if (global >= 0) {
    const RequirementFunction& f = requirements_[static_cast<std::size_t>(global)];
    if (!is_live(f.x, f.label)) return release(f);
    if (!attempt(f.x)) return false;
    // With nothing new paid, only the owner of the cheapest support can lose by it.
    if (at(f.x).live > 1 || f.supports.empty() || !is_live(f.supports[f.witness])) return true;
    const int last = f.supports[f.witness].variable;
    return at(last).live == 1 || attempt(last);
  }
  const CardinalityFunction& f = cardinalities_[static_cast<std::size_t>(~global)];
  if ((f.x >= 0 && !is_live(f.x, f.label)) || !is_tight(f)) return true;
  if (f.x >= 0 && !attempt(f.x)) return false;
  if (f.x >= 0 && at(f.x).live > 1) return true;
  for (const auto& member : f.members)
    if (!attempt(member.variable)) return false;
  return true;
}

void Network::pull_global(int global, int to, int above) {
  if (global >= 0)
    pull(requirements_[static_cast<std::size_t>(global)], to, above);
  else
    pull(cardinalities_[static_cast<std::size_t>(~global)], to, above);
}

/// Directional consistency: costs of v go through each function to the variables before v.
bool Network::directed_from(int v) {
  source_ = -1;
  if (at(v).live > 1) {
    for (const Link& link : links_[static_cast<std::size_t>(v)]) {
      if (rank(link.other) > rank(v) || at(link.other).live == 1) continue;
      std::fill(gain_.begin(), gain_.end(), 0);
      pull(view(binary_[static_cast<std::size_t>(link.function)], link.other));
      if (!commit(link.other)) return false;
      if (at(v).live == 1) break;
    }
  }
  for (const int global : globals_[static_cast<std::size_t>(v)]) {
    if (global < 0) continue;
    RequirementFunction& f = requirements_[static_cast<std::size_t>(global)];
    if (rank(f.x) >= rank(v) || !is_live(f.x, f.label)) continue;
    std::fill(gain_.begin(), gain_.end(), 0);
    pull(f, f.x, rank(f.x));
    if (!commit(f.x)) return false;
  }
  return true;
}

/// Whether a label is free of charge with every binary function towards the variables before v.
bool Network::existential_support(int v, int label) {
  if (!is_live(v, label) || unary(v, label) > 0) return false;
  for (const Link& link : links_[static_cast<std::size_t>(v)]) {
    if (rank(link.other) > rank(v) || at(link.other).live == 1) continue;
    const View side = view(binary_[static_cast<std::size_t>(link.function)], v);
    const Cost* row = side.table + label * side.to_stride;
    const Cost shift = cost_at(side.to_cell + label);
    const auto others = live(link.other);
    const bool supported = std::any_of(others.begin(), others.end(), [&](int other) {
      return row[other * side.from_stride] - cost_at(side.from_cell + other) + unary(link.other, other) <
             shift + least_gain_;
    });
    if (!supported) return false;
  }
  return true;
}

/// Existential consistency: when every label of v costs something together with its neighbours, the bound rises.
bool Network::existential(int v) {
  std::fill(gain_.begin(), gain_.end(), 0);
  source_ = -1;
  moves_.clear();
  for (const int global : globals_[static_cast<std::size_t>(v)]) pull_global(global, v, -1);
  const auto total = [&](int label) {
    const Cost gain = gain_[static_cast<std::size_t>(label)];
    return is_forbidden(gain) ? kTop : unary(v, label) + gain;
  };
  int& support = support_[static_cast<std::size_t>(v)];
  const auto give_up = [&] {
    forget();
    return commit(v);  // only removes labels
  };
  if (is_live(v, support) && total(support) == 0 && existential_support(v, support)) return give_up();
  for (const Link& link : links_[static_cast<std::size_t>(v)])
    if (rank(link.other) < rank(v) && at(link.other).live > 1) pull(view(binary_[static_cast<std::size_t>(link.function)], v));
  Cost least = kTop;
  for (const int label : live(v)) {
    if (total(label) >= least) continue;
    least = total(label);
    support = label;
  }
  if (least < least_gain_) return give_up();
  return commit(v);
}

bool Network::out_of_time() {
  constexpr unsigned kStepsBetweenLooks = 64;
  if (budget_ == nullptr || ++steps_ % kStepsBetweenLooks != 0) return false;
  return budget_->out_of_time();
}

bool Network::propagate() {
  failed_constraint_ = failed_variable_ = -1;
  bound_rose_ = true;
  for (;;) {
    if (bound() >= limit_) return fail(-1);
    if (out_of_time()) return true;
    int v = -1;
    if ((v = reduced_.pop_min()) >= 0) {
      if (!arcs_from(v)) return false;
    } else if ((v = dirty_requirements_.pop_min()) >= 0) {
      if (!filter_global(v)) return false;
    } else if ((v = dirty_cardinalities_.pop_min()) >= 0) {
      if (!filter_global(~v)) return false;
    } else if (bound_rose_) {
      bound_rose_ = false;
      if (!settle_all()) return false;
    } else if (!shifting_ || !pushing_) {
      raised_.clear();
      checks_.clear();
      return true;
    } else if ((v = raised_.pop_max()) >= 0) {
      if (!directed_from(by_rank_[static_cast<std::size_t>(v)])) return false;
    } else if ((v = checks_.pop_min()) >= 0) {
      if (!existential(by_rank_[static_cast<std::size_t>(v)])) return false;
    } else {
      return true;
    }
  }
}

void Network::turn_order() {
  std::reverse(by_rank_.begin(), by_rank_.end());
  for (int place = 0; place < variables(); ++place) {
    rank_[static_cast<std::size_t>(by_rank_[static_cast<std::size_t>(place)])] = place;
    raised_.insert(place);
    checks_.insert(place);
  }
}

/// Existential directional consistency depends on the order of the variables: costs go to those that come first. Shifting
/// them to the one end and then to the other one closes most of the gap between it and the best bound that shifting can
/// give (optimal soft arc consistency), at a small part of what that one takes.
bool Network::turn_to_and_fro(int most_turns, int most_idle) {
  int idle = 0;
  for (int turn = 0; turn < most_turns && idle < most_idle; ++turn) {
    const Cost before = bound();
    turn_order();
    if (!propagate()) return false;
    const Cost room = is_forbidden(limit_) ? bound() : limit_ - bound();
    idle = bound() - before <= std::max(least_gain_, room / 256) ? idle + 1 : 0;
  }
  return true;
}

/// Whether some assignment costs no more than the bound, which can rise no further then.
bool Network::is_met(Place place) {
  if (place == Place::root && bound() >= met_) return true;
  round(rounded_);
  return evaluate(rounded_) <= bound();
}

/// Unless some assignment meets the bound already: at the root, which is worth the time, all that there is. Below it costs are
/// spread already: pushing them to and fro would undo that, and two passes of diffusion go on from there, or many
/// at a root that is looked at again.
bool Network::strengthen(Place place) {
  const bool diffuses = shifting_ && !(binary_.empty() && requirements_.empty());
  const bool root = place == Place::root;
  pushing_ = root || !diffuses;
  if (!propagate()) return false;
  if (!shifting_ || is_met(place)) return true;
  if (pushing_ && !turn_to_and_fro(root ? 8 : 1, root ? 2 : 1)) return false;
  if (!diffuses) return true;
  pushing_ = false;
  return root || place == Place::root_again ? diffuse(60, 1024, 3) : diffuse(2, 4, 2);
}

}  // namespace scenelore::engine
