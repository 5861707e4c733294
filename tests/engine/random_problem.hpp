// Small random problems with every kind of constraint, and all their assignments: the oracle of the engine's tests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "scenelore/engine/checker.hpp"
#include "scenelore/engine/problem.hpp"

namespace scenelore::engine::testing {

/// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// In [0, count).
  int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
  bool chance(double probability) { return real() < probability; }
  double real() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

 private:
  std::uint64_t state_;
};

struct Shape {
  int most_variables = 6;
  int most_labels = 4;
  int most_constraints = 8;
  double hard = 0.3;        ///< share of hard constraints
  double forbidden = 0.05;  ///< of labels
  double twins = 0;         ///< share of labels that are like the one before in costs and tables
  double zero = 0;          ///< share of costs and entries that are 0, beyond the usual
  double largest = 8;       ///< costs are multiples of largest / 64, or of largest / 4 (many equal ones)
};

inline Problem random_problem(std::uint64_t seed, const Shape& shape) {
  Random random(seed);
  Problem problem;
  const int steps = random.chance(0.5) ? 64 : 4;
  const auto cost = [&] {
    if (shape.zero > 0 && random.chance(shape.zero)) return 0.0;
    return shape.largest * random.below(steps + 1) / steps;
  };
  const auto is_twin = [&](std::size_t label) { return shape.twins > 0 && label > 0 && random.chance(shape.twins); };
  const auto weight = [&] {
    return random.chance(shape.hard) ? kHard : shape.largest * (1 + random.below(steps)) / steps;
  };
  const int variables = 1 + random.below(shape.most_variables);
  for (int v = 0; v < variables; ++v) {
    std::vector<std::string> labels;
    std::vector<double> costs;
    const int count = 1 + random.below(shape.most_labels);
    for (int l = 0; l < count; ++l) {
      labels.push_back("l" + std::to_string(l));
      if (is_twin(costs.size())) {
        costs.push_back(costs.back());
        continue;
      }
      costs.push_back(random.chance(shape.forbidden) ? kHard : random.chance(0.2) ? 0 : cost());
    }
    problem.add_variable("v" + std::to_string(v), labels, costs);
  }
  const auto literal = [&] {
    const int v = random.below(variables);
    return Literal{v, random.below(static_cast<int>(problem.variables()[static_cast<std::size_t>(v)].labels.size()))};
  };
  const int constraints = random.below(shape.most_constraints + 1);
  for (int c = 0; c < constraints; ++c) {
    const std::string name = "c" + std::to_string(c);
    const double w = weight();
    switch (random.below(4)) {
      case 0:
        problem.add(name, w, c, Conflict{literal(), literal()});
        break;
      case 1: {
        Requirement requirement{literal(), {}};
        for (int i = random.below(5); i > 0; --i)
          requirement.supports.push_back({literal(), random.chance(0.4) ? 0 : std::min(w, cost())});
        problem.add(name, w, c, requirement);
        break;
      }
      case 2: {
        Cardinality cardinality;
        if (random.chance(0.4)) cardinality.condition = literal();
        for (int i = random.below(7); i > 0; --i) cardinality.literals.push_back(literal());
        cardinality.low = random.below(3);
        cardinality.high = random.chance(0.3) ? std::numeric_limits<int>::max() : random.below(4);
        problem.add(name, w, c, cardinality);
        break;
      }
      default: {
        if (variables < 2) break;
        const int a = random.below(variables);
        const int b = (a + 1 + random.below(variables - 1)) % variables;
        const auto rows = problem.variables()[static_cast<std::size_t>(a)].labels.size();
        const auto columns = problem.variables()[static_cast<std::size_t>(b)].labels.size();
        std::vector<double> entries;
        for (std::size_t i = 0; i < rows * columns; ++i)
          entries.push_back(random.chance(0.5) ? 0 : random.chance(0.1) ? kHard : cost() / shape.largest);
        for (std::size_t row = 1; row < rows; ++row)
          if (is_twin(row))
            for (std::size_t column = 0; column < columns; ++column)
              entries[row * columns + column] = entries[(row - 1) * columns + column];
        problem.add(name, w, c,
                    PairTable{a, b, problem.add_table(static_cast<int>(rows), static_cast<int>(columns), entries)});
      }
    }
  }
  return problem;
}

/// All valid assignments, cheapest first, costs that are equal within `tie` in lexicographic order.
inline std::vector<std::pair<double, std::vector<int>>> all_worlds(const Problem& problem, double tie = 1e-9) {
  std::vector<std::pair<double, std::vector<int>>> worlds;
  const auto& variables = problem.variables();
  std::vector<int> labels(variables.size(), 0);
  for (;;) {
    const Check checked = check(problem, labels);
    if (checked.valid) worlds.emplace_back(checked.cost, labels);
    std::size_t v = 0;
    while (v < labels.size() && ++labels[v] == static_cast<int>(variables[v].labels.size())) labels[v++] = 0;
    if (v == labels.size()) break;
  }
  std::sort(worlds.begin(), worlds.end(), [tie](const auto& a, const auto& b) {
    return std::abs(a.first - b.first) > tie ? a.first < b.first : a.second < b.second;
  });
  return worlds;
}

}  // namespace scenelore::engine::testing
