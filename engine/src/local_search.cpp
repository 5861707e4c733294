#include "local_search.hpp"

#include <algorithm>

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
  for (std::size_t p = 0; p < outline.pairs.size(); ++p) {
    pairs_[index(outline.pairs[p].a)].push_back(static_cast<int>(p));
    pairs_[index(outline.pairs[p].b)].push_back(static_cast<int>(p));
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
}

void LocalSearch::descend(std::vector<int>& assignment, Budget& budget) {
  constexpr int kLeastSweeps = 4;  // these come first, so that there is something to keep
  constexpr int kMostSweeps = 100;
  labels_ = &assignment;
  charged_.assign(outline_.own.size(), {});
  for (std::size_t l = 0; l < charged_.size(); ++l) charged_[l].add(outline_.own[l]);
  for (int v = 0; v < outline_.variables(); ++v) charge(held(v), 1);
  bool changed = true;
  for (int sweep = 0; changed && sweep < kMostSweeps; ++sweep) {
    if (sweep >= kLeastSweeps && budget.out_of_time()) return;
    changed = false;
    for (int v = 0; v < outline_.variables(); ++v) {
      const char* const allowed = allowed_.data() + outline_.first_label[index(v)];
      if (std::count(allowed, allowed + outline_.labels(v), 1) < 2) continue;
      weigh(v);
      int label = assignment[index(v)];
      for (int l = 0; l < outline_.labels(v); ++l)
        if (allowed[l] != 0 && prices_[index(l)] < prices_[index(label)]) label = l;
      if (label == assignment[index(v)]) continue;
      charge(held(v), -1);
      assignment[index(v)] = label;
      charge(held(v), 1);
      changed = true;
    }
  }
}

void LocalSearch::weigh(int v) {
  const auto first = charged_.begin() + outline_.first_label[index(v)];
  prices_.assign(first, first + outline_.labels(v));
  weigh_needs(v);
  weigh_counts(v);
  weigh_pairs(v);
}

/// Of the props that hold at other variables.
Cost LocalSearch::least_prop(const Outline::Need& need, int without) const {
  Cost least = need.weight;
  for (const Outline::Prop& prop : outline_.props_of(need))
    if (prop.cost < least && outline_.variable(prop.literal) != without && holds(prop.literal)) least = prop.cost;
  return least;
}

void LocalSearch::weigh_needs(int v) {
  const std::size_t first = index(outline_.first_label[index(v)]);
  for (std::size_t l = 0; l < prices_.size(); ++l) {
    for (const Outline::Need& need : outline_.needs_of(static_cast<int>(first + l))) prices_[l].add(least_prop(need, v));
    for (std::size_t u = first_use_[first + l]; u < first_use_[first + l + 1]; ++u) {
      const auto& [number, cost] = uses_[u];
      const Outline::Need& need = outline_.needs[index(number)];
      if (!holds(need.owner) || outline_.variable(need.owner) == v) continue;
      const Cost least = least_prop(need, v);
      if (cost >= least) continue;
      // All labels would pay `least`; that is left out, and this one gets what it saves.
      prices_[l].add(least, -1);
      prices_[l].add(cost);
    }
  }
}

void LocalSearch::weigh_counts(int v) {
  const std::size_t first = index(outline_.first_label[index(v)]);
  for (const int c : counts_[index(v)]) {
    const Outline::Count& count = outline_.counts[index(c)];
    const bool own_condition = count.condition >= 0 && outline_.variable(count.condition) == v;
    if (count.condition >= 0 && !own_condition && !holds(count.condition)) continue;
    int others = 0;
    for (const int literal : count.literals) others += outline_.variable(literal) != v && holds(literal) ? 1 : 0;
    for (std::size_t l = 0; l < prices_.size(); ++l) {
      if (own_condition && count.condition != static_cast<int>(first + l)) continue;
      const bool counts = std::binary_search(count.literals.begin(), count.literals.end(), static_cast<int>(first + l));
      const int off = std::max({0, count.low - others - counts, others + counts - count.high});
      if (off > 0) prices_[l].add(is_forbidden(count.weight) ? kTop : off * count.weight);
    }
  }
}

void LocalSearch::weigh_pairs(int v) {
  for (const int p : pairs_[index(v)]) {
    const Outline::Pair& pair = outline_.pairs[index(p)];
    const bool is_a = pair.a == v;
    const int other = (*labels_)[index(is_a ? pair.b : pair.a)];
    for (std::size_t l = 0; l < prices_.size(); ++l) {
      const int label = static_cast<int>(l);
      prices_[l].add(is_a ? outline_.cost(pair, label, other) : outline_.cost(pair, other, label));
    }
  }
}

}  // namespace scenelore::engine
