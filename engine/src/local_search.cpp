#include "local_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

LocalSearch::LocalSearch(const Outline& outline)
    : outline_(outline), first_use_(index(outline.literals()) + 1, 0), counts_(index(outline.variables())), pairs_(counts_) {
  for (const Outline::Prop& prop : outline.props) ++first_use_[index(prop.literal) + 1];
  for (std::size_t l = 1; l < first_use_.size(); ++l) first_use_[l] += first_use_[l - 1];
  uses_.resize(first_use_.back());
  std::vector<std::size_t> next(first_use_.begin(), first_use_.end() - 1);
  for (std::size_t n = 0; n < outline.needs.size(); ++n)
    for (const Outline::Prop& prop : outline.props_of(outline.needs[n]))
      uses_[next[index(prop.literal)]++] = {static_cast<int>(n), prop.cost};
  for (std::size_t c = 0; c < outline.counts.size(); ++c) {
    const auto add = [&](int literal) {
      auto& own = counts_[index(outline.variable(literal))];
      if (own.empty() || own.back() != static_cast<int>(c)) own.push_back(static_cast<int>(c));
    };
    if (outline.counts[c].condition >= 0) add(outline.counts[c].condition);
    for (const int literal : outline.counts[c].literals) add(literal);
  }
  find_members();
  for (std::size_t p = 0; p < outline.pairs.size(); ++p) {
    pairs_[index(outline.pairs[p].a)].push_back(static_cast<int>(p));
    pairs_[index(outline.pairs[p].b)].push_back(static_cast<int>(p));
  }
}

void LocalSearch::find_members() {
  std::size_t size = 0;
  for (int v = 0; v < outline_.variables(); ++v) {
    first_member_.push_back(size);
    size += counts_[index(v)].size() * index(outline_.labels(v));
  }
  members_.assign(size, 0);
  std::vector<std::size_t> place(index(outline_.variables()), 0);  // of the count at hand among those of a variable, which ascend
  for (std::size_t c = 0; c < outline_.counts.size(); ++c) {
    for (const int literal : outline_.counts[c].literals) {
      const int v = outline_.variable(literal);
      std::size_t& at = place[index(v)];
      while (counts_[index(v)][at] < static_cast<int>(c)) ++at;
      members_[first_member_[index(v)] + at * index(outline_.labels(v)) + index(outline_.label(literal))] = 1;
    }
  }
}

std::vector<int> LocalSearch::begin(const Assumptions& assumptions, const std::vector<int>& start) {
  const auto& own = outline_.own;
  allowed_.assign(own.size(), 1);
  for (std::size_t l = 0; l < own.size(); ++l) allowed_[l] = is_forbidden(own[l]) ? 0 : 1;
  for (const Literal& literal : assumptions.fixed)
    for (int l = 0; l < outline_.labels(literal.variable); ++l)
      if (l != literal.label) allowed_[index(outline_.literal({literal.variable, l}))] = 0;
  for (const Literal& literal : assumptions.forbidden) allowed_[index(outline_.literal(literal))] = 0;
  std::vector<int> assignment;
  for (int v = 0; v < outline_.variables(); ++v) {
    const std::size_t first = index(outline_.first_label[index(v)]);
    std::size_t best = 0;
    for (std::size_t l = 0; l < index(outline_.labels(v)); ++l)
      if (allowed_[first + l] != 0 && (allowed_[first + best] == 0 || own[first + l] < own[first + best])) best = l;
    if (!start.empty() && allowed_[first + index(start[index(v)])] != 0) best = index(start[index(v)]);
    assignment.push_back(static_cast<int>(best));
  }
  return assignment;
}

void LocalSearch::charge(std::size_t literal, int sign) {
  for (const auto& [other, number] : outline_.clashes_of(static_cast<int>(literal)))
    charged_[index(other)].add(outline_.price[index(number)], sign);
  const int v = outline_.variable(static_cast<int>(literal)), label = outline_.label(static_cast<int>(literal));
  for (const int p : pairs_[index(v)]) {
    const Outline::Pair& pair = outline_.pairs[index(p)];
    const bool is_a = pair.a == v;
    const int other = is_a ? pair.b : pair.a;
    Price* charged = charged_.data() + outline_.first_label[index(other)];
    for (int l = 0; l < outline_.labels(other); ++l) {
      const Cost cost = is_a ? outline_.cost(pair, label, l) : outline_.cost(pair, l, label);
      if (cost != 0) charged[l].add(cost, sign);
    }
  }
}

/// What is charged is kept: a part of a large problem starts from where another part ended.
void LocalSearch::start(const std::vector<int>& assignment) {
  total_ = {};
  const bool fresh = labels_.empty();
  if (fresh) {
    labels_ = assignment;
    charged_.assign(outline_.own.size(), {});
    for (std::size_t l = 0; l < charged_.size(); ++l) charged_[l].add(outline_.own[l]);
    met_.assign(outline_.needs.size(), {});
    held_.assign(outline_.counts.size(), 0);
  }
  open_.clear();
  for (int v = 0; v < outline_.variables(); ++v) {
    if (fresh)
      charge(held(v), 1), join(v, held(v));
    else if (labels_[index(v)] != assignment[index(v)])
      hold(v, assignment[index(v)]);
    const char* const allowed = allowed_.data() + outline_.first_label[index(v)];
    if (std::count(allowed, allowed + outline_.labels(v), 1) > 1) open_.push_back(v);
  }
}

void LocalSearch::hold(int v, int label) {
  charge(held(v), -1);
  leave(v, held(v));
  labels_[index(v)] = label;
  charge(held(v), 1);
  join(v, held(v));
}

void LocalSearch::join(int v, std::size_t literal) {
  for (std::size_t u = first_use_[literal]; u < first_use_[literal + 1]; ++u) {
    const auto& [need, cost] = uses_[u];
    Met& met = met_[index(need)];
    if (!met.known || cost >= outline_.needs[index(need)].weight) continue;
    if (cost < met.best) {
      met.second = met.best;
      met.best = cost;
      met.variable = v;
    } else {
      met.second = std::min(met.second, cost);
    }
  }
  const char* member = members_.data() + first_member_[index(v)] + labels_[index(v)];
  for (const int c : counts_[index(v)]) {
    held_[index(c)] += *member;
    member += outline_.labels(v);
  }
}

void LocalSearch::leave(int v, std::size_t literal) {
  for (std::size_t u = first_use_[literal]; u < first_use_[literal + 1]; ++u) {
    const auto& [need, cost] = uses_[u];
    Met& met = met_[index(need)];
    if (met.variable == v || (cost <= met.second && cost < outline_.needs[index(need)].weight)) met.known = false;
  }
  const char* member = members_.data() + first_member_[index(v)] + labels_[index(v)];
  for (const int c : counts_[index(v)]) {
    held_[index(c)] -= *member;
    member += outline_.labels(v);
  }
}

/// weigh(v) has been called.
void LocalSearch::change(int v, int label) {
  const int own = labels_[index(v)];
  total_.broken += prices_[index(label)].broken - prices_[index(own)].broken;
  total_.cost += prices_[index(label)].cost - prices_[index(own)].cost;
  hold(v, label);
}

bool LocalSearch::improve(int v) {
  weigh(v);
  const char* const allowed = allowed_.data() + outline_.first_label[index(v)];
  int label = labels_[index(v)];
  for (int l = 0; l < outline_.labels(v); ++l)
    if (allowed[l] != 0 && prices_[index(l)] < prices_[index(label)]) label = l;
  if (label == labels_[index(v)]) return false;
  change(v, label);
  return true;
}

void LocalSearch::go_down(int most_sweeps, int least_sweeps, Budget& budget) {
  bool changed = true;
  for (int sweep = 0; changed && sweep < most_sweeps; ++sweep) {
    if (sweep >= least_sweeps && budget.out_of_time()) return;
    changed = false;
    for (const int v : open_) changed = improve(v) || changed;
  }
}

void LocalSearch::descend(std::vector<int>& assignment, Budget& budget) {
  constexpr int kLeastSweeps = 4;  // these come first, so that there is something to keep
  constexpr int kMostSweeps = 100;
  start(assignment);
  go_down(kMostSweeps, kLeastSweeps, budget);
  assignment = labels_;
}

/// What a change of one label costs here, about: the mean over the open variables of the second best label less the best one.
double LocalSearch::mean_step() {
  double sum = 0;
  for (const int v : open_) {
    weigh(v);
    std::vector<Cost> costs;
    for (std::size_t l = 0; l < prices_.size(); ++l)
      if (allowed_[index(outline_.first_label[index(v)]) + l] != 0) costs.push_back(prices_[l].cost);
    std::partial_sort(costs.begin(), costs.begin() + 2, costs.end());
    sum += static_cast<double>(costs[1] - costs[0]);
  }
  return sum / static_cast<double>(open_.size());
}

/// A label by its price at this temperature (heat bath).
int LocalSearch::drawn(int v, double temperature, double broken) {
  const char* const allowed = allowed_.data() + outline_.first_label[index(v)];
  const auto price = [&](std::size_t l) { return broken * prices_[l].broken + static_cast<double>(prices_[l].cost); };
  double least = std::numeric_limits<double>::infinity(), sum = 0;
  for (std::size_t l = 0; l < prices_.size(); ++l)
    if (allowed[l] != 0) least = std::min(least, price(l));
  shares_.assign(prices_.size(), 0);
  for (std::size_t l = 0; l < prices_.size(); ++l)
    if (allowed[l] != 0) sum += shares_[l] = std::exp((least - price(l)) / temperature);
  double at = sum * static_cast<double>(random_() >> 11) * 0x1.0p-53;
  int last = labels_[index(v)];
  for (std::size_t l = 0; l < shares_.size(); ++l) {
    if (shares_[l] <= 0) continue;
    last = static_cast<int>(l);
    at -= shares_[l];
    if (at < 0) break;
  }
  return last;
}

void LocalSearch::anneal(std::vector<int>& assignment, std::uint64_t sweeps, Budget& budget) {
  // In steps as mean_step() tells them. Chosen on random planes, 60 and 200 of them.
  constexpr double kHot = 3, kCold = 0.1, kBroken = 3;
  constexpr int kMostSweeps = 20;
  start(assignment);
  if (open_.empty()) return;
  const double step = std::max(1.0, mean_step());
  std::vector<int> best = assignment;
  Price least = total_;
  for (std::uint64_t sweep = 0; sweep < sweeps && !budget.out_of_time(); ++sweep) {
    const double part = static_cast<double>(sweep) / static_cast<double>(sweeps);
    const double temperature = step * kHot * std::pow(kCold / kHot, part);
    for (const int v : open_) {
      weigh(v);
      const int label = drawn(v, temperature, step * kBroken);
      if (label != labels_[index(v)]) change(v, label);
    }
    if (total_ < least) least = total_, best = labels_;
  }
  start(best);
  go_down(kMostSweeps, kMostSweeps, budget);
  assignment = labels_;
}

void LocalSearch::weigh(int v) {
  const auto first = charged_.begin() + outline_.first_label[index(v)];
  prices_.assign(first, first + outline_.labels(v));
  weigh_needs(v);
  weigh_counts(v);
}

/// Of the props that hold at other variables. A need may have hundreds of props; few labels change from one look to the next.
Cost LocalSearch::least_prop(std::size_t number, int without) {
  Met& met = met_[number];
  if (!met.known) {
    const Outline::Need& need = outline_.needs[number];
    met = {true, -1, need.weight, need.weight};
    for (const Outline::Prop& prop : outline_.props_of(need)) {
      if (prop.cost >= met.second || !holds(prop.literal)) continue;
      if (prop.cost < met.best) {
        met.second = met.best;
        met.best = prop.cost;
        met.variable = outline_.variable(prop.literal);
      } else {
        met.second = prop.cost;
      }
    }
  }
  return met.variable == without ? met.second : met.best;
}

void LocalSearch::weigh_needs(int v) {
  const std::size_t first = index(outline_.first_label[index(v)]);
  for (std::size_t l = 0; l < prices_.size(); ++l) {
    for (std::size_t n = outline_.first_need[first + l]; n < outline_.first_need[first + l + 1]; ++n) prices_[l].add(least_prop(n, v));
    for (std::size_t u = first_use_[first + l]; u < first_use_[first + l + 1]; ++u) {
      const auto& [number, cost] = uses_[u];
      const Outline::Need& need = outline_.needs[index(number)];
      if (!holds(need.owner) || outline_.variable(need.owner) == v) continue;
      const Cost least = least_prop(index(number), v);
      if (cost >= least) continue;
      // All labels would pay `least`; that is left out, and this one gets what it saves.
      prices_[l].add(least, -1);
      prices_[l].add(cost);
    }
  }
}

void LocalSearch::weigh_counts(int v) {
  const std::size_t first = index(outline_.first_label[index(v)]);
  const char* member = members_.data() + first_member_[index(v)];
  for (std::size_t k = 0; k < counts_[index(v)].size(); ++k, member += prices_.size()) {
    const int c = counts_[index(v)][k];
    const Outline::Count& count = outline_.counts[index(c)];
    const bool own_condition = count.condition >= 0 && outline_.variable(count.condition) == v;
    if (count.condition >= 0 && !own_condition && !holds(count.condition)) continue;
    const int others = held_[index(c)] - member[labels_[index(v)]];
    if (count.low <= others && others < count.high) continue;  // whatever v holds
    for (std::size_t l = 0; l < prices_.size(); ++l) {
      if (own_condition && count.condition != static_cast<int>(first + l)) continue;
      const int counts = member[l];
      const int off = std::max({0, count.low - others - counts, others + counts - count.high});
      if (off > 0) prices_[l].add(is_forbidden(count.weight) ? kTop : off * count.weight);
    }
  }
}

}  // namespace scenelore::engine
