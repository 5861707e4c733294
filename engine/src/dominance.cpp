#include "dominance.hpp"

#include <algorithm>

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

constexpr Cost kNone = -kTop;

/// The most that a function can cost more, over all assignments of its other variables, when a variable has `other` instead of
/// `label`. What is forbidden with `label` does not count; kNone: all is. kTop: `other` forbids what `label` allows.
class Most {
 public:
  /// A case in which the two labels cost so much.
  void of(Cost label, Cost other) {
    if (!is_forbidden(label)) most_ = std::max(most_, is_forbidden(other) ? kTop : other - label);
  }
  Cost value() const { return most_; }

 private:
  Cost most_ = kNone;
};

class Dominance {
 public:
  Dominance(const Residual& residual, std::int64_t most_work)
      : residual_(residual), work_(most_work), roles_(residual.variables.size()) {
    for (const auto& pair : residual.pairs)
      for (const int v : {pair.x, pair.y}) roles_[index(v)].pairs.push_back(&pair);
    for (const auto& need : residual.needs) {
      roles_[index(need.x)].owned.push_back(&need);
      for (std::size_t s = 0; s < need.supports.size(); ++s)
        if (s == 0 || need.supports[s].variable != need.supports[s - 1].variable)
          roles_[index(need.supports[s].variable)].supported.push_back({&need, s});
    }
    for (const auto& count : residual.counts) {
      Counted role{&count, 0, 0, nullptr};
      for (const auto& member : count.members) {
        const auto [low, high] = std::minmax_element(member.second.begin(), member.second.end());
        role.least += *low;
        role.most += *high;
      }
      bool owner_counts = false;
      for (const auto& member : count.members) {
        const auto [low, high] = std::minmax_element(member.second.begin(), member.second.end());
        roles_[index(member.first)].counted.push_back({&count, role.least - *low, role.most - *high, &member.second});
        owner_counts = owner_counts || member.first == count.x;
      }
      if (count.x >= 0 && !owner_counts) roles_[index(count.x)].counted.push_back(role);
    }
  }

  std::vector<std::pair<int, int>> labels() {
    std::vector<std::pair<int, int>> result;
    for (std::size_t v = 0; v < roles_.size(); ++v) {
      const auto& variable = residual_.variables[v];
      const int count = static_cast<int>(variable.labels.size());
      for (int label = 0; label < count; ++label)
        for (int other = 0; other < count; ++other)
          if (other != label && dominates(static_cast<int>(v), other, label)) {
            result.emplace_back(variable.variable, variable.labels[index(label)]);
            break;
          }
    }
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  struct Supported {
    const Residual::Need* need;
    std::size_t first;  ///< of the variable's supports
  };
  struct Counted {
    const Residual::Count* count;
    int least, most;                ///< what the other variables hold
    const std::vector<char>* counts;  ///< the variable's own; nullptr = none
  };
  struct Roles {  ///< of one variable
    std::vector<const Residual::Pair*> pairs;
    std::vector<const Residual::Need*> owned;
    std::vector<Supported> supported;
    std::vector<Counted> counted;
  };
  int size(int v) const { return static_cast<int>(residual_.variables[index(v)].labels.size()); }

  bool dominates(int v, int other, int label) {
    const auto& costs = residual_.variables[index(v)].costs;
    Most own;
    own.of(costs[index(label)], costs[index(other)]);
    Cost sum = own.value();
    const auto add = [&](const auto& functions) {
      for (const auto& function : functions) {
        if (sum == kNone || is_forbidden(sum)) return;
        const Cost more = work_-- > 0 ? most(function, v, other, label) : kTop;
        sum = more == kNone || is_forbidden(more) ? more : sum + more;
      }
    };
    add(roles_[index(v)].pairs);
    add(roles_[index(v)].owned);
    add(roles_[index(v)].supported);
    add(roles_[index(v)].counted);
    return sum < 0;
  }

  Cost most(const Residual::Pair* pair, int v, int other, int label) const {
    const bool is_x = pair->x == v;
    const int columns = size(pair->y);
    const int own = is_x ? columns : 1, step = is_x ? 1 : columns;
    Most most;
    for (int t = 0; t < size(is_x ? pair->y : pair->x); ++t)
      most.of(pair->costs[index(label * own + t * step)], pair->costs[index(other * own + t * step)]);
    return most.value();
  }

  Cost most(const Residual::Need* need, int /*owner*/, int other, int label) const {
    if ((label == need->label) == (other == need->label)) return 0;
    if (other == need->label) return need->weight;
    Cost least = need->weight;
    for (const auto& support : need->supports) least = std::min(least, support.cost);
    return -least;
  }

  /// Not negative: the owner may be something else, and others may be as good a support.
  Cost most(const Supported& role, int v, int other, int label) const {
    const auto& supports = role.need->supports;
    Cost with = role.need->weight, instead = with;
    for (std::size_t s = role.first; s < supports.size() && supports[s].variable == v; ++s) {
      if (supports[s].label == label) with = supports[s].cost;
      if (supports[s].label == other) instead = supports[s].cost;
    }
    return instead <= with ? 0 : is_forbidden(instead) ? kTop : instead - with;
  }

  Cost most(const Counted& role, int v, int other, int label) const {
    const Residual::Count& count = *role.count;
    const auto held = [&](int of) { return role.counts == nullptr ? 0 : (*role.counts)[index(of)]; };
    if (count.x != v && held(label) == held(other)) return 0;
    const auto cost = [&](int of, int others) {
      return count.x == v && of != count.label ? 0 : count.violation(others + held(of));
    };
    Most most;
    for (int others = role.least; others <= role.most; ++others) most.of(cost(label, others), cost(other, others));
    if (count.x >= 0 && count.x != v) most.of(0, 0);  // it need not apply
    return most.value();
  }

  const Residual& residual_;
  std::int64_t work_;
  std::vector<Roles> roles_;
};

}  // namespace

std::vector<std::pair<int, int>> dominated_labels(const Residual& residual, std::int64_t most_work) {
  return Dominance(residual, most_work).labels();
}

}  // namespace scenelore::engine
