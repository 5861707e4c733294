#include "auxiliary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace scenelore::engine {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }
bool is_zero(double cost) { return cost == 0; }

/// The functions of one variable and another one, seen from the one.
struct Side {
  struct Part {
    const FileFunction* function;
    std::size_t own_stride, other_stride;
  };
  int other;
  std::size_t labels_of_other;
  std::vector<Part> parts;

  double cost(std::size_t own, std::size_t of_other) const {
    double sum = 0;
    for (const Part& part : parts) sum += part.function->costs[own * part.own_stride + of_other * part.other_stride];
    return sum;
  }
  bool is_free(std::size_t own) const {
    for (std::size_t l = 0; l < labels_of_other; ++l)
      if (cost(own, l) != 0) return false;
    return true;
  }
};

/// price(n) = weight · max(0, low − n, n − high); weight 0 = always 0.
struct Price {
  double weight = 0, least = 0;
  int low = 0, high = std::numeric_limits<int>::max();
};

std::optional<Price> read_price(std::vector<double> costs) {
  Price price;
  price.least = *std::min_element(costs.begin(), costs.end());
  if (!std::isfinite(price.least)) return std::nullopt;
  for (double& cost : costs) cost -= price.least;
  const int count = static_cast<int>(costs.size());
  const auto first = static_cast<int>(std::find_if(costs.begin(), costs.end(), is_zero) - costs.begin());
  const auto last = count - 1 - static_cast<int>(std::find_if(costs.rbegin(), costs.rend(), is_zero) - costs.rbegin());
  price.low = first;
  if (last + 1 < count) price.high = last;
  price.weight = first > 0 ? costs[index(first - 1)] : last + 1 < count ? costs[index(last + 1)] : 0;
  for (int n = 0; n < count; ++n) {
    const int off = std::max({0, first - n, n - last});
    const double expected = off == 0 ? 0 : price.weight * off;
    const double cost = costs[index(n)];
    if (cost != expected && !(std::abs(cost - expected) <= 1e-12 * expected)) return std::nullopt;
  }
  return price;
}

class Finder {
 public:
  Finder(const std::vector<Variable>& variables, const std::vector<FileFunction>& functions)
      : variables_(variables), functions_(functions), functions_of_(variables.size()), kept_(variables.size(), 0) {
    found_.gone.assign(functions.size(), 0);
    for (std::size_t f = 0; f < functions.size(); ++f)
      for (const int v : functions[f].scope) functions_of_[index(v)].push_back(static_cast<int>(f));
  }

  Auxiliaries find() {
    for (int v = 0; v < static_cast<int>(variables_.size()); ++v) counters(v);
    for (int v = static_cast<int>(variables_.size()); v-- > 0;) supporter(v);  // auxiliary ones come last, as a rule
    return std::move(found_);
  }

 private:
  std::size_t labels(int v) const { return variables_[index(v)].labels.size(); }
  bool costs_nothing(int v) const {
    const auto& costs = variables_[index(v)].costs;
    return std::all_of(costs.begin(), costs.end(), is_zero);
  }
  /// Neither gone nor needed by something that was found.
  bool is_open(int v) const { return kept_[index(v)] == 0; }
  void keep(int v) { kept_[index(v)] = 1; }
  void take(int function) { found_.gone[index(function)] = 1; }

  std::optional<Side> side(int function, int own) const {
    const FileFunction& f = functions_[index(function)];
    if (f.scope.size() != 2 || found_.gone[index(function)] != 0) return std::nullopt;
    if (f.scope[0] == own) return Side{f.scope[1], labels(f.scope[1]), {{&f, labels(f.scope[1]), 1}}};
    return Side{f.scope[0], labels(f.scope[0]), {{&f, 1, labels(own)}}};
  }

  // --- requirements ---

  /// One label, "none", costs something with one label of one variable, the owner, and nothing else; each other label is
  /// forbidden with other labels of the owner, and with some labels of one more variable, the support. Then the least cost
  /// over its labels is that of a requirement. Many an ordinary variable costs like that by chance, but without so much
  /// being forbidden.
  void supporter(int s) {
    if (!is_open(s) || functions_of_[index(s)].empty() || !costs_nothing(s)) return;
    std::vector<Side> sides;
    for (const int f : functions_of_[index(s)]) {
      const auto of = side(f, s);
      if (!of) return;
      const auto known = std::find_if(sides.begin(), sides.end(), [&](const Side& by) { return by.other == of->other; });
      if (known == sides.end())
        sides.push_back(*of);
      else
        known->parts.push_back(of->parts[0]);
    }
    std::vector<std::vector<std::size_t>> charging(labels(s));  // which functions charge each label
    for (std::size_t b = 0; b < charging.size(); ++b) {
      for (std::size_t i = 0; i < sides.size(); ++i)
        if (!sides[i].is_free(b)) charging[b].push_back(i);
      if (charging[b].size() > 2) return;
    }
    for (std::size_t none = 0; none < charging.size(); ++none) {
      if (charging[none].size() != 1) continue;
      const std::size_t owner = charging[none][0];
      const auto label = only_label(sides[owner], none);
      if (!label) continue;
      const auto is_support = [&](std::size_t b) {
        return b == none || (only_forbidden(sides[owner], b, *label) &&
                             std::all_of(charging[b].begin(), charging[b].end(), [&](std::size_t by) {
                               return by == owner || only_forbidden(sides[by], b);
                             }));
      };
      bool fits = charging.size() > 1;
      for (std::size_t b = 0; b < charging.size(); ++b)
        fits = fits && is_support(b) && (charging[b].size() < 2 || charging[b][0] == owner || charging[b][1] == owner);
      if (fits) return require(s, sides, charging, none, owner, *label);
    }
  }

  /// The one label of the other variable that costs anything.
  static std::optional<std::size_t> only_label(const Side& side, std::size_t own) {
    std::optional<std::size_t> only;
    for (std::size_t l = 0; l < side.labels_of_other; ++l) {
      if (side.cost(own, l) == 0) continue;
      if (only) return std::nullopt;
      only = l;
    }
    return only;
  }

  /// Whether each label of the other variable, but the one, is forbidden.
  static bool only_forbidden(const Side& side, std::size_t own, std::size_t without) {
    for (std::size_t l = 0; l < side.labels_of_other; ++l)
      if (l != without && !std::isinf(side.cost(own, l))) return false;
    return true;
  }
  /// Whether each label of the other variable is free or forbidden.
  static bool only_forbidden(const Side& side, std::size_t own) {
    for (std::size_t l = 0; l < side.labels_of_other; ++l)
      if (const double cost = side.cost(own, l); cost != 0 && !std::isinf(cost)) return false;
    return true;
  }

  void require(int s, const std::vector<Side>& sides, const std::vector<std::vector<std::size_t>>& charging,
               std::size_t none, std::size_t owner, std::size_t label) {
    Follower follower{.variable = s, .idle = static_cast<int>(none), .otherwise = static_cast<int>(none)};
    follower.owner = {sides[owner].other, static_cast<int>(label)};
    follower.weight = sides[owner].cost(none, label);
    Requirement requirement{follower.owner, {}};
    for (std::size_t b = 0; b < charging.size(); ++b) {
      if (b == none) continue;
      const double own = sides[owner].cost(b, label);
      const auto partner = std::find_if(charging[b].begin(), charging[b].end(), [&](std::size_t i) { return i != owner; });
      if (partner == charging[b].end()) {  // always there
        if (own < follower.weight) follower.weight = own, follower.otherwise = static_cast<int>(b);
        continue;
      }
      const Side& other = sides[*partner];
      for (std::size_t l = 0; l < other.labels_of_other; ++l) {
        const Support support{{other.other, static_cast<int>(l)}, own + other.cost(b, l)};
        if (!std::isfinite(support.cost)) continue;
        follower.choices.push_back({static_cast<int>(b), support.literal, support.cost});
        requirement.supports.push_back(support);
      }
    }
    std::erase_if(requirement.supports, [&](const Support& support) { return support.cost >= follower.weight; });
    if (requirement.supports.empty())
      found_.charges.emplace_back(follower.owner, follower.weight);
    else if (follower.weight > 0)
      found_.constraints.push_back({sides[owner].parts[0].function->name, follower.weight, -1, std::move(requirement)});
    for (const int f : functions_of_[index(s)]) take(f);
    for (const Side& of : sides) keep(of.other);
    keep(s);
    found_.followers.push_back(std::move(follower));
  }

  // --- cardinalities ---

  struct Chain {
    std::vector<int> counters, functions;
    std::vector<std::vector<Literal>> counted;
    std::vector<int> members;
  };

  /// The functions of `counter` but the one given; nothing when there are more than one.
  std::optional<std::vector<int>> others(int counter, int function) const {
    std::vector<int> rest;
    for (const int f : functions_of_[index(counter)])
      if (f != function) rest.push_back(f);
    if (rest.size() > 1) return std::nullopt;
    return rest;
  }

  /// A chain that begins with this counter.
  void counters(int first) {
    if (!is_open(first) || labels(first) != 2 || functions_of_[index(first)].size() > 2) return;
    for (const int f : functions_of_[index(first)]) {
      const auto of = side(f, first);
      if (!of) continue;
      const auto counted = begin_of_chain(*of);
      if (!counted) continue;
      Chain chain{{first}, {f}, {*counted}, {of->other}};
      if (follow(chain)) return;
    }
  }

  /// Which labels of the other variable count: each allows exactly one of 0 and 1.
  std::optional<std::vector<Literal>> begin_of_chain(const Side& side) const {
    std::vector<Literal> counted;
    for (std::size_t l = 0; l < side.labels_of_other; ++l) {
      const double no = side.cost(0, l), yes = side.cost(1, l);
      if (!(no == 0 && std::isinf(yes)) && !(yes == 0 && std::isinf(no))) return std::nullopt;
      if (yes == 0) counted.push_back({side.other, static_cast<int>(l)});
    }
    return counted;
  }

  /// The next counter is this one, or one more when a label counts.
  std::optional<std::vector<Literal>> next_of_chain(const FileFunction& f) const {
    const std::size_t before = labels(f.scope[0]), middle = labels(f.scope[1]), after = labels(f.scope[2]);
    if (after != before + 1) return std::nullopt;
    std::vector<Literal> counted;
    for (std::size_t l = 0; l < middle; ++l) {
      const auto cost = [&](std::size_t n, std::size_t m) { return f.costs[(n * middle + l) * after + m]; };
      const std::size_t one = cost(0, 1) == 0 ? 1 : 0;
      for (std::size_t n = 0; n < before; ++n)
        for (std::size_t m = 0; m < after; ++m)
          if (m == n + one ? cost(n, m) != 0 : !std::isinf(cost(n, m))) return std::nullopt;
      if (one == 1) counted.push_back({f.scope[1], static_cast<int>(l)});
    }
    return counted;
  }

  bool follow(Chain& chain) {
    for (;;) {
      const int last = chain.counters.back();
      const auto rest = others(last, chain.functions.back());
      if (!rest) return false;
      if (rest->empty()) return end(chain, -1);
      const FileFunction& f = functions_[index((*rest)[0])];
      if (found_.gone[index((*rest)[0])] != 0) return false;
      if (f.scope.size() == 2) return costs_nothing(last) && end(chain, (*rest)[0]);
      if (f.scope.size() != 3 || f.scope[0] != last || !costs_nothing(last) || !is_open(f.scope[2])) return false;
      auto counted = next_of_chain(f);
      if (!counted) return false;
      chain.counters.push_back(f.scope[2]);
      chain.functions.push_back((*rest)[0]);
      chain.counted.push_back(std::move(*counted));
      chain.members.push_back(f.scope[1]);
    }
  }

  /// The price of the last count: a function with the variable that has the condition, or costs of its own.
  bool end(const Chain& chain, int price_function) {
    const int last = chain.counters.back();
    std::vector<double> costs = variables_[index(last)].costs;
    Cardinality cardinality;
    if (price_function >= 0) {
      const auto of = side(price_function, last);
      if (!of) return false;
      for (std::size_t n = 0; n < labels(last); ++n) {
        if (of->is_free(n)) continue;
        const auto label = only_label(*of, n);
        if (!label) return false;
        const Literal condition{of->other, static_cast<int>(*label)};
        if (cardinality.condition && *cardinality.condition != condition) return false;
        cardinality.condition = condition;
        costs[n] = of->cost(n, *label);
      }
    }
    const auto price = read_price(costs);
    const auto is_counter = [&](int v) { return std::find(chain.counters.begin(), chain.counters.end(), v) != chain.counters.end(); };
    if (!price || (price_function >= 0 && price->least > 0)) return false;
    if (std::any_of(chain.members.begin(), chain.members.end(), is_counter)) return false;
    if (cardinality.condition && is_counter(cardinality.condition->variable)) return false;
    found_.constant += price->least;
    cardinality.low = price->low;
    cardinality.high = price->high;
    for (const auto& counted : chain.counted)
      cardinality.literals.insert(cardinality.literals.end(), counted.begin(), counted.end());
    if (price_function >= 0) take(price_function);
    if (cardinality.condition) keep(cardinality.condition->variable);
    if (price->weight > 0)
      found_.constraints.push_back({functions_[index(chain.functions.back())].name, price->weight, -1, cardinality});
    for (std::size_t i = 0; i < chain.counters.size(); ++i) {
      take(chain.functions[i]);
      keep(chain.counters[i]);
      keep(chain.members[i]);
      found_.followers.push_back({.variable = chain.counters[i], .before = i == 0 ? -1 : chain.counters[i - 1], .counted = chain.counted[i]});
    }
    return true;
  }

  const std::vector<Variable>& variables_;
  const std::vector<FileFunction>& functions_;
  std::vector<std::vector<int>> functions_of_;
  std::vector<char> kept_;
  Auxiliaries found_;
};

}  // namespace

Auxiliaries find_auxiliaries(const std::vector<Variable>& variables, const std::vector<FileFunction>& functions) {
  return Finder(variables, functions).find();
}

}  // namespace scenelore::engine
