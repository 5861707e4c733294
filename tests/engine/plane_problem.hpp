// Labelling problems like those of scanned rooms: planes with noisy class costs, a hard table for each pair of planes
// (which classes may stand in the relation that the two planes stand in), and "each screen needs some table below it".
// A hidden true labelling satisfies everything and is what most of the costs speak for; with `truth` = 0 nothing is
// hidden.
#pragma once

#include <cmath>

#include "random_problem.hpp"

namespace scenelore::engine::testing {

struct PlaneShape {
  int planes = 60;
  int classes = 8;
  double forbidden = 0.06;  ///< share of forbidden class pairs in a relation
  double noise = 1.0;       ///< standard deviation of the class costs
  double truth = 2.5;       ///< by how much the true class is cheaper, before noise; 0 = there is no true class
  double reach = 0.3;       ///< share of the planes that could support a plane
  int requirements = 1;     ///< classes that need a support
  bool graded = false;      ///< soft requirements with graded supports and soft tables
};

inline Problem plane_problem(std::uint64_t seed, const PlaneShape& shape) {
  Random random(seed);
  Problem problem;
  std::vector<std::string> names;
  for (int c = 0; c < shape.classes; ++c) names.push_back("class" + std::to_string(c));
  const auto gauss = [&] {  // sum of uniform numbers, variance 1
    double sum = 0;
    for (int i = 0; i < 12; ++i) sum += random.real();
    return sum - 6;
  };
  std::vector<int> truth;
  for (int p = 0; p < shape.planes; ++p) {
    std::vector<double> costs;
    double sum = 0;
    truth.push_back(random.below(shape.classes));
    for (int c = 0; c < shape.classes; ++c)
      costs.push_back(shape.noise * gauss() - (c == truth.back() ? shape.truth : 0));
    for (const double cost : costs) sum += std::exp(-cost);
    for (double& cost : costs) cost = std::max(0.0, cost + std::log(sum));
    problem.add_variable("p" + std::to_string(p), names, costs);
  }
  constexpr int kRelations = 6;
  const auto at = [&](int a, int b) { return static_cast<std::size_t>(a * shape.classes + b); };
  std::vector<std::vector<double>> relations;
  std::vector<int> tables;
  for (int r = 0; r < kRelations; ++r) {
    auto& costs = relations.emplace_back();
    for (int i = 0; i < shape.classes * shape.classes; ++i) costs.push_back(random.chance(shape.forbidden) ? 1 : 0);
    tables.push_back(problem.add_table(shape.classes, shape.classes, costs));
  }
  for (int a = 0; a < shape.planes; ++a)
    for (int b = a + 1; b < shape.planes; ++b) {
      int r = random.below(kRelations);  // the true classes may stand in it, if there is one like that
      for (int i = 0; i < kRelations && shape.truth > 0; ++i)
        if (relations[static_cast<std::size_t>(r)]
                     [at(truth[static_cast<std::size_t>(a)], truth[static_cast<std::size_t>(b)])] > 0)
          r = (r + 1) % kRelations;
      problem.add("pair", shape.graded && random.chance(0.5) ? 1 + random.real() : kHard, a,
                  PairTable{a, b, tables[static_cast<std::size_t>(r)]});
    }
  for (int r = 0; r < shape.requirements; ++r) {
    const int needy = r % shape.classes, table = (r + 1 + r / shape.classes) % shape.classes;
    for (int a = 0; a < shape.planes; ++a) {
      Requirement requirement{{a, needy}, {}};
      const double weight = shape.graded ? 2 + 3 * random.real() : kHard;
      for (int b = 0; b < shape.planes; ++b)
        if (b != a && random.chance(shape.reach))
          requirement.supports.push_back({{b, table}, shape.graded ? 2 * random.real() : 0});
      // In the hidden truth it has one, if there is any such plane.
      const int b = random.below(shape.planes);
      for (int i = 0; i < shape.planes && shape.truth > 0; ++i) {
        const int other = (b + i) % shape.planes;
        if (other == a || truth[static_cast<std::size_t>(other)] != table) continue;
        requirement.supports.push_back({{other, table}, shape.graded ? 0.2 * random.real() : 0});
        break;
      }
      if (requirement.supports.empty()) continue;
      problem.add("needs", weight, a, requirement);
    }
  }
  return problem;
}

}  // namespace scenelore::engine::testing
