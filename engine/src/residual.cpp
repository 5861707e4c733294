#include "residual.hpp"

#include <algorithm>
#include <limits>

#include "network.hpp"

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

/// Collects the functions of a network one by one.
class ResidualBuilder {
 public:
  explicit ResidualBuilder(const Network& network) : network_(network), place_(index(network.variables()), -1) {
    for (int v = 0; v < network.variables(); ++v) {
      Residual::OpenVariable open{v, {network.live(v).begin(), network.live(v).end()}, {}};
      if (open.labels.size() == 1) {
        pay(network.original(v, open.labels[0]));
        continue;
      }
      std::sort(open.labels.begin(), open.labels.end());
      for (const int label : open.labels) open.costs.push_back(network.original(v, label));
      place_[index(v)] = static_cast<int>(residual_.variables.size());
      residual_.variables.push_back(std::move(open));
    }
  }

  void add(const BinaryFunction& f, const Cost* table, int columns) {
    const int x = place_[index(f.x)], y = place_[index(f.y)];
    const auto cost = [&](int a, int b) { return table[a * columns + b]; };
    if (x < 0 && y < 0) return pay(cost(network_.value(f.x), network_.value(f.y)));
    if (x < 0) return charge(y, [&](int label) { return cost(network_.value(f.x), label); });
    if (y < 0) return charge(x, [&](int label) { return cost(label, network_.value(f.y)); });
    Residual::Pair pair{x, y, {}};
    bool any = false;
    for (const int a : labels(x))
      for (const int b : labels(y)) {
        pair.costs.push_back(cost(a, b));
        any = any || pair.costs.back() != 0;
      }
    if (any) residual_.pairs.push_back(std::move(pair));
  }

  void add(const RequirementFunction& f) {
    if (!network_.is_live(f.x, f.label)) return;
    Residual::Need need{place_[index(f.x)], -1, f.weight, {}};
    for (const auto& member : f.members)
      if (place_[index(member.variable)] < 0)
        for (const auto& [label, cost] : member.supports)
          if (network_.is_live(member.variable, label)) need.weight = std::min(need.weight, cost);
    if (need.weight == 0) return;
    for (const auto& member : f.members)
      if (const int v = place_[index(member.variable)]; v >= 0)
        for (const auto& [label, cost] : member.supports)
          if (network_.is_live(member.variable, label) && cost < need.weight)
            need.supports.push_back({v, label_of(v, label), cost});
    if (need.supports.empty()) {
      if (need.x < 0) return pay(need.weight);
      return charge(need.x, [&](int label) { return label == f.label ? need.weight : 0; });
    }
    if (need.x < 0) {
      need.x = static_cast<int>(residual_.variables.size());
      residual_.variables.push_back({f.x, {f.label}, {0}});
    }
    need.label = label_of(need.x, f.label);
    residual_.needs.push_back(std::move(need));
  }

  void add(const CardinalityFunction& f) {
    if (f.x >= 0 && !network_.is_live(f.x, f.label)) return;
    Residual::Count count{f.x < 0 ? -1 : place_[index(f.x)], -1, f.low, f.high, f.weight, {}};
    int least = 0, most = 0;
    for (const auto& member : f.members) {
      std::vector<char> counts;
      for (const int label : network_.live(member.variable)) counts.push_back(member.counts[index(label)]);
      const auto [out, in] = std::minmax_element(counts.begin(), counts.end());
      const int low = *out, high = *in;
      least += low;
      most += high;
      if (low == high) {
        count.low -= low;
        if (count.high != std::numeric_limits<int>::max()) count.high -= low;
        continue;
      }
      const int v = place_[index(member.variable)];
      counts.clear();
      for (const int label : labels(v)) counts.push_back(member.counts[index(label)]);
      count.members.emplace_back(v, std::move(counts));
    }
    if (least >= f.low && most <= f.high) return;
    if (count.members.empty()) {
      if (count.x < 0) return pay(f.violation(least));
      return charge(count.x, [&](int label) { return label == f.label ? f.violation(least) : 0; });
    }
    if (count.x >= 0) count.label = label_of(count.x, f.label);
    residual_.counts.push_back(std::move(count));
  }

  Residual take() { return std::move(residual_); }

 private:
  const std::vector<int>& labels(int open) const { return residual_.variables[index(open)].labels; }
  int label_of(int open, int label) const {
    const auto& own = labels(open);
    return static_cast<int>(std::lower_bound(own.begin(), own.end(), label) - own.begin());
  }
  void pay(Cost cost) { residual_.constant = std::min(residual_.constant + cost, kTop); }
  void charge(int open, const auto& cost_of) {
    Residual::OpenVariable& variable = residual_.variables[index(open)];
    for (std::size_t i = 0; i < variable.labels.size(); ++i)
      variable.costs[i] = std::min(variable.costs[i] + cost_of(variable.labels[i]), kTop);
  }

  const Network& network_;
  std::vector<int> place_;  ///< of the network's variables among the open ones, −1 = not open
  Residual residual_;
};

Residual Network::residual() const {
  ResidualBuilder builder(*this);
  for (const BinaryFunction& f : binary_) builder.add(f, tables_[index(f.table)].data(), labels(f.y));
  for (const RequirementFunction& f : requirements_) builder.add(f);
  for (const CardinalityFunction& f : cardinalities_) builder.add(f);
  return builder.take();
}

}  // namespace scenelore::engine
