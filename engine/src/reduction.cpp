#include "reduction.hpp"

#include <algorithm>

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// From what is left of a network to parts with networks of their own.
class Builder {
 public:
  Builder(const Component& whole, const Residual& residual) : whole_(whole), residual_(residual) {}

  /// `room`: how much dearer than the best world the worlds may be.
  Reduction build(Cost room) {
    const auto count = index(whole_.network.variables());
    result_.constant = residual_.constant;
    result_.part_of.assign(count, -1);
    result_.index_in.assign(count, -1);
    result_.label_in.resize(count);
    for (int v = 0; v < whole_.network.variables(); ++v) result_.settled.push_back(whole_.network.value(v));
    add_variables();
    add_functions();
    for (Component& part : result_.parts) close(part, room);
    return std::move(result_);
  }

 private:
  Parts split() const {
    Parts parts(residual_.variables.size());
    for (const auto& pair : residual_.pairs) parts.join(pair.x, pair.y);
    for (const auto& need : residual_.needs)
      for (const auto& support : need.supports) parts.join(need.x, support.variable);
    for (const auto& count : residual_.counts)
      for (const auto& member : count.members) parts.join(count.x < 0 ? count.members[0].first : count.x, member.first);
    return parts;
  }

  void add_variables() {
    Parts parts = split();
    for (std::size_t i = 0; i < residual_.variables.size(); ++i) {
      const auto& open = residual_.variables[i];
      const auto root = index(parts.find(static_cast<int>(i)));
      part_.push_back(root == i ? static_cast<int>(result_.parts.size()) : part_[root]);
      if (root == i) result_.parts.emplace_back().whole = false;
      Component& part = result_.parts[index(part_[i])];
      place_.push_back(part.network.add_variable(open.costs));
      part.variables.push_back(open.variable);
      part.labels.push_back(open.labels);
      const auto best = std::find(open.labels.begin(), open.labels.end(), whole_.best[index(open.variable)]);
      part.best.push_back(static_cast<int>(best - open.labels.begin()));
      if (open.labels.size() == 1) continue;  // stays settled
      result_.part_of[index(open.variable)] = part_[i];
      result_.index_in[index(open.variable)] = place_[i];
      auto& numbers = result_.label_in[index(open.variable)];
      numbers.assign(index(whole_.network.labels(open.variable)), -1);
      for (std::size_t l = 0; l < open.labels.size(); ++l) numbers[index(open.labels[l])] = static_cast<int>(l);
    }
  }

  Network& network(int open) { return result_.parts[index(part_[index(open)])].network; }
  int place(int open) const { return place_[index(open)]; }

  void add_functions() {
    for (const auto& pair : residual_.pairs) {
      Network& of = network(pair.x);
      of.add_binary(place(pair.x), place(pair.y), of.add_table(pair.costs), -1);
    }
    for (const auto& need : residual_.needs) {
      RequirementFunction f{place(need.x), need.label, need.weight, -1};
      for (const auto& support : need.supports) {
        const int v = place(support.variable);
        if (f.members.empty() || f.members.back().variable != v) f.members.push_back({v});
        f.members.back().supports.emplace_back(support.label, support.cost);
      }
      network(need.x).add_requirement(std::move(f));
    }
    for (const auto& count : residual_.counts) {
      CardinalityFunction f{
          count.x < 0 ? -1 : place(count.x), count.label, -1, count.low, count.high, count.weight, {}, -1};
      for (const auto& [variable, counts] : count.members) f.members.push_back({place(variable), -1, counts});
      network(count.members[0].first).add_cardinality(std::move(f));
    }
  }

  static void close(Component& component, Cost room) {
    component.network.close();
    component.best_cost = component.network.evaluate(component.best);
    component.network.set_met(component.best_cost);
    component.network.set_limit(component.best_cost + room);
    component.feasible = component.network.strengthen();
  }

  const Component& whole_;
  const Residual& residual_;
  Reduction result_;
  std::vector<int> part_, place_;  ///< of each open variable
};

}  // namespace

Reduction reduce(Component& component, Cost cutoff) {
  Network& network = component.network;
  network.push();
  network.set_limit(cutoff);
  network.set_met(component.best_cost);
  network.strengthen();
  Reduction result = Builder(component, network.residual()).build(cutoff - component.best_cost);
  result.cutoff = cutoff;
  network.pop();
  return result;
}

}  // namespace scenelore::engine
