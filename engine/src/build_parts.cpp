// From the outline of a problem to networks.
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "component.hpp"
#include "outline.hpp"

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Labels that take part; which functions they leave; networks of these. Variables with just one label can be settled: what
/// they cost, alone and with others, goes to the labels of others and the constant. Else each function is in a network.
class PartsBuilder {
 public:
  PartsBuilder(const Outline& outline, const Selection& selection, Budget* budget)
      : outline_(outline), budget_(budget), settles_(selection.settle), joined_(index(outline.variables())) {
    for (int v = 0; v < outline.variables(); ++v) {
      std::vector<int>& numbers = result_.label_in.emplace_back(index(outline.labels(v)), -1);
      int next = 0, last = -1;
      for (int l = 0; l < outline.labels(v); ++l) {
        if (!selection.labels.empty() && selection.labels[index(v)][index(l)] == 0) continue;
        numbers[index(l)] = next++;
        last = l;
      }
      number_.insert(number_.end(), numbers.begin(), numbers.end());
      result_.settled.push_back(selection.settle && next == 1 ? last : -1);
    }
    kept_.assign(index(outline.variables()), 0);
    cost_ = outline.own;
  }

  Decomposition build() {
    for (int v = 0; v < outline_.variables(); ++v)
      if (is_settled(v)) pay(std::exchange(cost_[index(held(v))], 0), -1);
    if (!clashes() || !pairs() || !needs() || !counts()) return {.cut = true};
    make_networks();
    if (!fill_networks()) return {.cut = true};
    result_.built = true;
    return std::move(result_);
  }

 private:
  struct OpenClash {
    int a, b, number;
  };

  bool is_in(int literal) const { return number_[index(literal)] >= 0; }
  bool is_settled(int v) const { return result_.settled[index(v)] >= 0; }
  int held(int v) const { return outline_.first_label[index(v)] + result_.settled[index(v)]; }
  bool out_of_time(std::size_t step) const {
    constexpr std::size_t kStepsBetweenLooks = 1024;
    return budget_ != nullptr && step % kStepsBetweenLooks == 0 && budget_->out_of_time();
  }

  void pay(Cost cost, int constraint) {
    if (is_forbidden(cost) && result_.broken < 0) result_.broken = constraint;
    result_.constant = std::min(result_.constant + cost, kTop);
  }
  void charge(int literal, Cost cost) { cost_[index(literal)] = std::min(cost_[index(literal)] + cost, kTop); }

  bool clashes() {
    for (int a = 0; a < outline_.literals(); ++a) {
      if (out_of_time(index(a))) return false;
      if (!is_in(a)) continue;
      const int x = outline_.variable(a);
      for (const auto& [b, number] : outline_.clashes_of(a)) {
        if (b < a || !is_in(b)) continue;
        const int y = outline_.variable(b);
        const Cost cost = outline_.price[index(number)];
        if (is_settled(x) && is_settled(y))
          pay(cost, outline_.conflict[index(number)]);
        else if (is_settled(x))
          charge(b, cost);
        else if (is_settled(y))
          charge(a, cost);
        else
          open_clashes_.push_back({a, b, number}), joined_.join(x, y);
      }
    }
    return true;
  }

  bool pairs() {
    for (std::size_t p = 0; p < outline_.pairs.size(); ++p) {
      if (out_of_time(p)) return false;
      const Outline::Pair& pair = outline_.pairs[p];
      const int a = result_.settled[index(pair.a)], b = result_.settled[index(pair.b)];
      if (a >= 0 && b >= 0)
        pay(outline_.cost(pair, a, b), pair.constraint);
      else if (a >= 0)
        for (int l = 0; l < outline_.labels(pair.b); ++l) charge(outline_.first_label[index(pair.b)] + l, outline_.cost(pair, a, l));
      else if (b >= 0)
        for (int l = 0; l < outline_.labels(pair.a); ++l) charge(outline_.first_label[index(pair.a)] + l, outline_.cost(pair, l, b));
      else
        open_pairs_.push_back(p), joined_.join(pair.a, pair.b);
    }
    return true;
  }

  /// A need that is not decided keeps its owner, though it may have one label only.
  bool needs() {
    for (std::size_t n = 0; n < outline_.needs.size(); ++n) {
      if (out_of_time(n)) return false;
      Outline::Need need = outline_.needs[n];
      if (!is_in(need.owner)) continue;
      const int x = outline_.variable(need.owner);
      for (const auto& [literal, cost] : outline_.props_of(need))
        if (is_in(literal) && is_settled(outline_.variable(literal))) need.weight = std::min(need.weight, cost);
      if (need.weight == 0) continue;
      bool any = false;
      for (const auto& [literal, cost] : outline_.props_of(need)) {
        if (!is_in(literal) || is_settled(outline_.variable(literal)) || (settles_ && cost >= need.weight)) continue;
        joined_.join(x, outline_.variable(literal));
        any = true;
      }
      if (any || !settles_) {
        if (is_settled(x)) kept_[index(x)] = 1;
        open_needs_.push_back(need);
      } else if (is_settled(x)) {
        pay(need.weight, need.constraint);
      } else {
        charge(need.owner, need.weight);
      }
    }
    return true;
  }

  bool counts() {
    for (const Outline::Count& count : outline_.counts) {
      if (out_of_time(0)) return false;
      if (count.condition >= 0 && !is_in(count.condition)) continue;
      CardinalityFunction f{-1, -1, -1, count.low, count.high, count.weight, {}, count.constraint};
      std::vector<int> open;
      for (const int literal : count.literals) {
        if (!is_in(literal)) continue;
        if (is_settled(outline_.variable(literal)))
          --f.low, --f.high;
        else
          open.push_back(literal);
      }
      const int x = count.condition < 0 ? -1 : outline_.variable(count.condition);
      if (open.empty() && (x < 0 || settles_)) {
        if (x < 0 || is_settled(x))
          pay(f.violation(0), count.constraint);
        else
          charge(count.condition, f.violation(0));
        continue;
      }
      if (x >= 0 && is_settled(x)) kept_[index(x)] = 1;
      for (const int literal : open) joined_.join(x >= 0 ? x : outline_.variable(open[0]), outline_.variable(literal));
      open_counts_.push_back({&count, f.low, f.high, std::move(open)});
    }
    return true;
  }

  void make_networks() {
    const int count = outline_.variables();
    result_.component_of.assign(index(count), -1);
    result_.index_in.assign(index(count), -1);
    for (int v = 0; v < count; ++v) {
      if (is_settled(v) && kept_[index(v)] == 0) continue;
      int& of_root = result_.component_of[index(joined_.find(v))];
      if (of_root < 0) {
        of_root = static_cast<int>(result_.components.size());
        result_.components.emplace_back();
      }
      const int number = of_root;
      Component& component = result_.components[index(number)];
      result_.component_of[index(v)] = number;
      costs_.clear();
      std::vector<int>& labels = component.labels.emplace_back();
      for (int l = 0; l < outline_.labels(v); ++l) {
        const int literal = outline_.first_label[index(v)] + l;
        if (!is_in(literal)) continue;
        labels.push_back(l);
        costs_.push_back(cost_[index(literal)]);
      }
      result_.index_in[index(v)] = component.network.add_variable(costs_);
      component.variables.push_back(v);
    }
  }

  Network& network(int v) { return result_.components[index(result_.component_of[index(v)])].network; }
  int local(int v) const { return result_.index_in[index(v)]; }
  const std::vector<int>& labels(int v) const {
    return result_.components[index(result_.component_of[index(v)])].labels[index(local(v))];
  }

  bool fill_networks() {
    for (std::size_t i = 0; i < open_clashes_.size(); ++i) {
      if (out_of_time(i)) return false;
      const auto& [a, b, number] = open_clashes_[i];
      const int x = outline_.variable(a), y = outline_.variable(b);
      network(x).add_binary(local(x), local(y), number_[index(a)], number_[index(b)], outline_.price[index(number)],
                            outline_.conflict[index(number)]);
    }
    for (std::size_t i = 0; i < open_pairs_.size(); ++i) {
      if (out_of_time(i)) return false;
      add(outline_.pairs[open_pairs_[i]]);
    }
    for (const Outline::Need& need : open_needs_) add(need);
    for (const OpenCount& count : open_counts_) add(count);
    return true;
  }

  void add(const Outline::Pair& pair) {
    const bool swapped = pair.a > pair.b;
    const int x = swapped ? pair.b : pair.a, y = swapped ? pair.a : pair.b;
    const auto fill = [&] {
      costs_.clear();
      for (const int i : labels(x))
        for (const int j : labels(y)) costs_.push_back(swapped ? outline_.cost(pair, j, i) : outline_.cost(pair, i, j));
      return network(x).add_table(costs_);
    };
    const auto is_whole = [&](int v) { return static_cast<int>(labels(v).size()) == outline_.labels(v); };
    int table = -1;
    if (is_whole(x) && is_whole(y)) {
      const auto key = std::tuple(result_.component_of[index(x)], pair.table, swapped, pair.weight);
      const auto [known, fresh] = whole_tables_.try_emplace(key, -1);
      if (fresh) known->second = fill();
      table = known->second;
    } else {
      table = fill();
    }
    network(x).add_binary(local(x), local(y), table, pair.constraint);
  }

  void add(const Outline::Need& need) {
    const int x = outline_.variable(need.owner);
    RequirementFunction f{local(x), number_[index(need.owner)], need.weight, need.constraint};
    for (const auto& [literal, cost] : outline_.props_of(need)) {
      const int y = outline_.variable(literal);
      if (!is_in(literal) || is_settled(y) || cost >= need.weight) continue;
      if (f.members.empty() || f.members.back().variable != local(y)) f.members.push_back({local(y)});
      f.members.back().supports.emplace_back(number_[index(literal)], cost);
    }
    network(x).add_requirement(std::move(f));
  }

  struct OpenCount {
    const Outline::Count* count;
    int low, high;
    std::vector<int> literals;
  };

  void add(const OpenCount& open) {
    const int condition = open.count->condition;
    const int first = outline_.variable(condition >= 0 ? condition : open.literals[0]);
    CardinalityFunction f{-1, -1, -1, open.low, open.high, open.count->weight, {}, open.count->constraint};
    if (condition >= 0) f.x = local(outline_.variable(condition)), f.label = number_[index(condition)];
    for (const int literal : open.literals) {
      const int v = outline_.variable(literal);
      if (f.members.empty() || f.members.back().variable != local(v))
        f.members.push_back({local(v), -1, std::vector<char>(labels(v).size(), 0)});
      f.members.back().counts[index(number_[index(literal)])] = 1;
    }
    network(first).add_cardinality(std::move(f));
  }

  const Outline& outline_;
  Budget* budget_;
  bool settles_;
  Decomposition result_;
  Parts joined_;
  std::vector<int> number_;   ///< by literal, in its component, −1 = it takes no part
  std::vector<char> kept_;    ///< by variable: settled, but the owner of a function that is not
  std::vector<Cost> cost_;    ///< by literal: what it costs by itself, with functions that are decided otherwise
  std::vector<Cost> costs_;
  std::vector<OpenClash> open_clashes_;
  std::vector<std::size_t> open_pairs_;
  std::vector<Outline::Need> open_needs_;
  std::vector<OpenCount> open_counts_;
  std::map<std::tuple<int, int, bool, double>, int> whole_tables_;  ///< by component, table, direction, weight
};

}  // namespace

Decomposition build_parts(const Outline& outline, const Selection& selection, Budget* budget) {
  return PartsBuilder(outline, selection, budget).build();
}

}  // namespace scenelore::engine
